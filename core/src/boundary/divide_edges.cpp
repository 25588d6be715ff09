// Nodes on all edges, shared by all faces.
// In: model, sizes, counts. Out: divisions with global node numbers.
// Steps: number the vertices that divided edges use; per edge, interval ends at equal weight (integral of ds/h) and on
// kinks, middles at half arc length, both on the exact curve; the ends of an edge are the vertex points themselves.
// Across narrow faces interval ends then move to where they face vertices.
#include <algorithm>
#include <map>

#include "boundary/border/border_facets.h"
#include "boundary/edge_metric.h"
#include "boundary/edge_nodes.h"
#include "boundary/facing/facing_nodes.h"
#include "boundary/region_loops.h"

namespace paver {
namespace {

void number_vertices(const Model& model, const std::vector<int>& counts, EdgeNodes& result) {
  std::vector<int> edge_of_vertex(model.vertices.size(), -1);
  for (std::size_t e = model.edges.size(); e-- > 0;)  // so that the first one stays
    if (counts[e] > 0)
      for (int vertex : {model.edges[e].start, model.edges[e].end}) edge_of_vertex[vertex] = static_cast<int>(e);
  result.node_of_vertex.assign(model.vertices.size(), -1);
  for (std::size_t v = 0; v < model.vertices.size(); ++v) {
    if (edge_of_vertex[v] < 0) continue;
    result.node_of_vertex[v] = static_cast<int>(result.nodes.size());
    result.nodes.push_back(model.vertices[v]);
    result.node_edge.push_back(edge_of_vertex[v]);
  }
}

constexpr double table_cost = 50, node_cost = 2;  // microseconds

/// What dividing an edge gives before nodes have numbers.
struct Places {
  std::vector<double> t;
  std::vector<Vec3> x;         // as in EdgeDivision
  std::vector<double> length;  // per node, from the start
  std::vector<double> target;  // per node
};
PAVER_FIELDS(Places, t, x, length, target)

EdgeMetric metric_of(const Model& model, int edge, const SizeField& size) {
  return {model.edges[edge], size, size.turning_sides(static_cast<std::size_t>(edge))};
}

Places divide(const Model& model, int index, const EdgeMetric& metric, const std::vector<double>& lengths) {
  const Edge& edge = model.edges[index];
  Places places;
  places.length = lengths;
  auto add = [&](double t, Vec3 x) {
    places.t.push_back(t);
    places.x.push_back(x);
  };
  auto add_on_curve = [&](double length) {
    const double t = metric.parameter_at_length(length);
    add(t, edge.curve->point(t));
  };
  add(edge.t0, model.vertices[edge.start]);
  for (std::size_t i = 1; i < lengths.size(); ++i) {
    add_on_curve(0.5 * (lengths[i - 1] + lengths[i]));
    if (i + 1 < lengths.size()) add_on_curve(lengths[i]);
  }
  add(edge.t1, model.vertices[edge.end]);
  for (double length : lengths) places.target.push_back(metric.size_at_length(length));
  return places;
}

/// Numbers the nodes of one more edge.
void append(int edge, Places places, int start, int end, EdgeNodes& result) {
  EdgeDivision& division = result.edges[edge];
  division.t = std::move(places.t);
  division.x = std::move(places.x);
  auto lower_target = [&](int node, double target) {
    double& known = result.node_target[node];
    known = std::min(known, target);
  };
  lower_target(start, places.target.front());
  lower_target(end, places.target.back());
  division.node.push_back(start);
  for (std::size_t i = 1; i + 1 < places.target.size(); ++i) {
    division.node.push_back(static_cast<int>(result.nodes.size()));
    result.nodes.push_back(division.x[2 * i]);
    result.node_edge.push_back(edge);
    result.node_target.push_back(places.target[i]);
  }
  division.node.push_back(end);
}

/// Nodes opposite vertices, where they may be; otherwise at equal weight.
std::vector<double> lengths_on(const EdgeMetric& metric, int count, const std::vector<double>& opposite) {
  std::vector<double> even = metric.node_lengths(count);
  if (opposite.empty() || metric.kink_count() > 0) return even;
  std::vector<double> lengths = shares_of(opposite, count);
  for (double& length : lengths) length *= even.back();
  return metric.turns_within(lengths) ? lengths : even;
}

/// `places`: of the edges `divided`. Edges with nodes `opposite` vertices stay.
void move_nodes(const Model& model, const SizeField& size, const std::vector<int>& divided,
                const OppositeShares& opposite, std::vector<Places>& places) {
  NodeLengths lengths(model.edges.size());
  std::vector<int> task_of_edge(model.edges.size(), -1);
  std::vector<bool> is_placed(model.edges.size(), false);
  for (std::size_t i = 0; i < divided.size(); ++i) {
    lengths[divided[i]] = places[i].length;
    task_of_edge[divided[i]] = static_cast<int>(i);
    is_placed[divided[i]] = !opposite.empty() && !opposite[divided[i]].empty();
  }
  std::vector<std::vector<Loop>> loops;
  for (std::size_t f = 0; f < model.faces.size(); ++f)
    loops.push_back(model.faces[f].is_meshed() ? linked_loops(model, static_cast<int>(f)) : std::vector<Loop>{});
  std::map<int, EdgeMetric> known;
  const auto metric_at = [&](int edge) -> const EdgeMetric& {
    const auto at = known.find(edge);
    return at != known.end() ? at->second : known.emplace(edge, metric_of(model, edge, size)).first->second;
  };
  const auto may_move = [&](const MovedNodes& moved) {
    const EdgeMetric& metric = metric_at(moved.edge);
    return metric.kink_count() == 0 && metric.turns_within(moved.lengths);
  };
  const auto point = [&](int edge, double length) {
    return model.edges[edge].curve->point(metric_at(edge).parameter_at_length(length));
  };
  for (const MovedNodes& moved : face_vertices(model, find_opposite_sides(model, loops), std::move(lengths),
                                               std::move(is_placed), may_move, point))
    places[task_of_edge[moved.edge]] = divide(model, moved.edge, metric_at(moved.edge), moved.lengths);
}

}  // namespace

EdgeNodes divide_edges(const Model& model, const SizeField& size, const EdgeCounts& counts, SharedTasks& tasks) {
  EdgeNodes result;
  result.edges.resize(model.edges.size());
  number_vertices(model, counts.count, result);
  result.node_target.assign(result.nodes.size(), size.h);
  std::vector<int> divided;
  std::vector<double> costs;
  for (std::size_t e = 0; e < model.edges.size(); ++e) {
    if (counts.count[e] <= 0 || model.edges[e].is_degenerate || !model.edges[e].curve) continue;
    divided.push_back(static_cast<int>(e));
    costs.push_back(table_cost + node_cost * counts.count[e]);
  }
  const std::vector<double> nowhere;
  auto opposite_on = [&](int e) -> const std::vector<double>& {
    return counts.opposite.empty() ? nowhere : counts.opposite[e];
  };
  std::vector<Places> places = tasks.run<Places>(Stage::boundary, costs, [&](int task) {
    const int e = divided[task];
    const EdgeMetric metric = metric_of(model, e, size);
    return divide(model, e, metric, lengths_on(metric, counts.count[e], opposite_on(e)));
  });
  move_nodes(model, size, divided, counts.opposite, places);
  for (std::size_t i = 0; i < divided.size(); ++i) {
    const Edge& edge = model.edges[divided[i]];
    append(divided[i], std::move(places[i]), result.node_of_vertex[edge.start], result.node_of_vertex[edge.end],
           result);
  }
  return result;
}

}  // namespace paver
