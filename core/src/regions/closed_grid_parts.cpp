// Extent of a closed face, judgement of a grid and outlines of patches.
#include "regions/closed_grid_parts.h"

#include <algorithm>
#include <cmath>
#include <map>

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

double signed_area(const GridPatch& patch) {
  double area = 0;
  for (const auto& q : patch.quads) {
    Vec2 a = patch.chart->to_chart(patch.uv[q[0]]), b = patch.chart->to_chart(patch.uv[q[1]]);
    Vec2 c = patch.chart->to_chart(patch.uv[q[2]]), d = patch.chart->to_chart(patch.uv[q[3]]);
    area += cross(c - a, d - b);
  }
  return area;
}

}  // namespace

std::shared_ptr<const Chart> make_plain_chart(Vec2 scale) { return std::make_shared<PlainChart>(scale); }

FaceExtent measure_extent(const ClosedFace& face) {
  constexpr int across = 32, along = 64;
  const ParameterBox& box = face.box;
  FaceExtent extent;
  double dx = (box.hi.x - box.lo.x) / across, dy = (box.hi.y - box.lo.y) / along;
  for (int j = 0; j < along; ++j) {
    double row = 0;
    for (int i = 0; i < across; ++i) {
      Vec2 uv = box_uv(box, {box.lo.x + (i + 0.5) * dx, box.lo.y + (j + 0.5) * dy});
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

bool finish_patch(GridPatch& patch) {
  if (signed_area(patch) < 0)
    for (auto& q : patch.quads) std::swap(q[1], q[3]);
  std::vector<Vec2> p;
  for (Vec2 uv : patch.uv) p.push_back(patch.chart->to_chart(uv));
  std::vector<std::pair<int, int>> sides;
  for (const auto& q : patch.quads)
    for (std::size_t k = 0; k < 4; ++k) {
      if (orientation(p[q[k]], p[q[(k + 1) % 4]], p[q[(k + 2) % 4]]) <= 0) return false;
      sides.push_back({q[k], q[(k + 1) % 4]});
    }
  std::sort(sides.begin(), sides.end());
  std::map<int, int> next;  // along the outline
  for (auto [from, to] : sides)
    if (!std::binary_search(sides.begin(), sides.end(), std::pair{to, from})) next[from] = to;
  int node = next.begin()->first;
  do {
    patch.outline.push_back(node);
    node = next.at(node);
  } while (node != patch.outline.front());
  return patch.outline.size() == next.size();
}

}  // namespace paver
