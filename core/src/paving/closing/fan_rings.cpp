// In: a fan about an apex that the surface turns about. Out: rings of quads about it, each a target length from the
// last. Columns are as many as the turn asks for, however narrow: rows of the front would lean there, for the metric
// hardly sees it. They end where columns are wide enough to be paved, or half way to the next loop.
#include "paving/closing/fan_rings.h"

#include <algorithm>
#include <cmath>

#include "base/segment.h"

namespace paver {
namespace {

constexpr double wide_enough = 1.2;     // target lengths, turns counted, between two columns
constexpr double wide_in_space = 0.75;  // the same where turns do not count by themselves
constexpr double room = 0.45;           // of the distance from the apex to the nearest loop
constexpr int most_rings = 64;
constexpr int corrections = 6;
constexpr double first_growth = 2, most_growth = 1e6;  // of a ring in the chart

class FanRings {
 public:
  FanRings(const Region& region, RegionMesh& mesh, const Fan& fan)
      : region_(region), mesh_(mesh), apex_(fan.centre), nearest_(nearest_node(region, apex_.x)) {
    for (const auto& loop : region.loops)
      for (std::size_t i = 0; i < loop.size(); ++i)
        nearest_in_chart_ =
            std::min(nearest_in_chart_, distance_to_segment(apex_.p, loop[i].p, loop[(i + 1) % loop.size()].p));
  }

  std::vector<int> run(std::vector<int> ring) {
    for (int k = 0; k < most_rings && mean_width(ring) < (mesh_.has_turns() ? wide_enough : wide_in_space); ++k) {
      const double growth = next_ring(ring);
      if (!(growth > 1) || radius(ring, growth) >= nearest_in_chart_ || distance(ring, growth) > room * nearest_) break;
      ring = lay(ring, growth);
    }
    return ring;
  }

 private:
  /// Target lengths between neighbours.
  double mean_width(const std::vector<int>& ring) const {
    double sum = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) sum += mesh_.relative_length(ring[i], ring[(i + 1) % ring.size()]);
    return sum / static_cast<double>(ring.size());
  }

  /// Where a column goes on: as far from the apex in the chart as the others, though corners of the first quads lie
  /// behind.
  Vec2 grown(const std::vector<int>& ring, std::size_t i, double growth) const {
    const Vec2 way = mesh_.p[ring[i]] - apex_.p;
    return apex_.p + (radius(ring, growth) / norm(way)) * way;
  }

  /// In the chart, of the ring that follows.
  double radius(const std::vector<int>& ring, double growth) const { return growth * norm(mesh_.p[ring[0]] - apex_.p); }

  /// From the apex to the ring that follows, at most.
  double distance(const std::vector<int>& ring, double growth) const {
    double most = 0;
    for (std::size_t i = 0; i < ring.size(); ++i)
      most = std::max(most, norm(region_.point(grown(ring, i, growth)) - apex_.x));
    return most;
  }

  /// By how much a ring grows in the chart to be a target length from the last one, in the mean.
  double next_ring(const std::vector<int>& ring) const {
    double growth = first_growth;  // distances are about logarithms of it
    for (int i = 0; i < corrections; ++i) {
      double share = 0;
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vec2 p = grown(ring, k, growth);
        share += norm(region_.point(p) - mesh_.x[ring[k]]) / (0.5 * (mesh_.h[ring[k]] + region_.target(p)));
      }
      share /= static_cast<double>(ring.size());
      if (!(share > 0)) return 0;
      growth = std::clamp(std::pow(growth, 1 / share), 1 + 1e-6, most_growth);
    }
    return growth;
  }

  std::vector<int> lay(const std::vector<int>& ring, double growth) {
    std::vector<int> outer;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      outer.push_back(add_node(region_, grown(ring, i, growth), mesh_));
      mesh_.is_fixed[ring[i]] = 1;
    }
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::size_t k = (i + 1) % ring.size();
      mesh_.add_element({ring[i], outer[i], outer[k], ring[k]});
    }
    return outer;
  }

  const Region& region_;
  RegionMesh& mesh_;
  const LoopNode& apex_;
  const double nearest_;  // loop, from the apex: beyond it the surface may come near the apex again
  double nearest_in_chart_ = INFINITY;
};

}  // namespace

std::vector<int> lay_fan_rings(const Region& region, RegionMesh& mesh, const Fan& fan, std::vector<int> ring) {
  return FanRings(region, mesh, fan).run(std::move(ring));
}

}  // namespace paver
