// In: loops, sizes, counts. Out: larger counts.
// Steps for gaps, face by face: width by area and length of the border; counts wanted; nodes there, equally far apart
// on each edge; the turn of one loop against the other that brings them nearest; the quads between them; where these
// are bad, counts fitted to the nodes that edges face.
#include "boundary/facing/raise_counts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include "base/search/nearest_turn.h"
#include "boundary/facing/side_chain.h"
#include "boundary/facing/sides_of_loops.h"
#include "quality/metrics.h"
#include "sizing/sample_box.h"

namespace paver {
namespace {

constexpr double shortest_divided = 0.7;   // target lengths
constexpr double narrow_gap = 0.7;         // target lengths
constexpr double largest_ring = 3;         // target lengths: of a face with a gap about a hole
constexpr double most_more = 2.5;          // times the intervals that a loop has
constexpr double most_fitted_more = 4;     // the same, where edges get each as many as what they face asks for
constexpr double most_less = 0.12;         // of its wish: what an edge may lose
constexpr long most_fitted = 32;           // nodes
constexpr double most_more_of_both = 1.4;  // of those wanted
constexpr double least_jacobian = 0.4;     // of the quads between equally spaced nodes
constexpr long most_nodes = 256;
constexpr double largest_bulge = 0.5;  // of the width
constexpr int most_rounds = 8;         // through strips that share sides
constexpr double thin = 0.2;           // intervals: of a face whose vertices face nodes
constexpr int on_lune = 3;             // intervals of either edge
constexpr double most_in_one = 1.5;    // turn limits: from one edge of a lune to the other, across one element

std::vector<int> counts_of(const std::vector<int>& edges, const std::vector<EdgeCount>& counts) {
  std::vector<int> number;
  for (int e : edges) number.push_back(counts[e].count);
  return number;
}

long sum(const std::vector<int>& number) { return std::accumulate(number.begin(), number.end(), 0L); }

/// More where intervals are longest, until these are `total` together.
void raise_to(long total, const Model& model, const std::vector<int>& edges, std::vector<int>& number) {
  const auto interval = [&](std::size_t i) { return model.edges[edges[i]].length / number[i]; };
  for (long have = sum(number); have < total; ++have) {
    std::size_t longest = 0;
    for (std::size_t i = 1; i < number.size(); ++i)
      if (interval(i) > interval(longest)) longest = i;
    ++number[longest];
  }
}

/// The edges get these where they have fewer, and keep them.
void take_counts(const std::vector<int>& edges, const std::vector<int>& number, std::vector<EdgeCount>& counts) {
  for (std::size_t k = 0; k < edges.size(); ++k) raise_to(counts[edges[k]], number[k]);
}

/// All of a face's edges but those of its longest side, where each of them is a side of one interval; else none.
std::vector<int> single_sides(const Sides& sides, const std::vector<EdgeCount>& counts) {
  auto intervals = [&](const std::vector<int>& side) { return sum_of_counts(side, counts); };
  const auto longest = std::ranges::max_element(sides, {}, intervals);
  if (intervals(*longest) < 2) return {};
  std::vector<int> single;
  for (auto side = sides.begin(); side != sides.end(); ++side) {
    if (side == longest) continue;
    if (intervals(*side) != 1) return {};
    single.push_back(*std::ranges::find_if(*side, [&](int e) { return counts[e].count == 1; }));
  }
  return single;
}

/// Where interval i of `count` starts, as the loop goes.
Vec3 node_at(const Model& model, const Coedge& coedge, int i, int count) {
  const Edge& edge = edge_of(model, coedge);
  return edge.curve->point(edge.parameter(static_cast<double>(coedge.is_reversed ? count - i : i) / count));
}

std::vector<Vec3> nodes_on(const Model& model, const Loop& loop, const std::vector<int>& number) {
  std::vector<Vec3> nodes;
  for (std::size_t k = 0; k < number.size(); ++k)
    for (int i = 0; i < number[k]; ++i) nodes.push_back(node_at(model, loop.coedges[k], i, number[k]));
  return nodes;
}

/// Worst scaled Jacobian of the quads between two loops, which run opposite ways.
double quality_between(const std::vector<Vec3>& one, const std::vector<Vec3>& two) {
  const std::size_t n = one.size();
  const std::size_t turn = nearest_turn(n, [&](auto i, auto j) { return two[j] - one[i]; });
  double worst = 1;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    worst = std::min(worst, scaled_jacobian(one[i], one[next], two[(turn + n - next) % n], two[(turn + n - i) % n]));
  }
  return worst;
}

/// Counts of a loop's edges, none below `least`, with as many intervals as there are nodes on the loop that it faces:
/// those by which the worst quad between the two is best. None where that is no good one.
class FacingCounts {
 public:
  FacingCounts(const Model& model, const Loop& loop, const std::vector<int>& least, std::vector<Vec3> facing)
      : model_(model),
        loop_(loop),
        least_(least),
        facing_(std::move(facing)),
        total_(static_cast<int>(facing_.size())) {
    std::ranges::reverse(facing_);
    known_.assign(loop.coedges.size() * facing_.size() * (facing_.size() + 1), NAN);
  }

