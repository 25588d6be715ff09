// In: loops of a region. Out: quads about small round holes, loops of what is left.
// From a hole far smaller than the target length lengths grow by as much per row as it has columns. Rows of the front,
// which grow by the gradation, put nodes in that later ones have to take out again, most where the other loops are of a
// few long facets. Steps: holes; the room of each; rings, until columns are as wide as the target length or the room
// ends.
#include "paving/closing/hole_rings.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/boxes/nearest_segment.h"
#include "base/predicates.h"

namespace paver {
namespace {

constexpr std::size_t fewest_columns = 6, most_columns = 16;
constexpr double short_facets = 0.4;  // of the target length: from here on rings are laid
constexpr double wide_enough = 0.7;   // the same, turns counted: from here on not any more
constexpr double room = 0.5;          // of the distance from a hole's middle to other loops
constexpr double roundest = 1.5;      // the most by which distances from the middle, and angles between columns, differ
constexpr double round_off = 0.5;     // so much of what a ring is out of round the next one is
constexpr double most_turn = M_PI / 6;  // of the surface, from the middle on
constexpr int corrections = 4;

/// Each loop a group.
NearestSegment facets_of(const RegionMesh& mesh, const std::vector<std::vector<int>>& loops) {
  std::vector<std::vector<Segment>> facets(loops.size());
  for (std::size_t l = 0; l < loops.size(); ++l)
    for (std::size_t i = 0, n = loops[l].size(); i < n; ++i)
      facets[l].push_back({mesh.x[loops[l][i]], mesh.x[loops[l][(i + 1) % n]]});
  return {facets, 1};
}

class HoleRings {
 public:
  HoleRings(const Region& region, RegionMesh& mesh, const std::vector<int>& loop)
      : region_(region), mesh_(mesh), ring_(loop) {}

  bool is_wanted() { return is_small() && is_round(); }

  /// Nodes of the outermost one. `to_others`: distance from the middle to other loops.
  std::vector<int> run(double to_others) {
    const double end = room * std::min(to_others, distance_to_fans());
    while (relative_width() < wide_enough) {
      const double next = radius_ * (1 + 2 * M_PI / static_cast<double>(ring_.size()));
      if (next > end || !lay(next)) break;
    }
    return ring_;
  }

  Vec3 middle() const { return at_middle_.x; }

 private:
  /// A loop of few facets that the region lies about, all of them short.
  bool is_small() const {
    if (ring_.size() < fewest_columns || ring_.size() > most_columns) return false;
    double area = 0;
    for (std::size_t i = 0; i < ring_.size(); ++i) area += cross(mesh_.p[ring_[i]], mesh_.p[after(i)]);
    return area < 0 && widest_facet() < short_facets * region_.target(mesh_.p[ring_[0]]);
  }

  int after(std::size_t i) const { return ring_[(i + 1) % ring_.size()]; }

  double widest_facet() const {
    double most = 0;
    for (std::size_t i = 0; i < ring_.size(); ++i) most = std::max(most, norm(mesh_.x[after(i)] - mesh_.x[ring_[i]]));
    return most;
  }

  /// Target lengths from column to column, in the mean.
  double relative_width() const {
    double sum = 0;
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      const Vec3 way = mesh_.x[after(i)] - mesh_.x[ring_[i]];
      const double turn = mesh_.turn_weight * angle_between(mesh_.normal(ring_[i]), mesh_.normal(after(i)));
      const double length = norm(way) / region_.target(mesh_.p[ring_[i]]);
      sum += std::sqrt(length * length + turn * turn);
    }
    return sum / static_cast<double>(ring_.size());
  }

  /// Seen from the middle, in the chart and in space.
  bool is_round() {
    const double share = 1.0 / static_cast<double>(ring_.size());
    for (int node : ring_) middle_ = middle_ + share * mesh_.p[node];
    if (region_.goes_round && dot(middle_, middle_) == 0) return false;
    at_middle_ = region_.place(middle_);
    double least = INFINITY, most = 0, turned = 0;
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      const Vec2 a = mesh_.p[ring_[i]] - middle_, b = mesh_.p[after(i)] - middle_;
      const double angle = -std::atan2(cross(a, b), dot(a, b)), even = 2 * M_PI * share;
      if (angle < even / roundest || angle > even * roundest) return false;
      turned += angle;
      const double away = norm(mesh_.x[ring_[i]] - at_middle_.x);
      least = std::min(least, away), most = std::max(most, away), radius_ += share * away;
      out_of_round_.push_back(away);
    }
    for (double& value : out_of_round_) value = value / radius_ - 1;
    return most <= roundest * least && turned < 3 * M_PI;
  }

  double distance_to_fans() const {
    double least = INFINITY;
    for (const Fan& fan : region_.fans)
      for (const LoopNode& node : fan.ring) least = std::min(least, norm(node.x - at_middle_.x));
    return least;
  }

  /// Where a column is so far from the middle in space.
  Vec2 column_at(std::size_t i, double distance) const {
    const Vec2 way = mesh_.p[ring_[i]] - middle_;
    double share = distance / norm(mesh_.x[ring_[i]] - at_middle_.x);
    for (int k = 0; k < corrections; ++k) share *= distance / norm(region_.point(middle_ + share * way) - at_middle_.x);
    return middle_ + share * way;
  }

  /// The next ring; false where it would fold, or the surface turns away.
  bool lay(double radius) {
    std::vector<Vec2> places;
    std::vector<NodePlace> nodes;
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      out_of_round_[i] *= round_off;
      places.push_back(column_at(i, radius * (1 + out_of_round_[i])));
      nodes.push_back(region_.place(places[i]));
      if (angle_between(cross(nodes[i].xp, nodes[i].xq), cross(at_middle_.xp, at_middle_.xq)) > most_turn) return false;
    }
    const std::size_t n = ring_.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Vec2 corner[] = {mesh_.p[ring_[i]], mesh_.p[after(i)], places[(i + 1) % n], places[i]};
      for (std::size_t k = 0; k < 4; ++k)
        if (!(orientation(corner[k], corner[(k + 1) % 4], corner[(k + 2) % 4]) > 0)) return false;
    }
    std::vector<int> outer;
    const double h = 2 * M_PI * radius / static_cast<double>(n);
    for (std::size_t i = 0; i < n; ++i)
      outer.push_back(mesh_.add_node(nodes[i], std::min(h, region_.target(places[i]))));
    for (std::size_t i = 0; i < n; ++i) mesh_.add_element({ring_[i], after(i), outer[(i + 1) % n], outer[i]});
    ring_ = std::move(outer);
    radius_ = radius;
    return true;
  }

  const Region& region_;
  RegionMesh& mesh_;
  std::vector<int> ring_;
  Vec2 middle_;
  NodePlace at_middle_;
  double radius_ = 0;                 // of the ring, in the mean
  std::vector<double> out_of_round_;  // per column, of the radius
};

}  // namespace

void lay_hole_rings(const Region& region, RegionMesh& mesh, std::vector<std::vector<int>>& loops,
                    const std::vector<std::size_t>& holes) {
  if (region.evenness > 1 || loops.size() < 2) return;  // a coarse element becomes many, all of its length
  std::optional<NearestSegment> facets;
  for (std::size_t hole : holes) {
    HoleRings rings(region, mesh, loops[hole]);
    if (!rings.is_wanted()) continue;
    if (!facets) facets = facets_of(mesh, loops);
    loops[hole] = rings.run(facets->least_of_others(rings.middle(), INFINITY, hole));
  }
}

}  // namespace paver
