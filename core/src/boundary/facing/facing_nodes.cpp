// Nodes that face vertices across narrow faces.
// In: pairs of sides, nodes of every edge. Out: edges whose nodes move, and where to.
// Steps: narrow faces with as many intervals on either side; nodes inside an edge follow the vertices they face, and
// the nodes of edges that have moved themselves; until nothing moves. Rows across a narrow face join nodes of equal
// number: where a trace ends on one side of a board's thin wall, evenly divided edges beyond lean such rows until they
// are needles. A node moves only until its row leans by half of the width (27 degrees), and so neither side gets
// intervals shorter than both had. Rims of rings likewise.
#include "boundary/facing/facing_nodes.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "boundary/facing/side_chain.h"

namespace paver {
namespace {

constexpr double narrow = 0.7;           // intervals: wider faces are paved, not laid as one row
constexpr double leaning = 0.5;          // of the width: rows may, by 27 degrees
constexpr double exactly = 1e-6;         // of the width: more than rounding
constexpr double bulging = 0.5;          // of the width: chords of circles lie so far off them
constexpr double least_interval = 0.25;  // of the shortest there was on both sides

/// Nodes of a side from its first corner to the last, or of a part of it.
struct Nodes {
  std::vector<double> places;  // distances from the first corner, mm
  std::vector<bool> is_set;    // a vertex, or of an edge that has moved
  double length() const { return places.back() - places.front(); }
  double share(std::size_t i) const { return (places[i] - places.front()) / length(); }
  bool has_set() const { return std::find(is_set.begin() + 1, is_set.end() - 1, true) != is_set.end() - 1; }
  Nodes part(std::size_t from, std::size_t to) const {
    auto cut = [&](const auto& all) { return std::vector(all.begin() + from, all.begin() + to + 1); };
    return {cut(places), cut(is_set)};
  }
};

double shortest(const std::vector<double>& places) {
  double least = INFINITY;
  for (std::size_t i = 1; i < places.size(); ++i) least = std::min(least, places[i] - places[i - 1]);
  return least;
}

/// Of the length, from 0 to 1: where both sides should have their nodes. Where one that is set is; between such as both
/// have them in the mean.
std::vector<double> shared_places(const Nodes& one, const Nodes& other) {
  std::vector<double> shared, mean;
  const bool has_one = one.has_set(), has_both = has_one && other.has_set();
  std::size_t last = 0;
  for (std::size_t i = 0; i < one.places.size(); ++i) {
    mean.push_back(0.5 * (one.share(i) + other.share(i)));
    shared.push_back(one.is_set[i] || (has_one && !has_both) ? one.share(i) : other.share(i));
    if (!has_both || (!one.is_set[i] && !other.is_set[i])) continue;
    for (std::size_t k = last + 1; k < i; ++k)
      shared[k] = shared[last] + (shared[i] - shared[last]) * (mean[k] - mean[last]) / (mean[i] - mean[last]);
    last = i;
  }
  return shared;
}

using Place = std::vector<double>::iterator;

/// Between two nodes that are set on both sides and face each other: moves nodes of both that are not.
void follow_between(const Nodes& one, const Nodes& other, double slack, Place first, Place second) {
  if (!one.has_set() && !other.has_set()) return;
  const std::vector<double> shared = shared_places(one, other);
  auto move = [&](const Nodes& nodes, Place place) {
    for (std::size_t i = 0; i < shared.size(); ++i) {
      const double opposite = nodes.places.front() + shared[i] * nodes.length();
      if (!nodes.is_set[i]) place[i] = std::clamp(place[i], opposite - slack, opposite + slack);
    }
  };
  move(one, first);
  move(other, second);
}

/// Nodes of two rims that begin at vertices which do not face each other. `opposite`: the place on the other rim of
/// what faces the start of the one. Where one rim's node is set the other's goes opposite; between such nodes both are
/// even.
void follow_round(const Nodes& one, const Nodes& other, double opposite, double slack, Place first, Place second) {
  const std::size_t n = one.places.size() - 1;
  const double around = other.length();
  std::size_t from = 0;  // the other rim's node nearest to there
  for (std::size_t i = 1; i <= n; ++i)
    if (std::fabs(other.places[i] - opposite) < std::fabs(other.places[from] - opposite)) from = i;
  auto begin = [&](std::size_t i) { return opposite - (from + i >= n ? around : 0); };
  std::vector<double> turned, shared;
  for (std::size_t i = 0, last = 0; i <= n; ++i) {
    const std::size_t k = (from + i) % n;
    turned.push_back(other.places[k] - begin(i) + (from + i >= 2 * n ? around : 0));
    shared.push_back(one.is_set[i] || !other.is_set[k] ? one.share(i) : turned[i] / around);
    if (!one.is_set[i] && !other.is_set[k]) continue;
    for (std::size_t m = last + 1; m < i; ++m)
      shared[m] =
          shared[last] + (shared[i] - shared[last]) * static_cast<double>(m - last) / static_cast<double>(i - last);
    last = i;
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t k = (from + i) % n;
    const double here = shared[i] * one.length(), there = shared[i] * around;
    if (!one.is_set[i]) first[i] = std::clamp(first[i], here - slack, here + slack);
    if (!other.is_set[k]) second[k] += std::clamp(turned[i], there - slack, there + slack) - turned[i];
  }
}

/// Part by part between nodes that are set on both sides. `is_ring`: parts of any lengths.
void follow_parts(const Nodes& one, const Nodes& other, double slack, bool is_ring, Place first, Place second) {
  for (std::size_t from = 0, to = 1; to < one.places.size(); ++to) {
    if (!one.is_set[to] || !other.is_set[to]) continue;
    const Nodes part = one.part(from, to), opposite = other.part(from, to);
    if (is_ring || are_alike(part.length(), opposite.length()))
      follow_between(part, opposite, slack, first + static_cast<std::ptrdiff_t>(from),
                     second + static_cast<std::ptrdiff_t>(from));
    from = to;
  }
}

class Following {
 public:
  Following(const Model& model, NodeLengths lengths, std::vector<bool> is_placed, const MayMove& may_move,
            const EdgePoint& point)
      : model_(model),
        lengths_(std::move(lengths)),
        may_move_(may_move),
        point_(point),
        is_placed_(std::move(is_placed)) {}