  std::vector<int> best() {
    auto off = [&](Vec3 x) { return norm(x - node_at(model_, loop_.coedges[0], 0, 1)); };
    const auto nearest = std::ranges::min_element(facing_, {}, off) - facing_.begin();
    for (int turn = -most_turned; turn <= most_turned; ++turn) try_from(static_cast<int>(nearest) + turn);
    return best_;
  }

 private:
  static constexpr int most_turned = 3;  // nodes

  Vec3 facing(int i) const { return facing_[((i % total_) + total_) % total_]; }

  /// Worst of the quads between an edge of `count` intervals and the nodes from `from` on.
  double worst_on(std::size_t k, int from, int count) {
    const int first = ((from % total_) + total_) % total_;
    double& worst = known_[(k * total_ + first) * (total_ + 1) + count];
    if (!std::isnan(worst)) return worst;
    worst = 1;
    for (int i = 0; i < count && worst > worst_; ++i)
      worst = std::min(worst, scaled_jacobian(node_at(model_, loop_.coedges[k], i, count),
                                              node_at(model_, loop_.coedges[k], i + 1, count), facing(first + i + 1),
                                              facing(first + i)));
    return worst;
  }

  /// With the first edge's start opposite node `start`: for every edge and number of nodes passed the best way so far.
  void try_from(int start) {
    const std::size_t edges = loop_.coedges.size();
    std::vector<std::vector<double>> worst(edges + 1, std::vector<double>(total_ + 1, 0));
    std::vector<std::vector<int>> taken(edges + 1, std::vector<int>(total_ + 1, 0));
    worst[0][0] = 1;
    for (std::size_t k = 0; k < edges; ++k)
      for (int passed = 0; passed < total_; ++passed)
        for (int count = least_[k]; worst[k][passed] > worst_ && passed + count <= total_; ++count) {
          const double with = std::min(worst[k][passed], worst_on(k, start + passed, count));
          if (with > worst[k + 1][passed + count])
            worst[k + 1][passed + count] = with, taken[k + 1][passed + count] = count;
        }
    if (worst[edges][total_] <= worst_) return;
    worst_ = worst[edges][total_];
    best_.assign(edges, 0);
    for (int k = static_cast<int>(edges), passed = total_; k > 0; passed -= best_[--k]) best_[k - 1] = taken[k][passed];
  }

