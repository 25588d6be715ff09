// Discs: a core in the middle, rows around it.
// In: region. Out: its mesh.
// Layout: the core of a x b quads, corners 0 to 3, and a block of m rows on each of its sides, out to corners 4 to 7 on
// the loop, which runs as the core's outline does. Steps: a, b from the loop's extent both ways, m from the area;
// positions between the loop's middle and the loop; smoothing.
#include "paving/disc_grid.h"

#include <algorithm>
#include <cmath>

#include "structured/block_grid.h"

namespace paver {
namespace {

constexpr double round_ratio = 1.02;  // of the extents, up to which a rim has no direction
constexpr double corner_stretch = 0.3;
constexpr double most_rings = 1e6;
constexpr double of_a_line = 1e9;  // ratio of the extents
constexpr double corner = 0.52;    // radians (30 degrees): a loop that turns more at a node has a corner there
constexpr int fewest_nodes = 8;    // on the loop
// Coefficient of variation of the lengths. Paving reaches 0.16 on round discs, 0.1 on ellipses of 2 : 1.
constexpr double most_uneven = 0.14;
constexpr double least_jacobian = 0.5;
// Of rims that have only the nodes that their turn asks for, whose lengths are uneven however they are meshed: angles
// decide. Paved, 8 nodes give 10 quads (scaled Jacobian 0.58), here 12 (0.84).
constexpr int few_nodes = 10;
constexpr double least_of_few = 0.7;
constexpr double least_ratio = 0.8, largest_ratio = 1.25;  // of the mean length to the target length

/// The loop as a closed curve in the chart.
class Rim {
 public:
  explicit Rim(const std::vector<LoopNode>& loop) : loop_(loop) {
    for (const LoopNode& node : loop) middle_ = middle_ + (1.0 / static_cast<double>(loop.size())) * node.p;
  }
  int size() const { return static_cast<int>(loop_.size()); }
  Vec2 middle() const { return middle_; }
  const LoopNode& node(int i) const { return loop_[(i % size() + size()) % size()]; }
  /// Point between nodes, `i` any real number.
  Vec2 at(double i) const {
    double whole = std::floor(i), t = i - whole;
    return (1 - t) * node(static_cast<int>(whole)).p + t * node(static_cast<int>(whole) + 1).p;
  }

  /// Ratio of the longer extent to the shorter, and the node that lies furthest along the shorter one.
  std::pair<double, int> shape() const {
    double xx = 0, xy = 0, yy = 0;
    for (const LoopNode& n : loop_) {
      Vec2 d = n.p - middle_;
      xx += d.x * d.x, xy += d.x * d.y, yy += d.y * d.y;
    }
    double mean = 0.5 * (xx + yy), spread = std::sqrt(0.25 * (xx - yy) * (xx - yy) + xy * xy);
    if (!(mean > spread)) return {of_a_line, 0};
    double ratio = std::sqrt((mean + spread) / (mean - spread));
    if (ratio < round_ratio) return {ratio, 0};  // round: anywhere
    double angle = 0.5 * std::atan2(2 * xy, xx - yy) + M_PI_2;
    Vec2 shorter{std::cos(angle), std::sin(angle)};
    int best = 0;
    for (int i = 1; i < size(); ++i)
      if (dot(node(i).p - middle_, shorter) > dot(node(best).p - middle_, shorter)) best = i;
    return {ratio, best};
  }

 private:
  const std::vector<LoopNode>& loop_;
  Vec2 middle_;
};

/// Quads of the core either way, rows around it.
struct Counts {
  int a = 0, b = 0, m = 0;
  double first = 0;  // place on the loop, in its nodes, that lies opposite core corner 0
};

class Disc {
 public:
  Disc(const Region& region, const Rim& rim, const Counts& counts) : region_(region), rim_(rim), counts_(counts) {
    const auto [a, b, m, first] = counts;
    layout_.blocks.push_back({{0, 1, 2, 3}, {a, b}, region.chart, {}});
    for (int k = 0; k < sides; ++k) {
      const int next = (k + 1) % sides;
      layout_.blocks.push_back({{k, next, sides + next, sides + k}, {k % 2 == 0 ? a : b, m}, region.chart, {}});
    }
  }

  /// Nothing where an element is not positive in the chart.
  std::optional<GluedGrid> smoothed(const Progress& progress) const {
    constexpr Smoothing smoothing{60, 5, 400};
    auto places = [&](std::size_t block, double s, double t) {
      return block == 0 ? core_place(s, t) : row_place(start_of(block) + s * layout_.blocks[block].count[0], t);
    };
    BlockGrid grid = smoothed_grid(
        layout_, layout_, *region_.surface, region_.size, places, smoothing, [&](BlockGrid& at) { hold_rim(at); },
        progress);
    finish(grid);
    if (!are_all_positive(grid.grid().mesh)) return std::nullopt;
    return std::move(grid.grid());
  }

 private:
  static constexpr int sides = 4;

  int start_of(std::size_t block) const {
    const int starts[] = {0, counts_.a, counts_.a + counts_.b, 2 * counts_.a + counts_.b};
    return starts[block - 1];
  }

