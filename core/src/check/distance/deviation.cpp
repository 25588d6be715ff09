#include "check/distance/deviation.h"

#include <algorithm>
#include <span>

#include "curving/near_surface.h"

namespace paver {
namespace {

// Quarters find what bends evenly; near the middles of sides lies what an element bridges beyond a ridge.
constexpr Vec2 in_quad[] = {{0.25, 0.25}, {0.75, 0.25}, {0.25, 0.75}, {0.75, 0.75},
                            {0.5, 0.125}, {0.875, 0.5}, {0.5, 0.875}, {0.125, 0.5}};
constexpr Vec2 in_triangle[] = {{0.2, 0.2}, {0.6, 0.2}, {0.2, 0.6}};

}  // namespace

Vec2 place_at(const Region& region, int corners, const std::array<Vec2, 4>& p, Vec2 uv) {
  const Chart& chart = *region.chart;
  if (corners == 4) return chart.between(chart.between(p[0], p[1], uv.x), chart.between(p[3], p[2], uv.x), uv.y);
  const double far = uv.x + uv.y;
  return far > 0 ? chart.between(p[0], chart.between(p[1], p[2], uv.y / far), far) : p[0];
}

double deviation(const Region& region, const ElementPatch& element, const std::array<Vec2, 4>& places, double known) {
  const std::span<const Vec2> points = element.corners == 4 ? std::span<const Vec2>(in_quad) : in_triangle;
  const double scale = norm(element.nodes[2] - element.nodes[0]);
  double most = 0;
  for (Vec2 uv : points)
    most = std::max(most, distance_to_surface(region, place_at(region, element.corners, places, uv), element.at(uv),
                                              scale, std::max(known, most)));
  return most;
}

}  // namespace paver
