// Even loops by a T-join: which edges to change by one so that every odd loop becomes even.
// In: edges of each loop, counts. Out: counts.
// Steps: graph of loops; rounds of shortest paths from all odd loops at once, pairs taken cheapest first; every edge
// on a path flips (twice: not at all); loops still odd try edges of more than two uses; counts change.
// Pairing is greedy, not a least-cost matching: near it on real models, and n log n.
#include "boundary/parity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

namespace paver {
namespace {

constexpr double free_change = 0.12;    // relative change that costs no extra
constexpr double extra_cost = 4;        // per relative change above it
constexpr double tied_cost = 0.05;      // for a tie that may be lost
constexpr double short_cost = 10000;    // a short one interval to two
constexpr double locked_cost = 100;     // one interval to two: when nothing else helps
constexpr double shortest_split = 0.7;  // of h: a shorter edge of one interval is never split
constexpr double unreachable = std::numeric_limits<double>::infinity();

// The neighbour of the count that lies nearer to the wish, not below the minimum.
int changed_count(const EdgeCount& edge) {
  bool can_drop = edge.count - 1 >= std::max(edge.minimum, 1);
  return can_drop && edge.wish < edge.count ? edge.count - 1 : edge.count + 1;
}

double change_cost(const EdgeCount& edge, bool may_split_short) {
  if (edge.count == 1 && edge.wish <= shortest_split) return may_split_short ? short_cost : unreachable;
  if (edge.count == 1) return locked_cost;
  double change = std::abs(changed_count(edge) - edge.wish) / edge.count;
  return change + extra_cost * std::max(0.0, change - free_change) + (edge.is_tied ? tied_cost : 0);
}

// Nodes are loops; the last one is the outside.
class LoopGraph {
 public:
  LoopGraph(const std::vector<std::vector<int>>& loop_edges, const std::vector<EdgeCount>& counts, bool may_split_short)
      : uses_(counts.size()), flips_(counts.size(), false), is_odd_(loop_edges.size() + 1, false) {
    for (const EdgeCount& edge : counts)
      cost_.push_back(edge.count == 0 ? unreachable : change_cost(edge, may_split_short));
    for (int l = 0; l < outside(); ++l)
      for (int edge : loop_edges[l]) {
        // A loop that uses an edge twice keeps its parity when the edge changes.
        std::vector<int>& loops = uses_[edge];
        if (!loops.empty() && loops.back() == l)
          loops.pop_back();
        else
          loops.push_back(l);
        if (counts[edge].count % 2 != 0) is_odd_[l] = !is_odd_[l];
      }
    build_arcs();
  }

  void pair_odd_loops() {
    while (pair_round()) {
    }
  }

  // An edge of more than two uses flips all its loops: taken only where that leaves fewer odd ones.
  void use_nonmanifold_edges() {
    for (bool has_changed = true; has_changed;) {
      has_changed = false;
      for (std::size_t e = 0; e < uses_.size(); ++e) {
        if (uses_[e].size() < 3 || flips_[e] || cost_[e] == unreachable) continue;
        const auto odd = std::ranges::count_if(uses_[e], [&](int loop) { return is_odd_[loop]; });
        if (2 * static_cast<std::size_t>(odd) <= uses_[e].size()) continue;
        flip_edge(static_cast<int>(e));
        has_changed = true;
      }
    }
  }

  bool is_flipped(std::size_t edge) const { return flips_[edge]; }
  int odd_count() const { return static_cast<int>(std::count(is_odd_.begin(), is_odd_.end() - 1, true)); }

 private:
  struct Arc {
    int edge, a, b;
    double cost;
  };
  struct Reach {
    double cost = unreachable;
    int source = -1;
    int arc = -1;  // towards the source; -1 at the source
  };

  int outside() const { return static_cast<int>(is_odd_.size()) - 1; }

  void build_arcs() {
    arcs_of_.resize(is_odd_.size());
    for (std::size_t e = 0; e < uses_.size(); ++e) {
      if (cost_[e] == unreachable || uses_[e].empty() || uses_[e].size() > 2) continue;
      int a = uses_[e][0], b = uses_[e].size() == 2 ? uses_[e][1] : outside();
      arcs_of_[a].push_back(static_cast<int>(arcs_.size()));
      arcs_of_[b].push_back(static_cast<int>(arcs_.size()));
      arcs_.push_back({static_cast<int>(e), a, b, cost_[e]});
    }
  }