  /// `use(node, i)` for the nodes on the rim, i the place around, in nodes of the finest grid.
  template <class Use>
  void each_on_rim(const BlockGrid& grid, Use use) const {
    for (std::size_t block = 1; block <= sides; ++block) {
      const auto [m, n] = grid.layout().blocks[block].count;
      const double step = static_cast<double>(layout_.blocks[block].count[0]) / m;
      for (int i = 0; i < m; ++i) use(grid.node(block, i, n), start_of(block) + i * step);
    }
  }

  void hold_rim(BlockGrid& grid) const {
    each_on_rim(grid, [&](int node, double i) {
      grid.place(node, rim_place(i));
      grid.grid().mesh.is_fixed[node] = 1;
    });
  }

  // Boundary nodes as they are.
  void finish(BlockGrid& grid) const {
    RegionMesh& mesh = grid.grid().mesh;
    each_on_rim(grid, [&](int v, double i) {
      const LoopNode& node = rim_.node(static_cast<int>(counts_.first) + static_cast<int>(i));
      mesh.global[v] = node.global;
      mesh.x[v] = node.x;
      mesh.h[v] = node.h;
    });
  }

  Vec2 rim_place(double i) const { return rim_.at(counts_.first + i); }

  // A square pressed into the disc's shape: between the middle and the loop, `reach` of the way.
  Vec2 core_place(double s, double t) const {
    s = 2 * s - 1, t = 2 * t - 1;
    double reach = std::max(std::fabs(s), std::fabs(t));
    if (reach == 0) return rim_.middle();
    s /= reach, t /= reach;  // on the core's border: how far along it
    double a = counts_.a, b = counts_.b, i = 0;
    if (t <= -1)
      i = 0.5 * (s + 1) * a;
    else if (s >= 1)
      i = a + 0.5 * (t + 1) * b;
    else if (t >= 1)
      i = a + b + 0.5 * (1 - s) * a;
    else
      i = 2 * a + b + 0.5 * (1 - t) * b;
    // Corners reach as far as sides; inside, the square turns into itself.
    double corners = std::min(std::fabs(s), std::fabs(t)),
           stretch = 1 + (1 - reach) * corner_stretch * corners * corners;
    return rim_.middle() + (core_share() * reach * stretch) * (rim_place(i) - rim_.middle());
  }
  Vec2 row_place(double i, double t) const {
    double reach = core_share() + (1 - core_share()) * t;
    return rim_.middle() + reach * (rim_place(i) - rim_.middle());
  }
  double core_share() const {
    double half = 0.25 * (counts_.a + counts_.b);
    return half / (half + counts_.m);
  }

  const Region& region_;
  const Rim& rim_;
  const Counts counts_;
  BlockLayout layout_;
};

bool is_smooth(const std::vector<LoopNode>& loop) {
  return std::all_of(loop.begin(), loop.end(),
                     [](const LoopNode& n) { return n.angle >= 0 && std::fabs(n.angle - M_PI) < corner; });
}

// Integral of 1/h^2 over the triangles that the loop's facets make with its middle.
double count_elements(const Region& region, const Rim& rim) {
  double sum = 0;
  for (int i = 0; i < rim.size(); ++i)
    for (double s : {0.125, 0.375, 0.625, 0.875}) {
      Vec2 side = rim.node(i + 1).p - rim.node(i).p, out = rim.at(i + 0.5) - rim.middle();
      Vec2 p = rim.middle() + s * out;
      const auto [x, xp, xq] = region.slope(p);
      double h = region.target(p);
      sum += 0.25 * s * cross(out, side) * norm(cross(xp, xq)) / (h * h);
    }
  return sum;
}

std::optional<Counts> choose_counts(const Region& region, const Rim& rim) {
  auto [ratio, furthest] = rim.shape();
  int half = rim.size() / 2;
  Counts counts;
  counts.a = static_cast<int>(std::lround(half * ratio / (1 + ratio)));
  counts.b = half - counts.a;
  if (counts.b < 2) return std::nullopt;
  double m = (count_elements(region, rim) - static_cast<double>(counts.a) * counts.b) / rim.size();
  if (!((m > -0.5 || rim.size() <= few_nodes) && m < most_rings)) return std::nullopt;
  counts.m = std::max(1, static_cast<int>(std::lround(m)));
  const int half_side = counts.a / 2;
  counts.first = furthest - half_side;
  return counts;
}

}  // namespace

std::optional<RegionMesh> lay_disc(const Region& region, const Progress& progress) {
  if (region.loops.size() != 1 || !region.fans.empty()) return std::nullopt;
  const std::vector<LoopNode>& loop = region.loops[0];
  if (loop.size() < fewest_nodes || loop.size() % 2 != 0 || !is_smooth(loop)) return std::nullopt;
  Rim rim(loop);
  const std::optional<Counts> counts = choose_counts(region, rim);
  if (!counts) return std::nullopt;
  std::optional<GluedGrid> grid = Disc(region, rim, *counts).smoothed(progress);
  if (!grid) return std::nullopt;
  GridFigures figures = measure_grid(*grid);
  const bool is_even = figures.variation <= most_uneven && figures.worst >= least_jacobian &&
                       figures.mean_ratio >= least_ratio && figures.mean_ratio <= largest_ratio;
  const bool is_of_few = loop.size() <= few_nodes && counts->m == 1 && figures.worst >= least_of_few;
  if (!is_even && !is_of_few) return std::nullopt;
  return std::move(grid->mesh);
}

}  // namespace paver
