// Vertices on a periodic edge. The edge disappears when its face is meshed, and its vertices with it; those that others
// have as well (a wire that ends there, the corner of another part, a point) must be nodes inside the face.
#include <algorithm>
#include <set>

#include "topology/model.h"

namespace paver {

bool has_other_user(const Model& model, int edge, int face) {
  const std::vector<int>& faces = model.edges[edge].faces;
  return is_of_wire(model, edge) || std::ranges::any_of(faces, [&](int user) { return user != face; });
}

void add_periodic_points(Model& model, const std::set<int>& wanted) {
  std::set<int> points = wanted;
  for (const PartPoint& point : model.points) points.insert(point.vertex);
  for (const Face& face : model.faces)  // where one touches another in a point
    for (const InnerPoint& point : face.points) points.insert(point.vertex);
  std::vector<std::vector<int>> edges_at(model.vertices.size());
  for (std::size_t e = 0; e < model.edges.size(); ++e)
    for (int vertex : {model.edges[e].start, model.edges[e].end}) edges_at[vertex].push_back(static_cast<int>(e));
  const auto edge = [&](int e) -> const Edge& { return model.edges[e]; };
  // Whether something else than the face itself has the vertex.
  const auto is_shared = [&](int vertex, int face) {
    const std::vector<int>& edges = edges_at[vertex];
    return points.contains(vertex) || std::any_of(edges.begin(), edges.end(), [&](int e) {
             return !edge(e).is_degenerate && has_other_user(model, e, face);
           });
  };
  for (std::size_t f = 0; f < model.faces.size(); ++f) {
    Face& face = model.faces[f];
    std::set<int> known;
    for (const InnerPoint& point : face.points) known.insert(point.vertex);
    for (const Coedge& c : coedges_of(face.loops))
      if (const Edge& e = edge(c.edge); !e.is_periodic && !e.is_degenerate) known.insert({e.start, e.end});
    for (const Coedge& c : coedges_of(face.loops)) {
      const Edge& e = edge(c.edge);
      if (!e.is_periodic) continue;
      for (auto [vertex, t] : {std::pair{e.start, e.t0}, std::pair{e.end, e.t1}})
        if (is_shared(vertex, static_cast<int>(f)) && known.insert(vertex).second)
          face.points.push_back({vertex, c.pcurve->uv(t)});
    }
  }
}

}  // namespace paver