  /// Whether an edge has moved.
  bool follow(const OppositeSides& pair) {
    const bool is_ring = pair.is_crescent ? pair.is_moon : pair.partner < 0;
    const double width = width_between(model_, pair);
    std::optional<ChainPair> chains = is_ring ? facing_rims_of(model_, pair, width) : chains_of(model_, pair);
    const bool is_turned = is_ring && !pair.is_crescent && !chains;
    if (is_turned) chains = rims_of(model_, pair);
    if (!chains || !are_divided(pair)) return false;
    const double opposite = is_turned ? place_opposite(chains->first, chains->second) : 0;
    const Nodes one = nodes_of(chains->first), other = nodes_of(chains->second);
    const std::size_t n = one.places.size();
    if (other.places.size() != n) return false;
    const double shorter = std::min(chains->first.length, chains->second.length),
                 interval = shorter / static_cast<double>(n - 1);
    if (width * static_cast<double>(n - 1) > narrow * shorter) return false;
    const double least = least_interval * std::min(shortest(one.places), shortest(other.places));
    // Chords of rims that bulge by more than that would cross unless their nodes lie exactly opposite.
    const bool is_bent = is_ring && 0.25 * M_PI * interval * interval > bulging * width * shorter;
    const double slack = (is_bent ? exactly : leaning) * width;
    std::vector<double> first = one.places, second = other.places;
    if (pair.is_crescent && chains->first.length > chains->second.length)
      face_across(chains->first, one, chains->second, other, first, second);
    else if (pair.is_crescent)
      face_across(chains->second, other, chains->first, one, second, first);
    else if (is_turned)
      follow_round(one, other, opposite, slack, first.begin(), second.begin());
    else
      follow_parts(one, other, slack, is_ring, first.begin(), second.begin());
    if (shortest(first) < least || shortest(second) < least) return false;
    std::vector<MovedNodes> next;
    add_moved(chains->first, one.places, first, next);
    add_moved(chains->second, other.places, second, next);
    if (next.empty() || !std::ranges::all_of(next, may_move_)) return false;
    for (MovedNodes& edge : next) {
      lengths_[edge.edge] = edge.lengths;
      is_placed_[edge.edge] = true;
      moved.push_back(std::move(edge));
    }
    return true;
  }

  std::vector<MovedNodes> moved;

 private:
  bool are_divided(const OppositeSides& pair) const {
    return std::ranges::all_of(pair.edges(), [&](int e) { return lengths_[e].size() > 1; });
  }

  Vec3 point_at(const SideChain& side, double place) const {
    std::size_t i = 0;
    for (; i + 1 < side.edges.size() && place > model_.edges[side.edges[i]].length; ++i)
      place -= model_.edges[side.edges[i]].length;
    const double whole = lengths_[side.edges[i]].back(), along = std::clamp(place, 0.0, whole);
    return point_(side.edges[i], side.is_against[i] ? whole - along : along);
  }

  /// The place of a side nearest to a point, by steps of Newton's method from a place near it.
  double nearest_place(const SideChain& side, Vec3 target, double place) const {
    constexpr int steps = 8;
    constexpr double about = 1e-4;  // of the side's length, from where its direction is taken
    for (int k = 0; k < steps; ++k) {
      const double before = std::max(place - about * side.length, 0.0),
                   behind = std::min(place + about * side.length, side.length);
      const Vec3 along = (1 / (behind - before)) * (point_at(side, behind) - point_at(side, before));
      place = std::clamp(place + dot(target - point_at(side, place), along), 0.0, side.length);
    }
    return place;
  }

