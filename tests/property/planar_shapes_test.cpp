// Hard planar regions: combs, thin rings, cusps, stars, spirals, holes and slots closer than the target length. Each
// must end in a whole mesh, and none of its elements may be flatter than the region itself asks for. And random regions
// other than those of the shared corpus.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "paving/pave_region.h"
#include "support/planar_region.h"
#include "support/validate.h"

namespace paver {
namespace {

using test::circle;
using test::divided;
using test::planar_region;
using test::reversed;

using Points = std::vector<Vec2>;
using Loops = std::vector<Points>;
constexpr double pi = std::numbers::pi;
constexpr double sound = 0.1;  // least scaled Jacobian where all corners are wider than about 30 degrees

/// No element in a sharp corner is better than its sine.
double least_at(double angle) { return std::min(sound, 0.5 * std::sin(angle)); }

struct Shape {
  std::string name;
  Loops loops;
  double h;
  double least = sound;  // scaled Jacobian
};

Points box(double width, double height, Vec2 at = {0, 0}) {
  return {at, at + Vec2{width, 0}, at + Vec2{width, height}, at + Vec2{0, height}};
}

Shape comb(double gap) {
  Points corners{{0, 0}};
  const int teeth = 6;
  corners.push_back({teeth * 1.6 + (teeth - 1) * gap, 0});
  for (int i = teeth - 1; i >= 0; --i) {
    double x = i * (1.6 + gap);
    corners.insert(corners.end(), {{x + 1.6, 9}, {x, 9}});
    if (i > 0) corners.insert(corners.end(), {{x, 3}, {x - gap, 3}});
  }
  return {"comb", {divided(corners, 1)}, 1};
}

Shape thin_ring(double thickness, int outer, int inner) {
  double h = 2 * pi / outer;
  // Nodes may be half a target length out of step across the ring.
  double least = outer == inner ? sound : least_at(std::atan(thickness) / 2);
  return {"thin ring", {circle({0, 0}, 1, outer), reversed(circle({0, 0}, 1 - thickness * h, inner))}, h, least};
}

Shape star(int points, double inner) {
  Points corners;
  for (int i = 0; i < 2 * points; ++i) {
    double r = i % 2 == 0 ? 1 : inner, a = pi * i / points;
    corners.push_back({r * std::cos(a), r * std::sin(a)});
  }
  double step = pi / points;
  double half_angle = std::atan2(inner * std::sin(step), 1 - inner * std::cos(step));
  return {"star", {divided(corners, 0.08)}, 0.08, least_at(2 * half_angle)};
}

Shape spiral(double width) {
  Points outer, inner;
  double pitch = 1.5 * width + 0.5;
  for (double a = 4; a < 22; a += 0.9 / (pitch * a / (2 * pi) + 1)) {
    double r = pitch * a / (2 * pi);
    outer.push_back({(r + width) * std::cos(a), (r + width) * std::sin(a)});
    inner.push_back({r * std::cos(a), r * std::sin(a)});
  }
  if ((outer.size() + inner.size()) % 2 == 1) inner.pop_back();
  outer.insert(outer.end(), inner.rbegin(), inner.rend());
  return {"spiral", {outer}, 1};
}

/// A profile of 12 % thickness, nodes close together at both ends, within its air or alone.
Shape aerofoil(int n, bool is_hole) {
  auto thickness = [](double x) {
    return 0.6 * (0.2969 * std::sqrt(x) - 0.126 * x - 0.3516 * x * x + 0.2843 * x * x * x - 0.1036 * x * x * x * x);
  };
  auto at = [&](int i) { return 0.5 * (1 - std::cos(pi * i / n)); };
  Points upper, profile;
  for (int i = 0; i < n; ++i) profile.push_back({at(i), i == 0 ? 0 : -thickness(at(i))});
  profile.push_back({1, 0});
  for (int i = n - 1; i > 0; --i) profile.push_back({at(i), thickness(at(i))});
  double h = 1.5 / n;
  if (!is_hole) return {"aerofoil", {profile}, h, least_at(2 * std::atan(0.14))};
  return {"air about an aerofoil", {divided(box(3, 2, {-1, -1}), h), reversed(profile)}, h};
}

Shape near_holes(double gap) {
  Loops loops{divided(box(20, 12), 1)};
  for (int side : {-1, 1}) loops.push_back(reversed(circle({10 + side * (2 + gap / 2), 6}, 2, 12)));
  return {"holes that nearly touch", loops, 1};
}

Shape hole_in_hole(double gap) {
  return {"crescent", {circle({0, 0}, 4, 40), reversed(circle({4 - 2.5 - gap, 0}, 2.5, 24))}, 0.65};
}

Shape slot(double width) {
  Points corners{{0, 0}, {12, 0}, {12, 8}, {6 + width, 8}, {6 + width, 2}, {6, 2}, {6, 8}, {0, 8}};
  return {"slot", {divided(corners, 1)}, 1};
}

Shape hole_slot(double width) {
  return {"slot inside", {divided(box(12, 8), 1), reversed(divided(box(6, width, {3, 4}), 1))}, 1};
}

/// The region itself is the gap.
Shape channel(double width) {
  Points corners{{0, 0}, {6, 0}, {6, -6}, {12, -6}, {12, 6}, {6, 6}, {6, width}, {0, width}};
  return {"channel", {divided(corners, 1)}, 1};
}

/// Steps of `small` in the sides of a box whose other edges are long.
Shape small_steps(double small) {
  Points corners{{0, 0}, {4, 0}, {4, small}, {4 + small, small}, {4 + small, 0},
                 {8, 0}, {8, 5}, {4, 5},     {4, 5 - small},     {0, 5 - small}};
  return {"small steps", {divided(corners, 1)}, 1};
}

Shape small_hole(double radius) {
  return {"small hole", {circle({0, 0}, 1, 60), reversed(circle({0.1, 0}, radius, 8))}, 0.1};
}

std::vector<Shape> shapes() {
  std::vector<Shape> all;
  for (double gap : {0.05, 0.5, 1.0, 2.3}) all.push_back(comb(gap));
  for (double thickness : {0.01, 0.1, 0.3, 1.0, 2.4}) all.push_back(thin_ring(thickness, 60, 60));
  for (double thickness : {0.3, 1.0, 2.4}) all.push_back(thin_ring(thickness, 60, 54));
  for (int points : {3, 5, 7, 12})
    for (double inner : {0.1, 0.3, 0.6, 0.8}) all.push_back(star(points, inner));
  for (double width : {0.4, 1.0, 1.7, 3.1}) all.push_back(spiral(width));
  for (int n : {8, 20, 40})
    for (bool is_hole : {false, true}) all.push_back(aerofoil(n, is_hole));
  for (double gap : {1e-6, 1e-3, 0.02, 0.3, 1.0}) all.push_back(near_holes(gap));
  for (double gap : {0.01, 0.2, 0.6}) all.push_back(hole_in_hole(gap));
  for (double width : {1e-6, 1e-3, 0.05, 0.4})
    for (auto make : {slot, hole_slot, channel}) all.push_back(make(width));
  for (double small : {1e-5, 1e-3, 0.02, 0.2}) all.push_back(small_steps(small));
  for (double radius : {1e-5, 1e-3, 0.03}) all.push_back(small_hole(radius));
  return all;
}

/// Figures of one mesh, or sums of them.
struct Figures {
  double worst = 1, jacobian = 0;
  long quads = 0, triangles = 0, interior = 0, irregular = 0;
};

void add_figures(const RegionMesh& mesh, Figures& sum) {
  for (const Element& e : mesh.elements) {
    if (!e.is_alive()) continue;
    double jacobian = scaled_jacobian(mesh, e);
    sum.worst = std::min(sum.worst, jacobian);
    sum.jacobian += jacobian;
    ++(e.corners() == 4 ? sum.quads : sum.triangles);
  }
  for (int i = 0; i < mesh.node_count(); ++i) {
    if (mesh.is_fixed[i] || mesh.star[i].size() == 0) continue;
    ++sum.interior;
    if (mesh.star[i].size() != 4) ++sum.irregular;
  }
}

TEST(PlanarShapes, AreNoFlatterThanTheyMustBe) {
  std::vector<Shape> all = shapes();
  for (std::size_t i = 0; i < all.size(); ++i) {
    SCOPED_TRACE(testing::Message() << all[i].name << ", shape " << i);
    Region region = planar_region(all[i].loops, all[i].h);
    PavedRegion paved = pave_region(region, Progress());
    EXPECT_EQ(test::paved_faults(region, paved.mesh), "");
    Figures figures;
    add_figures(paved.mesh, figures);
    EXPECT_GT(figures.worst, all[i].least);
  }
}

/// Uniform in [0, 1), the same everywhere.
double uniform(std::mt19937& random) { return random() / 4294967296.0; }

/// Star-shaped polygon of 5 to 14 corners with up to two round holes, divided into pieces of about h.
Shape random_region(unsigned seed) {
  std::mt19937 random(seed);
  const int corner_count = 5 + static_cast<int>(10 * uniform(random));
  const double h = std::vector{0.05, 0.07, 0.1}[static_cast<std::size_t>(3 * uniform(random))];
  const double phase = 2 * pi * uniform(random);
  Points corners;
  for (int i = 0; i < corner_count; ++i) {
    double a = phase + 2 * pi * (i + 0.35 * (uniform(random) - 0.5)) / corner_count;
    double least = uniform(random) < 0.6 ? 0.45 : 0.8;
    double r = least + (1 - least) * uniform(random);
    corners.push_back({r * std::cos(a), r * std::sin(a)});
  }
  Loops loops{divided(corners, h)};
  const int holes = static_cast<int>(3 * uniform(random));
  for (int i = 0; i < holes; ++i) {
    double radius = 0.04 + 0.08 * uniform(random), x = holes == 1 ? 0 : 0.34 * i - 0.17;
    int n = std::max(4, 2 * static_cast<int>(std::lround(pi * radius / h)));
    loops.push_back(reversed(circle({x, 0}, radius, n)));
  }
  return {"random", loops, h};
}

/// PAVER_SEEDS in the environment asks for more.
unsigned seed_count() {
  const char* asked = std::getenv("PAVER_SEEDS");
  return asked ? static_cast<unsigned>(std::max(100, std::atoi(asked))) : 100;
}

TEST(PlanarShapes, RandomRegionsAreAsGoodAsTheCorpus) {
  Figures sum;
  std::vector<double> worst;
  for (unsigned seed = 0; seed < seed_count(); ++seed) {
    SCOPED_TRACE(seed);
    Shape shape = random_region(seed);
    Region region = planar_region(shape.loops, shape.h);
    PavedRegion paved = pave_region(region, Progress());
    EXPECT_EQ(test::paved_faults(region, paved.mesh), "");
    Figures figures;
    add_figures(paved.mesh, figures);
    EXPECT_GT(figures.worst, sound);
    worst.push_back(figures.worst);
    add_figures(paved.mesh, sum);
  }
  std::sort(worst.begin(), worst.end());
  const auto elements = static_cast<double>(sum.quads + sum.triangles);
  std::printf(
      "%zu regions: mean SJ %.4f, min SJ median %.3f, 5 %% %.3f, least %.3f; irregular %.2f %%, triangles %ld\n",
      worst.size(), sum.jacobian / elements, worst[worst.size() / 2], worst[worst.size() / 20], worst[0],
      100.0 * static_cast<double>(sum.irregular) / static_cast<double>(sum.interior), sum.triangles);
  EXPECT_GT(sum.jacobian / elements, 0.95);
  EXPECT_GT(worst[worst.size() / 2], 0.7);
  EXPECT_GT(worst[worst.size() / 20], 0.6);
  EXPECT_LT(static_cast<double>(sum.triangles), 0.002 * elements);
  EXPECT_LT(static_cast<double>(sum.irregular), 0.08 * static_cast<double>(sum.interior));
}

}  // namespace
}  // namespace paver