  const Model& model_;
  const Loop& loop_;
  const std::vector<int>& least_;
  std::vector<Vec3> facing_;  // in the order of the loop
  const int total_;
  std::vector<double> known_;  // worst_on
  double worst_ = least_jacobian;
  std::vector<int> best_;
};

/// Gives both loops about a gap as many intervals, `total`, the first on its longest edges or, `is_fitted`, where the
/// second asks for them; whether one row of quads between the two is good then.
bool match_loops(const Model& model, const Loop& fewer, const Loop& more, std::vector<int> of_many, long total,
                 bool is_fitted, std::vector<EdgeCount>& counts) {
  const std::vector<int> few = edges_of(fewer), many = edges_of(more);
  std::vector<int> of_few = counts_of(few, counts);
  const double growth = static_cast<double>(total) / static_cast<double>(sum(of_few));
  if (total > (is_fitted ? most_fitted : most_nodes) || growth > (is_fitted ? most_fitted_more : most_more))
    return false;
  raise_to(total, model, many, of_many);
  const std::vector<Vec3> facing = nodes_on(model, more, of_many);
  if (is_fitted)
    of_few = FacingCounts(model, fewer, of_few, facing).best();
  else
    raise_to(total, model, few, of_few);
  if (of_few.empty() || quality_between(nodes_on(model, fewer, of_few), facing) < least_jacobian) return false;
  take_counts(few, of_few, counts);
  take_counts(many, of_many, counts);
  for (std::size_t k = 0; k < many.size(); ++k) {
    EdgeCount& lower = counts[many[k]];
    if (of_many[k] < lower.count) lower.count = of_many[k], lower.wish = std::min(lower.wish, 1.0 * of_many[k]);
  }
  return true;
}

/// With as many as the second loop has, or some more so that the edges of the first get equally many.
bool match_loops(const Model& model, const Loop& fewer, const Loop& more, const std::vector<int>& of_many,
                 std::vector<EdgeCount>& counts) {
  const auto edges = static_cast<long>(fewer.coedges.size());
  const long even = 2 * ((sum(of_many) + 1) / 2), equal = edges * ((even + edges - 1) / edges);
  const bool can_equal = equal % 2 == 0 && static_cast<double>(equal) <= most_more_of_both * static_cast<double>(even);
  auto match = [&](long total, bool is_fitted) {
    return match_loops(model, fewer, more, of_many, total, is_fitted, counts);
  };
  return (can_equal && match(equal, false)) || match(even, false) || match(even, true) ||
         (can_equal && match(equal, true));
}

/// Loops about a gap, by the intervals that they have; an odd one rather loses an interval than that both get more.
void match_loops(const Model& model, const Loop& fewer, const Loop& more, std::vector<EdgeCount>& counts) {
  // Two smooth rims are tied in any case.
  if (fewer.coedges.size() == 1 && more.coedges.size() == 1) return;
  const std::vector<int> many = edges_of(more);
  if (!are_divided(edges_of(fewer), counts) || !are_divided(many, counts)) return;
  const std::vector<int> as_they_are = counts_of(many, counts);
  std::vector<int> lower = as_they_are;
  const auto may_lose = std::ranges::find_if(many, [&](int e) {
    const EdgeCount& edge = counts[e];
    return edge.count > edge.minimum && edge.count - 1 >= (1 - most_less) * edge.wish;
  });
  if (sum(lower) % 2 != 0 && may_lose != many.end()) --lower[may_lose - many.begin()];
  if (!match_loops(model, fewer, more, lower, counts) && lower != as_they_are)
    match_loops(model, fewer, more, as_they_are, counts);
}

/// Largest distance from the chords of `n` intervals that are equal in the parameter to the curve at their middles; of
/// many intervals at some.
double bulge(const Edge& edge, int n) {
  constexpr int most_samples = 64;
  const int step = (n + most_samples - 1) / most_samples;
  double most = 0;
  auto at = [&](double share) { return edge.curve->point(edge.parameter(share)); };
  for (int i = 0; i < n; i += step)
    most = std::max(most, norm(at((i + 0.5) / n) - 0.5 * (at(static_cast<double>(i) / n) + at((i + 1.0) / n))));
  return most;
}

/// Whether a count was raised.
bool match_sides(const Model& model, const OppositeSides& pair, std::vector<EdgeCount>& counts) {
  const long first = sum_of_counts(pair.first, counts), second = sum_of_counts(pair.second, counts);
  if (first == second || !are_divided(pair.edges(), counts)) return false;
  double most = 0;
  for (int e : pair.edges()) most = std::max(most, bulge(model.edges[e], counts[e].count));
  if (most <= largest_bulge * width_between(model, pair)) return false;
  const std::vector<int>& fewer = first < second ? pair.first : pair.second;
  std::vector<int> raised = counts_of(fewer, counts);
  raise_to(std::max(first, second), model, fewer, raised);
  take_counts(fewer, raised, counts);
  return true;
}

/// Of a narrow face, between breaks.
struct Part {
  int first = -1, second = -1;  // edges
  double length = 0;
  int count = 1;
};

std::vector<Part> parts_between(const ChainPair& sides, const std::vector<Break>& breaks) {
  std::vector<Part> parts;
  std::size_t first = 0, second = 0;
  double from = 0;
  for (const Break& at : breaks) {
    parts.push_back({sides.first.edges[first], sides.second.edges[second], at.first - from});
    first += at.is_of_first, second += at.is_of_second, from = at.first;
  }
  return parts;
}

/// Intervals of each part, until edges have as many as they had; `lacking`: per edge, how many more that takes. The
/// longest first, of those that are wanted on both sides.
void divide_parts(std::vector<Part>& parts, std::map<int, int>& lacking) {
  for (const Part& part : parts) --lacking[part.first], --lacking[part.second];
  for (;;) {
    auto need = [&](const Part& part) { return (lacking[part.first] > 0) + (lacking[part.second] > 0); };
    auto key = [&](const Part& part) { return std::pair(need(part), part.length / part.count); };
    const auto next = std::ranges::max_element(parts, {}, key);
    if (need(*next) == 0) return;
    ++next->count, --lacking[next->first], --lacking[next->second];
  }
}

bool match_vertices(const Model& model, const OppositeSides& pair, std::vector<EdgeCount>& counts) {
  if (pair.first.size() < 2 || pair.second.size() < 2 || !are_divided(pair.edges(), counts)) return false;
  const std::optional<ChainPair> sides = chains_of(model, pair);
  const double width = width_between(model, pair);
  const auto intervals = static_cast<double>(sum_of_counts(pair.edges(), counts));
  if (!sides || width * intervals > thin * length_of(model, pair)) return false;
  const std::vector<Break> breaks = breaks_between(model, *sides, width);
  if (std::ranges::none_of(breaks, &Break::is_lone)) return false;
  std::map<int, int> lacking;
  for (int e : pair.edges()) lacking[e] = counts[e].count;
  std::vector<Part> parts = parts_between(*sides, breaks);
  divide_parts(parts, lacking);
  bool is_changed = false;
  for (const auto& [e, missing] : lacking) {
    is_changed = is_changed || missing < 0;
    take_counts({e}, {counts[e].count - missing}, counts);
  }
  return is_changed;
}

/// Of the surface's normal, from the middle of one coedge to that of the other, radians.
double turn_between(const Model& model, const Face& face, const Coedge& one, const Coedge& other) {
  constexpr int steps = 4;
  auto middle_of = [&](const Coedge& coedge) { return coedge.pcurve->uv(edge_of(model, coedge).parameter(0.5)); };
  const Vec2 from = middle_of(one), step = (1.0 / steps) * (middle_of(other) - from);
  auto normal = [&](int i) {
    const auto [x, xu, xv] = face.surface->slope(from + i * step);
    return unit(cross(xu, xv));
  };
  double turn = 0;
  for (int i = 0; i < steps; ++i) {
    const Vec3 a = normal(i), b = normal(i + 1);
    turn += std::atan2(norm(cross(a, b)), dot(a, b));
  }
  return turn;
}

bool is_round_at_a_vertex(const Model& model, const Face& face, const Loop& loop) {
  const std::vector<double> angles = angles_of(model, face, loop);
  return std::ranges::any_of(angles, [](double angle) { return junction_of(angle) == Junction::straight; });
}

/// Matches sides until no count changes, or for the most rounds that are made.
template <class Match>
void in_rounds(const std::vector<OppositeSides>& pairs, Match match) {
  bool is_changed = true;
  for (int round = 0; is_changed && round < most_rounds; ++round) {
    is_changed = false;
    for (const OppositeSides& pair : pairs)
      if (pair.partner >= 0) is_changed = match(pair) || is_changed;
  }
}

}  // namespace

