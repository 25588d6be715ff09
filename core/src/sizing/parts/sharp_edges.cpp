// In: edges with their faces. Out: one answer for each edge.
// Steps: normals of both faces along the edge, and the way from it into the first of them; a corner is outside where
// that way goes behind the other face.
#include <algorithm>
#include <array>
#include <cmath>

#include "sizing/parts/find_places.h"
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

struct Use {
  const Face* face;
  const Coedge* coedge;
};

bool is_corner(const Edge& edge, const Use& one, const Use& two, double share) {
  const FaceAtEdge a = look(*one.face, *one.coedge, edge, share), b = look(*two.face, *two.coedge, edge, share);
  const bool is_sheet = one.face->front.empty() && one.face->back.empty();
  return angle_between(a.normal, b.normal) > corner && (is_sheet || dot(a.inward, b.normal) < 0);
}

bool is_sharp(const Edge& edge, const std::vector<Use>& uses) {
  if (!edge.curve || edge.is_periodic || uses.empty()) return false;
  if (uses.size() == 1) return edge.faces.size() == 1;
  if (uses.size() > 2) return true;
  return std::ranges::any_of(shares, [&](double share) { return is_corner(edge, uses[0], uses[1], share); });
}

}  // namespace

std::vector<bool> find_sharp_edges(const Model& model) {
  std::vector<std::vector<Use>> uses(model.edges.size());
  for (const Face& face : model.faces)
    if (face.has_area && face.surface)
      for (const Coedge& coedge : coedges_of(face.loops))
        if (coedge.pcurve) uses[coedge.edge].push_back({&face, &coedge});
  std::vector<bool> result;
  for (std::size_t e = 0; e < model.edges.size(); ++e) result.push_back(is_sharp(model.edges[e], uses[e]));
  return result;
}

}  // namespace paver
