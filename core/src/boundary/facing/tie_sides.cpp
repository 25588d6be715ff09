// Equal counts on opposite sides, so that such faces can be meshed as grids.
// In: loops, counts. Out: groups of edges with one count each.
// Steps: edges that lie opposite each other are joined, those of faces far narrower than their intervals first, then
// those of one kind (shorter than the target length, or not) and of large faces, while there is a count that all
// members of a group can take (where a face has one pair of sides only that can be equal: while they differ by
// rounding, for such a face stays irregular anyway); each group takes the one nearest to their wishes; sides of unequal
// numbers of edges then get equal sums by changing groups that no earlier pair of sides holds.
#include "boundary/facing/tie_sides.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "base/union_find.h"
#include "boundary/facing/side_chain.h"
#include "topology/corner_angle.h"

namespace paver {
namespace {

constexpr double most_intervals = 1e8;   // keeps counts within int
constexpr double largest_change = 0.12;  // of an edge's wish
// Intervals on the rims of a ring, by the target length: cones up to 1 : 1.67 come out regular (decision frusta).
constexpr double shortest_on_rim = 0.75, longest_on_rim = 1.25;
constexpr double narrow = 0.7;         // intervals
constexpr double thin = 0.2;           // intervals: what lies between unequal sides are needles
constexpr double most_on_prism = 1.4;  // of the wish, and its inverse: lines of a prism, for a grid between them
// Of the wish: sides of thin faces may take as many more.
constexpr double most_on_thin = 1.5;
// Of the wish: a side of a thin face that is one edge, for the vertices it faces.
constexpr double most_for_vertices = 64;
constexpr double rounding = 0.9;  // intervals: short edges may change by more than that share
constexpr int most_on_short = 4;  // intervals: on an edge shorter than the target length no length is right
// Of the intervals that its bends ask for: those of the other end of a thin rod ask for more.
constexpr double most_on_short_rim = 1.6;
constexpr int most_tried = 3;            // intervals more or fewer, for vertices between several edges that one faces
constexpr double beside_vertex = 0.25;   // intervals: so far aside of them nodes may be
constexpr double rounding_slack = 1e-6;  // equal wishes at a half round alike

/// Of an edge with so many intervals: how far its nodes lie aside of where edges with `counts` intervals end that it
/// faces, intervals. `ends`: shares of its length.
double most_aside(int total, const std::vector<double>& ends, const std::vector<int>& counts) {
  double most = 0;
  for (std::size_t k = 0, node = 0; k < ends.size(); ++k)
    most = std::max(most, std::fabs(total * ends[k] - static_cast<double>(node += counts[k])));
  return most;
}

/// Counts an edge may take.
struct Range {
  int least, most;
  bool is_possible(bool is_even) const { return is_even ? (least + 1) / 2 <= most / 2 : least <= most; }
};

struct EdgeKind {
  bool is_rim = false, is_of_thin = false;  // of a ring, a bent strip or a single row; of a thin face
  bool is_of_prism = false;                 // one of two parallel lines between sides that bend
  int faced = 0;                            // intervals of several edges that it faces across a thin face
};

Range range_of(const EdgeCount& edge, EdgeKind kind) {
  double slack = std::max(largest_change * edge.wish, rounding);
  double lowest = edge.wish - slack, highest = edge.wish + slack;
  if (kind.is_rim)
    lowest = std::min(lowest, edge.wish / longest_on_rim), highest = std::max(highest, edge.wish / shortest_on_rim);
  if (kind.is_of_prism)
    lowest = std::min(lowest, edge.wish / most_on_prism), highest = std::max(highest, edge.wish * most_on_prism);
  // The count it has is always allowed: its minimum may lie far above its wish.
  int least = std::max(edge.minimum, static_cast<int>(std::ceil(std::max(lowest, 1.0))));
  int most = static_cast<int>(std::floor(std::min(highest, most_intervals)));
  if (edge.is_short) most = std::max(most, std::min(2 * edge.count, most_on_short));
  if (kind.is_of_thin) most = std::max(most, static_cast<int>(std::min(most_on_thin * edge.wish, most_intervals)));
  const double most_faced = std::min(most_for_vertices * std::max(edge.wish, 1.0), most_intervals);
  most = std::max(most, std::min(kind.faced, static_cast<int>(most_faced)));
  if (edge.is_short && kind.is_rim) most = std::max(most, static_cast<int>(most_on_short_rim * edge.count));
  return {std::min(least, edge.count), std::max(most, edge.count)};
}

/// Of both sides together.
double wish_of(const OppositeSides& pair, const std::vector<EdgeCount>& counts) {
  double wish = 0;
  for (int e : pair.edges()) wish += counts[e].wish;
  return wish;
}

Range common(Range a, Range b) { return {std::max(a.least, b.least), std::min(a.most, b.most)}; }

class Tying {
 public:
  Tying(const std::vector<EdgeCount>& counts, const std::vector<EdgeKind>& kinds)
      : counts_(counts),
        groups_(counts.size()),
        chosen_(counts.size(), 0),
        is_held_(counts.size(), false),
        is_equal_(counts.size(), false) {
    for (std::size_t e = 0; e < counts.size(); ++e) {
      const int count = counts[e].count;
      members_.push_back({range_of(counts[e], kinds[e]), {count, count}, counts[e].minimum, 1, counts[e].wish});
    }
  }

