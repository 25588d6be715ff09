// A cube's grid on a face that goes round between two poles.
// In: face. Out: six patches: caps of n x n quads about the poles, four sides of n x m.
// Steps: n and m from the area and the ratio of girth and meridian; the equi-angular cube on the sphere that has the
// face's meridians as arcs; smoothing on coarse grids first, each the start of the next; patches.
// Sides are counted i = 0..4n-1 around, j = 0..m from the low pole; a cap's nodes a, b = 0..n, its border i = 0 at
// (0, 0), then along a.
#include <algorithm>
#include <cmath>

#include "regions/closed_grid_parts.h"
#include "regions/grid_interpolation.h"

namespace paver {
namespace {

constexpr int coarsest = 10;         // quads along a patch where smoothing starts
constexpr int fewest = 7;            // across it: fewer do not show the shape
constexpr int first_sweeps = 150;    // on the coarsest grid: long waves settle
constexpr int least_sweeps = 2;      // of finer grids: they start smooth
constexpr int seam_rows = 3;         // on either side of a patch's border, where large grids are smoothed
constexpr int most_coarse = 4;       // quads along a cap: up to here finer grids are tried as well
constexpr double most_turn = 2.1;    // radians across an element: beyond, it misses what the surface does there
constexpr double most_uneven = 0.4;  // two polar charts are no better where lengths vary so much
constexpr int low_cap = 0, high_cap = 1, sides = 2;  // charts

class CubeGrid {
 public:
  CubeGrid(const ClosedFace& face, int n, int m) : face_(face), n_(n), m_(m) {
    ParameterBox low = face.box, high = face.box;
    low.high_pole = high.low_pole = false;
    grid_.charts = {make_polar_chart(face.surface, low, face.period), make_polar_chart(face.surface, high, face.period),
                    make_plain_chart()};
    is_possible_ = grid_.charts[low_cap] && grid_.charts[high_cap];
    MeridianTable table(face.surface, face.box, 64);
    arc_.push_back(0);
    for (int i = 0; i < table.cells(); ++i) arc_.push_back(arc_.back() + table.height(i));
  }

  bool is_possible() const { return is_possible_; }
  GluedGrid& grid() { return grid_; }

  /// The equi-angular cube.
  void start() {
    fill([&](int cap, double a, double b) { return on_cap(cap, a, b); },
         [&](double i, double j) { return on_side(i, j); });
  }

  /// From a coarser grid.
  void start_from(const CubeGrid& other) {
    const double scale_n = static_cast<double>(other.n_) / n_, scale_m = static_cast<double>(other.m_) / m_;
    std::vector<Vec2> places;  // of the other's sides
    for (int i = 0; i <= 4 * other.n_; ++i)
      for (int j = 0; j <= other.m_; ++j) places.push_back(other.unrolled(i, j));
    auto place = [&](int i, int j) { return places[static_cast<std::size_t>(i) * (other.m_ + 1) + j]; };
    fill([&](int cap, double a, double b) { return other.cap_between(cap, a * scale_n, b * scale_n); },
         [&](double i, double j) { return interpolate(i * scale_n, j * scale_m, 4 * other.n_, other.m_, place); });
  }

  /// Patches are interpolated one by one, which leaves kinks between them: only these move from here on.
  void hold_all_but_seams() {
    auto is_inside = [](int at, int size) { return at % size >= seam_rows && at % size <= size - seam_rows; };
    std::vector<char>& is_fixed = grid_.mesh.is_fixed;
    for (int i = 0; i < 4 * n_; ++i)
      for (int j = 0; j <= m_; ++j) is_fixed[side_node(i, j)] = is_inside(i, n_) && is_inside(j, m_);
    for (int cap : {low_cap, high_cap})
      for (int b = 1; b < n_; ++b)
        for (int a = 1; a < n_; ++a) is_fixed[cap_node(cap, a, b)] = is_inside(a, n_) && is_inside(b, n_);
  }

  std::shared_ptr<const ClosedGrid> patches() const {
    auto closed = std::make_shared<ClosedGrid>();
    closed->h = grid_.mesh.h;
    for (int cap : {low_cap, high_cap}) closed->patches.push_back(cap_patch(cap));
    for (int k = 0; k < 4; ++k) closed->patches.push_back(side_patch(k));
    for (GridPatch& patch : closed->patches)
      if (!finish_patch(patch)) return nullptr;
    return closed;
  }

