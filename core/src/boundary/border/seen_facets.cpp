// In: loops, counts. Out: larger counts.
// Steps, face by face: facets between evenly spaced nodes; for each edge of few intervals the least number of which no
// facet is seen; faces of edges that got more, once more.
#include "boundary/border/seen_facets.h"

#include <algorithm>
#include <cmath>

#include "base/boxes/box_tree.h"
#include "boundary/border/border_facets.h"

namespace paver {
namespace {

constexpr double blunt = 140 * M_PI / 180;
constexpr double shorter = 0.7;    // of the facet that is seen
constexpr int most_intervals = 3;  // more would all get shorter for the sake of one place
constexpr int most_more = 3;
constexpr int most_rounds = 4;

class Border {
 public:
  explicit Border(std::vector<BorderFacet> facets) : facets_(std::move(facets)) {
    std::vector<Box> boxes(facets_.size());
    for (std::size_t i = 0; i < facets_.size(); ++i) boxes[i].add(facets_[i].a);
    tree_ = BoxTree(std::move(boxes));
  }

  /// By a node that nothing hides.
  bool sees(const BorderFacet& facet) const {
    const double length = norm(facet.b - facet.a);
    Box near;
    near.add(facet.a), near.add(facet.b);
    bool is_seen = false;
    tree_.each_meeting(near.grown(0.5 * length / std::tan(0.5 * blunt)), [&](int i) {
      if (is_seen || shortest_at(facets_, i) > shorter * length) return;
      const Vec3 x = facets_[i].a;
      const Vec3 to_a = facet.a - x, to_b = facet.b - x;
      const bool is_in_front = -dot(to_a, facet.inward) > on_facet * length;
      if (is_in_front && dot(to_a, to_b) < std::cos(blunt) * norm(to_a) * norm(to_b)) is_seen = !is_hidden(facet, x);
    });
    return is_seen;
  }

 private:
  static constexpr double on_facet = 1e-9;  // of its length

  /// Whether a facet of another edge crosses the shortest way there, seen along the normal.
  bool is_hidden(const BorderFacet& facet, Vec3 x) const {
    const Vec3 along = unit(facet.b - facet.a);
    auto flat = [&](Vec3 p) { return Vec2{dot(p - facet.a, along), dot(p - facet.a, facet.inward)}; };
    const Vec2 from = flat(x), way{0, -from.y};
    return std::ranges::any_of(facets_, [&](const BorderFacet& other) {
      if (other.edge == facet.edge) return false;
      const Vec2 a = flat(other.a) - from, b = flat(other.b) - from;
      return cross(way, a) * cross(way, b) < 0 && cross(b - a, a) * cross(b - a, a - way) < 0;
    });
  }

  std::vector<BorderFacet> facets_;
  BoxTree tree_;
};

/// Edges of the face that get more.
std::vector<int> divide(const Model& model, int f, const std::vector<Loop>& loops, const OppositeShares& opposite,
                        std::vector<EdgeCount>& counts) {
  std::vector<int> divided;
  std::vector<BorderFacet> facets = border_of(model, f, loops, counts, opposite);
  if (facets.empty()) return divided;
  const Border border(std::move(facets));
  for (const Coedge& coedge : coedges_of(loops)) {
    EdgeCount& count = counts[coedge.edge];
    auto is_seen = [&](int n) {
      return std::ranges::any_of(facets_of(model, f, coedge, shares_of({}, n)),
                                 [&](const BorderFacet& facet) { return border.sees(facet); });
    };
    if (count.count > most_intervals || !opposite[coedge.edge].empty()) continue;
    int n = count.count;
    while (n <= count.count + most_more && is_seen(n)) ++n;
    if (n == count.count || n > count.count + most_more) continue;
    raise_to(count, n);
    divided.push_back(coedge.edge);
  }
  return divided;
}

}  // namespace

void divide_seen_facets(const Model& model, const std::vector<std::vector<Loop>>& loops, const OppositeShares& opposite,
                        std::vector<EdgeCount>& counts) {
  divide_in_rounds(model, loops.size(), most_rounds,
                   [&](int f) { return divide(model, f, loops[f], opposite, counts); });
}

}  // namespace paver
