// In: edges with their faces. Out: one answer for each edge.
// Steps: normals of both faces along the edge, and the way from it into the first of them; a corner is outside where
// that way goes behind the other face.
#include "sizing/parts/sharp_edges.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "topology/corner_angle.h"

namespace paver {
namespace {

constexpr double corner = 40 * M_PI / 180;
constexpr std::array shares{0.1, 0.5, 0.9};  // of the edge, where it is looked at

/// Of a face at a place of one of its edges.
struct FaceAtEdge {
  Vec3 normal;  // outward
  Vec3 inward;  // from the edge into the face
};

FaceAtEdge look(const Face& face, const Coedge& coedge, const Edge& edge, double share) {
  const double t = edge.parameter(share);
  const Vec3 normal = face.surface->normal(coedge.pcurve->uv(t));  // the face lies to the left of its coedges about it
  const Vec3 along = edge.curve->slope(t).t;
  return {face.is_reversed ? -1 * normal : normal, cross(normal, unit(coedge.is_reversed ? -1 * along : along))};
}

class SharpEdges {
 public:
  explicit SharpEdges(const Model& model) : model_(model), uses_(model.edges.size()) {
    for (const Face& face : model.faces)
      if (face.has_area && face.surface)
        for (const Coedge& coedge : coedges_of(face.loops))
          if (coedge.pcurve) uses_[coedge.edge].push_back({&face, &coedge});
  }

  bool is_sharp(std::size_t e) const {
    const Edge& edge = model_.edges[e];
    if (!edge.curve || edge.is_periodic || uses_[e].empty()) return false;
    if (uses_[e].size() == 1) return edge.faces.size() == 1;
    if (uses_[e].size() > 2) return true;
    return std::any_of(shares.begin(), shares.end(), [&](double share) { return is_corner(e, share); });
  }

 private:
  struct Use {
    const Face* face;
    const Coedge* coedge;
  };

  bool is_corner(std::size_t e, double share) const {
    const Edge& edge = model_.edges[e];
    const auto [one, first] = uses_[e][0];
    const auto [two, second] = uses_[e][1];
    const FaceAtEdge a = look(*one, *first, edge, share), b = look(*two, *second, edge, share);
    const bool is_sheet = one->front.empty() && one->back.empty();
    return angle_between(a.normal, b.normal) > corner && (is_sheet || dot(a.inward, b.normal) < 0);
  }

  const Model& model_;
  std::vector<std::vector<Use>> uses_;
};

}  // namespace

std::vector<bool> find_sharp_edges(const Model& model) {
  const SharpEdges edges(model);
  std::vector<bool> result;
  for (std::size_t e = 0; e < model.edges.size(); ++e) result.push_back(edges.is_sharp(e));
  return result;
}

}  // namespace paver