 private:
  int side_node(int i, int j) const { return (i % (4 * n_)) * (m_ + 1) + j; }
  int cap_node(int cap, int a, int b) const {
    int j = cap == low_cap ? 0 : m_;
    if (b == 0) return side_node(a, j);
    if (a == n_) return side_node(n_ + b, j);
    if (b == n_) return side_node(3 * n_ - a, j);
    if (a == 0) return side_node(4 * n_ - b, j);
    return 4 * n_ * (m_ + 1) + cap * (n_ - 1) * (n_ - 1) + (b - 1) * (n_ - 1) + a - 1;
  }

  template <class OnCap, class OnSide>
  void fill(OnCap cap_place, OnSide side_place) {
    for (int i = 0; i < 4 * n_; ++i)
      for (int j = 0; j <= m_; ++j) grid_.add_node(sides, side_place(i, j), face_.surface, face_.size);
    for (int cap : {low_cap, high_cap})
      for (int b = 1; b < n_; ++b)
        for (int a = 1; a < n_; ++a) grid_.add_node(cap, cap_place(cap, a, b), face_.surface, face_.size);
    for (int i = 0; i < 4 * n_; ++i)
      for (int j = 0; j < m_; ++j)
        add_quad({side_node(i, j), side_node(i + 1, j), side_node(i + 1, j + 1), side_node(i, j + 1)});
    for (int b = 0; b < n_; ++b)
      for (int a = 0; a < n_; ++a) {
        std::array<int, 4> low = cap_quad(low_cap, a, b), high = cap_quad(high_cap, a, b);
        std::swap(low[1], low[3]);  // seen from outside the caps lie face to face
        add_quad(low);
        add_quad(high);
      }
  }

  std::array<int, 4> cap_quad(int cap, int a, int b) const {
    return {cap_node(cap, a, b), cap_node(cap, a + 1, b), cap_node(cap, a + 1, b + 1), cap_node(cap, a, b + 1)};
  }

  void add_quad(std::array<int, 4> v) {
    if (face_.box.is_swapped) std::swap(v[1], v[3]);
    grid_.mesh.add_element(v);
  }

  // Where the caps' sides, an eighth of a great circle from the poles of the cube, lie by the counts of quads.
  double stretched(double share) const {
    double border = 0.5 * n_ / (n_ + m_);
    if (share > 0.5) return 1 - stretched(1 - share);
    return share < 0.25 ? 4 * border * share : border + (2 - 4 * border) * (share - 0.25);
  }

  // Parameters at `turns` of the way round and `share` of the cube's meridian.
  Vec2 at(double turns, double share) const {
    double wish = stretched(share) * arc_.back();
    int last = static_cast<int>(arc_.size()) - 2;
    int i = static_cast<int>(std::upper_bound(arc_.begin(), arc_.end(), wish) - arc_.begin()) - 1;
    i = std::clamp(i, 0, last);
    double step = (face_.box.hi.y - face_.box.lo.y) / (last + 1);
    double y = face_.box.lo.y + step * (i + (wish - arc_[i]) / (arc_[i + 1] - arc_[i]));
    return box_uv(face_.box, {face_.box.lo.x + turns * face_.period, std::clamp(y, face_.box.lo.y, face_.box.hi.y)});
  }

  Vec2 on_side(double i, double j) const {
    double column = std::floor(i / n_);
    double s = std::tan((2 * (i / n_ - column) - 1) * M_PI / 4), t = std::tan((2 * j / m_ - 1) * M_PI / 4);
    return at((column + 0.5) / 4 + std::atan(s) / (2 * M_PI), 0.5 + std::atan(t / std::sqrt(1 + s * s)) / M_PI);
  }

  Vec2 on_cap(int cap, double a, double b) const {
    double s = std::tan((2 * a / n_ - 1) * M_PI / 4), t = std::tan((2 * b / n_ - 1) * M_PI / 4);
    double share = std::atan(std::sqrt(s * s + t * t)) / M_PI, turns = (std::atan2(t, s) + 0.75 * M_PI) / (2 * M_PI);
    return grid_.charts[cap]->to_chart(at(turns, cap == low_cap ? share : 1 - share));
  }

  // Parameters of a side's node, a whole number of periods from where `i` turns lead.
  Vec2 unrolled(int i, int j) const {
    Vec2 place = box_uv(face_.box, grid_.uv(side_node(i, j)));
    double wish = face_.box.lo.x + face_.period * i / (4 * n_);
    place.x += face_.period * std::round((wish - place.x) / face_.period);
    return box_uv(face_.box, place);
  }

