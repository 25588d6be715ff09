// Layouts of closed faces: valences, soundness, evenness and counts on spheres, ellipsoids of revolution and tori.
#include "structured/closed_layout.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "brep/surfaces/evaluators_impl.h"
#include "mesh/region_mesh.h"

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
  SurfaceSlope slope(Vec2 q) const override {
    const Vec3 x = point(q);
    return {
        x, {-x.y, x.x, 0}, {-std::sin(q.y) * std::cos(q.x), -std::sin(q.y) * std::sin(q.x), height_ * std::cos(q.y)}};
  }
  SurfaceJet jet(Vec2 q) const override { return {slope(q)}; }
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

Figures judge(const ClosedLayout& closed, const Surface& surface) {
  Figures figures;
  const BlockNumbers numbers(closed.layout);
  std::set<std::pair<int, int>> sides;
  double sum = 0, squares = 0;
  for (std::size_t b = 0; b < closed.blocks.size(); ++b) {
    const MappedBlock& block = *closed.blocks[b];
    const auto [m, n] = block.fine;
    RegionMesh mesh;
    std::vector<int> number;
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= m; ++i) {
        const Vec2 p = block.place(i, j);
        mesh.add_node(p, surface.point(block.chart->uv(p)), {}, {}, 1);
        number.push_back(numbers.node(b, i, j));
      }
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < m; ++i) {
        const int first = j * (m + 1) + i;
        const std::array<int, 4> q{first, first + 1, first + m + 2, first + m + 1};
        double sj = scaled_jacobian(mesh, mesh.elements[static_cast<std::size_t>(mesh.add_element(q))]);
        figures.worst = std::min(figures.worst, sj);
        figures.mean += sj;
        ++figures.quads;
        for (std::size_t k = 0; k < 4; ++k) {
          const std::size_t from = static_cast<std::size_t>(q[k]), to = static_cast<std::size_t>(q[(k + 1) % 4]);
          if (!sides.insert(std::minmax(number[from], number[to])).second) continue;
          double length = norm(mesh.x[from] - mesh.x[to]);
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

TEST(Cube, ASphereHasEightNodesOfValenceThreeAndNoOtherIrregularOne) {
  auto sphere = evaluator(new Geom_SphericalSurface(gp_Ax3(), 10));
  for (double h : {9.0, 4.8, 2.0, 1.12, 0.5}) {
    SCOPED_TRACE(h);
    FaceSize size(h);
    auto grid = lay_cube(ball(*sphere, size), {});
    ASSERT_TRUE(grid);
    ASSERT_EQ(grid->blocks.size(), 6u);
    for (std::size_t k = 0; k < 2; ++k) EXPECT_EQ(grid->blocks[k]->fine, grid->blocks[k + 2]->fine);
    EXPECT_EQ(grid->blocks[4]->fine, (std::array{grid->blocks[0]->fine[0], grid->blocks[1]->fine[0]}));
    Figures figures = judge(*grid, *sphere);
    EXPECT_EQ(figures.valences[3], 8);
    EXPECT_EQ(figures.valences.size(), figures.quads > 6 ? 2u : 1u);
    EXPECT_GT(figures.worst, 0.8);
    EXPECT_LT(figures.variation, 0.12);
  }
}

// Six equal sides have 6 n^2 quads only; sides that differ and prisms fill the gaps. There is none of 28.
TEST(ClosedLayout, ASphereHasAsManyElementsAsAsked) {
  auto sphere = evaluator(new Geom_SphericalSurface(gp_Ax3(), 10));
  for (double asked = 24; asked < 3000; asked *= 1.05) {
    FaceSize size(std::sqrt(4 * M_PI * 100 / asked));
    auto grid = lay_cube(ball(*sphere, size), {});
    ASSERT_TRUE(grid);
    const Figures figures = judge(*grid, *sphere);
    EXPECT_NEAR(figures.quads / asked, 1, asked > 27.5 && asked < 28.5 ? 0.07 : 0.05) << asked;
    EXPECT_LT(figures.variation, asked > 170 ? 0.1 : 0.17) << asked;
    EXPECT_GT(figures.worst, asked > 170 ? 0.85 : 0.8) << asked;
  }
}

TEST(Prism, HasAPoleOfThreeToFiveAtEitherEndAndCornersOfValenceThree) {
  auto sphere = evaluator(new Geom_SphericalSurface(gp_Ax3(), 10));
  for (double asked : {29.0, 36.0, 60.0, 73.0, 104.0, 160.0}) {
    SCOPED_TRACE(asked);
    FaceSize size(std::sqrt(4 * M_PI * 100 / asked));
    auto prism = lay_prism(ball(*sphere, size), 0.05, {});
    ASSERT_TRUE(prism);
    const int sides = static_cast<int>(prism->blocks.size()) / 4;
    EXPECT_EQ(prism->blocks.size(), static_cast<std::size_t>(4 * sides));
    Figures figures = judge(*prism, *sphere);
    EXPECT_EQ(figures.valences[3], 2 * sides + (sides == 3 ? 2 : 0));
    EXPECT_EQ(figures.valences[5], sides == 5 ? 2 : 0);
    EXPECT_NEAR(figures.quads / asked, 1, 0.05);
    EXPECT_GT(figures.worst, 0.8);
    EXPECT_LT(figures.variation, 0.17);
  }
}

TEST(Prism, NothingWhereNoneIsAsNearAsAskedFor) {
  auto sphere = evaluator(new Geom_SphericalSurface(gp_Ax3(), 10));
  FaceSize between(std::sqrt(4 * M_PI * 100 / 28)), coarse(100);
  EXPECT_FALSE(lay_prism(ball(*sphere, between), 0.05, {}));
  EXPECT_FALSE(lay_prism(ball(*sphere, coarse), 1, {}));
}

TEST(Cube, AFineSphereIsEvenAndHasAsManyElementsAsAsked) {
  auto sphere = evaluator(new Geom_SphericalSurface(gp_Ax3(), 10));
  FaceSize size(1.121);
  auto grid = lay_cube(ball(*sphere, size), {});
  ASSERT_TRUE(grid);
  Figures figures = judge(*grid, *sphere);
  EXPECT_EQ(figures.quads, 6 * 13 * 13);  // 1000 asked
  EXPECT_LT(figures.variation, 0.08);
  EXPECT_GT(figures.mean, 0.985);
}

TEST(Cube, LongAndFlatBodiesGetMoreOrFewerRowsBetweenTheirCaps) {
  for (double height : {0.5, 1.5, 2.0, 4.0}) {
    SCOPED_TRACE(height);
    Ellipsoid surface(height);
    FaceSize size(0.1);
    auto grid = lay_cube(ball(surface, size), {});
    ASSERT_TRUE(grid);
    const std::array<int, 2> side = grid->blocks[0]->fine;
    EXPECT_EQ(side[1] < side[0], height < 1);
    Figures figures = judge(*grid, surface);
    EXPECT_EQ(figures.valences[3], 8);
    EXPECT_LT(figures.variation, 0.12);
    EXPECT_GT(figures.worst, 0.75);
    FaceExtent extent = measure_extent(ball(surface, size));
    EXPECT_NEAR(figures.quads / extent.elements, 1, 0.05);
  }
}

TEST(Torus, ASlenderOneHasNoIrregularNode) {
  auto torus = evaluator(new Geom_ToroidalSurface(gp_Ax3(), 100, 5));
  FaceSize size(1);
  auto grid = lay_torus(ring(*torus, size), {});
  ASSERT_TRUE(grid);
  Figures figures = judge(*grid, *torus);
  EXPECT_EQ(figures.valences.size(), 1u);
  EXPECT_NEAR(figures.quads / (4 * pi * pi * 100 * 5), 1, 0.05);
  EXPECT_LT(figures.variation, 0.04);
  EXPECT_GT(figures.worst, 0.98);
}

// Radii 100 and 35: the outer side is twice as long as the inner one.
TEST(Torus, HasMoreColumnsOnItsOuterSide) {
  auto torus = evaluator(new Geom_ToroidalSurface(gp_Ax3(), 100, 35));
  for (double h : {12.0, 7.0, 3.0}) {
    SCOPED_TRACE(h);
    FaceSize size(h);
    auto grid = lay_torus(ring(*torus, size), {});
    ASSERT_TRUE(grid);
    Figures figures = judge(*grid, *torus);
    const double cells = static_cast<double>(grid->blocks.size()) / 8;  // each has two nodes of either kind
    EXPECT_EQ(figures.valences.size(), 3u);
    EXPECT_EQ(figures.valences[3], 2 * cells);
    EXPECT_EQ(figures.valences[5], 2 * cells);
    EXPECT_NEAR(figures.quads * h * h / (4 * pi * pi * 100 * 35), 1, 0.05);
    EXPECT_LT(figures.variation, 0.095);
    EXPECT_GT(figures.mean, 0.97);
    EXPECT_GT(figures.worst, 0.75);
  }
}

// A turn of 45 degrees asks for eight quads either way.
TEST(Torus, AThinOneHasAsManyRowsAsTheTurnAsksFor) {
  for (const auto& [minor, h, quads] : {std::tuple{35.0, 1000.0, 8 * 8}, {10.0, 60.0, 10 * 8}, {10.0, 25.0, 25 * 8}}) {
    SCOPED_TRACE(h);
    auto torus = evaluator(new Geom_ToroidalSurface(gp_Ax3(), 100, minor));
    FaceSize size(h);
    auto grid = lay_torus(ring(*torus, size), {});
    ASSERT_TRUE(grid);
    Figures figures = judge(*grid, *torus);
    EXPECT_EQ(figures.quads, quads);
    EXPECT_EQ(figures.valences.size(), 1u);
    EXPECT_GT(figures.worst, 0.9);
  }
}

// Most of these nodes stay where they were interpolated.
TEST(ClosedLayout, LargeOnesAreAsEvenAsSmallOnes) {
  auto sphere = evaluator(new Geom_SphericalSurface(gp_Ax3(), 10));
  auto torus = evaluator(new Geom_ToroidalSurface(gp_Ax3(), 100, 20));
  Ellipsoid flat(0.5), tall(2.0);
  auto figures_at = [](const Surface& surface, double h, bool is_torus) {
    FaceSize size(h);
    auto grid = is_torus ? lay_torus(ring(surface, size), {}) : lay_cube(ball(surface, size), {});
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

TEST(Torus, LeavesAFatTubeToPaving) {
  auto torus = evaluator(new Geom_ToroidalSurface(gp_Ax3(), 100, 90));
  FaceSize size(10);
  EXPECT_FALSE(lay_torus(ring(*torus, size), {}));
}

TEST(ClosedLayout, StopsWhenCancelled) {
  auto sphere = evaluator(new Geom_SphericalSurface(gp_Ax3(), 10));
  FaceSize size(1);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(lay_cube(ball(*sphere, size), progress), Error);
}

}  // namespace
}  // namespace paver
