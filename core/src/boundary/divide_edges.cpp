// Nodes on all edges, shared by all faces.
// In: model, sizes, counts. Out: divisions with global node numbers.
// Steps: number the vertices that divided edges use; per edge, interval ends at equal weight (integral of ds/h) and on
// kinks, middles at half arc length, both on the exact curve; the ends of an edge are the vertex points themselves.
#include <algorithm>

#include "boundary/edge_metric.h"
#include "boundary/edge_nodes.h"

namespace paver {
namespace {

// Node of each vertex, -1 where no divided edge uses it.
std::vector<int> number_vertices(const Model& model, const std::vector<int>& counts, EdgeNodes& result) {
  std::vector<int> edge_of_vertex(model.vertices.size(), -1);
  for (std::size_t e = 0; e < model.edges.size(); ++e) {
    if (counts[e] <= 0) continue;
    for (int vertex : {model.edges[e].start, model.edges[e].end}) {
      int& first = edge_of_vertex[static_cast<std::size_t>(vertex)];
      if (first < 0) first = static_cast<int>(e);
    }
  }
  std::vector<int> node_of_vertex(model.vertices.size(), -1);
  for (std::size_t v = 0; v < model.vertices.size(); ++v) {
    if (edge_of_vertex[v] < 0) continue;
    node_of_vertex[v] = static_cast<int>(result.nodes.size());
    result.nodes.push_back(model.vertices[v]);
    result.node_edge.push_back(edge_of_vertex[v]);
  }
  return node_of_vertex;
}

class EdgeDivider {
 public:
  EdgeDivider(const Model& model, const SizeField& size, EdgeNodes& result)
      : model_(model), size_(size), result_(result) {}

  void divide(int edge_index, int count, const std::vector<int>& node_of_vertex) {
    const Edge& edge = model_.edges[static_cast<std::size_t>(edge_index)];
    const EdgeMetric metric(edge, size_);
    const int start = node_of_vertex[static_cast<std::size_t>(edge.start)];
    const int end = node_of_vertex[static_cast<std::size_t>(edge.end)];
    EdgeDivision& division = result_.edges[static_cast<std::size_t>(edge_index)];
    lower_target(start, metric.size_at_length(0));
    lower_target(end, metric.size_at_length(metric.length()));

    division.t.push_back(edge.t0);
    division.x.push_back(result_.nodes[static_cast<std::size_t>(start)]);
    division.node.push_back(start);
    const std::vector<double> lengths = metric.node_lengths(count);
    for (std::size_t i = 1; i < lengths.size(); ++i) {
      bool is_last = i + 1 == lengths.size();
      double here = lengths[i];
      add_point(division, edge, metric.parameter_at_length(0.5 * (lengths[i - 1] + here)));
      if (is_last) {
        division.t.push_back(edge.t1);
        division.x.push_back(result_.nodes[static_cast<std::size_t>(end)]);
        division.node.push_back(end);
      } else {
        add_point(division, edge, metric.parameter_at_length(here));
        division.node.push_back(static_cast<int>(result_.nodes.size()));
        result_.nodes.push_back(division.x.back());
        result_.node_edge.push_back(edge_index);
        result_.node_target.push_back(metric.size_at_length(here));
      }
    }
  }

 private:
  static void add_point(EdgeDivision& division, const Edge& edge, double t) {
    division.t.push_back(t);
    division.x.push_back(edge.curve->point(t));
  }

  void lower_target(int node, double target) {
    double& known = result_.node_target[static_cast<std::size_t>(node)];
    known = std::min(known, target);
  }

  const Model& model_;
  const SizeField& size_;
  EdgeNodes& result_;
};

}  // namespace

EdgeNodes divide_edges(const Model& model, const SizeField& size, const std::vector<int>& counts, Progress& progress) {
  EdgeNodes result;
  result.edges.resize(model.edges.size());
  const std::vector<int> node_of_vertex = number_vertices(model, counts, result);
  result.node_target.assign(result.nodes.size(), size.h);
  EdgeDivider divider(model, size, result);
  for (std::size_t e = 0; e < model.edges.size(); ++e) {
    progress.check();
    bool is_divided = counts[e] > 0 && !model.edges[e].is_degenerate && model.edges[e].curve;
    if (is_divided) divider.divide(static_cast<int>(e), counts[e], node_of_vertex);
  }
  return result;
}

}  // namespace paver
