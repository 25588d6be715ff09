// Vertices on a periodic edge. The edge disappears when its face is meshed, and its vertices with it; those that others
// have as well (a wire that ends there, the corner of another part, a point) must be nodes inside the face.
#include <set>

#include "topology/build_parts_impl.h"

namespace paver {
namespace {

/// Whether something else than the face itself has the vertices of an edge.
bool has_stranger(const Model& model, std::size_t edge, int face) {
  return !model.edges[edge].is_degenerate && has_other_user(model, static_cast<int>(edge), face);
}

class PeriodicPoints {
 public:
  explicit PeriodicPoints(Model& model) : model_(model), edges_at_(model.vertices.size()) {
    for (const PartPoint& point : model.points) points_.insert(point.vertex);
    for (std::size_t e = 0; e < model.edges.size(); ++e)
      for (int vertex : {model.edges[e].start, model.edges[e].end})
        edges_at_[static_cast<std::size_t>(vertex)].push_back(e);
  }

  void run() {
    for (std::size_t f = 0; f < model_.faces.size(); ++f) add_points(static_cast<int>(f));
  }

 private:
  const Edge& edge(const Coedge& c) const { return model_.edges[static_cast<std::size_t>(c.edge)]; }

  void add_points(int f) {
    Face& face = model_.faces[static_cast<std::size_t>(f)];
    std::set<int> known;
    for (const InnerPoint& point : face.points) known.insert(point.vertex);
    for (const Loop& loop : face.loops)
      for (const Coedge& c : loop.coedges)
        if (!edge(c).is_periodic && !edge(c).is_degenerate) known.insert({edge(c).start, edge(c).end});
    for (const Loop& loop : face.loops)
      for (const Coedge& c : loop.coedges) {
        if (!edge(c).is_periodic) continue;
        for (auto [vertex, t] : {std::pair{edge(c).start, edge(c).t0}, std::pair{edge(c).end, edge(c).t1}})
          if (is_shared(vertex, f) && known.insert(vertex).second) face.points.push_back({vertex, c.pcurve->uv(t)});
      }
  }

  bool is_shared(int vertex, int face) const {
    if (points_.count(vertex)) return true;
    for (std::size_t e : edges_at_[static_cast<std::size_t>(vertex)])
      if (has_stranger(model_, e, face)) return true;
    return false;
  }

  Model& model_;
  std::vector<std::vector<std::size_t>> edges_at_;
  std::set<int> points_;
};

}  // namespace

bool has_other_user(const Model& model, int edge, int face) {
  const auto e = static_cast<std::size_t>(edge);
  if (e < model.edge_part.size() && model.edge_part[e] >= 0) return true;
  for (int user : model.edges[e].faces)
    if (user != face) return true;
  return false;
}

void add_periodic_points(Model& model) { PeriodicPoints(model).run(); }

}  // namespace paver