  /// Nodes of the longer side opposite those of the shorter one that are set, unless it has such itself, then nodes of
  /// the shorter side that are not where they are nearest to those of the longer one.
  void face_across(const SideChain& longer, const Nodes& one, const SideChain& shorter, const Nodes& other,
                   std::vector<double>& of_longer, std::vector<double>& of_shorter) const {
    if (!one.has_set() && other.has_set()) stretch(longer, one, shorter, other, of_longer);
    for (std::size_t i = 1; i + 1 < of_shorter.size(); ++i)
      if (!other.is_set[i]) of_shorter[i] = nearest_place(shorter, point_at(longer, of_longer[i]), of_shorter[i]);
  }

  /// The longer side's nodes, in proportion between those that lie opposite set ones of the shorter side.
  void stretch(const SideChain& longer, const Nodes& one, const SideChain& shorter, const Nodes& other,
               std::vector<double>& places) const {
    for (std::size_t from = 0, to = 1; to < places.size(); ++to) {
      if (!other.is_set[to]) continue;
      if (to + 1 < places.size())
        places[to] = nearest_place(longer, point_at(shorter, other.places[to]), other.share(to) * one.length());
      const double scale = (places[to] - places[from]) / (one.places[to] - one.places[from]);
      for (std::size_t i = from + 1; i < to; ++i) places[i] = places[from] + scale * (one.places[i] - one.places[from]);
      from = to;
    }
  }

  /// Where on the other rim lies what faces the start of the one, both running the same way then.
  double place_opposite(const SideChain& one, SideChain& other) const {
    constexpr int samples = 32;
    auto facing = [&](double share) {
      const Vec3 target = point_at(one, share * one.length);
      double best = 0, least = INFINITY;
      for (int i = 0; i < samples; ++i) {
        const double place = other.length * i / samples, away = norm(point_at(other, place) - target);
        if (away < least) best = place, least = away;
      }
      return nearest_place(other, target, best);
    };
    const double start = facing(0);
    if (std::remainder(facing(0.125) - start, other.length) > 0) return start;
    turn_round(other);
    return other.length - start;
  }

  Nodes nodes_of(const SideChain& side) const {
    Nodes nodes{{0}, {true}};
    double before = 0;
    for (std::size_t i = 0; i < side.edges.size(); ++i) {
      const int edge = side.edges[i];
      const std::vector<double>& of_edge = lengths_[edge];
      const double whole = of_edge.back();
      for (std::size_t k = 1, last = of_edge.size() - 1; k <= last; ++k) {
        const double along = side.is_against[i] ? whole - of_edge[last - k] : of_edge[k];
        nodes.places.push_back(before + along);
        nodes.is_set.push_back(k == last || is_placed_[edge]);
      }
      before += whole;
    }
    return nodes;
  }

  void add_moved(const SideChain& side, const std::vector<double>& from, const std::vector<double>& to,
                 std::vector<MovedNodes>& next) const {
    std::size_t first = 0;  // node of the side, at the start of the edge
    for (std::size_t i = 0; i < side.edges.size(); ++i) {
      const int edge = side.edges[i];
      std::vector<double> of_edge = lengths_[edge];
      const std::size_t last = of_edge.size() - 1;
      if (!std::equal(from.begin() + first, from.begin() + first + last, to.begin() + first)) {
        for (std::size_t k = 1; k < last; ++k) {
          const double along = to[first + k] - to[first];
          (side.is_against[i] ? of_edge[last - k] : of_edge[k]) = side.is_against[i] ? of_edge[last] - along : along;
        }
        next.push_back({edge, std::move(of_edge)});
      }
      first += last;
    }
  }

  const Model& model_;
  NodeLengths lengths_;
  const MayMove& may_move_;
  const EdgePoint& point_;
  std::vector<bool> is_placed_;
};

}  // namespace

std::vector<MovedNodes> face_vertices(const Model& model, const std::vector<OppositeSides>& pairs, NodeLengths lengths,
                                      std::vector<bool> is_placed, const MayMove& may_move, const EdgePoint& point) {
  std::vector<const OppositeSides*> open;
  for (const OppositeSides& pair : pairs)
    if (!pair.is_gap && !pair.first.empty() && !pair.second.empty()) open.push_back(&pair);
  Following following(model, std::move(lengths), std::move(is_placed), may_move, point);
  while (std::erase_if(open, [&](const OppositeSides* pair) { return following.follow(*pair); }) > 0) {
  }
  return std::move(following.moved);
}

}  // namespace paver
