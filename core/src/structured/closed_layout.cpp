// Extent of a closed face, its grid and the blocks that follow from that.
#include "structured/closed_layout.h"

#include <algorithm>
#include <cmath>

#include "base/cells.h"
#include "base/predicates.h"

namespace paver {
namespace {

constexpr double least_jacobian = 0.3;
constexpr double far_turn = 60 * M_PI / 180;  // of a grid: below, curved elements follow the surface
constexpr double most_off = 0.08;             // of the lesser of target length and diagonal

class PlainChart : public Chart {
 public:
  explicit PlainChart(Vec2 scale) : scale_(scale) {}
  Vec2 to_chart(Vec2 uv) const override { return {uv.x * scale_.x, uv.y * scale_.y}; }
  ChartSlope slope(Vec2 p) const override {
    return {{p.x / scale_.x, p.y / scale_.y}, {1 / scale_.x, 0}, {0, 1 / scale_.y}};
  }

 private:
  Vec2 scale_;
};

bool is_positive(const MappedBlock& block) {
  const GridPlaces& at = block.coarse;
  const int wanted = block.is_clockwise ? -1 : 1;
  for (int j = 0; j < at.n; ++j)
    for (int i = 0; i < at.m; ++i) {
      const Vec2 p[] = {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
      for (int k = 0; k < 4; ++k)
        if (orientation(p[k], p[(k + 1) % 4], p[(k + 2) % 4]) * wanted <= 0) return false;
    }
  return true;
}

/// The surface's point nearest to `target`, sought from chart point p.
Vec3 foot(const MappedBlock& block, const Surface& surface, Vec2 p, Vec3 target) {
  constexpr int steps = 5;
  Vec3 nearest;
  double least = INFINITY;
  for (int i = 0; i < steps; ++i) {
    const auto [x, xp, xq] = slope_at(*block.chart, surface, p);
    const Vec3 off = target - x;
    if (const double d = norm(off); d < least) least = d, nearest = x;
    Vec2 step;
    if (!pull_back(xp, xq, off, step)) break;
    p = block.chart->approach(p, step);
  }
  return nearest;
}

/// The quad between four coarse places as it will be curved: nine nodes, row by row.
class CurvedQuad {
 public:
  CurvedQuad(const MappedBlock& block, const Surface& surface, int i, int j)
      : block_(block), surface_(surface), i_(i), j_(j) {
    for (std::size_t k : {0, 2, 6, 8}) x_[k] = on_surface(static_cast<int>(k), {});
    for (auto [k, a, b] : {std::array{1, 0, 2}, {3, 0, 6}, {5, 2, 8}, {7, 6, 8}})
      x_[k] = on_surface(k, 0.5 * (x_[a] + x_[b]));
    x_[4] = on_surface(4, 0.5 * (x_[1] + x_[3] + x_[5] + x_[7]) - 0.25 * (x_[0] + x_[2] + x_[6] + x_[8]));
  }

  /// Whether it lies near the surface, a quarter of the way in from its sides and on these.
  bool is_near(double h) const {
    constexpr std::array<double, 3> shares{0.25, 0.5, 0.75};
    const double most = most_off * std::min({h, norm(x_[8] - x_[0]), norm(x_[6] - x_[2])});
    auto is_off = [&](double s, double t) {
      const Vec3 y = at(s, t);
      return norm(foot(block_, surface_, place(s, t), y) - y) > most;
    };
    for (double s : shares)
      for (double t : shares)
        if (is_off(s, t)) return false;
    return !is_off(0.25, 0) && !is_off(0, 0.25) && !is_off(0.75, 0) && !is_off(0, 0.75);
  }

 private:
  Vec3 on_surface(int k, Vec3 target) const {
    const int column = k % 3, row = k / 3;
    const Vec2 p = place(0.5 * column, 0.5 * row);
    if (k % 2 == 1 || k == 4) return foot(block_, surface_, p, target);
    return slope_at(*block_.chart, surface_, p).x;
  }

  Vec2 place(double s, double t) const { return block_.coarse.in_cell(i_, j_, s, t); }

  Vec3 at(double s, double t) const {
    auto shape = [](double r) { return std::array{(1 - r) * (1 - 2 * r), 4 * r * (1 - r), r * (2 * r - 1)}; };
    Vec3 sum;
    for (std::size_t k = 0; k < 9; ++k) sum += shape(s)[k % 3] * shape(t)[k / 3] * x_[k];
    return sum;
  }

  const MappedBlock& block_;
  const Surface& surface_;
  const int i_, j_;
  std::array<Vec3, 9> x_;
};

bool follows(const MappedBlock& block, const Surface& surface, double h) {
  for (int j = 0; j < block.coarse.n; ++j)
    for (int i = 0; i < block.coarse.m; ++i)
      if (!CurvedQuad(block, surface, i, j).is_near(h)) return false;
  return true;
}

}  // namespace

Meridian::Meridian(const ClosedFace& face) : face_(face), arc_{0} {
  constexpr int cells = 64;
  const MeridianTable table(face.surface, face.box, cells);
  for (int i = 0; i < table.cells(); ++i) arc_.push_back(arc_.back() + table.height(i));
}

Vec2 Meridian::uv(double turns, double share) const {
  const double wish = share * arc_.back();
  const std::size_t i = cell_of(arc_, wish);
  const double step = (face_.box.hi.y - face_.box.lo.y) / static_cast<double>(arc_.size() - 1);
  const double y = face_.box.lo.y + step * (static_cast<double>(i) + (wish - arc_[i]) / (arc_[i + 1] - arc_[i]));
  return face_.box.uv({face_.box.lo.x + turns * face_.period, std::clamp(y, face_.box.lo.y, face_.box.hi.y)});
}

std::shared_ptr<const Chart> make_plain_chart(Vec2 scale) { return std::make_shared<PlainChart>(scale); }

FaceExtent measure_extent(const ClosedFace& face) {
  constexpr int across = 32, along = 64;
  const ParameterBox& box = face.box;
  FaceExtent extent;
  double dx = (box.hi.x - box.lo.x) / across, dy = (box.hi.y - box.lo.y) / along;
  for (int j = 0; j < along; ++j) {
    double row = 0;
    for (int i = 0; i < across; ++i) {
      Vec2 uv = face.box.uv({box.lo.x + (i + 0.5) * dx, box.lo.y + (j + 0.5) * dy});
      auto [x, a, b] = face.surface.slope(uv);
      if (box.is_swapped) std::swap(a, b);
      double h = face.size.at(uv, face.surface);
      extent.elements += norm(cross(a, b)) * dx * dy / (h * h);
      extent.tall += norm(b) * dy / across;
      row += norm(a) * dx;
    }
    extent.round += row / along;
    extent.girth = std::max(extent.girth, row);
  }
  return extent;
}

bool is_good(const GridFigures& figures, double most_uneven, double most_turn) {
  return figures.variation <= most_uneven && figures.worst >= least_jacobian && figures.turn <= most_turn;
}

BlockGrid placed_grid(const ClosedFace& face, const BlockLayout& layout, const BlockGrid::Places& places, long most,
                      const Progress& progress) {
  return smoothed_grid(layout.limited(most), layout, face.surface, face.size, places, {}, {}, progress);
}

std::shared_ptr<const ClosedLayout> mapped(const ClosedFace& face, const BlockLayout& layout, const BlockGrid& grid,
                                           double turn) {
  auto closed = std::make_shared<ClosedLayout>();
  closed->layout = layout;
  for (std::size_t b = 0; b < layout.blocks.size(); ++b) {
    auto block = std::make_shared<MappedBlock>();
    block->chart = layout.blocks[b].chart;
    block->coarse = grid.places(b);
    block->fine = layout.blocks[b].count;
    block->is_clockwise = grid.is_clockwise(b);
    if (!is_positive(*block) || (turn > far_turn && !follows(*block, face.surface, face.size.own()))) return nullptr;
    closed->blocks.push_back(std::move(block));
  }
  return closed;
}

}  // namespace paver
