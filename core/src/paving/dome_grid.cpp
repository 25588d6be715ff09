// In: region. Out: its mesh.
// The front of a loop of few nodes may close across the body that the region is the hull of. Steps: rays from the
// middle to the nodes, measured as lengths count turns; rows at equal shares of them; quads about the middle.
#include "paving/dome_grid.h"

#include <algorithm>
#include <cmath>

#include "base/search/nearest_turn.h"

namespace paver {
namespace {

constexpr std::size_t fewest_nodes = 4, most_nodes = 24;
constexpr int most_rows = 24, rows_of_most = 8;
constexpr double longest_row = 1.5;  // target lengths, of rays that would ask for more rows
constexpr int chart_steps = 32;
constexpr std::size_t most_samples = 49;  // of a ray
constexpr double far_corner = 1.25;       // of the way to the fan's other nodes, to those opposite the middle

/// From the middle, straight in the chart, or from a node of another loop, as the chart goes there, to a node of a
/// loop.
class Ray {
 public:
  enum class Way { straight, by_chart };

  Ray(const Region& region, Vec2 from, Vec2 end, DomeRows rows, Way way)
      : chart_(way == Way::by_chart ? region.chart.get() : nullptr),
        from_(from),
        step_(chart_ ? chart_->step_to(from, end) : end - from) {
    const std::vector<Sample> samples = samples_of(region, rows == DomeRows::in_chart);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      shares_.push_back(samples[i].share);
      if (i == 0) continue;
      const double length = norm(samples[i].at.x - samples[i - 1].at.x) / region.h;
      // An apex has no normal: the turn begins behind it.
      const double turn = i > 1 ? region.size.turn_weight() * norm(samples[i].at.n - samples[i - 1].at.n) : 0;
      reached_.push_back(reached_.back() + std::sqrt(length * length + turn * turn));
    }
  }

  /// Target lengths.
  double length() const { return reached_.back(); }

  Vec2 at(double share) const {
    const double wanted = share * length();
    const auto after = std::upper_bound(reached_.begin() + 1, reached_.end() - 1, wanted);
    const double before = *(after - 1), step = *after - before;
    const auto k = static_cast<std::size_t>(after - reached_.begin());
    return point(shares_[k - 1] + (step > 0 ? (wanted - before) / step : 0) * (shares_[k] - shares_[k - 1]));
  }

 private:
  struct Sample {
    double share = 0;
    NodePlace at;
  };

  Vec2 point(double s) const { return chart_ ? chart_->walk(from_, s * step_) : from_ + s * step_; }

  // Steps in polar charts of long bodies lie nearly all near the middle: the longest piece is halved again and again.
  std::vector<Sample> samples_of(const Region& region, bool in_chart) const {
    std::vector<Sample> samples;
    auto sample = [&](double share) { return Sample{share, region.place(point(share))}; };
    const int steps = in_chart ? chart_steps : 2;
    for (int i = 0; i <= steps; ++i) samples.push_back(sample(static_cast<double>(i) / steps));
    while (!in_chart && samples.size() < most_samples) {
      std::size_t longest = 1;
      double most = -1;
      for (std::size_t i = 1; i < samples.size(); ++i)
        if (const double d = norm(samples[i].at.x - samples[i - 1].at.x); d > most * (1 + 1e-9)) most = d, longest = i;
      const double share = 0.5 * (samples[longest - 1].share + samples[longest].share);
      samples.insert(samples.begin() + static_cast<std::ptrdiff_t>(longest), sample(share));
    }
    return samples;
  }

  const Chart* chart_;
  Vec2 from_, step_;
  std::vector<double> shares_, reached_{0};
};

double mean_length(const std::vector<Ray>& rays) {
  double sum = 0;
  for (const Ray& ray : rays) sum += ray.length();
  return sum / static_cast<double>(rays.size());
}

class Dome {
 public:
  Dome(const Region& region, DomeRows rows)
      : region_(region), loop_(region.loops[0]), kind_(rows), middle_(find_middle()) {}

  /// Whether every facet runs counter-clockwise about the middle, all of them once.
  bool is_star() const {
    double turned = 0;
    for (std::size_t i = 0; i < loop_.size(); ++i) {
      const Vec2 a = loop_[i].p - middle_, b = loop_[(i + 1) % loop_.size()].p - middle_;
      const double angle = std::atan2(cross(a, b), dot(a, b));
      if (!(angle > 0)) return false;
      turned += angle;
    }
    return turned < 3 * M_PI;
  }

