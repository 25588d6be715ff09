// Sides of faces by the corners of their loops.
// In: loops. Out: pairs of sides.
// Corners are junctions with an interior angle between 45 and 135 degrees; everywhere else a side runs straight on. One
// loop with four corners: two pairs. Two loops without any: one pair, its edges matched by nearest middles. Two loops
// with equally many, near each other: a pair for each side. One loop about a bent strip: a pair for each straight part;
// about a narrow crescent: its two long sides.
#include "boundary/facing/opposite_sides.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "boundary/facing/sides_of_loops.h"

namespace paver {
namespace {

constexpr double many_widths = 4;  // so long are the sides of a thin ring

Vec3 middle_of(const Edge& edge) { return edge.curve->point(0.5 * (edge.t0 + edge.t1)); }

// The second loop's edges in the order in which they lie nearest to the first's; as they are where that is no pairing.
void match_by_middles(const Model& model, OppositeSides& pair) {
  if (pair.first.size() != pair.second.size()) return;
  std::vector<int> matched;
  for (int e : pair.first) {
    Vec3 middle = middle_of(model.edges[e]);
    auto distance = [&](int other) { return norm(middle_of(model.edges[other]) - middle); };
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
  for (const Coedge& coedge : coedges_of(loops)) border += edge_of(model, coedge).length;
  return face.area / (0.5 * border);
}

/// Each side of the first loop with the one of the second that lies along it. None where that is no pairing, or where a
/// side is not many times as long as the ring is wide.
std::vector<OppositeSides> sides_of_thin_ring(const Model& model, int face, double width, const Sides& one,
                                              const Sides& two) {
  std::vector<OppositeSides> pairs;
  auto middle_of_side = [&](const std::vector<int>& side) { return middle_of(model.edges[side[side.size() / 2]]); };
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

/// A face between two ends and two borders that bend alike.
class BentStrip {
 public:
  BentStrip(const Model& model, int face, double width, const Loop& loop, const std::vector<double>& angles)
      : model_(model), face_(face), width_(width) {
    std::vector<Junction> junctions;
    for (double angle : angles) junctions.push_back(junction_of(angle));
    const std::size_t first = first_bend(junctions);
    sides_ = chains_of(loop, first, junctions);
    for (std::size_t k = 0, n = angles.size(); k < n; ++k)
      if (const std::size_t i = (first + k) % n; junctions[i] != Junction::straight) angles_.push_back(angles[i]);
  }

  /// Of its straight parts; none where it is no such strip.
  std::vector<OppositeSides> pairs() const {
    std::vector<OppositeSides> result;
    const std::size_t half = sides_.size() / 2;
    if (sides_.size() % 2 != 0 || half < least_parts) return {};
    for (std::size_t end = 0; result.empty() && end < half; ++end)
      if (is_end(end) && is_end(end + half)) result = pairs_from(end);
    return result;
  }

 private:
  static constexpr std::size_t least_parts = 3;    // two parts and an end
  static constexpr double widest_end = 2;          // widths
  static constexpr double least_alike = 0.5;       // lengths of a part's two sides
  static constexpr double most_unlike = M_PI / 6;  // bends of the two borders

  double angle(std::size_t side) const { return angles_[side % angles_.size()]; }

  bool is_end(std::size_t side) const {
    return angle(side) < M_PI && angle(side + 1) < M_PI && length_of(model_, sides_[side]) <= widest_end * width_;
  }

  std::vector<OppositeSides> pairs_from(std::size_t end) const {
    const std::size_t n = sides_.size();
    std::vector<OppositeSides> result;
    for (std::size_t k = 1; k < n / 2; ++k) {
      const std::size_t one = (end + k) % n, other = (end + n - k) % n;
      if (k > 1 && std::fabs(angle(one) + angle(other + 1) - 2 * M_PI) > most_unlike) return {};
      const auto [shorter, longer] = std::minmax({length_of(model_, sides_[one]), length_of(model_, sides_[other])});
      if (shorter < std::max(width_, least_alike * longer)) return {};
      result.push_back({face_, sides_[one], sides_[other], -1, width_});
      std::reverse(result.back().second.begin(), result.back().second.end());
    }
    return result;
  }

  const Model& model_;
  const int face_;
  const double width_;
  Sides sides_;                 // between bends
  std::vector<double> angles_;  // at the start of each
};

/// The two long sides of a narrow crescent, between ends that are sharp corners or short edges; none where it is no
/// such.
std::vector<OppositeSides> sides_of_crescent(const Model& model, int face, double width, const Loop& loop,
                                             const std::vector<double>& angles) {
  constexpr double least_slim = 10;    // widths
  constexpr double longest_end = 2;    // widths
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
  std::ranges::reverse(sides[1]);
  return {{face, sides[0], sides[1], -1, width, true}};
}

}  // namespace

double length_of(const Model& model, const std::vector<int>& side) {
  double length = 0;
  for (int e : side) length += model.edges[e].length;
  return length;
}

std::vector<OppositeSides> find_opposite_sides(const Model& model, const std::vector<std::vector<Loop>>& loops) {
  std::vector<OppositeSides> pairs;
  for (std::size_t f = 0; f < loops.size(); ++f) {
    if (loops[f].empty() || loops[f].size() > 2) continue;
    const int face = static_cast<int>(f);
    std::vector<Sides> sides;
    std::vector<double> angles;
    for (const Loop& loop : loops[f]) {
      angles = angles_of(model, model.faces[f], loop);
      if (auto found = sides_of(loop, angles, loops[f].size() == 2)) sides.push_back(*found);
    }
    const double width = width_of(model, model.faces[f], loops[f]);
    if (loops[f].size() == 1 && (sides.empty() || sides[0].size() != 4)) {
      std::vector<OppositeSides> found = BentStrip(model, face, width, loops[f][0], angles).pairs();
      if (found.empty()) found = sides_of_crescent(model, face, width, loops[f][0], angles);
      std::ranges::move(found, std::back_inserter(pairs));
    }
    if (sides.size() != loops[f].size()) continue;
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
      std::ranges::move(sides_of_thin_ring(model, face, width, sides[0], sides[1]), std::back_inserter(pairs));
    }
  }
  return pairs;
}

}  // namespace paver
