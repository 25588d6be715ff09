// Extent of a closed face, judgement of a grid and outlines of patches.
#include "regions/closed_grid_parts.h"

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

double signed_area(const GridPatch& patch, const std::vector<Vec2>& p) {
  double area = 0;
  for (const auto& q : patch.quads) area += cross(p[q[2]] - p[q[0]], p[q[3]] - p[q[1]]);
  return area;
}

/// Per node: where the outline's side from it leads, or -1.
std::vector<int> outline_sides(const GridPatch& patch) {
  std::vector<std::array<int, 4>> ends(patch.node.size(), {-1, -1, -1, -1});  // of the sides that start at a node
  for (const auto& q : patch.quads)
    for (std::size_t k = 0; k < 4; ++k) *std::find(ends[q[k]].begin(), ends[q[k]].end() - 1, -1) = q[(k + 1) % 4];
  std::vector<int> next(patch.node.size(), -1);
  for (int from = 0; from < static_cast<int>(next.size()); ++from)
    for (int to : ends[from])
      if (to >= 0 && std::find(ends[to].begin(), ends[to].end(), from) == ends[to].end()) next[from] = to;
  return next;
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
  std::vector<Vec2> p;
  p.reserve(patch.uv.size());
  for (Vec2 uv : patch.uv) p.push_back(patch.chart->to_chart(uv));
  if (signed_area(patch, p) < 0)
    for (auto& q : patch.quads) std::swap(q[1], q[3]);
  for (const auto& q : patch.quads)
    for (std::size_t k = 0; k < 4; ++k)
      if (orientation(p[q[k]], p[q[(k + 1) % 4]], p[q[(k + 2) % 4]]) <= 0) return false;
  const std::vector<int> next = outline_sides(patch);
  auto is_on_outline = [](int to) { return to >= 0; };
  const int first = static_cast<int>(std::find_if(next.begin(), next.end(), is_on_outline) - next.begin());
  int node = first;
  do {
    patch.outline.push_back(node);
    node = next[node];
  } while (node >= 0 && node != first);
  return node == first &&
         static_cast<long>(patch.outline.size()) == std::count_if(next.begin(), next.end(), is_on_outline);
}

}  // namespace paver