  void mark_even(int edge) { members_[groups_.find(edge)].is_even = true; }

  /// Whether equal sums of the sides are in reach, before any edges are joined.
  bool can_equal(const OppositeSides& pair) const {
    auto reach = [&](const std::vector<int>& side) {
      long least = 0, most = 0;
      for (int e : side) least += members_[e].range.least, most += members_[e].range.most;
      return std::pair{least, most};
    };
    const auto [least, most] = reach(pair.first);
    const auto [other_least, other_most] = reach(pair.second);
    return std::max(least, other_least) <= std::min(most, other_most);
  }

  /// `makes_grid`: worth a larger change.
  void join_if_alike(int a, int b, bool makes_grid) {
    a = groups_.find(a);
    b = groups_.find(b);
    if (a == b) return;
    if (a > b) std::swap(a, b);
    Members &into = members_[a], &from = members_[b];
    Members both{common(into.range, from.range),
                 {std::min(into.rounded.least, from.rounded.least), std::max(into.rounded.most, from.rounded.most)},
                 std::max(into.minimum, from.minimum),
                 into.size + from.size,
                 into.wish + from.wish,
                 into.is_even || from.is_even,
                 into.makes_grid || from.makes_grid || makes_grid};
    if (!both.range.is_possible(both.is_even)) return;
    if (!makes_grid && both.rounded.most - both.rounded.least > 1) return;
    into = both;
    groups_.merge(a, b);
  }

  void choose_counts() {
    for (std::size_t e = 0; e < counts_.size(); ++e) {
      if (groups_.find(static_cast<int>(e)) != static_cast<int>(e) || counts_[e].count == 0) continue;
      chosen_[e] = members_[e].size > 1 || members_[e].is_even ? nearest_count(members_[e]) : counts_[e].count;
    }
  }

  /// Changes groups by one, least relative change first, until the sides have equal sums; leaves all as it was where
  /// that is not to be had.
  void equal_sums(const OppositeSides& pair) {
    const std::vector<State> before = states_of(pair);
    long excess = sum(pair.first) - sum(pair.second);
    while (excess != 0) {
      int best = -1, best_step = 0;
      double least = std::numeric_limits<double>::infinity();
      for (const std::vector<int>* side : {&pair.first, &pair.second})
        for (int e : *side) {
          int group = groups_.find(e);
          int step = (excess > 0) == (side == &pair.first) ? -1 : 1;
          double cost = std::fabs(chosen_[group] + step - mean_wish(group)) / chosen_[group];
          if (!can_change(group, step, pair) || !(cost < least)) continue;
          least = cost, best = group, best_step = step;
        }
      if (best < 0) return put_back(before);
      chosen_[best] += best_step;
      excess += excess > 0 ? -1 : 1;
    }
    for (int e : pair.edges()) is_equal_[groups_.find(e)] = true;
    if (groups_of(pair.first) == groups_of(pair.second)) return;  // equal with any counts
    for (int e : pair.edges()) is_held_[groups_.find(e)] = true;
  }