  std::optional<RegionMesh> lay() {
    mesh_.turn_weight = region_.size.turn_weight();
    for (const LoopNode& node : loop_) rays_.emplace_back(region_, middle_, node.p, kind_, Ray::Way::straight);
    const int rows = count_rows();
    if (mean_length(rays_) > longest_row * (rows + 1)) return std::nullopt;
    std::vector<int> outer;
    for (const LoopNode& node : loop_) outer.push_back(add_node(region_, node, mesh_));
    const bool has_core = loop_.size() == 4 && region_.fans.empty();  // a fan of two quads has no angle in the middle
    for (int row = rows; row > 0; --row)
      outer = add_row(outer, static_cast<double>(row) / (rows + 1), row == 1 && !has_core);
    if (has_core)
      mesh_.add_element({outer[0], outer[1], outer[2], outer[3]});
    else
      add_fan(outer);
    return are_all_positive(mesh_) ? std::optional(std::move(mesh_)) : std::nullopt;
  }

 private:
  Vec2 find_middle() const {
    if (!region_.fans.empty()) return region_.fans[0].centre.p;
    Vec2 middle;
    if (region_.goes_round) return middle;
    for (const LoopNode& node : loop_) middle = middle + (1.0 / static_cast<double>(loop_.size())) * node.p;
    return middle;
  }

  // Fans are a target length wide, one row more and they need none of their own.
  int count_rows() const {
    const long rows = std::clamp(std::lround(mean_length(rays_)) - 1, 1L, long{most_rows});
    if (kind_ == DomeRows::most) return rows_of_most;
    return static_cast<int>(kind_ == DomeRows::many ? 2 * rows + 1 : rows);
  }

  std::vector<int> add_row(const std::vector<int>& outer, double share, bool is_fan) {
    std::vector<int> inner;
    for (std::size_t i = 0; i < outer.size(); ++i) {
      const Vec2 p = rays_[i].at(is_fan && i % 2 == 1 ? far_corner * share : share);
      inner.push_back(add_node(region_, p, mesh_));
    }
    for (std::size_t i = 0; i < outer.size(); ++i) {
      const std::size_t next = (i + 1) % outer.size();
      mesh_.add_element({inner[i], outer[i], outer[next], inner[next]});
    }
    return inner;
  }

  void add_fan(const std::vector<int>& ring) {
    const auto& fans = region_.fans;
    const int middle = fans.empty() ? add_node(region_, middle_, mesh_) : add_node(region_, fans[0].centre, mesh_);
    std::size_t i = 0;
    for (; i + 2 <= ring.size(); i += 2) mesh_.add_element({middle, ring[i], ring[i + 1], ring[(i + 2) % ring.size()]});
    if (i < ring.size()) mesh_.add_element({middle, ring[i], ring[0], -1});
  }

  const Region& region_;
  const std::vector<LoopNode>& loop_;
  const DomeRows kind_;
  const Vec2 middle_;
  std::vector<Ray> rays_;
  RegionMesh mesh_;
};

class Tube {
 public:
  explicit Tube(const Region& region) : region_(region), from_(region.loops[0]), to_(region.loops[1]) {
    const auto gap = [&](auto i, auto j) { return to_[j].p - from_[i].p; };
    shift_ = nearest_turn(from_.size(), gap, 1e-9);
  }

  bool is_prism() const {
    FacingSides sides;
    for (std::size_t i = 0; i <= from_.size(); ++i)
      sides.push_back({&from_[i % from_.size()], &opposite(i % from_.size())});
    return are_sides_of_prism(region_, sides);
  }

  /// Short from rim to rim, and turning by most of half a circle, as a groove: lengths that count turns take these for
  /// less, and rows of the front close across.
  bool is_short_bend() const {
    constexpr double longest = 1.1;  // target lengths: half a circle about 0.7 of one
    constexpr double least_turn = 2 * M_PI / 3;
    constexpr int steps = 8;
    double most_turn = 0;
    for (std::size_t i = 0; i < from_.size(); ++i) {
      const LoopNode &a = from_[i], &b = opposite(i);
      const auto between = [&](double share) { return region_.chart->between(a.p, b.p, share); };
      double length = 0;
      Vec3 last = a.x;
      for (int k = 1; k <= steps; ++k) {
        const Vec3 next = region_.point(between(k / double{steps}));
        length += norm(next - last);
        last = next;
      }
      if (length >= longest * std::min(region_.target(a.p), region_.target(b.p))) return false;
      most_turn = std::max(most_turn, turn_along(region_, between));
    }
    return most_turn > least_turn;
  }

