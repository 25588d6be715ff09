// Extent of a closed face, its grid and the blocks that follow from that.
#include "structured/closed_layout.h"

#include <algorithm>
#include <cmath>

#include "base/predicates.h"

namespace paver {
namespace {

constexpr double least_jacobian = 0.3;

class PlainChart : public Chart {
 public:
  explicit PlainChart(Vec2 scale) : scale_(scale) {}
  Vec2 to_chart(Vec2 uv) const override { return {uv.x * scale_.x, uv.y * scale_.y}; }
  void to_uv(Vec2 p, Vec2& uv, Vec2& uv_x, Vec2& uv_y) const override {
    uv = {p.x / scale_.x, p.y / scale_.y}, uv_x = {1 / scale_.x, 0}, uv_y = {0, 1 / scale_.y};
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

}  // namespace

Meridian::Meridian(const ClosedFace& face) : face_(face), arc_{0} {
  constexpr int cells = 64;
  const MeridianTable table(face.surface, face.box, cells);
  for (int i = 0; i < table.cells(); ++i) arc_.push_back(arc_.back() + table.height(i));
}

Vec2 Meridian::uv(double turns, double share) const {
  const double wish = share * arc_.back();
  const int last = static_cast<int>(arc_.size()) - 2;
  int i = static_cast<int>(std::upper_bound(arc_.begin(), arc_.end(), wish) - arc_.begin()) - 1;
  i = std::clamp(i, 0, last);
  const double step = (face_.box.hi.y - face_.box.lo.y) / (last + 1);
  const double y = face_.box.lo.y + step * (i + (wish - arc_[i]) / (arc_[i + 1] - arc_[i]));
  return face_.uv({face_.box.lo.x + turns * face_.period, std::clamp(y, face_.box.lo.y, face_.box.hi.y)});
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
      Vec2 uv = face.uv({box.lo.x + (i + 0.5) * dx, box.lo.y + (j + 0.5) * dy});
      Vec3 x, a, b;
      face.surface.d1(uv, x, a, b);
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

std::shared_ptr<const ClosedLayout> mapped(const BlockLayout& layout, const BlockGrid& grid) {
  auto closed = std::make_shared<ClosedLayout>();
  closed->layout = layout;
  for (std::size_t b = 0; b < layout.blocks.size(); ++b) {
    auto block = std::make_shared<MappedBlock>();
    block->chart = layout.blocks[b].chart;
    block->coarse = grid.places(b);
    block->fine = layout.blocks[b].count;
    block->is_clockwise = grid.is_clockwise(b);
    if (!is_positive(*block)) return nullptr;
    closed->blocks.push_back(std::move(block));
  }
  return closed;
}

}  // namespace paver