  Vec2 cap_point(int cap, int a, int b) const {
    int node = cap_node(cap, a, b);
    return grid_.chart[node] == cap ? grid_.mesh.p[node] : grid_.charts[cap]->to_chart(grid_.uv(node));
  }

  Vec2 cap_between(int cap, double a, double b) const {
    return interpolate(a, b, n_, n_, [&](int i, int j) { return cap_point(cap, i, j); });
  }

  static void add_quads(GridPatch& patch, int columns, int rows) {
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i) {
        int first = j * (columns + 1) + i;
        patch.quads.push_back({first, first + 1, first + columns + 2, first + columns + 1});
      }
  }

  GridPatch cap_patch(int cap) const {
    GridPatch patch;
    patch.chart = grid_.charts[cap];
    for (int b = 0; b <= n_; ++b)
      for (int a = 0; a <= n_; ++a) {
        patch.node.push_back(cap_node(cap, a, b));
        patch.uv.push_back(grid_.uv(patch.node.back()));
      }
    add_quads(patch, n_, n_);
    return patch;
  }

  GridPatch side_patch(int k) const {
    GridPatch patch;
    ParameterBox box = face_.box;
    box.low_pole = box.high_pole = false;
    box.lo.x = face_.box.lo.x + 0.25 * k * face_.period;
    box.hi.x = box.lo.x + 0.25 * face_.period;
    patch.chart = make_row_chart(face_.surface, box);
    for (int j = 0; j <= m_; ++j)
      for (int i = 0; i <= n_; ++i) {
        patch.node.push_back(side_node(k * n_ + i, j));
        patch.uv.push_back(unrolled(k * n_ + i, j));
      }
    add_quads(patch, n_, m_);
    return patch;
  }

  const ClosedFace& face_;
  int n_, m_;
  bool is_possible_ = false;
  std::vector<double> arc_;
  GluedGrid grid_;
};

/// Quads along a cap and from cap to cap. On the sphere girth and meridians ask for equal numbers.
std::pair<int, int> choose_counts(const ClosedFace& face) {
  FaceExtent extent = measure_extent(face);
  double ratio = 4 * extent.tall / extent.girth - 1;  // m / n
  if (!(ratio > 0.2)) return {0, 0};
  double exact = std::sqrt(extent.elements / (2 + 4 * ratio));
  int least = static_cast<int>(std::ceil(0.5 * M_PI / face.turn_limit - 1e-9));
  int n = std::max({1, least, static_cast<int>(std::lround(exact))});
  double m = ratio * n;
  if (std::fabs(m - n) > 0.5) m = (extent.elements - 2.0 * n * n) / (4.0 * n);
  return {n, std::max({1, least, static_cast<int>(std::lround(m))})};
}

std::shared_ptr<const ClosedGrid> lay_cube(const ClosedFace& face, int n, int m, double turn_limit,
                                           const Progress& progress) {
  std::vector<std::pair<int, int>> levels{{n, m}};
  while (std::max(levels.back().first, levels.back().second) > coarsest &&
         std::min(levels.back().first, levels.back().second) > fewest)
    levels.push_back({(levels.back().first + 1) / 2, (levels.back().second + 1) / 2});
  std::unique_ptr<CubeGrid> coarse;
  for (auto level = levels.rbegin(); level != levels.rend(); ++level) {
    auto grid = std::make_unique<CubeGrid>(face, level->first, level->second);
    if (!grid->is_possible()) return nullptr;
    if (coarse) {
      grid->start_from(*coarse);
    } else {
      grid->start();
    }
    if (coarse && is_smooth_enough(grid->grid())) grid->hold_all_but_seams();
    smooth_grid(grid->grid(), face.surface, face.size, coarse ? finer_sweeps(grid->grid(), least_sweeps) : first_sweeps,
                progress);
    coarse = std::move(grid);
  }
  return is_good(measure_grid(coarse->grid()), most_uneven, turn_limit) ? coarse->patches() : nullptr;
}

}  // namespace

std::shared_ptr<const ClosedGrid> make_cube_grid(const ClosedFace& face, const Progress& progress) {
  auto [n, m] = choose_counts(face);
  if (n == 0) return nullptr;
  // A few elements may be too few for the ends of a long body: then more, and at last as many as twice whatever they
  // miss.
  int most = n <= most_coarse ? 2 * n : n;
  for (int finer = n; finer <= most; ++finer) {
    double turn = finer > n && finer == most ? M_PI : most_turn;
    if (auto grid = lay_cube(face, finer, (m * finer + n - 1) / n, turn, progress)) return grid;
  }
  return nullptr;
}

}  // namespace paver
