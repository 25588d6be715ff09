// Grids of closed faces: valences, soundness, evenness and counts on spheres, ellipsoids of revolution and tori.
#include "regions/closed_grid.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "brep/evaluators_impl.h"
#include "mesh/region_mesh.h"
#include "regions/closed_grid_parts.h"

namespace paver {
namespace {

constexpr double pi = std::numbers::pi;

std::shared_ptr<const Surface> evaluator(const Handle(Geom_Surface) & surface) {
  return make_surface(BRepBuilderAPI_MakeFace(surface, 1e-7).Face(), 0);
}

/// Ellipsoid of revolution, half axes 1, 1 and `height`; `v` from pole to pole as a sphere's.
class Ellipsoid : public Surface {
 public:
  explicit Ellipsoid(double height) : height_(height) {}
  Vec3 point(Vec2 q) const override {
    return {std::cos(q.y) * std::cos(q.x), std::cos(q.y) * std::sin(q.x), height_ * std::sin(q.y)};
  }
  void d1(Vec2 q, Vec3& x, Vec3& xu, Vec3& xv) const override {
    x = point(q);
    xu = {-x.y, x.x, 0};
    xv = {-std::sin(q.y) * std::cos(q.x), -std::sin(q.y) * std::sin(q.x), height_ * std::cos(q.y)};
  }
  void d2(Vec2, Vec3&, Vec3&, Vec3&, Vec3&, Vec3&, Vec3&) const override {}
  SurfaceKind kind() const override { return SurfaceKind::other; }
  Vec2 period() const override { return {2 * pi, 0}; }
  std::unique_ptr<Surface> clone() const override { return std::make_unique<Ellipsoid>(*this); }