  /// The same; of an edge that several face across a thin face so many intervals, nearest to its wish, that vertices
  /// between these lie opposite nodes or near them, where that is to be had.
  void equal_shares(const Model& model, const OppositeSides& pair) {
    const std::vector<State> before = states_of(pair);
    equal_sums(pair);
    const bool is_first = pair.first.size() == 1;
    const std::vector<int>&one = is_first ? pair.first : pair.second, &several = is_first ? pair.second : pair.first;
    if (one.size() != 1 || several.size() < 2 || sum(one) != sum(several)) return;
    std::vector<double> ends;  // shares of the edge
    for (int e : several) ends.push_back((ends.empty() ? 0 : ends.back()) + model.edges[e].length);
    for (double& end : ends) end /= ends.back();
    std::vector<int> counts;
    for (int e : several) counts.push_back(chosen_[groups_.find(e)]);
    if (most_aside(chosen_[groups_.find(one[0])], ends, counts) <= beside_vertex) return;
    const std::vector<State> after = states_of(pair);
    put_back(before);
    if (share_out(pair, groups_.find(one[0]), several, ends)) return equal_sums(pair);
    put_back(after);
  }

  TiedCounts result() {
    TiedCounts tied;
    tied.groups.resize(counts_.size());
    for (std::size_t e = 0; e < counts_.size(); ++e) {
      int group = groups_.find(static_cast<int>(e));
      tied.group.push_back(group);
      if (group != static_cast<int>(e)) continue;
      tied.groups[e] = {mean_wish(group), members_[e].minimum, chosen_[e], is_equal_[e] || members_[e].makes_grid};
    }
    return tied;
  }

 private:
  struct Members {
    Range range, rounded;  // counts they may take; counts they had
    int minimum, size;
    double wish;  // sum
    bool is_even = false, makes_grid = false;
  };

  struct State {
    int group, chosen;
    bool is_held;
  };

  std::vector<State> states_of(const OppositeSides& pair) {
    std::vector<State> states;
    for (int e : pair.edges()) {
      const int group = groups_.find(e);
      states.push_back({group, chosen_[group], is_held_[group]});
    }
    return states;
  }

  void put_back(const std::vector<State>& states) {
    for (const State& state : states) chosen_[state.group] = state.chosen, is_held_[state.group] = state.is_held;
  }

  /// Whether there are such counts.
  bool share_out(const OppositeSides& pair, int group, const std::vector<int>& several,
                 const std::vector<double>& ends) {
    const double wish = mean_wish(group);
    std::vector<int> totals;
    for (int step = -most_tried; step <= most_tried; ++step)
      totals.push_back(std::max(1, static_cast<int>(std::lround(wish)) + step));
    std::ranges::stable_sort(totals, {}, [&](int total) { return std::fabs(total - wish); });
    for (int total : totals) {
      std::vector<std::pair<int, int>> shares{{group, total}};  // of groups
      std::vector<int> counts;
      int before = 0;
      for (std::size_t k = 0; k < several.size(); ++k) {
        const int node = static_cast<int>(std::lround(total * ends[k]));
        counts.push_back(node - before);
        shares.emplace_back(groups_.find(several[k]), counts.back());
        before = node;
      }
      auto can_be = [&](const std::pair<int, int>& share) {
        const int step = share.second - chosen_[share.first];
        return step == 0 || can_change(share.first, step, pair);
      };
      if (most_aside(total, ends, counts) > beside_vertex || !std::ranges::all_of(shares, can_be)) continue;
      for (const auto& [g, count] : shares) chosen_[g] = count;
      return true;
    }
    return false;
  }