  void flip_edge(int edge) {
    auto e = static_cast<std::size_t>(edge);
    flips_[e] = !flips_[e];
    for (int loop : uses_[e]) is_odd_[loop] = !is_odd_[loop];
  }

  // Cheapest way from any odd loop, or the outside, to every loop.
  std::vector<Reach> reach_from_odd_loops() const {
    std::vector<Reach> reach(is_odd_.size());
    using Item = std::tuple<double, int>;  // cost, node
    std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
    for (int node = 0; node <= outside(); ++node) {
      if (!is_odd_[node] && node != outside()) continue;
      reach[node] = {0, node, -1};
      queue.push({0, node});
    }
    while (!queue.empty()) {
      auto [cost, node] = queue.top();
      queue.pop();
      const Reach here = reach[node];
      if (cost > here.cost) continue;
      for (int index : arcs_of_[node]) {
        const Arc& arc = arcs_[index];
        int other = arc.a == node ? arc.b : arc.a;
        Reach& there = reach[other];
        if (!(cost + arc.cost < there.cost)) continue;
        there = {cost + arc.cost, here.source, index};
        queue.push({there.cost, other});
      }
    }
    return reach;
  }

  void flip_way_to_source(int node, const std::vector<Reach>& reach) {
    for (int index = reach[node].arc; index >= 0; index = reach[node].arc) {
      const Arc& arc = arcs_[index];
      flip_edge(arc.edge);
      node = arc.a == node ? arc.b : arc.a;
    }
  }

  // Pairs odd loops whose reaches meet, cheapest meeting first; false when no pair was found.
  bool pair_round() {
    const std::vector<Reach> reach = reach_from_odd_loops();
    std::vector<std::tuple<double, int>> meetings;  // cost, arc
    for (std::size_t i = 0; i < arcs_.size(); ++i) {
      const Reach &a = reach[arcs_[i].a], &b = reach[arcs_[i].b];
      if (a.source < 0 || b.source < 0 || a.source == b.source) continue;
      meetings.emplace_back(a.cost + arcs_[i].cost + b.cost, static_cast<int>(i));
    }
    std::sort(meetings.begin(), meetings.end());
    bool has_paired = false;
    std::vector<bool> is_taken(is_odd_.size(), false);
    for (auto [cost, index] : meetings) {
      const Arc arc = arcs_[index];
      auto a = static_cast<std::size_t>(reach[arc.a].source);
      auto b = static_cast<std::size_t>(reach[arc.b].source);
      if (is_taken[a] || is_taken[b]) continue;
      is_taken[a] = static_cast<int>(a) != outside();
      is_taken[b] = static_cast<int>(b) != outside();
      flip_edge(arc.edge);
      flip_way_to_source(arc.a, reach);
      flip_way_to_source(arc.b, reach);
      has_paired = true;
    }
    return has_paired;
  }

  std::vector<double> cost_;            // per edge
  std::vector<std::vector<int>> uses_;  // per edge: loops that use it an odd number of times
  std::vector<bool> flips_;
  std::vector<bool> is_odd_;
  std::vector<Arc> arcs_;
  std::vector<std::vector<int>> arcs_of_;
};

}  // namespace

void raise_to(EdgeCount& edge, int count) {
  if (count <= edge.count) return;
  edge.count = edge.minimum = count;
  edge.wish = std::max(edge.wish, static_cast<double>(count));
}

void want_two(EdgeCount& edge) {
  if (edge.count == 0) return;
  edge.minimum = std::max(edge.minimum, 2);
  edge.count = std::max(edge.count, 2);
}

bool are_divided(const std::vector<int>& edges, const std::vector<EdgeCount>& counts) {
  return std::ranges::all_of(edges, [&](int e) { return counts[e].count > 0; });
}

long sum_of_counts(const std::vector<int>& edges, const std::vector<EdgeCount>& counts) {
  long sum = 0;
  for (int e : edges) sum += counts[e].count;
  return sum;
}

int even_out_loops(const std::vector<std::vector<int>>& loop_edges, std::vector<EdgeCount>& counts,
                   bool may_split_short) {
  LoopGraph graph(loop_edges, counts, may_split_short);
  graph.pair_odd_loops();
  graph.use_nonmanifold_edges();
  graph.pair_odd_loops();
  for (std::size_t e = 0; e < counts.size(); ++e)
    if (graph.is_flipped(e)) counts[e].count = changed_count(counts[e]);
  return graph.odd_count();
}

}  // namespace paver
