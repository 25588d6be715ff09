// Equal counts on opposite sides, so that such faces can be meshed as grids.
// In: loops, counts. Out: counts.
// Steps: pairs of opposite edges; union of the pairs, most alike first, while a group's counts span one at most;
// each group takes the rounded mean.
#include "boundary/tie_sides.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace paver {
namespace {

constexpr double rounding_slack = 1e-6;               // equal wishes at a half round alike
constexpr double least_corner = 0.7853981633974483;   // 45 degrees
constexpr double largest_corner = 2.356194490192345;  // 135 degrees

const Edge& edge_of(const Model& model, const Coedge& coedge) {
  return model.edges[static_cast<std::size_t>(coedge.edge)];
}

// Direction of travel along the coedge at its start or its end.
Vec3 travel_direction(const Model& model, const Coedge& coedge, bool at_end) {
  const Edge& edge = edge_of(model, coedge);
  Vec3 x, xt;
  edge.curve->d1(at_end != coedge.is_reversed ? edge.t1 : edge.t0, x, xt);
  return unit(coedge.is_reversed ? -1 * xt : xt);
}

bool is_four_sided(const Model& model, const Loop& loop) {
  if (loop.coedges.size() != 4) return false;
  for (std::size_t i = 0; i < 4; ++i) {
    const Coedge &before = loop.coedges[i], &after = loop.coedges[(i + 1) % 4];
    if (before.edge == after.edge || !edge_of(model, before).curve || !edge_of(model, after).curve) return false;
    Vec3 back = -1 * travel_direction(model, before, true), ahead = travel_direction(model, after, false);
    double angle = std::atan2(norm(cross(back, ahead)), dot(back, ahead));
    if (!(angle >= least_corner && angle <= largest_corner)) return false;
  }
  return true;
}

std::vector<std::pair<int, int>> opposite_edges(const Model& model, const std::vector<std::vector<Loop>>& loops) {
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t f = 0; f < loops.size(); ++f) {
    const std::vector<Loop>& of_face = loops[f];
    if (of_face.size() == 1 && is_four_sided(model, of_face[0])) {
      const std::vector<Coedge>& sides = of_face[0].coedges;
      pairs.emplace_back(sides[0].edge, sides[2].edge);
      pairs.emplace_back(sides[1].edge, sides[3].edge);
    }
    bool is_ring = of_face.size() == 2 && of_face[0].coedges.size() == 1 && of_face[1].coedges.size() == 1;
    if (is_ring && model.faces[f].loops.size() == 1) {  // one loop in the face, two without its periodic edge
      pairs.emplace_back(of_face[0].coedges[0].edge, of_face[1].coedges[0].edge);
    }
  }
  return pairs;
}

// Disjoint groups of edges with the span of their counts.
class Groups {
 public:
  explicit Groups(const std::vector<EdgeCount>& counts) : parent_(counts.size()) {
    std::iota(parent_.begin(), parent_.end(), 0);
    for (const EdgeCount& edge : counts) members_.push_back({edge.count, edge.count, edge.minimum, 1, edge.wish});
  }

  int find(int edge) {
    while (parent_[static_cast<std::size_t>(edge)] != edge) {
      int& up = parent_[static_cast<std::size_t>(edge)];
      up = parent_[static_cast<std::size_t>(up)];
      edge = up;
    }
    return edge;
  }

  void join_if_alike(int a, int b) {
    a = find(a);
    b = find(b);
    if (a == b) return;
    if (a > b) std::swap(a, b);
    Members &into = members_[static_cast<std::size_t>(a)], &from = members_[static_cast<std::size_t>(b)];
    Members both{std::min(into.least, from.least), std::max(into.most, from.most), std::max(into.minimum, from.minimum),
                 into.size + from.size, into.wish + from.wish};
    if (both.most - both.least > 1 || both.minimum > both.most) return;
    into = both;
    parent_[static_cast<std::size_t>(b)] = a;
  }

  // Rounded mean wish, kept within the counts its members had.
  int count(int edge) {
    const Members& group = members_[static_cast<std::size_t>(find(edge))];
    double mean = group.wish / group.size;
    int rounded = static_cast<int>(std::min(mean + 0.5 + rounding_slack, 1e8));
    return std::max(std::clamp(rounded, group.least, group.most), group.minimum);
  }

  bool is_tied(int edge) { return members_[static_cast<std::size_t>(find(edge))].size > 1; }

 private:
  struct Members {
    int least, most, minimum, size;
    double wish;
  };
  std::vector<int> parent_;
  std::vector<Members> members_;
};

}  // namespace

void tie_opposite_sides(const Model& model, const std::vector<std::vector<Loop>>& loops,
                        std::vector<EdgeCount>& counts) {
  std::vector<std::tuple<double, int, int>> pairs;  // difference of the wishes, edges
  for (auto [a, b] : opposite_edges(model, loops)) {
    const EdgeCount &first = counts[static_cast<std::size_t>(a)], &second = counts[static_cast<std::size_t>(b)];
    if (a == b || first.count == 0 || second.count == 0) continue;
    pairs.emplace_back(std::abs(first.wish - second.wish), a, b);
  }
  std::sort(pairs.begin(), pairs.end());
  Groups groups(counts);
  for (auto [difference, a, b] : pairs) groups.join_if_alike(a, b);
  for (std::size_t e = 0; e < counts.size(); ++e) {
    if (groups.is_tied(static_cast<int>(e))) counts[e].count = groups.count(static_cast<int>(e));
  }
}

}  // namespace paver
