// Interval count of every edge.
// In: model, sizes. Out: count per edge, 0 where an edge is degenerate or no face uses it.
// Steps: round the integral of ds/h; least counts (turn, closed edges, edges between the same vertices); more for the
// sake of faces; opposite sides tied; loops made even, and where no triangle is wanted faces.
#include <algorithm>
#include <cmath>
#include <map>

#include "boundary/border/opposite_vertices.h"
#include "boundary/border/seen_facets.h"
#include "boundary/edge_metric.h"
#include "boundary/edge_nodes.h"
#include "boundary/facing/equal_sums.h"
#include "boundary/facing/raise_counts.h"
#include "boundary/facing/tie_sides.h"
#include "boundary/parity.h"
#include "boundary/region_loops.h"

namespace paver {
namespace {

constexpr double most_intervals = 1e8;           // keeps counts within int
constexpr double most_by_turn = 4096;            // intervals on one edge that its turn may ask for
constexpr double full_turn = 6.283185307179586;  // a closed edge that turns so far is round
constexpr double rounding_slack = 1e-6;          // equal edges that come out at a half must not part by rounding errors
constexpr double largest_change = 0.2;           // of the wish, for the sake of ties and parity
constexpr double table_cost = 50;                // microseconds: the metric of an edge
constexpr double turn_slack = 1e-3;              // radians

int least_for_shape(const Edge& edge, double turn) {
  if (edge.start != edge.end) return 1;
  return turn >= full_turn - turn_slack ? 4 : 3;
}

bool is_divided(const Edge& edge) { return !edge.is_degenerate && edge.curve; }

EdgeCount count_for_edge(const Edge& edge, const SizeField& size, std::span<const TurningSide> sides) {
  EdgeMetric metric(edge, size, sides);
  EdgeCount result;
  result.wish = std::isfinite(metric.weight()) ? metric.weight() : 1;
  // The turn of kinks counts for no interval where they take nodes.
  double turns = std::min(std::ceil(metric.smooth_turn() / metric.turn_limit().largest() - turn_slack), most_by_turn);
  double rounded = std::min(std::max({1.0, std::floor(result.wish + 0.5 + rounding_slack), turns}), most_intervals);
  result.minimum = least_for_shape(edge, metric.turn());
  result.is_short = edge.length < size.h;
  result.count = std::max(static_cast<int>(rounded), result.minimum);
  // Equal weights bound the turn once n reaches the weight of every piece between kinks.
  const int enough = static_cast<int>(std::min(std::ceil(result.wish), most_intervals)) + metric.kink_count();
  while (result.count < enough && !metric.turns_within(result.count)) ++result.count;
  // Ties and parity may take some away.
  int lowest = std::max(result.minimum, static_cast<int>((1 - largest_change) * result.wish) - 1);
  if (lowest >= result.count) {
    result.minimum = result.count;
  } else if (metric.turns_within(lowest)) {
    result.minimum = lowest;
  } else {
    int least = result.count;
    while (least - 1 > lowest && least > result.count - 2 && metric.turns_within(least - 1)) --least;
    result.minimum = least;
  }
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
    edges.erase(std::ranges::min_element(edges, {}, [&](int e) { return counts[e].wish; }));
    for (int e : edges) want_two(counts[e]);
  }
}

// Where a border turns back along an edge: the two sides of a slit that meets no other edge, or just periodic ones,
// would be one mesh edge, and no loop; elements about the end of a body pressed flat need a node before it.
void divide_where_borders_turn_back(const Model& model, std::vector<EdgeCount>& counts) {
  auto is_periodic = [&](const Coedge& c) { return edge_of(model, c).is_periodic; };
  for (std::size_t f = 0; f < model.faces.size(); ++f)
    for (std::size_t l = 0; l < model.faces[f].loops.size(); ++l) {
      const std::vector<Coedge>& coedges = model.faces[f].loops[l].coedges;
      for (std::size_t i = 0, n = coedges.size(); i < n; ++i) {
        const Coedge &there = coedges[i], &back = coedges[(i + 1) % n];
        if (there.edge != back.edge) continue;
        const bool is_lone_slit =
            there.is_slit && (n == 2 || (is_periodic(coedges[(i + n - 1) % n]) && is_periodic(coedges[(i + 2) % n])));
        const bool is_flat_end = !there.is_slit && there.is_reversed != back.is_reversed &&
                                 !periodic_coedges(model, static_cast<int>(f))[l][i];
        if (is_lone_slit || is_flat_end) want_two(counts[there.edge]);
      }
    }
}

void even_out(const std::vector<std::vector<Loop>>& loops, bool all_quad, TiedCounts& tied) {
  std::vector<std::vector<int>> of_loops, of_faces;  // groups
  for (const std::vector<Loop>& face : loops) {
    of_faces.emplace_back();
    for (const Loop& loop : face) {
      of_loops.push_back(edges_of(loop));
      for (int& e : of_loops.back()) e = tied.group[e];
      of_faces.back().insert(of_faces.back().end(), of_loops.back().begin(), of_loops.back().end());
    }
  }
  even_out_loops(of_loops, tied.groups);
  // Two odd loops of one face are even together; a face that stays odd may have a short edge split.
  if (all_quad) even_out_loops(of_faces, tied.groups, true);
}

}  // namespace

EdgeCounts choose_counts(const Model& model, const SizeField& size, Progress& progress, SharedTasks& tasks,
                         bool all_quad) {
  progress.begin(Stage::boundary, static_cast<long>(model.edges.size()));
  std::vector<double> costs;
  for (const Edge& edge : model.edges) costs.push_back(is_divided(edge) ? table_cost : 0);
  std::vector<EdgeCount> counts = tasks.run<EdgeCount>(Stage::boundary, costs, [&](int e) {
    const Edge& edge = model.edges[e];
    progress.advance();
    return is_divided(edge) ? count_for_edge(edge, size, size.turning_sides(static_cast<std::size_t>(e))) : EdgeCount{};
  });
  divide_lenses(model, counts);
  divide_where_borders_turn_back(model, counts);

  std::vector<std::vector<Loop>> loops;
  for (std::size_t f = 0; f < model.faces.size(); ++f)
    loops.push_back(model.faces[f].is_meshed() ? linked_loops(model, static_cast<int>(f)) : std::vector<Loop>{});
  divide_lunes(model, size.turn_limit, loops, counts);
  divide_few_sides(model, loops, counts);
  match_gaps(model, size, loops, counts);
  const std::vector<OppositeSides> pairs = find_opposite_sides(model, loops);
  match_vertices(model, pairs, counts);
  OppositeShares opposite = face_near_vertices(model, loops, counts);
  divide_seen_facets(model, loops, opposite, counts);
  match_bent_strips(model, pairs, counts);
  match_vertices(model, pairs, counts);
  TiedCounts tied = tie_opposite_sides(model, pairs, loops, counts);
  progress.check();
  const TiedCounts before = tied;
  even_out(loops, all_quad, tied);
  restore_equal_sums(pairs, before, tied);

  EdgeCounts result{{}, std::move(opposite), edges_together(pairs, tied)};
  for (int group : tied.group) result.count.push_back(tied.groups[group].count);
  return result;
}

}  // namespace paver