  double mean_wish(int group) const { return members_[group].wish / members_[group].size; }

  static int nearest_count(const Members& group) {
    double mean = group.wish / group.size;
    int step = group.is_even ? 2 : 1;
    int rounded = step * static_cast<int>(std::min(mean / step + 0.5 + rounding_slack, 0.5 * most_intervals));
    int least = step * ((group.range.least + step - 1) / step), most = group.range.most / step * step;
    return std::max(least, std::min(rounded, most));
  }

  std::multiset<int> groups_of(const std::vector<int>& side) {
    std::multiset<int> groups;
    for (int e : side) groups.insert(groups_.find(e));
    return groups;
  }

  long sum(const std::vector<int>& side) {
    long total = 0;
    for (int e : side) total += chosen_[groups_.find(e)];
    return total;
  }

  bool can_change(int group, int step, const OppositeSides& pair) {
    const Members& members = members_[group];
    int count = chosen_[group] + step;
    if (is_held_[group] || members.is_even || count < members.range.least || count > members.range.most) return false;
    return std::ranges::count_if(pair.edges(), [&](int e) { return groups_.find(e) == group; }) == 1;
  }

  const std::vector<EdgeCount>& counts_;
  UnionFind groups_;
  std::vector<Members> members_;
  std::vector<int> chosen_;     // per group
  std::vector<bool> is_held_;   // per group: an equal sum depends on its count
  std::vector<bool> is_equal_;  // per group: of sides with equal sums
};

/// Whether there is one row at most between the sides of a ring with corners: in wider ones rows need not meet.
bool is_narrow(const Model& model, const OppositeSides& pair, const std::vector<EdgeCount>& counts) {
  return pair.width * wish_of(pair, counts) <= narrow * length_of(model, pair);
}

/// Whether a face is at most so many of their intervals wide between two sides.
bool is_within(double intervals, const Model& model, const OppositeSides& pair, const std::vector<EdgeCount>& counts) {
  return width_between(model, pair) * wish_of(pair, counts) <= intervals * length_of(model, pair);
}

/// Whether a face lies between parallel lines, the sides of the pair, and sides that bend.
bool is_prism(const Model& model, const OppositeSides& pair, const OppositeSides& partner) {
  constexpr double parallel = 0.1, alike = 0.9, least_bend = 1.01;  // radians; of the longer line; of the chord
  if (pair.first.size() != 1 || pair.second.size() != 1) return false;
  auto chord = [&](int e) {
    const Edge& edge = model.edges[e];
    return model.vertices[edge.end] - model.vertices[edge.start];
  };
  const Vec3 one = chord(pair.first[0]), other = chord(pair.second[0]);
  const double angle = angle_between(one, other);
  const auto [shorter, longer] = std::minmax({norm(one), norm(other)});
  if (std::min(angle, M_PI - angle) > parallel || shorter < alike * longer) return false;
  auto bends = [&](int e) { return model.edges[e].length > least_bend * norm(chord(e)); };
  return std::ranges::none_of(pair.edges(), bends) && std::ranges::all_of(partner.edges(), bends);
}

/// Whether vertices of one side have none of the other one opposite: edges of equal number do not face each other.
bool has_lone_vertices(const Model& model, const OppositeSides& pair) {
  const std::optional<ChainPair> sides = chains_of(model, pair);
  return sides && std::ranges::any_of(breaks_between(model, *sides, width_between(model, pair)), &Break::is_lone);
}

/// Of sides that are single edges, also of those that face one across another thin face.
void find_faced(const std::vector<OppositeSides>& pairs, const std::vector<char>& is_thin,
                const std::vector<EdgeCount>& counts, std::vector<EdgeKind>& kinds) {
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (is_thin[i] == 0 || pairs[i].partner < 0) continue;
      auto raise = [&](const std::vector<int>& side, const std::vector<int>& other) {
        if (side.size() != 1) return;
        int& faced = kinds[side[0]].faced;
        const int by_other = other.size() > 1 ? static_cast<int>(sum_of_counts(other, counts)) : kinds[other[0]].faced;
        has_changed = has_changed || by_other > faced;
        faced = std::max(faced, by_other);
      };
      raise(pairs[i].first, pairs[i].second);
      raise(pairs[i].second, pairs[i].first);
    }
  }
}

}  // namespace

