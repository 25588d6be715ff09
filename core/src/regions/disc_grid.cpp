// Discs: a core in the middle, rows around it.
// In: region. Out: its mesh.
// Places are (i, k): i = 0..N-1 around the loop, k = 0 on the core's border to m on the loop; core nodes (c, d) inside
// it with c = 0..a, d = 0..b, N = 2 (a + b). i runs along d = 0, c = a, d = b, c = 0, as the loop does.
// Steps: a, b from the loop's extent both ways, m from the area; positions between the loop's middle and the loop;
// smoothing, on coarser discs first.
#include "regions/disc_grid.h"

#include <algorithm>
#include <cmath>

#include "base/predicates.h"
#include "regions/grid_smoothing.h"

namespace paver {
namespace {

constexpr int least_sweeps = 5;
constexpr double corner = 0.52;   // radians (30 degrees): a loop that turns more at a node has a corner there
constexpr int fewest_nodes = 8;   // on the loop
constexpr int coarsest = 12;      // quads along the core where smoothing starts
constexpr int first_sweeps = 60;  // there
// Coefficient of variation of the lengths. Paving reaches 0.16 on round discs, 0.1 on ellipses of 2 : 1.
constexpr double most_uneven = 0.14;
constexpr double least_jacobian = 0.5;
constexpr double least_ratio = 0.8, largest_ratio = 1.25;  // of the mean length to the target length

/// The loop as a closed curve in the chart.
class Rim {
 public:
  explicit Rim(const std::vector<LoopNode>& loop) : loop_(loop) {
    for (const LoopNode& node : loop) middle_ = middle_ + (1.0 / static_cast<double>(loop.size())) * node.p;
  }
  int size() const { return static_cast<int>(loop_.size()); }
  Vec2 middle() const { return middle_; }
  const LoopNode& node(int i) const { return loop_[static_cast<std::size_t>((i % size() + size()) % size())]; }
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
    if (!(mean > spread)) return {1e9, 0};
    double ratio = std::sqrt((mean + spread) / (mean - spread));
    if (ratio < 1.02) return {ratio, 0};  // round: anywhere
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

struct Layout {
  int a = 0, b = 0, m = 0;  // core, rows around it
  double first = 0;         // place on the loop, in its nodes, that lies opposite core node (0, 0)
  int around() const { return 2 * (a + b); }
};

class DiscGrid {
 public:
  DiscGrid(const Region& region, const Rim& rim, const Layout& layout) : region_(region), rim_(rim), layout_(layout) {
    grid_.charts = {region.chart};
  }

  GluedGrid& grid() { return grid_; }

  void start(const DiscGrid* coarse) {
    const auto [a, b, m, first] = layout_;
    for (int d = 0; d <= b; ++d)
      for (int c = 0; c <= a; ++c) add(coarse ? coarse->core_between(share(c, a), share(d, b)) : core_place(c, d));
    for (int k = 1; k <= m; ++k)
      for (int i = 0; i < layout_.around(); ++i)
        add(k == m ? rim_place(i) : coarse ? coarse->row_between(i, layout_, share(k, m)) : row_place(i, k));
    for (int i = 0; i < layout_.around(); ++i) grid_.mesh.is_fixed[static_cast<std::size_t>(row_node(i, m))] = 1;
    for (int d = 0; d < b; ++d)
      for (int c = 0; c < a; ++c)
        grid_.mesh.add_element({core_node(c, d), core_node(c + 1, d), core_node(c + 1, d + 1), core_node(c, d + 1)});
    for (int k = 0; k < m; ++k)
      for (int i = 0; i < layout_.around(); ++i)
        grid_.mesh.add_element({row_node(i, k), row_node(i, k + 1), row_node(i + 1, k + 1), row_node(i + 1, k)});
  }

  /// Boundary nodes as they are; whether all elements are positive in the chart.
  bool finish() {
    RegionMesh& mesh = grid_.mesh;
    for (int i = 0; i < layout_.around(); ++i) {
      const LoopNode& node = rim_.node(static_cast<int>(layout_.first) + i);
      auto v = static_cast<std::size_t>(row_node(i, layout_.m));
      mesh.global[v] = node.global;
      mesh.x[v] = node.x;
      mesh.h[v] = node.h;
    }
    return std::all_of(mesh.elements.begin(), mesh.elements.end(), [&](const Element& e) {
      for (int k = 0; k < 4; ++k)
        if (orientation(mesh.p[e.v[k]], mesh.p[e.v[(k + 1) % 4]], mesh.p[e.v[(k + 2) % 4]]) <= 0) return false;
      return true;
    });
  }

 private:
  static double share(int i, int n) { return static_cast<double>(i) / n; }
  void add(Vec2 p) { grid_.add_node(0, p, *region_.surface, region_.size); }

  int core_node(int c, int d) const { return d * (layout_.a + 1) + c; }
  int row_node(int i, int k) const {
    const auto [a, b, m, first] = layout_;
    i %= layout_.around();
    if (k > 0) return (a + 1) * (b + 1) + (k - 1) * layout_.around() + i;
    if (i <= a) return core_node(i, 0);
    if (i <= a + b) return core_node(a, i - a);
    if (i <= 2 * a + b) return core_node(2 * a + b - i, b);
    return core_node(0, layout_.around() - i);
  }

  Vec2 rim_place(double i) const { return rim_.at(layout_.first + i * rim_.size() / layout_.around()); }

