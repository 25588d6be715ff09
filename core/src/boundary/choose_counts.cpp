// Interval count of every edge.
// In: model, sizes. Out: count per edge, 0 where an edge is degenerate or no face uses it.
// Steps: round the integral of ds/h; least counts (turn, closed edges, edges between the same vertices); opposite sides
// tied; loops made even.
#include <algorithm>
#include <cmath>
#include <map>

#include "boundary/edge_metric.h"
#include "boundary/edge_nodes.h"
#include "boundary/parity.h"
#include "boundary/region_loops.h"
#include "boundary/tie_sides.h"

namespace paver {
namespace {

constexpr double most_intervals = 1e8;           // keeps counts within int
constexpr double most_by_turn = 4096;            // intervals on one edge that its turn may ask for
constexpr double full_turn = 6.283185307179586;  // a closed edge that turns so far is round
constexpr double rounding_slack = 1e-6;          // equal edges that come out at a half must not part by rounding errors
constexpr double turn_slack = 1e-3;              // radians

int least_for_shape(const Edge& edge, double turn) {
  if (edge.start != edge.end) return 1;
  return turn >= full_turn - turn_slack ? 4 : 3;
}

EdgeCount count_for_edge(const Edge& edge, const SizeField& size) {
  EdgeMetric metric(edge, size);
  EdgeCount result;
  result.wish = std::isfinite(metric.weight()) ? metric.weight() : 1;
  // The turn of kinks counts for no interval where they take nodes.
  double turns = std::min(std::ceil(metric.smooth_turn() / size.turn_limit - turn_slack), most_by_turn);
  double rounded = std::min(std::max({1.0, std::floor(result.wish + 0.5 + rounding_slack), turns}), most_intervals);
  result.minimum = least_for_shape(edge, metric.turn());
  result.count = std::max(static_cast<int>(rounded), result.minimum);
  // Equal weights bound the turn once n reaches the weight of every piece between kinks.
  const int enough = static_cast<int>(std::min(std::ceil(result.wish), most_intervals)) + metric.kink_count();
  while (result.count < enough && !metric.turns_within(result.count, size.turn_limit)) ++result.count;
  // Ties and parity may take one away each.
  int least = result.count;
  for (int step = 1; step <= 2; ++step) {
    int fewer = result.count - step;
    if (fewer < result.minimum || !metric.turns_within(fewer, size.turn_limit)) break;
    least = fewer;
  }
  result.minimum = least;
  return result;
}

// Edges between the same two vertices would fall onto one another as single intervals: all but the shortest get two.
void divide_lenses(const Model& model, std::vector<EdgeCount>& counts) {
  std::map<std::pair<int, int>, std::vector<int>> between;
  for (std::size_t e = 0; e < counts.size(); ++e) {
    const Edge& edge = model.edges[e];
    if (counts[e].count == 0 || edge.start == edge.end) continue;
    between[std::minmax(edge.start, edge.end)].push_back(static_cast<int>(e));
  }
  for (auto& [vertices, edges] : between) {
    if (edges.size() < 2) continue;
    auto shortest = std::min_element(edges.begin(), edges.end(), [&counts](int a, int b) {
      return counts[static_cast<std::size_t>(a)].wish < counts[static_cast<std::size_t>(b)].wish;
    });
    edges.erase(shortest);
    for (int e : edges) {
      EdgeCount& edge = counts[static_cast<std::size_t>(e)];
      edge.minimum = std::max(edge.minimum, 2);
      edge.count = std::max(edge.count, 2);
    }
  }
}

}  // namespace

std::vector<int> choose_counts(const Model& model, const SizeField& size, Progress& progress) {
  progress.begin(Stage::boundary, static_cast<long>(model.edges.size()));
  std::vector<EdgeCount> counts(model.edges.size());
  for (std::size_t e = 0; e < counts.size(); ++e) {
    const Edge& edge = model.edges[e];
    bool is_divided = !edge.is_degenerate && edge.curve && !edge.faces.empty();
    if (is_divided) counts[e] = count_for_edge(edge, size);
    progress.advance();
  }
  divide_lenses(model, counts);

  std::vector<std::vector<Loop>> loops;
  std::vector<std::vector<int>> loop_edges;
  for (std::size_t f = 0; f < model.faces.size(); ++f) {
    bool is_meshed = model.faces[f].has_area && model.faces[f].fault.empty();
    loops.push_back(is_meshed ? linked_loops(model, static_cast<int>(f), false) : std::vector<Loop>{});
    for (const Loop& loop : loops.back()) {
      std::vector<int>& edges = loop_edges.emplace_back();
      for (const Coedge& coedge : loop.coedges) edges.push_back(coedge.edge);
    }
  }
  tie_opposite_sides(model, loops, counts);
  progress.check();
  even_out_loops(loop_edges, counts);

  std::vector<int> result;
  for (const EdgeCount& edge : counts) result.push_back(edge.count);
  return result;
}

}  // namespace paver
