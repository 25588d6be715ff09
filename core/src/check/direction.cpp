#include "check/direction.h"

#include <span>

#include "check/distance/deviation.h"

namespace paver {
namespace {

constexpr double sure = 0.5;  // cosine between an element's normal and the surface's
// Beside corners: a lip is narrow that ends before.
constexpr Vec2 in_quad[] = {{0.1, 0.1}, {0.9, 0.1}, {0.9, 0.9}, {0.1, 0.9}};
constexpr Vec2 in_triangle[] = {{0.1, 0.1}, {0.8, 0.1}, {0.1, 0.8}};

Vec3 surface_normal(const Region& region, Vec2 p) {
  const auto [x, xp, xq] = region.slope(p);
  return unit(cross(xp, xq));
}

bool runs_beside_corners(const Region& region, int corners, const std::array<Vec2, 4>& places, Vec3 area) {
  for (Vec2 uv : corners == 4 ? std::span<const Vec2>(in_quad) : in_triangle)
    if (dot(area, surface_normal(region, place_at(region, corners, places, uv))) < sure) return false;
  return true;
}

}  // namespace

bool runs_with_surface(const Region& region, int corners, const std::array<Vec2, 4>& places,
                       const ElementNormals& normals) {
  const Vec3 area = unit(normals.area), centre = unit(normals.centre), mean = unit(normals.corners);
  const double along = dot(area, mean);
  if (along >= sure && dot(centre, mean) >= sure) return true;
  Vec2 middle;
  for (int k = 0; k < corners; ++k) middle = middle + (1.0 / corners) * places[k];
  if (!(dot(centre, surface_normal(region, middle)) > 0)) return false;
  return along > 0 || runs_beside_corners(region, corners, places, area);
}

}  // namespace paver
