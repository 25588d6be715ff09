// By points of its border; of a face without one by points of its surface.
#include "sizing/face_extent.h"

#include <cmath>

#include "base/box.h"
#include "sizing/sample_box.h"

namespace paver {
namespace {

constexpr int steps = 16;  // per edge, per direction of a surface

void add_finite(Vec3 x, Box& box) {
  if (std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z)) box.add(x);
}

double share(int i) { return static_cast<double>(i) / steps; }

/// False where it has none but its own periodic edges.
bool add_border(const Model& model, const Face& face, Box& box) {
  bool has_border = false;
  for (const Coedge& coedge : coedges_of(face.loops)) {
    const Edge& edge = edge_of(model, coedge);
    if (!edge.curve) continue;
    has_border = has_border || !edge.is_periodic;
    for (int i = 0; i <= steps; ++i) add_finite(edge.curve->point(edge.parameter(share(i))), box);
  }
  return has_border;
}

}  // namespace

double face_extent(const Model& model, const Face& face) {
  Box box;
  const SampleBox uv = sample_box(model, face);
  if (!add_border(model, face, box) && face.surface && uv.has_area())
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
