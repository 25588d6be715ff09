// A region that is a dome: a patch with a bump, inside a circle of its parameters.
#pragma once

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "charts/chart.h"
#include "regions/region.h"
#include "support/fake_model.h"

namespace paver::test {

/// Over the unit square, its border in the plane z = 0; the middle is 9/16 of `height` above it.
inline fake::CubicPatch bump(double height) {
  std::array<Vec3, 16> points;
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t i = 0; i < 4; ++i)
      points[i + 4 * j] = {static_cast<double>(i) / 3, static_cast<double>(j) / 3,
                           (i == 1 || i == 2) && (j == 1 || j == 2) ? height : 0};
  return fake::CubicPatch(points);
}

/// Loop through these places of the chart.
inline Region region_on(std::shared_ptr<const Surface> surface, const std::vector<Vec2>& places, double h) {
  Region region;
  region.surface = std::move(surface);
  region.chart = make_row_chart(*region.surface, {{-1, -1}, {1, 1}});
  region.size = FaceSize(h);
  region.h = h;
  std::vector<LoopNode>& loop = region.loops.emplace_back();
  for (Vec2 uv : places)
    loop.push_back(
        {100 + static_cast<int>(loop.size()), 0, region.chart->to_chart(uv), region.surface->point(uv), h, fake::pi});
  return region;
}

/// On a circle about the middle of the unit square.
inline std::vector<Vec2> circle(int n) {
  std::vector<Vec2> places;
  for (int i = 0; i < n; ++i) {
    const double t = 2 * fake::pi * i / n;
    places.push_back({0.5 + 0.5 * std::cos(t), 0.5 + 0.5 * std::sin(t)});
  }
  return places;
}

inline Region dome(double height, int n, double h) {
  return region_on(std::make_shared<fake::CubicPatch>(bump(height)), circle(n), h);
}

}  // namespace paver::test