  // A square pressed into the disc's shape: between the middle and the loop, `reach` of the way.
  Vec2 core_place(int c, int d) const {
    double s = 2 * share(c, layout_.a) - 1, t = 2 * share(d, layout_.b) - 1;
    double reach = std::max(std::fabs(s), std::fabs(t));
    if (reach == 0) return rim_.middle();
    s /= reach, t /= reach;  // on the core's border: how far along it
    double a = layout_.a, b = layout_.b, i = 0;
    if (t <= -1)
      i = 0.5 * (s + 1) * a;
    else if (s >= 1)
      i = a + 0.5 * (t + 1) * b;
    else if (t >= 1)
      i = a + b + 0.5 * (1 - s) * a;
    else
      i = 2 * a + b + 0.5 * (1 - t) * b;
    // Corners reach as far as sides; inside, the square turns into itself.
    double corners = std::min(std::fabs(s), std::fabs(t)), stretch = 1 + (1 - reach) * 0.3 * corners * corners;
    return rim_.middle() + (core_share() * reach * stretch) * (rim_place(i) - rim_.middle());
  }
  Vec2 row_place(int i, int k) const {
    double reach = core_share() + (1 - core_share()) * share(k, layout_.m);
    return rim_.middle() + reach * (rim_place(i) - rim_.middle());
  }
  double core_share() const {
    double half = 0.25 * (layout_.a + layout_.b);
    return half / (half + layout_.m);
  }

  template <class Corner>
  static Vec2 between(double s, double t, int most_s, int most_t, Corner corner_at) {
    int i = std::clamp(static_cast<int>(s), 0, most_s - 1), j = std::clamp(static_cast<int>(t), 0, most_t - 1);
    s -= i, t -= j;
    return (1 - t) * ((1 - s) * corner_at(i, j) + s * corner_at(i + 1, j)) +
           t * ((1 - s) * corner_at(i, j + 1) + s * corner_at(i + 1, j + 1));
  }
  Vec2 core_between(double s, double t) const {
    return between(s * layout_.a, t * layout_.b, layout_.a, layout_.b,
                   [&](int c, int d) { return grid_.mesh.p[static_cast<std::size_t>(core_node(c, d))]; });
  }
  // Place i of a finer disc: as far along the same side of the core.
  Vec2 row_between(int i, const Layout& finer, double t) const {
    const auto [a, b, m, first] = layout_;
    const int starts[] = {0, finer.a, finer.a + finer.b, 2 * finer.a + finer.b, finer.around()};
    const int own[] = {0, a, a + b, 2 * a + b, layout_.around()};
    int side = 0;
    while (i >= starts[side + 1]) ++side;
    double s = own[side] + share(i - starts[side], starts[side + 1] - starts[side]) * (own[side + 1] - own[side]);
    return between(s, t * m, layout_.around(), m,
                   [&](int k, int l) { return grid_.mesh.p[static_cast<std::size_t>(row_node(k, l))]; });
  }

  const Region& region_;
  const Rim& rim_;
  Layout layout_;
  GluedGrid grid_;
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
      Vec3 x, xp, xq;
      Vec2 p = rim.middle() + s * out;
      region.evaluate(p, x, xp, xq);
      double h = region.target(p);
      sum += 0.25 * s * cross(out, side) * norm(cross(xp, xq)) / (h * h);
    }
  return sum;
}

std::optional<Layout> choose_layout(const Region& region, const Rim& rim) {
  auto [ratio, furthest] = rim.shape();
  int half = rim.size() / 2;
  Layout layout;
  layout.a = static_cast<int>(std::lround(half * ratio / (1 + ratio)));
  layout.b = half - layout.a;
  if (layout.b < 2) return std::nullopt;
  double m = (count_elements(region, rim) - static_cast<double>(layout.a) * layout.b) / rim.size();
  if (!(m > -0.5 && m < 1e6)) return std::nullopt;
  layout.m = std::max(1, static_cast<int>(std::lround(m)));
  const int half_side = layout.a / 2;
  layout.first = furthest - half_side;
  return layout;
}

std::vector<Layout> levels_of(const Layout& layout) {
  std::vector<Layout> levels{layout};
  while (std::min(levels.back().a, levels.back().b) > coarsest) {
    const Layout& last = levels.back();
    levels.push_back({(last.a + 1) / 2, (last.b + 1) / 2, (last.m + 1) / 2, last.first});
  }
  std::reverse(levels.begin(), levels.end());
  return levels;
}

}  // namespace

std::optional<RegionMesh> lay_disc(const Region& region, const Progress& progress) {
  if (region.loops.size() != 1 || !region.fans.empty()) return std::nullopt;
  const std::vector<LoopNode>& loop = region.loops[0];
  if (loop.size() < fewest_nodes || loop.size() % 2 != 0 || !is_smooth(loop)) return std::nullopt;
  Rim rim(loop);
  std::optional<Layout> layout = choose_layout(region, rim);
  if (!layout) return std::nullopt;
  std::unique_ptr<DiscGrid> disc;
  for (const Layout& level : levels_of(*layout)) {
    auto finer = std::make_unique<DiscGrid>(region, rim, level);
    finer->start(disc.get());
    smooth_grid(finer->grid(), *region.surface, region.size,
                disc ? finer_sweeps(finer->grid(), least_sweeps) : first_sweeps, progress);
    disc = std::move(finer);
  }
  if (!disc->finish()) return std::nullopt;
  GridFigures figures = measure_grid(disc->grid());
  bool is_good = figures.variation <= most_uneven && figures.worst >= least_jacobian &&
                 figures.mean_ratio >= least_ratio && figures.mean_ratio <= largest_ratio;
  if (!is_good) return std::nullopt;
  return std::move(disc->grid().mesh);
}

}  // namespace paver
