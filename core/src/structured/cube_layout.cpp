// A cube's six sides on a face that goes round between two poles.
// In: face. Out: its layout: sides of a x m and b x m quads in turn, caps of a x b about the poles.
// Steps: a, b and m from the area and the ratio of girth and meridian; the equi-angular cube on the sphere that has the
// face's meridians as arcs; smoothing.
// Corners 0 to 3 go round the low cap, 4 to 7 the high one; side k starts at corner k.
#include <algorithm>
#include <cmath>

#include "structured/closed_layout.h"

namespace paver {
namespace {

constexpr double flattest = 0.2;  // ratio of m to a and b
constexpr double tie_price = 1e-3;
constexpr double most_turn = 1.6;     // radians across an element: beyond, it misses what the surface does there
constexpr double most_uneven = 0.4;   // two polar charts are no better where lengths vary so much
constexpr int most_change = 3;        // of counts, from those that are even
constexpr double near_enough = 0.04;  // of the elements asked for
constexpr double too_far_off = 0.05;  // a prism is tried
constexpr double off_price = 10;      // of what is beyond that, against the squares of uneven counts' logarithms
constexpr double fairly_even = 0.3;   // of these squares: counts of 3 and 5
constexpr double uneven_price = 100;  // of what is beyond that
constexpr std::size_t low_cap = 4, high_cap = 5;

/// Quads along the first and the second side of a cap, and from cap to cap.
struct CubeCounts {
  int a = 0, b = 0, m = 0;
  double quads() const { return 2.0 * a * b + 2.0 * (a + b) * m; }
};

class Cube {
 public:
  Cube(const ClosedFace& face, CubeCounts counts) : face_(face), counts_(counts), meridian_(face) {
    layout_.period = face.periods();
    for (int k = 0; k < 4; ++k) add_side(k);
    ParameterBox low = face.box, high = face.box;
    low.high_pole = high.low_pole = false;
    const std::array<int, 2> cap{counts.a, counts.b};
    layout_.blocks.push_back({{0, 1, 2, 3}, cap, make_polar_chart(face.surface, low, face.period), {}});
    layout_.blocks.push_back({{4, 5, 6, 7}, cap, make_polar_chart(face.surface, high, face.period), {}});
  }

  bool is_possible() const { return layout_.blocks[low_cap].chart && layout_.blocks[high_cap].chart; }
  const BlockLayout& layout() const { return layout_; }

  /// Chart point on the equi-angular cube.
  Vec2 place(std::size_t block, double s, double t) const {
    s = std::tan((2 * s - 1) * M_PI / 4), t = std::tan((2 * t - 1) * M_PI / 4);
    return layout_.blocks[block].chart->to_chart(block < low_cap ? on_side(static_cast<int>(block), s, t)
                                                                 : on_cap(block == low_cap, s, t));
  }

 private:
  void add_side(int k) {
    ParameterBox box = face_.box;
    box.low_pole = box.high_pole = false;
    box.lo.x = face_.box.lo.x + 0.25 * k * face_.period;
    box.hi.x = box.lo.x + 0.25 * face_.period;
    const int next = (k + 1) % 4, across = k % 2 == 0 ? counts_.a : counts_.b;
    layout_.blocks.push_back({{k, next, 4 + next, 4 + k},
                              {across, counts_.m},
                              make_row_chart(face_.surface, box),
                              face_.box.uv(0.5 * (box.lo + box.hi))});
  }

  Vec2 on_side(int k, double s, double t) const {
    return at((k + 0.5) / 4 + std::atan(s) / (2 * M_PI), 0.5 + std::atan(t / std::sqrt(1 + s * s)) / M_PI);
  }

  Vec2 on_cap(bool is_low, double s, double t) const {
    double share = std::atan(std::sqrt(s * s + t * t)) / M_PI, turns = (std::atan2(t, s) + 0.75 * M_PI) / (2 * M_PI);
    return at(turns, is_low ? share : 1 - share);
  }

  // Where the caps' sides, an eighth of a great circle from the poles of the cube, lie by the counts of quads.
  double stretched(double share) const {
    const double across = 0.5 * (counts_.a + counts_.b), border = 0.5 * across / (across + counts_.m);
    if (share > 0.5) return 1 - stretched(1 - share);
    return share < 0.25 ? 4 * border * share : border + (2 - 4 * border) * (share - 0.25);
  }

  // Parameters at `turns` of the way round and `share` of the cube's meridian.
  Vec2 at(double turns, double share) const { return meridian_.uv(turns, stretched(share)); }

  const ClosedFace& face_;
  const CubeCounts counts_;
  const Meridian meridian_;
  BlockLayout layout_;
};

/// Of the counts that come near enough to the elements asked for the most even ones; on the sphere girth and meridians
/// ask for equal numbers.
CubeCounts choose_counts(const ClosedFace& face, const FaceExtent& extent) {
  const double ratio = 4 * extent.tall / extent.girth - 1;  // of m to a and b
  if (!(ratio > flattest)) return {};
  const double exact = std::sqrt(extent.elements / (2 + 4 * ratio));
  const int least = std::max(1, static_cast<int>(std::ceil(0.5 * M_PI / face.turn_limit - 1e-9)));
  auto from = [&](double count) { return std::max(least, static_cast<int>(std::lround(count)) - most_change); };
  CubeCounts best;
  double least_cost = INFINITY;
  for (int a = from(exact); a <= from(exact) + 2 * most_change; ++a)
    for (int b = a; b <= a + most_change; ++b)
      for (int m = from(ratio * exact); m <= from(ratio * exact) + 2 * most_change; ++m) {
        const CubeCounts counts{a, b, m};
        const double off = std::fabs(std::log(counts.quads() / extent.elements));
        const double x = std::log(1.0 * b / a), y = std::log(m / (ratio * std::sqrt(1.0 * a * b)));
        const double uneven = x * x + y * y;
        const double cost = off_price * std::max(0.0, off - near_enough) + uneven +
                            uneven_price * std::max(0.0, uneven - fairly_even) + tie_price * off;
        if (cost < least_cost) least_cost = cost, best = counts;
      }
  return best;
}

}  // namespace

std::shared_ptr<const ClosedLayout> lay_cube(const ClosedFace& face, const Progress& progress) {
  const FaceExtent extent = measure_extent(face);
  const CubeCounts counts = choose_counts(face, extent);
  if (counts.a == 0) return nullptr;
  const double off = std::fabs(counts.quads() / extent.elements - 1);
  if (off > too_far_off)
    if (auto prism = lay_prism(face, off, progress)) return prism;
  const Cube cube(face, counts);
  if (!cube.is_possible()) return nullptr;
  auto place = [&](std::size_t block, double s, double t) { return cube.place(block, s, t); };
  const BlockGrid grid = placed_grid(face, cube.layout(), place, most_placed, progress);
  const GridFigures figures = measure_grid(grid.grid());
  return is_good(figures, most_uneven, most_turn) ? mapped(face, cube.layout(), grid, figures.turn) : nullptr;
}

}  // namespace paver