 private:
  double height_;
};

ParameterBox poles_box() { return {{0, -pi / 2}, {2 * pi, pi / 2}, false, true, true}; }

ClosedFace ball(const Surface& surface, const FaceSize& size) {
  return {surface, size, poles_box(), 2 * pi, 0, pi / 4};
}

ClosedFace ring(const Surface& surface, const FaceSize& size) {
  return {surface, size, {{0, 0}, {2 * pi, 2 * pi}}, 2 * pi, 2 * pi, pi / 4};
}

struct Figures {
  std::map<int, int> valences;  // how many nodes of each
  int quads = 0;
  double worst = 2, mean = 0, variation = 0;
};

// From the patches alone: the glued grid must come out of them again.
Figures judge(const ClosedGrid& grid, const Surface& surface) {
  Figures figures;
  std::set<std::pair<int, int>> sides;
  double sum = 0, squares = 0;
  for (const GridPatch& patch : grid.patches) {
    RegionMesh mesh;
    for (Vec2 uv : patch.uv) mesh.add_node(patch.chart->to_chart(uv), surface.point(uv), {}, {}, 1);
    for (const auto& q : patch.quads) {
      int e = mesh.add_element(q);
      double sj = scaled_jacobian(mesh, mesh.elements[static_cast<std::size_t>(e)]);
      figures.worst = std::min(figures.worst, sj);
      figures.mean += sj;
      ++figures.quads;
      for (std::size_t k = 0; k < 4; ++k) {
        int a = q[k], b = q[(k + 1) % 4];
        if (!sides.insert(std::minmax(patch.node[a], patch.node[b])).second) continue;
        double length = norm(mesh.x[a] - mesh.x[b]);
        sum += length, squares += length * length;
      }
    }
  }
  std::map<int, int> valence;
  for (auto [a, b] : sides) ++valence[a], ++valence[b];
  for (auto [node, count] : valence) ++figures.valences[count];
  double n = static_cast<double>(sides.size()), mean = sum / n;
  figures.mean /= figures.quads;
  figures.variation = std::sqrt(squares / n - mean * mean) / mean;
  return figures;
}

TEST(CubeGrid, ASphereHasEightNodesOfValenceThreeAndNoOtherIrregularOne) {
  auto sphere = evaluator(new Geom_SphericalSurface(gp_Ax3(), 10));
  for (double h : {9.0, 5.0, 2.0, 1.12, 0.5}) {
    SCOPED_TRACE(h);
    FaceSize size(h);
    auto grid = make_cube_grid(ball(*sphere, size), {});
    ASSERT_TRUE(grid);
    ASSERT_EQ(grid->patches.size(), 6u);
    for (const GridPatch& patch : grid->patches) EXPECT_EQ(patch.quads.size(), grid->patches[0].quads.size());
    Figures figures = judge(*grid, *sphere);
    EXPECT_EQ(figures.valences[3], 8);
    EXPECT_EQ(figures.valences.size(), figures.quads > 6 ? 2u : 1u);
    EXPECT_GT(figures.worst, 0.8);
    EXPECT_LT(figures.variation, 0.12);
  }
}

TEST(CubeGrid, AFineSphereIsEvenAndHasAsManyElementsAsAsked) {
  auto sphere = evaluator(new Geom_SphericalSurface(gp_Ax3(), 10));
  FaceSize size(1.121);
  auto grid = make_cube_grid(ball(*sphere, size), {});
  ASSERT_TRUE(grid);
  Figures figures = judge(*grid, *sphere);
  EXPECT_EQ(figures.quads, 6 * 13 * 13);  // 1000 asked
  EXPECT_LT(figures.variation, 0.08);
  EXPECT_GT(figures.mean, 0.985);
}

TEST(CubeGrid, LongAndFlatBodiesGetMoreOrFewerRowsBetweenTheirCaps) {
  for (double height : {0.5, 1.5, 2.0, 4.0}) {
    SCOPED_TRACE(height);
    Ellipsoid surface(height);
    FaceSize size(0.1);
    auto grid = make_cube_grid(ball(surface, size), {});
    ASSERT_TRUE(grid);
    std::size_t cap = grid->patches[0].quads.size(), side = grid->patches[2].quads.size();
    EXPECT_EQ(side < cap, height < 1);
    Figures figures = judge(*grid, surface);
    EXPECT_EQ(figures.valences[3], 8);
    EXPECT_LT(figures.variation, 0.12);
    EXPECT_GT(figures.worst, 0.75);
    FaceExtent extent = measure_extent(ball(surface, size));
    EXPECT_NEAR(figures.quads / extent.elements, 1, 0.05);
  }
}

TEST(TorusGrid, HasNoIrregularNodeAndAsManyElementsAsAsked) {
  for (double minor : {5.0, 20.0, 35.0}) {
    SCOPED_TRACE(minor);
    auto torus = evaluator(new Geom_ToroidalSurface(gp_Ax3(), 100, minor));
    FaceSize size(minor / 5);
    auto grid = make_torus_grid(ring(*torus, size), {});
    ASSERT_TRUE(grid);
    Figures figures = judge(*grid, *torus);
    EXPECT_EQ(figures.valences.size(), 1u);
    EXPECT_EQ(figures.valences.begin()->first, 4);
    EXPECT_NEAR(figures.quads * minor * minor / 25 / (4 * pi * pi * 100 * minor), 1, 0.05);
    EXPECT_LT(figures.variation, 0.115);
    EXPECT_GT(figures.worst, 0.8);
  }
}

// Most of these nodes stay where they were interpolated.
TEST(ClosedGrid, LargeOnesAreAsEvenAsSmallOnes) {
  auto sphere = evaluator(new Geom_SphericalSurface(gp_Ax3(), 10));
  auto torus = evaluator(new Geom_ToroidalSurface(gp_Ax3(), 100, 20));
  Ellipsoid flat(0.5), tall(2.0);
  auto figures_at = [](const Surface& surface, double h, bool is_torus) {
    FaceSize size(h);
    auto grid = is_torus ? make_torus_grid(ring(surface, size), {}) : make_cube_grid(ball(surface, size), {});
    return grid ? judge(*grid, surface) : Figures{};
  };
  for (auto [surface, h] :
       {std::pair<const Surface*, double>{sphere.get(), 0.13}, {&flat, 0.01}, {&tall, 0.016}, {torus.get(), 1.1}}) {
    const bool is_torus = surface == torus.get();
    Figures large = figures_at(*surface, h, is_torus), small = figures_at(*surface, 2 * h, is_torus);
    EXPECT_GT(large.quads, 50000);
    EXPECT_LT(small.quads, 50000);
    EXPECT_GT(large.worst, small.worst - 0.02);
    EXPECT_GT(large.mean, small.mean - 0.002);
    EXPECT_LT(large.variation, small.variation + 0.005);
  }
}

TEST(TorusGrid, LeavesAFatTubeToPaving) {
  auto torus = evaluator(new Geom_ToroidalSurface(gp_Ax3(), 100, 90));
  FaceSize size(10);
  EXPECT_FALSE(make_torus_grid(ring(*torus, size), {}));
}

TEST(ClosedGrid, OutlinesHoldTheCutNodesAndNothingElse) {
  auto sphere = evaluator(new Geom_SphericalSurface(gp_Ax3(), 10));
  auto torus = evaluator(new Geom_ToroidalSurface(gp_Ax3(), 10, 3));
  FaceSize size(1);
  for (const auto& grid : {make_cube_grid(ball(*sphere, size), {}), make_torus_grid(ring(*torus, size), {})}) {
    ASSERT_TRUE(grid);
    std::vector<int> uses(grid->h.size(), 0);
    for (const GridPatch& patch : grid->patches)
      for (int node : patch.node) ++uses[static_cast<std::size_t>(node)];
    for (const GridPatch& patch : grid->patches) {
      std::set<int> on_outline(patch.outline.begin(), patch.outline.end());
      EXPECT_EQ(on_outline.size(), patch.outline.size());
      for (std::size_t v = 0; v < patch.node.size(); ++v)
        EXPECT_EQ(uses[static_cast<std::size_t>(patch.node[v])] > 1, on_outline.count(static_cast<int>(v)) > 0) << v;
    }
  }
}

TEST(ClosedGrid, StopsWhenCancelled) {
  auto sphere = evaluator(new Geom_SphericalSurface(gp_Ax3(), 10));
  FaceSize size(1);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(make_cube_grid(ball(*sphere, size), progress), Error);
}

}  // namespace
}  // namespace paver
