// In: loops, counts. Out: larger counts.
// Steps, face by face: facets between evenly spaced nodes; for each edge of few intervals the least number of which no
// facet is seen; faces of edges that got more, once more.
#include "boundary/facing/seen_facets.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "base/boxes/box_tree.h"

namespace paver {
namespace {

constexpr double blunt = 140 * M_PI / 180;
constexpr double shorter = 0.7;    // of the facet that is seen
constexpr int most_intervals = 3;  // more would all get shorter for the sake of one place
constexpr int most_more = 3;
constexpr int most_rounds = 4;

/// The chord of an interval, the face to its left.
struct Facet {
  Vec3 a, b;
  Vec3 inward;  // of any length
  int edge = -1;
};

/// The coedge's edge in `n` intervals.
std::vector<Facet> facets_of(const Model& model, const Face& face, const Coedge& coedge, int n) {
  const Edge& edge = edge_of(model, coedge);
  auto parameter = [&](double i) { return edge.parameter((coedge.is_reversed ? n - i : i) / n); };
  std::vector<Facet> facets;
  for (int i = 0; i < n; ++i) {
    const Vec3 a = edge.curve->point(parameter(i)), b = edge.curve->point(parameter(i + 1));
    const auto [x, xu, xv] = face.surface->slope(coedge.pcurve->uv(parameter(i + 0.5)));
    facets.push_back({a, b, cross(cross(xu, xv), b - a), coedge.edge});
  }
  return facets;
}

class Border {
 public:
  Border(const Model& model, const Face& face, const std::vector<Loop>& loops, const std::vector<EdgeCount>& counts) {
    for (const Loop& loop : loops) {
      const std::size_t first = facets_.size();
      for (const Coedge& coedge : loop.coedges)
        std::ranges::move(facets_of(model, face, coedge, counts[coedge.edge].count), std::back_inserter(facets_));
      for (std::size_t i = first; i < facets_.size(); ++i) {
        const Facet &here = facets_[i], &before = i > first ? facets_[i - 1] : facets_.back();
        nodes_.push_back({here.a, std::min(norm(here.b - here.a), norm(before.b - before.a))});
      }
    }
    std::vector<Box> boxes(nodes_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i) boxes[i].add(nodes_[i].x);
    tree_ = BoxTree(std::move(boxes));
  }

  /// By a node that nothing hides.
  bool sees(const Facet& facet) const {
    const double length = norm(facet.b - facet.a);
    Box near;
    near.add(facet.a), near.add(facet.b);
    bool is_seen = false;
    tree_.each_meeting(near.grown(0.5 * length / std::tan(0.5 * blunt)), [&](int i) {
      const auto [x, shortest] = nodes_[i];
      if (is_seen || shortest > shorter * length) return;
      const Vec3 to_a = facet.a - x, to_b = facet.b - x;
      const bool is_in_front = -dot(to_a, facet.inward) > on_facet * length * norm(facet.inward);
      if (is_in_front && dot(to_a, to_b) < std::cos(blunt) * norm(to_a) * norm(to_b)) is_seen = !is_hidden(facet, x);
    });
    return is_seen;
  }

 private:
  static constexpr double on_facet = 1e-9;  // of its length

  struct Node {
    Vec3 x;
    double shortest = 0;  // facet that ends there
  };

  /// Whether a facet of another edge crosses the shortest way there, seen along the normal.
  bool is_hidden(const Facet& facet, Vec3 x) const {
    const Vec3 along = unit(facet.b - facet.a), inward = unit(facet.inward);
    auto flat = [&](Vec3 p) { return Vec2{dot(p - facet.a, along), dot(p - facet.a, inward)}; };
    const Vec2 from = flat(x), way{0, -from.y};
    return std::ranges::any_of(facets_, [&](const Facet& other) {
      if (other.edge == facet.edge) return false;
      const Vec2 a = flat(other.a) - from, b = flat(other.b) - from;
      return cross(way, a) * cross(way, b) < 0 && cross(b - a, a) * cross(b - a, a - way) < 0;
    });
  }

  std::vector<Facet> facets_;
  std::vector<Node> nodes_;
  BoxTree tree_;
};

/// Of a face that can be judged: all its edges are divided and have images on its surface.
bool is_known(const Model& model, int face, const std::vector<Loop>& loops, const std::vector<EdgeCount>& counts) {
  return model.faces[face].surface && std::ranges::all_of(loops, [&](const Loop& loop) {
           return std::ranges::all_of(loop.coedges, [&](const Coedge& coedge) {
             return coedge.pcurve && edge_of(model, coedge).curve && counts[coedge.edge].count > 0;
           });
         });
}

/// Edges of the face that get more.
std::vector<int> divide(const Model& model, int f, const std::vector<Loop>& loops, std::vector<EdgeCount>& counts) {
  std::vector<int> divided;
  if (!is_known(model, f, loops, counts)) return divided;
  const Face& face = model.faces[f];
  const Border border(model, face, loops, counts);
  for (const Coedge& coedge : coedges_of(loops)) {
    EdgeCount& count = counts[coedge.edge];
    auto is_seen = [&](int n) {
      return std::ranges::any_of(facets_of(model, face, coedge, n),
                                 [&](const Facet& facet) { return border.sees(facet); });
    };
    if (count.count > most_intervals) continue;
    int n = count.count;
    while (n <= count.count + most_more && is_seen(n)) ++n;
    if (n == count.count || n > count.count + most_more) continue;
    count.count = count.minimum = n;
    count.wish = std::max(count.wish, static_cast<double>(n));
    divided.push_back(coedge.edge);
  }
  return divided;
}

}  // namespace

void divide_seen_facets(const Model& model, const std::vector<std::vector<Loop>>& loops,
                        std::vector<EdgeCount>& counts) {
  std::set<int> faces;
  for (std::size_t f = 0; f < loops.size(); ++f) faces.insert(static_cast<int>(f));
  for (int round = 0; round < most_rounds; ++round) {
    std::set<int> next;
    for (int f : faces)
      for (int edge : divide(model, f, loops[f], counts))
        next.insert(model.edges[edge].faces.begin(), model.edges[edge].faces.end());
    faces = std::move(next);
  }
}

}  // namespace paver
