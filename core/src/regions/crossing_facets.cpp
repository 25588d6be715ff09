// In: region. Out: pairs of facets.
// Steps: nodes; a tree of boxes about the facets, halved along the longer side; pairs of boxes that meet, down to pairs
// of facets; these by exact orientation tests.
#include "regions/crossing_facets.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "base/box.h"
#include "base/predicates.h"
#include "base/segment.h"

namespace paver {
namespace {

constexpr double no_angle = 1e-10;  // radians, between facets from one node
constexpr double one_node = 1e-9;   // of the facet: the same node of the boundary stage this near is one node

struct Segment {
  LoopFacet facet;
  int a, b;  // nodes
  int edge;
  Box box;
  Vec3 middle() const { return 0.5 * (box.low + box.high); }
};

class FacetTree {
 public:
  FacetTree(const Region& region, std::size_t most) : most_(most) {
    LoopNodes nodes = number_loop_nodes(region);
    at_ = std::move(nodes.at);
    for (std::size_t l = 0; l < region.loops.size(); ++l)
      add_loop(static_cast<int>(l), nodes.of_loop[l], &region.loops[l]);
    for (const Fan& fan : region.fans) add_ring(fan);
    if (!segments_.empty()) build(0, segments_.size());
  }

  std::vector<std::array<LoopFacet, 2>> pairs() {
    if (!boxes_.empty()) visit_within(0);
    std::sort(found_.begin(), found_.end());
    if (found_.size() > most_) found_.resize(most_);
    return std::move(found_);
  }

 private:
  struct Node {
    Box box;
    std::size_t first, last;  // of segments_
    int low = -1, high = -1;  // halves; -1 at a leaf
  };
  static constexpr std::size_t leaf_size = 4;

  void add_loop(int loop, const std::vector<int>& nodes, const std::vector<LoopNode>* edges) {
    for (std::size_t i = 0, n = nodes.size(); i < n; ++i) {
      Segment s{{loop, static_cast<int>(i)}, nodes[i], nodes[(i + 1) % n], edges ? (*edges)[i].edge : -1, {}};
      s.box.add(at_[s.a]);
      s.box.add(at_[s.b]);
      segments_.push_back(s);
    }
    ++loops_;
  }

  void add_ring(const Fan& fan) {
    std::vector<int> nodes;
    for (const LoopNode& node : fan.ring) {
      nodes.push_back(static_cast<int>(at_.size()));
      at_.push_back(node.p);
    }
    add_loop(loops_, nodes, nullptr);
  }

  int build(std::size_t first, std::size_t last) {
    const int here = static_cast<int>(boxes_.size());
    boxes_.push_back({{}, first, last, -1, -1});
    Box box;
    for (std::size_t i = first; i < last; ++i) box.add(segments_[i].box);
    boxes_[here].box = box;
    auto begin = segments_.begin();
    if (last - first <= leaf_size) {
      std::ranges::sort(begin + static_cast<long>(first), begin + static_cast<long>(last), {}, &Segment::facet);
      return here;
    }
    const bool is_wide = box.high.x - box.low.x > box.high.y - box.low.y;
    auto before = [&](const Segment& s, const Segment& t) {
      const double p = is_wide ? s.middle().x : s.middle().y, q = is_wide ? t.middle().x : t.middle().y;
      return p < q || (p == q && s.facet < t.facet);
    };
    const std::size_t middle = first + (last - first) / 2;
    std::nth_element(begin + static_cast<long>(first), begin + static_cast<long>(middle),
                     begin + static_cast<long>(last), before);
    const int low = build(first, middle), high = build(middle, last);
    boxes_[here].low = low, boxes_[here].high = high;
    return here;
  }

  void visit_within(int node) {
    const Node& n = boxes_[node];
    if (n.low < 0) {
      for (std::size_t i = n.first; i < n.last; ++i)
        for (std::size_t j = n.first; j < i; ++j) test(segments_[i], segments_[j]);
      return;
    }
    visit_within(n.low);
    visit_within(n.high);
    visit_between(n.low, n.high);
  }

  void visit_between(int one, int other) {
    const Node &a = boxes_[one], &b = boxes_[other];
    if (!a.box.meets(b.box) || found_.size() >= most_) return;
    if (a.low < 0 && b.low < 0) {
      for (std::size_t i = a.first; i < a.last; ++i)
        for (std::size_t j = b.first; j < b.last; ++j) test(segments_[i], segments_[j]);
    } else if (b.low < 0 || (a.low >= 0 && a.last - a.first >= b.last - b.first)) {
      visit_between(a.low, other);
      visit_between(a.high, other);
    } else {
      visit_between(one, b.low);
      visit_between(one, b.high);
    }
  }

  void test(const Segment& s, const Segment& t) {
    if (!s.box.meets(t.box) || !has_trouble(s, t)) return;
    found_.push_back(s.facet < t.facet ? std::array{s.facet, t.facet} : std::array{t.facet, s.facet});
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

  const std::size_t most_;
  std::vector<Vec2> at_;
  std::vector<Segment> segments_;
  std::vector<Node> boxes_;
  std::vector<std::array<LoopFacet, 2>> found_;
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
    for (std::size_t i = 0, n = loop.size(); i < n; ++i) {
      int node = -1;
      for (int other : made[loop[i].global])
        if (norm(nodes.at[other] - loop[i].p) <= one_node * norm(loop[(i + 1) % n].p - loop[i].p)) node = other;
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

std::vector<std::array<LoopFacet, 2>> crossing_facets(const Region& region, std::size_t most) {
  auto pairs = FacetTree(region, most).pairs();
  for (std::size_t f = 0; f < region.fans.size() && pairs.size() < most; ++f)
    if (auto facet = facet_that_cuts_off(region, region.fans[f].centre.p))
      pairs.push_back({*facet, {static_cast<int>(region.loops.size() + f), 0}});
  return pairs;
}

}  // namespace paver
