// Paving of hand-made nasty fronts. Each must end, and what comes out must be whole: see test::paved_faults().
#include "paving/pave_region.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/planar_region.h"
#include "support/validate.h"

namespace paver {
namespace {

using test::circle;
using test::divided;
using test::planar_region;
using test::reversed;

using Loops = std::vector<std::vector<Vec2>>;
constexpr double pi = std::numbers::pi;

struct Paved {
  long quads = 0, triangles = 0, closed_by_triangulation = 0;
  double worst = 1;
};

/// Paves and checks; what a test looks at besides is in the result.
Paved expect_paved(const Loops& loops, double h) {
  Region region = planar_region(loops, h);
  PavedRegion paved = pave_region(region, Progress());
  EXPECT_EQ(test::paved_faults(region, paved.mesh), "");
  Paved result;
  for (const Element& e : paved.mesh.elements) {
    if (!e.is_alive()) continue;
    ++(e.corners() == 4 ? result.quads : result.triangles);
    result.worst = std::min(result.worst, scaled_jacobian(paved.mesh, e));
  }
  result.closed_by_triangulation = paved.closed_by_triangulation;
  std::size_t nodes = 0;
  for (const auto& loop : region.loops) nodes += loop.size();
  EXPECT_EQ(result.triangles % 2, static_cast<long>(nodes % 2));
  EXPECT_GT(result.worst, 0);
  return result;
}

std::vector<Vec2> box(double width, double height, Vec2 at = {0, 0}) {
  return {at, at + Vec2{width, 0}, at + Vec2{width, height}, at + Vec2{0, height}};
}

TEST(PaveRegion, ASquareIsAGrid) {
  for (int n : {1, 2, 3, 5, 10, 31}) {
    SCOPED_TRACE(n);
    Paved paved = expect_paved({divided(box(1, 1), 1.0 / n)}, 1.0 / n);
    EXPECT_EQ(paved.quads, n * n);
    EXPECT_EQ(paved.triangles, 0);
    EXPECT_NEAR(paved.worst, 1, 1e-9);
  }
}

TEST(PaveRegion, LoopsOfFewNodesAreAsFewElements) {
  EXPECT_EQ(expect_paved({circle({0, 0}, 1, 3)}, 1.7).triangles, 1);
  EXPECT_EQ(expect_paved({circle({0, 0}, 1, 4)}, 1.4).quads, 1);
  EXPECT_EQ(expect_paved({circle({0, 0}, 1, 6)}, 1).triangles, 0);
  Paved rectangle = expect_paved({divided(box(2, 1), 1)}, 1);
  EXPECT_EQ(rectangle.quads, 2);
  Paved five = expect_paved({circle({0, 0}, 1, 5)}, 1.2);
  EXPECT_EQ(five.triangles, 1);
}

TEST(PaveRegion, Disks) {
  for (int n : {8, 12, 20, 50, 100}) {
    SCOPED_TRACE(n);
    Paved paved = expect_paved({circle({0, 0}, 1, n)}, 2 * pi / n);
    EXPECT_EQ(paved.triangles, 0);
  }
}

// Nodes of many holes lie in line with one another, and all are far nearer to each other than h.
TEST(PaveRegion, ArraysOfHoles) {
  constexpr int holes = 12;
  constexpr double pitch = 6.55, side = (holes - 1) * pitch + 10;
  for (double h : {7.0, 8.0, 14.0, 17.0}) {
    SCOPED_TRACE(h);
    Loops loops{divided(box(side, side, {-0.5 * side, 0}), h)};
    for (int i = 0; i < holes; ++i)
      for (int j = 0; j < holes; ++j)
        loops.push_back(reversed(circle({5 - 0.5 * side + pitch * i, 5 + pitch * j}, 2.2, 6)));
    Region region = planar_region(loops, h);
    for (auto& loop : region.loops)
      if (loop.size() == 6)
        for (LoopNode& node : loop) node.h = 2.3;
    EXPECT_EQ(test::paved_faults(region, pave_region(region, Progress()).mesh), "");
  }
}

TEST(PaveRegion, AComb) {
  for (double gap : {0.05, 0.5, 1.0, 2.3}) {  // of the target length 1, between teeth 1.6 wide
    SCOPED_TRACE(gap);
    std::vector<Vec2> corners{{0, 0}};
    const int teeth = 5;
    double width = teeth * 1.6 + (teeth - 1) * gap;
    corners.push_back({width, 0});
    for (int i = teeth - 1; i >= 0; --i) {
      double x = i * (1.6 + gap);
      corners.push_back({x + 1.6, 9});
      corners.push_back({x, 9});
      if (i > 0) corners.insert(corners.end(), {{x, 3}, {x - gap, 3}});
    }
    expect_paved({divided(corners, 1)}, 1);
  }
}

TEST(PaveRegion, AThinAnnulus) {
  for (double thickness : {0.01, 0.1, 0.3, 1.0, 2.4}) {  // of the target length
    SCOPED_TRACE(thickness);
    double h = 2 * pi / 60;
    double inner = 1 - thickness * h;
    // Chords must not cut the other circle: nodes opposite one another, then as many as suit the thickness.
    expect_paved({circle({0, 0}, 1, 60), reversed(circle({0, 0}, inner, 60))}, h);
    if (thickness >= 0.1) expect_paved({circle({0, 0}, 1, 60), reversed(circle({0, 0}, inner, 54, 0.02))}, h);
    if (thickness >= 0.3) expect_paved({circle({0, 0}, 1, 61), reversed(circle({0, 0}, inner, 59, 0.01))}, h);
  }
}

TEST(PaveRegion, AStar) {
  for (int points : {3, 5, 7, 12})
    for (double inner : {0.1, 0.3, 0.6}) {
      SCOPED_TRACE(testing::Message() << points << " " << inner);
      std::vector<Vec2> corners;
      for (int i = 0; i < 2 * points; ++i) {
        double r = i % 2 == 0 ? 1 : inner, a = pi * i / points;
        corners.push_back({r * std::cos(a), r * std::sin(a)});
      }
      expect_paved({divided(corners, 0.08)}, 0.08);
    }
}

TEST(PaveRegion, ASpiral) {
  for (double width : {0.4, 1.0, 1.7, 3.1}) {  // of the corridor, of the target length 1
    SCOPED_TRACE(width);
    std::vector<Vec2> outer, inner;
    double pitch = 1.5 * width + 0.5;
    for (double a = 4; a < 22; a += 0.9 / (pitch * a / (2 * pi) + 1)) {
      double r = pitch * a / (2 * pi);
      outer.push_back({(r + width) * std::cos(a), (r + width) * std::sin(a)});
      inner.push_back({r * std::cos(a), r * std::sin(a)});
    }
    if ((outer.size() + inner.size()) % 2 == 1) inner.pop_back();
    std::vector<Vec2> loop = outer;
    loop.insert(loop.end(), inner.rbegin(), inner.rend());
    expect_paved({loop}, 1);
  }
}

TEST(PaveRegion, HolesThatNearlyTouch) {
  for (double gap : {1e-9, 1e-4, 0.02, 0.3, 1.0}) {  // target length 1
    SCOPED_TRACE(gap);
    Loops loops{divided(box(20, 12), 1)};
    loops.push_back(reversed(circle({10 - 2 - gap / 2, 6}, 2, 12)));
    loops.push_back(reversed(circle({10 + 2 + gap / 2, 6}, 2, 12)));
    expect_paved(loops, 1);
    Loops near_side{divided(box(20, 12), 1), reversed(circle({10, 2 + gap}, 2, 12, pi / 2))};
    expect_paved(near_side, 1);
  }
}

TEST(PaveRegion, AHoleThatTouchesTheOutsideInOneNode) {
  Loops loops{divided(box(8, 6), 1)};
  loops.push_back(reversed({{4, 0}, {5, 1.5}, {4, 3}, {3, 1.5}}));
  expect_paved(loops, 1);
}

TEST(PaveRegion, EdgesOfVeryDifferentSizes) {
  for (double small : {1e-5, 1e-3, 0.02, 0.2}) {
    SCOPED_TRACE(small);
    // One side in pieces of `small` for a stretch; a cut corner; and a step.
    std::vector<Vec2> loop = divided({{0, 0}, {4, 0}}, 1, false);
    loop.resize(4);
    for (int i = 0; i <= 6; ++i) loop.push_back({4 + small * i, 0});
    loop.insert(loop.end(), {{6, 0}, {7, 0}, {8, 0}, {8, 1}, {8, 2}, {8, 3}, {8, 4}, {8, 5 - small}, {8 - small, 5}});
    loop.insert(loop.end(),
                {{7, 5}, {6, 5}, {5, 5}, {4 + small, 5}, {4 + small, 5 - small}, {4, 5 - small}, {3, 5 - small}});
    loop.insert(loop.end(), {{2, 5 - small}, {1, 5 - small}, {0, 5 - small}, {0, 4}, {0, 3}, {0, 2}, {0, 1}});
    if (loop.size() % 2 == 1) loop.insert(loop.begin() + 1, {0.5, 0});
    expect_paved({loop}, 1);
  }
  Loops tiny_hole{circle({0, 0}, 1, 60), reversed(circle({0.1, 0}, 1e-4, 6))};
  expect_paved(tiny_hole, 0.1);
}

TEST(PaveRegion, ACusp) {
  // Between a straight line and an arc that leaves it at angle 0.
  for (int n : {6, 11, 24}) {
    SCOPED_TRACE(n);
    std::vector<Vec2> loop;
    for (int i = 0; i < n; ++i) loop.push_back({static_cast<double>(i) / n, 0});
    loop.push_back({1, 0});
    for (int i = 0; i < n; ++i) {
      double a = (pi / 2) * (1 - static_cast<double>(i) / n);  // arc about (0, 1) from (1, 1) down to (0, 0)
      loop.push_back({std::sin(a), 1 - std::cos(a)});
    }
    loop.insert(loop.begin() + n + 1, {1, 0.5});
    if (loop.size() % 2 == 1) loop.insert(loop.begin() + n + 2, {1, 0.75});
    expect_paved({loop}, 1.0 / n);
  }
}

TEST(PaveRegion, ASlotMuchSmallerThanTheTargetLength) {
  for (double slot : {1e-6, 1e-3, 0.05, 0.4}) {
    SCOPED_TRACE(slot);
    expect_paved({divided({{0, 0}, {12, 0}, {12, 8}, {6 + slot, 8}, {6 + slot, 2}, {6, 2}, {6, 8}, {0, 8}}, 1)}, 1);
    Loops inside{divided(box(12, 8), 1), reversed(divided(box(6, slot, {3, 4}), 1))};
    expect_paved(inside, 1);
    // The other way round: the region itself is the slot.
    expect_paved({divided(box(6, slot), 1)}, 1);
    expect_paved({divided({{0, 0}, {6, 0}, {6, -6}, {12, -6}, {12, 6}, {6, 6}, {6, slot}, {0, slot}}, 1)}, 1);
  }
}

TEST(PaveRegion, OddLoopsGetOneTriangle) {
  std::vector<Vec2> outer = divided(box(10, 8), 1);
  outer.insert(outer.begin() + 1, {0.5, 0});
  Paved one = expect_paved({outer}, 1);
  EXPECT_EQ(one.triangles, 1);
  expect_paved({outer, reversed(circle({5, 4}, 1.5, 8))}, 1);
  expect_paved({divided(box(10, 8), 1), reversed(circle({5, 4}, 1.5, 9))}, 1);
  Paved both = expect_paved({outer, reversed(circle({5, 4}, 1.5, 9))}, 1);  // even together
  EXPECT_LE(both.triangles, 2);
  expect_paved({outer, reversed(circle({3, 4}, 1, 5)), reversed(circle({7, 4}, 1, 7))}, 1);
}

TEST(PaveRegion, TwoLoops) {
  for (double x : {2.0, 3.0, 3.5, 0.9}) {
    SCOPED_TRACE(x);
    Paved paved = expect_paved({divided(box(8, 8), 1), reversed(divided(box(2, 2, {x, 3}), 1))}, 1);
    EXPECT_EQ(paved.triangles, 0);
  }
  Loops nine{divided(box(9, 9), 0.5)};
  for (int i = 0; i < 9; ++i) nine.push_back(reversed(circle({1.5 + 3 * (i % 3), 1.5 + 3 * (i / 3)}, 0.5, 8, 0.3 * i)));
  expect_paved(nine, 0.5);
}

TEST(PaveRegion, TriangularAndSlenderRegions) {
  for (double apex : {90.0, 60.0, 30.0, 10.0, 2.0}) {
    SCOPED_TRACE(apex);
    double a = apex * pi / 180;
    expect_paved({divided({{0, 0}, {10, 0}, {10 * std::cos(a), 10 * std::sin(a)}}, 1)}, 1);
  }
  expect_paved({divided(box(100, 1.4), 1)}, 1);
  expect_paved({divided(box(100, 0.6), 1)}, 1);
}

TEST(PaveRegion, AllTriangles) {
  Region region = planar_region({divided(box(10, 8), 1), reversed(circle({5, 4}, 1.5, 8))}, 1);
  PavedRegion quads = pave_region(region, Progress()), paved = pave_region(region, Progress(), Elements::all_triangle);
  EXPECT_EQ(test::paved_faults(region, paved.mesh), "");
  auto is_alive = [](const Element& e) { return e.is_alive(); };
  for (const Element& e : paved.mesh.elements) EXPECT_TRUE(!e.is_alive() || e.corners() == 3);
  EXPECT_EQ(std::count_if(paved.mesh.elements.begin(), paved.mesh.elements.end(), is_alive),
            2 * std::count_if(quads.mesh.elements.begin(), quads.mesh.elements.end(), is_alive));
}

TEST(PaveRegion, AllQuadsLeaveOneTriangleWhereTheBoundaryIsOdd) {
  for (int n : {8, 9})
    for (double apex : {90.0, 60.0, 30.0, 20.0}) {
      SCOPED_TRACE(testing::Message() << n << " " << apex);
      double a = apex * pi / 180;
      Loops loops{divided({{0, 0}, {12, 0}, {12 * std::cos(a), 12 * std::sin(a)}}, 1)};
      loops.push_back(reversed(circle({7 * std::cos(a / 2), 7 * std::sin(a / 2)}, 0.7, n)));
      Region region = planar_region(loops, 1);
      PavedRegion paved = pave_region(region, Progress(), Elements::all_quad);
      EXPECT_EQ(test::paved_faults(region, paved.mesh), "");
      long triangles = 0;
      for (const Element& e : paved.mesh.elements) triangles += e.is_alive() && e.corners() == 3;
      EXPECT_EQ(triangles, n % 2);
    }
}

// Nothing hangs on an absolute size, and a power of two changes no decision.
TEST(PaveRegion, ScalingByPowersOfTwoKeepsConnectivity) {
  auto elements = [](double scale) {
    Loops loops{divided(box(10, 8), 1), reversed(circle({4, 4}, 1.5, 10)), reversed(circle({7.5, 3}, 0.7, 8))};
    for (auto& loop : loops)
      for (Vec2& p : loop) p = scale * p;
    return pave_region(planar_region(loops, scale), Progress()).mesh.elements;
  };
  std::vector<Element> one = elements(1);
  for (double scale : {0x1p-40, 0x1p-10, 0x1p10, 0x1p40}) {
    std::vector<Element> other = elements(scale);
    ASSERT_EQ(one.size(), other.size()) << scale;
    for (std::size_t i = 0; i < one.size(); ++i) ASSERT_EQ(one[i].v, other[i].v) << scale << " element " << i;
  }
}

TEST(PaveRegion, GivesTheSameMeshTwice) {
  Region region = planar_region({circle({0, 0}, 1, 60), reversed(circle({0.3, 0}, 0.2, 14))}, 0.1);
  RegionMesh a = pave_region(region, Progress()).mesh, b = pave_region(region, Progress()).mesh;
  ASSERT_EQ(a.node_count(), b.node_count());
  for (int i = 0; i < a.node_count(); ++i) ASSERT_EQ(a.p[i], b.p[i]);
  ASSERT_EQ(a.elements.size(), b.elements.size());
  for (std::size_t i = 0; i < a.elements.size(); ++i) ASSERT_EQ(a.elements[i].v, b.elements[i].v);
}

/// As a face, in paving, with a place.
void expect_failed(const Region& region) {
  try {
    pave_region(region, Progress());
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::face_failed);
    EXPECT_EQ(error.where().stage, "paving");
    EXPECT_TRUE(error.where().point);
  }
}

TEST(PaveRegion, CrossingLoopsAreAFaceThatFailed) {
  Region region = planar_region({divided(box(8, 8), 1), reversed(divided(box(4, 4, {6, 2}), 1))}, 1);
  expect_failed(region);
}

TEST(PaveRegion, FarMoreElementsThanTheAreaAsksForAreAFaceThatFailed) {
  Region region = planar_region({divided(box(500, 500), 1)}, 1);
  region.area = 1;  // as if it were small
  expect_failed(region);
}

TEST(PaveRegion, ASideDividedFarFinerThanTheOthersEnds) {
  std::vector<Vec2> points;
  for (int i = 0; i < 400; ++i) points.push_back({0.025 * i, 0});
  for (int i = 0; i < 10; ++i) points.push_back({10, 1.0 * i});
  for (int i = 0; i < 10; ++i) points.push_back({10 - 1.0 * i, 10});
  for (int i = 0; i < 10; ++i) points.push_back({0, 10 - 1.0 * i});
  Paved paved = expect_paved({points}, 1);
  EXPECT_LT(paved.quads + paved.triangles, 20000);
}

TEST(PaveRegion, StopsWhenCancelled) {
  Progress progress;
  progress.cancel();
  try {
    pave_region(planar_region({circle({0, 0}, 1, 60)}, 0.1), progress);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::cancelled);
  }
}

// One of many like it where a cavity was filled by the spokes of other corners, which left a hole.
TEST(PaveRegion, ANotchedPlateOfUnevenSidesIsWhole) {
  expect_paved({{{0, 0},
                 {14.5, 0},
                 {29, 0},
                 {29, 7.25},
                 {29, 14.5},
                 {29, 21.75},
                 {29, 29},
                 {0, 29},
                 {0, 20.25},
                 {4, 20.125},
                 {3, 20.09375},
                 {2, 20.0625},
                 {1, 20.03125},
                 {0, 20}}},
               10);
}

}  // namespace
}  // namespace paver
