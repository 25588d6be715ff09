// Sides of faces by the corners of their loops.
// In: loops. Out: pairs of sides.
// Corners are junctions with an interior angle between 45 and 135 degrees; everywhere else a side runs straight on. One
// loop with four corners: two pairs. Two loops without any: one pair, its edges matched by nearest middles. Two loops
// with equally many, near each other: a pair for each side. One loop about a bent strip: a pair for each straight part;
// about a narrow crescent: its two long sides. More loops: edges whose ends and middles lie close together.
#include "boundary/facing/opposite_sides.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>
#include <tuple>

#include "base/boxes/box_tree.h"
#include "boundary/facing/sides_of_loops.h"

namespace paver {
namespace {

constexpr double many_widths = 4;  // so long are the sides of a thin ring

using Side = std::vector<int>;

double length_of(const Model& model, const Side& side) {
  double length = 0;
  for (int e : side) length += model.edges[e].length;
  return length;
}

/// Sides that run opposite ways round their face, or its loops.
OppositeSides facing(int face, const Side& first, const Side& second, double width) {
  return {face, first, {second.rbegin(), second.rend()}, -1, width};
}

Vec3 middle_of(const Edge& edge) { return edge.curve->point(edge.parameter(0.5)); }

// The second loop's edges in the order in which they lie nearest to the first's; as they are where that is no pairing.
void match_by_middles(const Model& model, OppositeSides& pair) {
  if (pair.first.size() != pair.second.size()) return;
  Side matched;
  for (int e : pair.first) {
    Vec3 middle = middle_of(model.edges[e]);
    auto distance = [&](int other) { return norm(middle_of(model.edges[other]) - middle); };
    matched.push_back(*std::ranges::min_element(pair.second, {}, distance));
  }
  if (std::is_permutation(matched.begin(), matched.end(), pair.second.begin())) pair.second = matched;
}

/// The mean width of a face, by the length of its border.
double width_of(const Model& model, const Face& face, const std::vector<Loop>& loops) {
  double border = 0;
  for (const Coedge& coedge : coedges_of(loops)) border += edge_of(model, coedge).length;
  return face.area / (0.5 * border);
}

/// Each side of the first loop with the one of the second that lies along it. None where that is no pairing, or where a
/// side is not many times as long as the ring is wide.
std::vector<OppositeSides> sides_of_thin_ring(const Model& model, int face, double width, const Sides& one,
                                              const Sides& two) {
  std::vector<OppositeSides> pairs;
  auto middle_of_side = [&](const Side& side) { return middle_of(model.edges[side[side.size() / 2]]); };
  std::set<const Side*> taken;
  for (const Side& side : one) {
    auto distance = [&](const Side& other) { return norm(middle_of_side(other) - middle_of_side(side)); };
    const Side& nearest = *std::ranges::min_element(two, {}, distance);
    const double length = length_of(model, side), other = length_of(model, nearest);
    if (side.size() != nearest.size() || std::min(length, other) < many_widths * width) return {};
    if (!taken.insert(&nearest).second) return {};
    pairs.push_back(facing(face, side, nearest, width));
  }
  return pairs;
}

/// Of the straight parts of a face between two ends and two borders that bend alike; none where it is no such strip.
std::vector<OppositeSides> parts_of_bent_strip(const Model& model, int face, double width, const Loop& loop,
                                               const std::vector<double>& angles) {
  constexpr std::size_t least_parts = 3;    // two parts and an end
  constexpr double widest_end = 2;          // widths
  constexpr double least_alike = 0.5;       // lengths of a part's two sides
  constexpr double most_unlike = M_PI / 6;  // bends of the two borders
  std::vector<Junction> junctions;
  std::vector<double> bends;  // at the start of each side
  for (double angle : angles)
    if (junctions.push_back(junction_of(angle)); junctions.back() != Junction::straight) bends.push_back(angle);
  const Sides sides = chains_of(loop, junctions);
  const std::size_t n = sides.size();
  if (n % 2 != 0 || n / 2 < least_parts) return {};
  auto bend = [&](std::size_t side) { return bends[side % n]; };
  auto is_end = [&](std::size_t side) {
    return bend(side) < M_PI && bend(side + 1) < M_PI && length_of(model, sides[side]) <= widest_end * width;
  };
  auto parts_from = [&](std::size_t end) -> std::vector<OppositeSides> {
    std::vector<OppositeSides> parts;
    for (std::size_t k = 1; k < n / 2; ++k) {
      const std::size_t one = (end + k) % n, other = (end + n - k) % n;
      if (k > 1 && std::fabs(bend(one) + bend(other + 1) - 2 * M_PI) > most_unlike) return {};
      const auto [shorter, longer] = std::minmax({length_of(model, sides[one]), length_of(model, sides[other])});
      if (shorter < std::max(width, least_alike * longer)) return {};
      parts.push_back(facing(face, sides[one], sides[other], width));
    }
    return parts;
  };
  std::vector<OppositeSides> parts;
  for (std::size_t end = 0; parts.empty() && end < n / 2; ++end)
    if (is_end(end) && is_end(end + n / 2)) parts = parts_from(end);
  return parts;
}

/// The two long sides of a narrow crescent, between ends that are sharp corners or short edges; none where it is no
/// such.
std::vector<OppositeSides> sides_of_crescent(const Model& model, int face, double width, const Loop& loop,
                                             const std::vector<double>& angles) {
  constexpr double least_slim = 10;    // widths
  constexpr double longest_end = 2.5;  // widths: the base of a slim triangle has a little more than 2
  constexpr double most_unlike = 0.1;  // of the longer side
  const std::size_t n = angles.size();
  auto is_end_edge = [&](std::size_t i) { return edge_of(model, loop.coedges[i]).length <= longest_end * width; };
  auto is_tip = [&](std::size_t i) { return angles[i] < M_PI / 4 && !is_end_edge(i) && !is_end_edge((i + n - 1) % n); };
  std::size_t first = 0;
  while (first < n && !is_tip(first) && !is_end_edge((first + n - 1) % n)) ++first;
  Sides sides;
  for (std::size_t k = 0; k < n && first < n; ++k) {
    const std::size_t i = (first + k) % n;
    if (is_end_edge(i)) continue;
    if (k == 0 || is_tip(i) || is_end_edge((i + n - 1) % n)) sides.emplace_back();
    sides.back().push_back(loop.coedges[i].edge);
  }
  if (sides.size() != 2) return {};
  const auto [shorter, longer] = std::minmax({length_of(model, sides[0]), length_of(model, sides[1])});
  if (longer - shorter > most_unlike * longer || shorter < least_slim * width) return {};
  OppositeSides pair = facing(face, sides[0], sides[1], width);
  pair.is_crescent = true;
  return {pair};
}

/// Two loops that touch in a vertex, or all but do in two, from there on; none where they do not.
std::vector<OppositeSides> sides_of_moon(const Model& model, int face, double width, const std::vector<Loop>& loops) {
  constexpr double touching = 0.05, touching_loops = 0.01;  // of the width, and of the shorter loop
  auto start = [&](const Coedge& coedge) { return start_of(edge_of(model, coedge), coedge); };
  auto from = [&](const Loop& loop, std::size_t first) {
    Side side = edges_of(loop);
    std::rotate(side.begin(), side.begin() + static_cast<std::ptrdiff_t>(first), side.end());
    return side;
  };
  const double shorter = std::min(length_of(model, edges_of(loops[0])), length_of(model, edges_of(loops[1])));
  double least = std::min(touching * width, touching_loops * shorter);
  std::vector<Box> starts(loops[1].coedges.size());
  for (std::size_t k = 0; k < starts.size(); ++k) starts[k].add(model.vertices[start(loops[1].coedges[k])]);
  const BoxTree tree(starts);
  std::optional<std::pair<std::size_t, std::size_t>> nearest;
  for (std::size_t i = 0; i < loops[0].coedges.size(); ++i) {
    const int one = start(loops[0].coedges[i]);
    Box about;
    about.add(model.vertices[one]);
    tree.each_meeting(about.grown(least), [&](int k) {
      const int other = start(loops[1].coedges[k]);
      const double apart = one == other ? -1 : norm(model.vertices[one] - model.vertices[other]);
      if (apart < least) least = apart, nearest = {i, k};
    });
    if (least < 0) break;
  }
  if (!nearest) return {};
  OppositeSides pair = facing(face, from(loops[0], nearest->first), from(loops[1], nearest->second), width);
  pair.is_crescent = pair.is_moon = true;
  return {pair};
}

/// An edge as its face sees it.
struct Bank {
  int edge = -1;
  Vec3 start, middle, end;
  Vec3 inward;  // at its middle, of any length
};

std::vector<Bank> banks_of(const Model& model, const Face& face, const std::vector<Loop>& loops) {
  std::vector<Bank> banks;
  for (const Coedge& coedge : coedges_of(loops)) {
    const Edge& edge = edge_of(model, coedge);
    if (!coedge.pcurve || !edge.curve || edge.start == edge.end) continue;
    const double t = edge.parameter(0.5);
    const auto [x, along] = edge.curve->slope(t);
    const auto [at, xu, xv] = face.surface->slope(coedge.pcurve->uv(t));
    banks.push_back({coedge.edge, model.vertices[edge.start], x, model.vertices[edge.end],
                     (coedge.is_reversed ? -1 : 1) * cross(cross(xu, xv), along)});
    if (coedge.is_reversed) std::swap(banks.back().start, banks.back().end);
  }
  return banks;
}

/// Edges that lie along each other across a part of the face far narrower than they are long, nearest ones first.
std::vector<OppositeSides> sides_of_gaps(const Model& model, int face, const std::vector<Loop>& loops) {
  constexpr double widest = 0.2;       // lengths
  constexpr double most_unlike = 0.1;  // of the longer one
  if (!model.faces[face].surface) return {};
  const std::vector<Bank> banks = banks_of(model, model.faces[face], loops);
  std::vector<Box> middles(banks.size());
  for (std::size_t i = 0; i < banks.size(); ++i) middles[i].add(banks[i].middle);
  const BoxTree tree(middles);
  std::vector<OppositeSides> found;
  for (std::size_t i = 0; i < banks.size(); ++i) {
    const Bank& one = banks[i];
    const double length = model.edges[one.edge].length;
    tree.each_meeting(middles[i].grown(widest * length), [&](int k) {
      const Bank& other = banks[k];
      const double other_length = model.edges[other.edge].length;
      if (static_cast<std::size_t>(k) <= i || other.edge == one.edge) return;
      if (std::fabs(length - other_length) > most_unlike * std::max(length, other_length)) return;
      const Vec3 across = other.middle - one.middle;
      if (dot(across, one.inward) <= 0 || dot(across, other.inward) >= 0) return;
      const double width = std::max({norm(other.end - one.start), norm(across), norm(other.start - one.end)});
      if (width > widest * std::min(length, other_length)) return;
      found.push_back({face, {one.edge}, {other.edge}, -1, width});
      found.back().is_gap = true;
    });
  }
  auto key = [](const OppositeSides& pair) { return std::tuple(pair.width, pair.first[0], pair.second[0]); };
  std::ranges::sort(found, {}, key);
  std::set<int> taken;
  std::erase_if(found, [&](const OppositeSides& pair) {
    if (taken.contains(pair.first[0]) || taken.contains(pair.second[0])) return true;
    taken.insert({pair.first[0], pair.second[0]});
    return false;
  });
  return found;
}

/// Of a face with one or two loops.
void add_sides(const Model& model, int face, const std::vector<Loop>& loops, std::vector<OppositeSides>& pairs) {
  std::vector<Sides> sides;
  std::vector<double> angles;
  for (const Loop& loop : loops) {
    angles = angles_of(model, model.faces[face], loop);
    if (auto found = sides_of(loop, angles, loops.size() == 2)) sides.push_back(*found);
  }
  const double width = width_of(model, model.faces[face], loops);
  if (loops.size() == 1 && !sides.empty() && sides[0].size() == 4) {
    const int place = static_cast<int>(pairs.size());
    for (std::size_t k : {0u, 1u}) {
      pairs.push_back(facing(face, sides[0][k], sides[0][k + 2], 0));
      pairs.back().partner = place + (k == 0 ? 1 : 0);
    }
  } else if (loops.size() == 1) {
    std::vector<OppositeSides> found = parts_of_bent_strip(model, face, width, loops[0], angles);
    if (found.empty()) found = sides_of_crescent(model, face, width, loops[0], angles);
    std::ranges::move(found, std::back_inserter(pairs));
  } else if (sides.size() == 2 && sides[0].size() == 1 && sides[1].size() == 1) {
    std::vector<OppositeSides> moon = sides_of_moon(model, face, width, loops);
    if (moon.empty()) {
      pairs.push_back({face, sides[0][0], sides[1][0], -1});
      match_by_middles(model, pairs.back());
    }
    std::ranges::move(moon, std::back_inserter(pairs));
  } else if (sides.size() == 2 && sides[0].size() == sides[1].size()) {
    std::ranges::move(sides_of_thin_ring(model, face, width, sides[0], sides[1]), std::back_inserter(pairs));
  }
}

}  // namespace

double length_of(const Model& model, const OppositeSides& pair) {
  return length_of(model, pair.first) + length_of(model, pair.second);
}

double width_between(const Model& model, const OppositeSides& pair) {
  return pair.is_gap ? pair.width : 2 * model.faces[pair.face].area / length_of(model, pair);
}

std::vector<OppositeSides> find_opposite_sides(const Model& model, const std::vector<std::vector<Loop>>& loops) {
  std::vector<OppositeSides> pairs;
  for (std::size_t f = 0; f < loops.size(); ++f) {
    const int face = static_cast<int>(f);
    const std::size_t before = pairs.size();
    if (!loops[f].empty() && loops[f].size() <= 2) add_sides(model, face, loops[f], pairs);
    if (pairs.size() == before || pairs.back().is_moon)
      std::ranges::move(sides_of_gaps(model, face, loops[f]), std::back_inserter(pairs));
  }
  return pairs;
}

}  // namespace paver
