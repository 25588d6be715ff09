// In: region. Out: pairs of facets.
// Steps: nodes; pairs of facets whose boxes meet; these by exact orientation tests.
#include "regions/crossing_facets.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "base/boxes/box_pairs.h"
#include "base/predicates.h"
#include "base/segment.h"

namespace paver {
namespace {

constexpr double no_angle = 1e-10;  // radians, between facets from one node
constexpr double one_node = 1e-9;   // of the facets there: the same node of the boundary stage this near is one

struct Segment {
  LoopFacet facet;
  int a, b;  // nodes
  int edge;
};

class FacetPairs {
 public:
  explicit FacetPairs(const Region& region) {
    LoopNodes nodes = number_loop_nodes(region);
    at_ = std::move(nodes.at);
    for (std::size_t l = 0; l < region.loops.size(); ++l) add_loop(nodes.of_loop[l], &region.loops[l]);
    for (const Fan& fan : region.fans) {
      std::vector<int> ring;
      for (const LoopNode& node : fan.ring) {
        ring.push_back(static_cast<int>(at_.size()));
        at_.push_back(node.p);
      }
      add_loop(ring, nullptr);
    }
  }

  std::vector<std::array<LoopFacet, 2>> find(std::size_t most) const {
    std::vector<std::array<LoopFacet, 2>> found;
    for_meeting(boxes_, [&](int i, int j) {
      const Segment &s = segments_[std::min(i, j)], &t = segments_[std::max(i, j)];
      if (has_trouble(s, t)) found.push_back({s.facet, t.facet});
      return found.size() < most;
    });
    std::sort(found.begin(), found.end());
    return found;
  }

 private:
  void add_loop(const std::vector<int>& nodes, const std::vector<LoopNode>* edges) {
    for (std::size_t i = 0, n = nodes.size(); i < n; ++i) {
      const Segment s{{loops_, static_cast<int>(i)}, nodes[i], nodes[(i + 1) % n], edges ? (*edges)[i].edge : -1};
      segments_.push_back(s);
      Box& box = boxes_.emplace_back();
      box.add(at_[s.a]);
      box.add(at_[s.b]);
    }
    ++loops_;
  }

  bool has_trouble(const Segment& s, const Segment& t) const {
    if (s.a == t.a && s.b == t.b) return true;
    if (s.a == t.b && s.b == t.a) return s.edge != t.edge;
    if (s.a == t.a) return overlaps(s.a, s.b, t.b);
    if (s.a == t.b) return overlaps(s.a, s.b, t.a);
    if (s.b == t.a) return overlaps(s.b, s.a, t.b);
    if (s.b == t.b) return overlaps(s.b, s.a, t.a);
    auto side = [&](int a, int b, int c) { return side_of_line(at_[a], at_[b], at_[c]); };
    // In line with each other their boxes, which meet, tell.
    return side(s.a, s.b, t.a) * side(s.a, s.b, t.b) <= 0 && side(t.a, t.b, s.a) * side(t.a, t.b, s.b) <= 0;
  }

  // Facets from one node to two others lie on one another, or so nearly that an element between them has no area. The
  // sides of a slit are farther apart.
  bool overlaps(int node, int one, int other) const {
    const Vec2 o = at_[node], a = at_[one] - o, b = at_[other] - o;
    return std::abs(orientation(o, at_[one], at_[other])) <= no_angle * norm(a) * norm(b) && dot(a, b) > 0;
  }

  std::vector<Vec2> at_;
  std::vector<Segment> segments_;  // in the order of their facets
  std::vector<Box> boxes_;         // of them
  int loops_ = 0;
};

// By how many facets a ray from p meets, and the one nearest to p.
std::optional<LoopFacet> facet_that_cuts_off(const Region& region, Vec2 p) {
  bool is_inside = false;
  double least = INFINITY;
  LoopFacet nearest;
  for (std::size_t l = 0; l < region.loops.size(); ++l)
    for (std::size_t i = 0, n = region.loops[l].size(); i < n; ++i) {
      const Vec2 a = region.loops[l][i].p, b = region.loops[l][(i + 1) % n].p;
      if ((a.y > p.y) != (b.y > p.y) && (orientation(a, b, p) > 0) == (b.y > a.y)) is_inside = !is_inside;
      const double away = norm(a + nearest_share(p, a, b) * (b - a) - p);
      if (away < least) least = away, nearest = {static_cast<int>(l), static_cast<int>(i)};
    }
  return is_inside || nearest.loop < 0 ? std::nullopt : std::optional(nearest);
}

}  // namespace

LoopNodes number_loop_nodes(const Region& region) {
  LoopNodes nodes;
  std::map<int, std::vector<int>> made;
  for (const auto& loop : region.loops) {
    std::vector<int>& numbers = nodes.of_loop.emplace_back();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const double near = one_node * shorter_facet(loop, i);
      int node = -1;
      for (int other : made[loop[i].global])
        if (norm(nodes.at[other] - loop[i].p) <= near) node = other;
      if (node < 0) {
        node = static_cast<int>(nodes.at.size());
        nodes.at.push_back(loop[i].p);
        made[loop[i].global].push_back(node);
      }
      numbers.push_back(node);
    }
  }
  return nodes;
}

double shorter_facet(const std::vector<LoopNode>& loop, std::size_t place) {
  const std::size_t n = loop.size();
  const Vec2 at = loop[place].p;
  return std::min(norm(loop[(place + 1) % n].p - at), norm(loop[(place + n - 1) % n].p - at));
}

std::vector<std::array<LoopFacet, 2>> crossing_facets(const Region& region, std::size_t most) {
  auto pairs = FacetPairs(region).find(most);
  for (std::size_t f = 0; f < region.fans.size() && pairs.size() < most; ++f)
    if (auto facet = facet_that_cuts_off(region, region.fans[f].centre.p))
      pairs.push_back({*facet, {static_cast<int>(region.loops.size() + f), 0}});
  return pairs;
}

}  // namespace paver