  std::optional<RegionMesh> lay() {
    mesh_.turn_weight = region_.size.turn_weight();
    const std::size_t n = from_.size();
    for (std::size_t i = 0; i < n; ++i)
      rays_.emplace_back(region_, from_[i].p, opposite(i).p, DomeRows::even, Ray::Way::by_chart);
    // Where a pipe bends it turns most along its outer and inner line. Lengths do not count turns closer than a few
    // target lengths.
    double longest = 0;
    for (const Ray& ray : rays_) {
      const double turn = turn_along(region_, [&](double share) { return ray.at(share); });
      longest = std::max({longest, ray.length(), turn / region_.turn_limit});
    }
    int rows = static_cast<int>(std::clamp(std::floor(longest), 1.0, double{most_rows}));
    if (rows < most_rows && longest * longest > rows * (rows + 1)) ++rows;  // as far above a target length as below
    if (longest > longest_row * rows) return std::nullopt;
    std::vector<int> last, next;
    for (int row = 0; row <= rows; ++row, last = std::move(next)) {
      next.clear();
      for (std::size_t i = 0; i < n; ++i) next.push_back(add(i, row, rows));
      for (std::size_t i = 0; row > 0 && i < n; ++i)
        mesh_.add_element({last[i], last[(i + 1) % n], next[(i + 1) % n], next[i]});
    }
    return are_all_positive(mesh_) ? std::optional(std::move(mesh_)) : std::nullopt;
  }

 private:
  /// Loops have the region on their left: they run opposite ways round.
  const LoopNode& opposite(std::size_t i) const {
    const std::size_t n = to_.size();
    return to_[(shift_ + n - i) % n];
  }

  int add(std::size_t i, int row, int rows) {
    if (row == 0) return add_node(region_, from_[i], mesh_);
    if (row == rows) return add_node(region_, opposite(i), mesh_);
    return add_node(region_, rays_[i].at(static_cast<double>(row) / rows), mesh_);
  }

  const Region& region_;
  const std::vector<LoopNode>&from_, &to_;
  std::size_t shift_ = 0;  // of to_: faces the first of from_
  std::vector<Ray> rays_;
  RegionMesh mesh_;
};

bool are_equal_ends(const Region& region, std::size_t most) {
  if (region.loops.size() != 2 || !region.fans.empty()) return false;
  const std::size_t nodes = region.loops[0].size();
  return nodes == region.loops[1].size() && nodes >= 3 && nodes <= most;
}

}  // namespace

bool is_slim_tube(const Region& region) {
  constexpr double slim = 0.7;  // of the target length
  if (region.loops.size() != 2) return false;
  return std::ranges::all_of(region.loops, [&](const std::vector<LoopNode>& loop) {
    return std::ranges::all_of(loop, [&](const LoopNode& node) { return norm(node.x - loop[0].x) < slim * region.h; });
  });
}

std::optional<RegionMesh> lay_tube(const Region& region) {
  return are_equal_ends(region, most_nodes) ? Tube(region).lay() : std::nullopt;
}

std::optional<RegionMesh> lay_prism(const Region& region) {
  constexpr std::size_t most = 4096;  // turning tries all
  if (!region.goes_round || !are_equal_ends(region, most)) return std::nullopt;
  Tube tube(region);
  return tube.is_prism() || tube.is_short_bend() ? tube.lay() : std::nullopt;
}

std::optional<RegionMesh> lay_dome(const Region& region, Elements elements, DomeRows rows) {
  if (region.loops.size() != 1 || region.fans.size() > 1) return std::nullopt;
  const std::size_t nodes = region.loops[0].size();
  if (nodes < fewest_nodes || nodes > most_nodes) return std::nullopt;
  if (nodes % 2 == 1 && elements == Elements::all_quad) return std::nullopt;
  Dome dome(region, rows);
  return dome.is_star() ? dome.lay() : std::nullopt;
}

}  // namespace paver
