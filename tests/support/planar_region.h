// Regions in the plane z = 0, built in code: the chart is (u, v) itself.
#pragma once

#include <vector>

#include "mesh/region_mesh.h"
#include "regions/region.h"

namespace paver::test {

/// Sides of a polygon divided into pieces of about h, at least one; with `is_even`, the longest side takes one more
/// piece where the total would be odd. Corners stay.
std::vector<Vec2> divided(const std::vector<Vec2>& corners, double h, bool is_even = true);

/// n points on a circle, counter-clockwise from the angle `start`.
std::vector<Vec2> circle(Vec2 centre, double radius, int n, double start = 0);

std::vector<Vec2> reversed(std::vector<Vec2> points);

/// Region with the given loops of nodes (holes clockwise), numbered globally one after another. Equal points of
/// different loops are one boundary node. Target length h everywhere, at the nodes the mean of their two facets.
Region planar_region(const std::vector<std::vector<Vec2>>& loops, double h);

/// Area inside the region's loops, in the chart.
double chart_area(const Region& region);
/// Of the mesh's elements.
double chart_area(const RegionMesh& mesh);

}  // namespace paver::test
