// Discs: four nodes of valence 3, boundary kept, paving where no grid fits.
#include "paving/disc_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "charts/chart.h"
#include "structured/grid_smoothing.h"
#include "support/fake_model.h"

namespace paver {
namespace {

/// Ellipse with half axes a and b in the plane z = 0, `n` nodes about equally far apart.
Region ellipse(double a, double b, int n, double h) {
  Region region;
  region.surface = std::make_shared<fake::Plane>(Vec3{}, Vec3{1, 0, 0}, Vec3{0, 1, 0});
  region.chart = make_row_chart(*region.surface, {{-a, -b}, {a, b}});
  region.size = FaceSize(h);
  region.h = h;
  region.area = fake::pi * a * b;
  std::vector<Vec2> fine;
  std::vector<double> length{0};
  for (int i = 0; i <= 10000; ++i) {
    double t = 2 * fake::pi * i / 10000;
    fine.push_back({a * std::cos(t), b * std::sin(t)});
    if (i > 0)
      length.push_back(length.back() + norm(fine[static_cast<std::size_t>(i)] - fine[static_cast<std::size_t>(i - 1)]));
  }
  std::vector<LoopNode>& loop = region.loops.emplace_back();
  for (std::size_t i = 0, k = 0; k < static_cast<std::size_t>(n); ++i)
    if (length[i] >= length.back() * static_cast<double>(k) / n) {
      Vec2 p = region.chart->to_chart(fine[i]);
      loop.push_back({static_cast<int>(100 + k++), 0, p, {fine[i].x, fine[i].y, 0}, h, fake::pi});
    }
  return region;
}

std::map<int, int> interior_valences(const RegionMesh& mesh) {
  std::map<int, int> found;
  for (int i = 0; i < mesh.node_count(); ++i)
    if (mesh.global[static_cast<std::size_t>(i)] < 0) ++found[mesh.star[i].size()];
  return found;
}

GridFigures figures_of(const Region& region, const RegionMesh& mesh) {
  GluedGrid grid;
  grid.charts = {region.chart};
  grid.chart.assign(mesh.p.size(), 0);
  grid.mesh = mesh;
  return measure_grid(grid);
}

TEST(DiscGrid, HasFourIrregularNodesAndEvenEdges) {
  for (int n : {20, 26, 32, 50, 64, 112}) {
    SCOPED_TRACE(n);
    double h = 2 * fake::pi / n;
    Region region = ellipse(1, 1, n, h);
    auto mesh = lay_disc(region, {});
    ASSERT_TRUE(mesh);
    std::map<int, int> valences = interior_valences(*mesh);
    EXPECT_EQ(valences[3], 4);
    EXPECT_LE(valences.size(), 2u);
    GridFigures figures = figures_of(region, *mesh);
    EXPECT_LT(figures.variation, 0.14);
    EXPECT_GT(figures.worst, 0.7);
    EXPECT_NEAR(static_cast<double>(mesh->elements.size()) * h * h / fake::pi, 1, n > 40 ? 0.1 : 0.45);
  }
}

TEST(DiscGrid, KeepsEveryNodeOfTheLoopInItsPlace) {
  Region region = ellipse(1.3, 1, 46, 0.158);
  auto mesh = lay_disc(region, {});
  ASSERT_TRUE(mesh);
  std::map<int, Vec3> wanted;
  for (const LoopNode& node : region.loops[0]) wanted[node.global] = node.x;
  for (std::size_t i = 0; i < mesh->p.size(); ++i) {
    if (mesh->global[i] < 0) continue;
    EXPECT_EQ(mesh->x[i], wanted.at(mesh->global[i]));
    wanted.erase(mesh->global[i]);
  }
  EXPECT_TRUE(wanted.empty());
  double area = 0;
  for (const Element& e : mesh->elements)
    area += 0.5 * cross(mesh->p[e.v[2]] - mesh->p[e.v[0]], mesh->p[e.v[3]] - mesh->p[e.v[1]]);
  EXPECT_NEAR(area, region.area, 0.01 * region.area);
}

TEST(DiscGrid, LaysRimsOfFewNodesForTheSakeOfAnglesWhereTheirFacetsAreShort) {
  for (const auto& [n, quads] : {std::pair{8, 12u}, {10, 16u}}) {
    SCOPED_TRACE(n);
    const Region region = ellipse(1, 1, n, 10);
    const auto mesh = lay_disc(region, {});
    ASSERT_TRUE(mesh);
    EXPECT_EQ(mesh->elements.size(), quads);
    EXPECT_GT(figures_of(region, *mesh).worst, 0.8);
  }
  EXPECT_FALSE(lay_disc(ellipse(1, 1, 16, 10), {}));
}

TEST(DiscGrid, LeavesToPavingWhatIsNoDiscOrHasItsNodesElsewhere) {
  Region odd = ellipse(1, 1, 31, 0.2), cornered = ellipse(1, 1, 32, 0.2), fine = ellipse(1, 1, 32, 0.05);
  cornered.loops[0][5].angle = 0.5 * fake::pi;
  Region ring = ellipse(1, 1, 32, 0.2);
  ring.loops.push_back(ellipse(0.5, 0.5, 16, 0.2).loops[0]);
  EXPECT_FALSE(lay_disc(odd, {}));
  EXPECT_FALSE(lay_disc(cornered, {}));
  EXPECT_FALSE(lay_disc(ring, {}));
  EXPECT_FALSE(lay_disc(ellipse(3, 1, 80, 0.165), {})) << "long: paving is more even";
  EXPECT_FALSE(lay_disc(fine, {})) << "few nodes on the loop for elements so small";
}

}  // namespace
}  // namespace paver