void divide_lunes(const Model& model, double turn_limit, const std::vector<std::vector<Loop>>& loops,
                  std::vector<EdgeCount>& counts) {
  for (std::size_t f = 0; f < loops.size(); ++f) {
    const Face& face = model.faces[f];
    if (!face.surface || loops[f].size() != 1 || loops[f][0].coedges.size() != 2) continue;
    const Coedge &one = loops[f][0].coedges[0], &other = loops[f][0].coedges[1];
    const std::vector<int> edges = edges_of(loops[f][0]);
    if (is_round_at_a_vertex(model, face, loops[f][0])) continue;  // a disc
    if (edges[0] == edges[1] || !are_divided(edges, counts) || !one.pcurve || !other.pcurve) continue;
    if (std::ranges::all_of(edges, [&](int e) { return counts[e].count >= on_lune; })) continue;
    if (turn_between(model, face, one, other) > most_in_one * turn_limit)
      take_counts(edges, {on_lune, on_lune}, counts);
  }
}

void divide_few_sides(const Model& model, const std::vector<std::vector<Loop>>& loops, std::vector<EdgeCount>& counts) {
  for (std::size_t f = 0; f < loops.size(); ++f) {
    if (loops[f].size() != 1) continue;
    const Loop& loop = loops[f][0];
    const std::optional<Sides> sides = sides_of(loop, angles_of(model, model.faces[f], loop), false);
    if (!sides || sides->size() < 2 || sides->size() > 3) continue;
    const std::vector<int> single = single_sides(*sides, counts);
    if (std::ranges::any_of(single, [&](int e) { return counts[e].wish <= shortest_divided; })) continue;
    for (int e : single) want_two(counts[e]);
  }
}