TiedCounts tie_opposite_sides(const Model& model, const std::vector<OppositeSides>& pairs,
                              const std::vector<std::vector<Loop>>& loops, const std::vector<EdgeCount>& counts) {
  std::vector<EdgeKind> kinds(counts.size());
  std::vector<char> is_thin;
  for (const OppositeSides& pair : pairs) {
    is_thin.push_back(is_within(thin, model, pair, counts) ? 1 : 0);
    const bool is_row = pair.partner >= 0 && is_within(narrow, model, pair, counts);
    const bool is_of_prism = pair.partner >= 0 && is_prism(model, pair, pairs[pair.partner]);
    for (int e : pair.edges()) {
      kinds[e].is_of_prism = kinds[e].is_of_prism || is_of_prism;
      kinds[e].is_rim = kinds[e].is_rim || is_row || (pair.partner < 0 && !pair.is_crescent && !pair.is_gap);
      kinds[e].is_of_thin = kinds[e].is_of_thin || is_thin.back() != 0;
    }
  }
  find_faced(pairs, is_thin, counts, kinds);
  Tying tying(counts, kinds);
  for (const std::vector<Loop>& of_face : loops)
    for (const Loop& loop : of_face)
      if (loop.coedges.size() == 1 && counts[loop.coedges[0].edge].count > 0) tying.mark_even(loop.coedges[0].edge);
  std::vector<bool> can_equal;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const OppositeSides& p = pairs[i];
    can_equal.push_back(are_divided(p.edges(), counts) && is_narrow(model, p, counts) && tying.can_equal(p) &&
                        (is_thin[i] != 0 || p.is_moon || !(p.is_crescent || p.is_gap)));
  }
  std::vector<int> order(pairs.size());
  std::iota(order.begin(), order.end(), 0);
  // A long rim must not take a short one away from those beside it.
  auto is_short = [&](const std::vector<int>& side) {
    return std::ranges::all_of(side, [&](int e) { return counts[e].is_short; });
  };
  auto is_unlike = [&](const OppositeSides& pair) { return is_short(pair.first) != is_short(pair.second); };
  std::ranges::stable_sort(order, {}, [&](int i) {
    return std::tuple(is_thin[i] == 0, is_unlike(pairs[i]), -model.faces[pairs[i].face].area);
  });
  std::erase_if(order, [&](int i) { return !can_equal[i]; });
  auto makes_grid = [&](int i) { return pairs[i].partner < 0 || can_equal[pairs[i].partner]; };
  for (int i : order) {
    const OppositeSides& pair = pairs[i];
    if (pair.first.size() != pair.second.size() || (is_thin[i] != 0 && has_lone_vertices(model, pair))) continue;
    for (std::size_t k = 0; k < pair.first.size(); ++k)
      tying.join_if_alike(pair.first[k], pair.second[k], makes_grid(i));
  }
  tying.choose_counts();
  for (int i : order)
    if (makes_grid(i)) is_thin[i] != 0 ? tying.equal_shares(model, pairs[i]) : tying.equal_sums(pairs[i]);
  TiedCounts tied = tying.result();
  tied.is_thin = std::move(is_thin);
  return tied;
}

}  // namespace paver
