// The extent by points of the border; of a face without one by points of its surface.
#include "sizing/sample_box.h"

#include "base/box.h"

namespace paver {
namespace {

constexpr int steps = 16;               // per edge, per direction of a surface
constexpr int samples_per_pcurve = 17;  // for the box in (u, v)

void add_finite(Vec3 x, Box& box) {
  if (std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z)) box.add(x);
}

double share(int i) { return static_cast<double>(i) / steps; }

}  // namespace

SampleBox sample_box(const Model& model, const Face& face) {
  SampleBox box;
  for (const Coedge& coedge : coedges_of(face.loops)) {
    if (!coedge.pcurve) continue;
    const Edge& edge = edge_of(model, coedge);
    for (int i = 0; i < samples_per_pcurve; ++i) {
      double share = static_cast<double>(i) / (samples_per_pcurve - 1);
      box.add(coedge.pcurve->uv(edge.parameter(share)));
    }
  }
  return box;
}

double face_extent(const Model& model, const Face& face) {
  Box box;
  bool is_bordered = false;
  for (const Coedge& coedge : coedges_of(face.loops)) {
    const Edge& edge = edge_of(model, coedge);
    if (!edge.curve) continue;
    is_bordered = is_bordered || !edge.is_periodic;
    for (int i = 0; i <= steps; ++i) add_finite(edge.curve->point(edge.parameter(share(i))), box);
  }
  const SampleBox uv = sample_box(model, face);
  if (!is_bordered && face.surface && uv.has_area())
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; j <= steps; ++j) add_finite(face.surface->point(uv.at(share(i), share(j))), box);
  const double size = norm(box.high - box.low);
  return size > 0 ? size : Box::infinity;
}

bool has_border(const Model& model, const Face& face) {
  for (const Coedge& coedge : coedges_of(face.loops))
    if (const Edge& edge = edge_of(model, coedge); !edge.is_periodic && !edge.is_degenerate) return true;
  return false;
}

}  // namespace paver