void match_gaps(const Model& model, const SizeField& size, const std::vector<std::vector<Loop>>& loops,
                std::vector<EdgeCount>& counts) {
  auto intervals = [&](const Loop& loop) { return sum_of_counts(edges_of(loop), counts); };
  for (std::size_t f = 0; f < loops.size(); ++f) {
    if (loops[f].size() != 2) continue;
    const bool is_first = intervals(loops[f][0]) < intervals(loops[f][1]);
    const Loop &fewer = loops[f][is_first ? 0 : 1], &more = loops[f][is_first ? 1 : 0];
    // Elsewhere neighbours lose more than the gap wins: 38 triangles more on a model of 5000 elements. So do the walls
    // of bores, whose other rims keep their counts.
    auto is_tube = [&](int face) { return face != static_cast<int>(f) && loops[face].size() == 2; };
    const bool is_of_bore =
        fewer.coedges.size() == 1 && std::ranges::any_of(edge_of(model, fewer.coedges[0]).faces, is_tube);
    const double largest = (is_of_bore ? 1 : largest_ring) * size.face_h[f];
    if (face_extent(model, model.faces[f]) > largest) continue;
    double border = 0;
    for (const Loop* loop : {&fewer, &more})
      for (const Coedge& coedge : loop->coedges) border += edge_of(model, coedge).length;
    if (model.faces[f].area < 0.5 * border * narrow_gap * size.face_h[f]) match_loops(model, fewer, more, counts);
  }
}

void match_vertices(const Model& model, const std::vector<OppositeSides>& pairs, std::vector<EdgeCount>& counts) {
  in_rounds(pairs, [&](const OppositeSides& pair) { return match_vertices(model, pair, counts); });
}

void match_bent_strips(const Model& model, const std::vector<OppositeSides>& pairs, std::vector<EdgeCount>& counts) {
  in_rounds(pairs, [&](const OppositeSides& pair) { return match_sides(model, pair, counts); });
}

}  // namespace paver
