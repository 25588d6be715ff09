#include "support/planar_region.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "support/fake_model.h"

namespace paver::test {
namespace {

class PlaneChart : public Chart {
 public:
  Vec2 to_chart(Vec2 uv) const override { return uv; }
  ChartSlope slope(Vec2 p) const override { return {p, {1, 0}, {0, 1}}; }
};

}  // namespace

std::vector<Vec2> divided(const std::vector<Vec2>& corners, double h, bool is_even) {
  std::size_t n = corners.size(), longest = 0;
  std::vector<int> pieces;
  int total = 0;
  auto side = [&](std::size_t i) { return corners[(i + 1) % n] - corners[i]; };
  for (std::size_t i = 0; i < n; ++i) {
    pieces.push_back(std::max(1, static_cast<int>(std::lround(norm(side(i)) / h))));
    total += pieces.back();
    if (norm(side(i)) > norm(side(longest))) longest = i;
  }
  if (is_even && total % 2 == 1) ++pieces[longest];
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < n; ++i)
    for (int k = 0; k < pieces[i]; ++k) points.push_back(corners[i] + (static_cast<double>(k) / pieces[i]) * side(i));
  return points;
}

std::vector<Vec2> circle(Vec2 centre, double radius, int n, double start) {
  std::vector<Vec2> points;
  for (int i = 0; i < n; ++i) {
    double a = start + 2 * std::numbers::pi * i / n;
    points.push_back(centre + radius * Vec2{std::cos(a), std::sin(a)});
  }
  return points;
}

std::vector<Vec2> reversed(std::vector<Vec2> points) {
  std::reverse(points.begin(), points.end());
  return points;
}

Region planar_region(const std::vector<std::vector<Vec2>>& loops, double h) {
  Region region;
  region.face = 0;
  region.surface = std::make_shared<fake::Plane>(Vec3{}, Vec3{1, 0, 0}, Vec3{0, 1, 0});
  region.chart = std::make_shared<PlaneChart>();
  region.size = FaceSize(h);
  region.h = h;
  std::map<std::pair<double, double>, int> numbers;
  for (const std::vector<Vec2>& points : loops) {
    std::vector<LoopNode>& loop = region.loops.emplace_back();
    for (std::size_t i = 0, n = points.size(); i < n; ++i) {
      LoopNode node;
      node.p = points[i];
      node.x = {node.p.x, node.p.y, 0};
      node.global = numbers.try_emplace({node.p.x, node.p.y}, static_cast<int>(numbers.size())).first->second;
      node.edge = 0;
      node.h = 0.5 * (norm(points[(i + 1) % n] - node.p) + norm(points[(i + n - 1) % n] - node.p));
      loop.push_back(node);
    }
  }
  region.area = chart_area(region);
  return region;
}

double chart_area(const Region& region) {
  long double area = 0;
  for (const auto& loop : region.loops)
    for (std::size_t i = 0, n = loop.size(); i < n; ++i) {
      Vec2 a = loop[i].p - loop[0].p, b = loop[(i + 1) % n].p - loop[0].p;
      area += 0.5L * (static_cast<long double>(a.x) * b.y - static_cast<long double>(a.y) * b.x);
    }
  return static_cast<double>(area);
}

double chart_area(const RegionMesh& mesh) {
  double sum = 0;
  for (const Element& e : mesh.elements)
    for (int k = 0; e.is_alive() && k < e.corners(); ++k)
      sum += 0.5 * cross(mesh.p[e.v[k]], mesh.p[e.v[(k + 1) % e.corners()]]);
  return sum;
}

}  // namespace paver::test
