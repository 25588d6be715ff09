// Sides of faces by the corners of their loops.
// In: loops. Out: pairs of sides.
// Corners are junctions with an interior angle between 45 and 135 degrees; everywhere else a side runs straight on. One
// loop with four corners: two pairs. Two loops without any: one pair, its edges matched by nearest middles. Two loops
// with equally many, near each other: a pair for each side.
#include "boundary/facing/opposite_sides.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "topology/corner_angle.h"

namespace paver {
namespace {

constexpr double least_corner = 0.7853981633974483;    // 45 degrees
constexpr double largest_corner = 2.356194490192345;   // 135 degrees
constexpr double least_straight = 2.6179938779914944;  // 150 degrees; from there to 210 a side runs on

constexpr double many_widths = 4;  // so long are the sides of a thin ring

enum class Junction { corner, reflex, straight, other };

Junction junction_of(double angle) {
  if (angle >= least_corner && angle <= largest_corner) return Junction::corner;
  if (angle >= 2 * M_PI - largest_corner && angle <= 2 * M_PI - least_corner) return Junction::reflex;
  return angle >= least_straight && angle <= 2 * M_PI - least_straight ? Junction::straight : Junction::other;
}

/// Chains of edges between corners, from the first corner on; one chain where there is no corner.
using Sides = std::vector<std::vector<int>>;

/// `has_reflex`: sides end at corners of a hole, too.
std::optional<Sides> sides_of(const Model& model, const Face& face, const Loop& loop, bool has_reflex) {
  const std::size_t n = loop.coedges.size();
  std::vector<Junction> junctions;  // at the start of each coedge
  for (const Coedge& coedge : loop.coedges)
    if (!edge_of(model, coedge).curve) return std::nullopt;
  for (std::size_t i = 0; i < n; ++i) {
    const Coedge &before = loop.coedges[(i + n - 1) % n], &after = loop.coedges[i];
    if (n > 1 && before.edge == after.edge) return std::nullopt;
    junctions.push_back(junction_of(corner_angle(model, face, before, after)));
    if (has_reflex && junctions.back() == Junction::reflex) junctions.back() = Junction::corner;
    if (junctions.back() != Junction::corner && junctions.back() != Junction::straight) return std::nullopt;
  }
  auto first = std::find(junctions.begin(), junctions.end(), Junction::corner);
  std::size_t start = first == junctions.end() ? 0 : static_cast<std::size_t>(first - junctions.begin());
  Sides sides;
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t i = (start + k) % n;
    if (k == 0 || junctions[i] == Junction::corner) sides.emplace_back();
    sides.back().push_back(loop.coedges[i].edge);
  }
  if (first == junctions.end() || sides.size() > 1) return sides;
  return std::nullopt;  // a drop: one corner
}

Vec3 middle_of(const Edge& edge) { return edge.curve->point(0.5 * (edge.t0 + edge.t1)); }

// The second loop's edges in the order in which they lie nearest to the first's; as they are where that is no pairing.
void match_by_middles(const Model& model, OppositeSides& pair) {
  if (pair.first.size() != pair.second.size()) return;
  std::vector<int> matched;
  for (int e : pair.first) {
    Vec3 middle = middle_of(model.edges[static_cast<std::size_t>(e)]);
    auto distance = [&](int other) { return norm(middle_of(model.edges[static_cast<std::size_t>(other)]) - middle); };
    matched.push_back(*std::min_element(pair.second.begin(), pair.second.end(),
                                        [&](int a, int b) { return distance(a) < distance(b); }));
  }
  std::vector<int> sorted = matched, all = pair.second;
  std::sort(sorted.begin(), sorted.end());
  std::sort(all.begin(), all.end());
  if (sorted == all) pair.second = matched;
}

/// The mean width of a face, by the length of its border.
double width_of(const Model& model, const Face& face, const std::vector<Loop>& loops) {
  double border = 0;
  for (const Loop& loop : loops)
    for (const Coedge& coedge : loop.coedges) border += edge_of(model, coedge).length;
  return face.area / (0.5 * border);
}

/// Each side of the first loop with the one of the second that lies along it. None where that is no pairing, or where a
/// side is not many times as long as the ring is wide.
std::vector<OppositeSides> sides_of_thin_ring(const Model& model, int face, double width, const Sides& one,
                                              const Sides& two) {
  std::vector<OppositeSides> pairs;
  auto middle_of_side = [&](const std::vector<int>& side) {
    return middle_of(model.edges[static_cast<std::size_t>(side[side.size() / 2])]);
  };
  std::vector<char> is_taken(two.size(), 0);
  for (const std::vector<int>& side : one) {
    std::size_t nearest = 0;
    auto distance = [&](std::size_t k) { return norm(middle_of_side(two[k]) - middle_of_side(side)); };
    for (std::size_t k = 1; k < two.size(); ++k)
      if (distance(k) < distance(nearest)) nearest = k;
    const double length = length_of(model, side), other = length_of(model, two[nearest]);
    if (is_taken[nearest] || side.size() != two[nearest].size() || std::min(length, other) < many_widths * width)
      return {};
    is_taken[nearest] = 1;
    pairs.push_back({face, side, two[nearest], -1, width});
    std::reverse(pairs.back().second.begin(), pairs.back().second.end());
  }
  return pairs;
}

}  // namespace

double length_of(const Model& model, const std::vector<int>& side) {
  double length = 0;
  for (int e : side) length += model.edges[static_cast<std::size_t>(e)].length;
  return length;
}

std::vector<OppositeSides> find_opposite_sides(const Model& model, const std::vector<std::vector<Loop>>& loops) {
  std::vector<OppositeSides> pairs;
  for (std::size_t f = 0; f < loops.size(); ++f) {
    if (loops[f].empty() || loops[f].size() > 2) continue;
    std::vector<Sides> sides;
    for (const Loop& loop : loops[f])
      if (auto found = sides_of(model, model.faces[f], loop, loops[f].size() == 2)) sides.push_back(*found);
    if (sides.size() != loops[f].size()) continue;
    int face = static_cast<int>(f);
    if (sides.size() == 1 && sides[0].size() == 4) {
      const int place = static_cast<int>(pairs.size());
      for (std::size_t k : {0u, 1u}) {
        OppositeSides pair{face, sides[0][k], sides[0][k + 2], place + (k == 0 ? 1 : 0)};
        std::reverse(pair.second.begin(), pair.second.end());
        pairs.push_back(std::move(pair));
      }
    } else if (sides.size() == 2 && sides[0].size() == 1 && sides[1].size() == 1) {
      pairs.push_back({face, sides[0][0], sides[1][0], -1});
      match_by_middles(model, pairs.back());
    } else if (sides.size() == 2 && sides[0].size() == sides[1].size()) {
      const double width = width_of(model, model.faces[f], loops[f]);
      std::ranges::move(sides_of_thin_ring(model, face, width, sides[0], sides[1]), std::back_inserter(pairs));
    }
  }
  return pairs;
}

}  // namespace paver
