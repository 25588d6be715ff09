#include "paving/cleanup/clean_up.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/predicates.h"
#include "paving/cleanup/cavity.h"
#include "paving/cleanup/mesh_edit.h"
#include "paving/cleanup/moves.h"

namespace paver {
namespace {

struct Plane : Surface {
  Vec3 point(Vec2 p) const override { return {p.x, p.y, 0}; }
  SurfaceSlope slope(Vec2 p) const override { return {{p.x, p.y, 0}, {1, 0, 0}, {0, 1, 0}}; }
  SurfaceJet jet(Vec2 p) const override { return {slope(p)}; }
  SurfaceKind kind() const override { return SurfaceKind::plane; }
  Vec2 period() const override { return {0, 0}; }
  std::unique_ptr<Surface> clone() const override { return std::make_unique<Plane>(); }
};

struct SameChart : Chart {
  Vec2 to_chart(Vec2 uv) const override { return uv; }
  ChartSlope slope(Vec2 p) const override { return {p, {1, 0}, {0, 1}}; }
};

Region plane_region() {
  Region region;
  region.surface = std::make_shared<Plane>();
  region.chart = std::make_shared<SameChart>();
  region.size = FaceSize(1);
  region.h = 1;
  return region;
}

/// A grid of unit squares with fixed border, node (i, j) numbered j (n + 1) + i; nothing of it is void.
struct Grid {
  explicit Grid(int side) : n(side), region(plane_region()), front(region, mesh) {
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) {
        front.add_node({1.0 * i, 1.0 * j});
        mesh.is_fixed.back() = i == 0 || j == 0 || i == n || j == n;
      }
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) mesh.add_element({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  }
  int at(int i, int j) const { return j * (n + 1) + i; }
  /// Replaces the elements of one row that start at (i, j), ... by others.
  void replace(int i, int j, int count, const std::vector<std::array<int, 4>>& made) {
    for (int k = 0; k < count; ++k) mesh.remove_element(j * n + i + k);
    for (const auto& v : made) mesh.add_element(v);
  }
  long triangles() const {
    return std::count_if(mesh.elements.begin(), mesh.elements.end(),
                         [](const Element& e) { return e.is_alive() && e.corners() == 3; });
  }
  long irregular() const {
    long count = 0;
    for (int i = 0; i < mesh.node_count(); ++i)
      count += !mesh.is_fixed[i] && mesh.star[i].size() != 0 && mesh.star[i].size() != 4;
    return count;
  }
  double area_if_positive() const {
    double area = 0;
    for (const Element& e : mesh.elements) {
      if (!e.is_alive()) continue;
      for (int k = 0, m = e.corners(); k < m; ++k) {
        Vec2 a = mesh.p[e.v[k]], b = mesh.p[e.v[(k + 1) % m]];
        if (orientation(a, b, mesh.p[e.v[(k + 2) % m]]) <= 0) return -1;
        area += 0.5 * cross(a, b);
      }
    }
    return area;
  }

  int n;
  Region region;
  RegionMesh mesh;
  Front front;
};

/// Places of each element's corners, whatever the numbers of nodes and elements.
std::vector<std::array<std::pair<double, double>, 4>> sorted_elements(const RegionMesh& mesh) {
  std::vector<std::array<std::pair<double, double>, 4>> all;
  for (const Element& e : mesh.elements) {
    auto& places = all.emplace_back();
    for (int k = 0; k < e.corners(); ++k) places[k] = {mesh.p[e.v[k]].x, mesh.p[e.v[k]].y};
  }
  std::sort(all.begin(), all.end());
  return all;
}

TEST(CleanUp, leaves_a_grid_as_it_is) {
  Grid grid(5);
  const auto before = sorted_elements(grid.mesh);
  clean_up(grid.front, Progress());
  EXPECT_EQ(before, sorted_elements(grid.mesh));
}

// A large mesh is numbered along a curve, but for nodes that are done: those that follow are told by their numbers.
TEST(CleanUp, numbers_a_large_mesh_anew_when_all_of_it_is_new) {
  for (const bool is_new : {true, false}) {
    Grid grid(320);
    const std::vector<Vec2> before = grid.mesh.p;
    clean_up(grid.front, Progress(), false, is_new ? 0 : grid.mesh.node_count());
    const bool is_same =
        std::ranges::equal(before, grid.mesh.p, [](Vec2 a, Vec2 b) { return a.x == b.x && a.y == b.y; });
    EXPECT_EQ(is_same, !is_new);
  }
}

TEST(CleanUp, joins_two_triangles_with_a_common_side) {
  Grid grid(5);
  grid.replace(2, 2, 1,
               {{grid.at(2, 2), grid.at(3, 2), grid.at(3, 3), -1}, {grid.at(2, 2), grid.at(3, 3), grid.at(2, 3), -1}});
  clean_up(grid.front, Progress());
  EXPECT_EQ(grid.triangles(), 0);
  EXPECT_EQ(grid.irregular(), 0);
  EXPECT_NEAR(grid.area_if_positive(), 25, 1e-9);
}

TEST(CleanUp, joins_two_triangles_across_quads) {
  Grid grid(8);
  auto v = [&](int i, int j) { return grid.at(i, j); };
  // One row sheared: a triangle at each end, parallelograms between.
  grid.replace(2, 4, 4,
               {{v(2, 4), v(3, 4), v(2, 5), -1},
                {v(3, 4), v(4, 4), v(3, 5), v(2, 5)},
                {v(4, 4), v(5, 4), v(4, 5), v(3, 5)},
                {v(5, 4), v(6, 4), v(5, 5), v(4, 5)},
                {v(6, 4), v(6, 5), v(5, 5), -1}});
  clean_up(grid.front, Progress());
  EXPECT_EQ(grid.triangles(), 0);
  EXPECT_EQ(grid.irregular(), 0);
  EXPECT_NEAR(grid.area_if_positive(), 64, 1e-9);
}

TEST(CleanUp, turns_an_edge_back) {
  Grid grid(6);
  auto v = [&](int i, int j) { return grid.at(i, j); };
  grid.replace(2, 2, 2, {{v(2, 2), v(3, 2), v(4, 2), v(4, 3)}, {v(4, 3), v(3, 3), v(2, 3), v(2, 2)}});
  clean_up(grid.front, Progress());
  EXPECT_EQ(grid.irregular(), 0);
  EXPECT_NEAR(grid.area_if_positive(), 36, 1e-9);
}

TEST(CleanUp, stops_when_cancelled) {
  Grid grid(3);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(clean_up(grid.front, progress), Error);
}

bool any_change(double, std::span<const int>, int) { return true; }

TEST(MeshEdit, takes_every_change_back_exactly) {
  Grid grid(5);
  MeshEdit edit(grid.front);
  Moves moves(edit);
  const auto elements = sorted_elements(grid.mesh);
  const std::vector<Vec2> places = grid.mesh.p;
  int tried = 0;
  moves.each(grid.at(2, 2), any_change, [&](const Change& change, double) {
    if (edit.apply(change)) {
      ++tried;
      edit.settle({});
    }
    edit.roll_back(0);
    EXPECT_EQ(elements, sorted_elements(grid.mesh));
    EXPECT_EQ(places, grid.mesh.p);
    for (int i = 0; i < grid.mesh.node_count(); ++i)
      for (int e : grid.mesh.star[i]) EXPECT_GE(grid.mesh.elements[e].corner_of(i), 0);
    return false;
  });
  EXPECT_GT(tried, 10);
}

TEST(MeshEdit, reports_the_energy_it_changes) {
  Grid grid(5);
  MeshEdit edit(grid.front);
  Moves moves(edit);
  auto sum = [&] {
    double total = 0;
    for (int i = 0; i < grid.mesh.node_count(); ++i) total += edit.energy(i);
    return total;
  };
  const double before = sum();
  EXPECT_EQ(before, 0);
  moves.each(grid.at(2, 2), any_change, [&](const Change& change, double) {
    double gain = edit.energy_gain(change);
    if (edit.apply(change)) {
      EXPECT_DOUBLE_EQ(sum(), before + gain);
    }
    edit.roll_back(0);
    return false;
  });
}

// At the border, next to it and about irregular nodes with a triangle.
TEST(Moves, know_the_energy_of_a_change_before_they_make_it) {
  Grid grid(6);
  auto v = [&](int i, int j) { return grid.at(i, j); };
  grid.replace(2, 2, 2, {{v(2, 2), v(3, 2), v(4, 2), v(4, 3)}, {v(4, 3), v(3, 3), v(2, 3), v(2, 2)}});
  grid.replace(1, 4, 1, {{v(1, 4), v(2, 4), v(2, 5), -1}, {v(1, 4), v(2, 5), v(1, 5), -1}});
  MeshEdit edit(grid.front);
  Moves moves(edit);
  int seen = 0;
  for (int node = 0; node < grid.mesh.node_count(); ++node) {
    double offered = 0;
    std::size_t gone = 0;
    int made = 0;
    auto wanted = [&](double gain, std::span<const int> elements, int count) {
      offered = gain, gone = elements.size(), made = count;
      return true;
    };
    moves.each(node, wanted, [&](const Change& change, double gain) {
      ++seen;
      EXPECT_NEAR(gain, edit.energy_gain(change), 1e-6);
      EXPECT_EQ(gain, offered);
      EXPECT_EQ(change.gone.size(), gone);
      EXPECT_EQ(static_cast<int>(change.made.size()), made);
      return false;
    });
  }
  EXPECT_GT(seen, 1000);
}

TEST(MeshEdit, refuses_an_element_with_one_boundary_node_twice) {
  Grid grid(4);
  grid.mesh.global[grid.at(1, 0)] = grid.mesh.global[grid.at(3, 0)] = 7;  // both sides of a cut
  MeshEdit edit(grid.front);
  Change change;
  change.gone = {1, 2};
  change.made = {{grid.at(1, 0), grid.at(2, 0), grid.at(3, 0), grid.at(3, 1)},
                 {grid.at(3, 1), grid.at(2, 1), grid.at(1, 1), grid.at(1, 0)}};
  EXPECT_FALSE(edit.apply(change));
  EXPECT_EQ(edit.mark(), 0u);
}

TEST(Cavity, is_not_filled_where_lengths_would_be_uneven) {
  Grid grid(6);
  auto v = [&](int i, int j) { return grid.at(i, j); };
  grid.replace(2, 2, 2, {{v(2, 2), v(3, 2), v(4, 2), v(4, 3)}, {v(4, 3), v(3, 3), v(2, 3), v(2, 2)}});
  for (int i = 0; i < grid.mesh.node_count(); ++i) grid.mesh.h[i] = 2;  // half as many quads are wanted
  MeshEdit edit(grid.front);
  Cavity cavity(edit);
  Change fill;
  cavity.start(v(3, 3));
  std::optional<double> gain;
  while (!gain && cavity.grow(60)) gain = cavity.find_fill(1);
  ASSERT_TRUE(gain);
  EXPECT_TRUE(cavity.make_fill(fill, 100));
  EXPECT_FALSE(cavity.make_fill(fill, -1));
}

TEST(Cavity, is_filled_as_a_grid_when_its_outline_allows) {
  Grid grid(6);
  auto v = [&](int i, int j) { return grid.at(i, j); };
  grid.replace(2, 2, 2, {{v(2, 2), v(3, 2), v(4, 2), v(4, 3)}, {v(4, 3), v(3, 3), v(2, 3), v(2, 2)}});
  MeshEdit edit(grid.front);
  Cavity cavity(edit);
  Change fill;
  cavity.start(v(3, 3));
  std::optional<double> gain;
  for (int ring = 0; ring < 3 && !gain && cavity.grow(60); ++ring) gain = cavity.find_fill(1);
  ASSERT_TRUE(gain);
  EXPECT_LE(*gain, -1);
  ASSERT_TRUE(cavity.make_fill(fill, 1e9));
  EXPECT_DOUBLE_EQ(edit.energy_gain(fill), *gain) << "as foretold";
  ASSERT_TRUE(edit.apply(fill));
  EXPECT_TRUE(edit.settle({}));
  EXPECT_NEAR(grid.area_if_positive(), 36, 1e-9);
}

}  // namespace
}  // namespace paver
