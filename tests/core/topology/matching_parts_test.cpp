// Parts that have nothing in common but whole faces, edges and vertices are connected without a fuse; others are not.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <cmath>
#include <numbers>

#include "brep/connecting/connect_impl.h"
#include "brep/occt_shapes_impl.h"
#include "core/brep/shape_files.h"
#include "support/report_of.h"

namespace paver {
namespace {

constexpr double tolerance = 1e-5;

TopoDS_Shape box(gp_Pnt at, double dx = 10, double dy = 10, double dz = 10) {
  return BRepPrimAPI_MakeBox(at, dx, dy, dz).Shape();
}

/// Upright, of height 10.
TopoDS_Shape prism(const std::vector<gp_Pnt>& points) {
  BRepBuilderAPI_MakePolygon base;
  for (const gp_Pnt& point : points) base.Add(point);
  base.Close();
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(base.Wire()).Face(), gp_Vec(0, 0, 10)).Shape();
}

/// `off`: what each block is off its place by, as by rounding.
std::vector<TopoDS_Shape> grid(int count, double off = 0) {
  std::vector<TopoDS_Shape> blocks;
  for (int i = 0; i < count * count * count; ++i) {
    auto place = [&](int step, double share) { return 10 * step + off * std::sin(share * (i + 1)); };
    const int x = i % count, y = i / count % count, z = i / count / count;
    blocks.push_back(box({place(x, 1), place(y, 2), place(z, 3)}));
  }
  return blocks;
}

std::optional<Fusion> match(const std::vector<TopoDS_Shape>& solids) {
  Workpiece work;
  std::vector<int> parts;
  std::vector<PartPair> pairs;
  for (const TopoDS_Shape& solid : solids) {
    const int part = static_cast<int>(work.parts.size());
    for (const int other : parts) pairs.push_back({other, part});
    parts.push_back(part);
    work.parts.push_back({"", part});
    for (const TopoDS_Face& face : faces_of(solid)) {
      work.faces.emplace_back().face = face;
      work.faces.back().uses = {{part, false}};
    }
  }
  Progress progress;
  return match_parts(work, parts, pairs, tolerance, progress);
}

struct Counts {
  int faces, edges, vertices;
  bool operator==(const Counts&) const = default;
};

Counts counts_of(const Fusion& fusion) {
  TopTools_IndexedMapOfShape faces, edges, vertices;
  for (const Fusion::Image& image : fusion.images) {
    TopExp::MapShapes(image.face, TopAbs_FACE, faces);
    TopExp::MapShapes(image.face, TopAbs_EDGE, edges);
    TopExp::MapShapes(image.face, TopAbs_VERTEX, vertices);
  }
  return {faces.Extent(), edges.Extent(), vertices.Extent()};
}

TEST(MatchingParts, BlocksInAGridShareAllThatTheyHaveInCommon) {
  for (const double off : {0.0, 2e-6}) {
    const auto fusion = match(grid(3, off));
    ASSERT_TRUE(fusion) << off;
    EXPECT_EQ(counts_of(*fusion), (Counts{108, 144, 64}));
    long faces = 0;
    for (const Fusion::Image& image : fusion->images) faces += static_cast<long>(image.of.size());
    EXPECT_EQ(faces, 6 * 27);
  }
}

TEST(MatchingParts, WedgesAboutAnEdgeDo) {
  std::vector<TopoDS_Shape> wedges;
  for (int i = 0; i < 7; ++i) {
    const double from = 2 * std::numbers::pi * i / 7, to = 2 * std::numbers::pi * (i + 1) / 7;
    wedges.push_back(
        prism({{0, 0, 0}, {9 * std::cos(from), 9 * std::sin(from), 0}, {9 * std::cos(to), 9 * std::sin(to), 0}}));
  }
  const auto fusion = match(wedges);
  ASSERT_TRUE(fusion);
  EXPECT_EQ(counts_of(*fusion), (Counts{28, 36, 16}));
}

TEST(MatchingParts, OthersAreLeftToTheKernel) {
  const TopoDS_Shape block = box({0, 0, 0});
  const std::vector<std::pair<const char*, TopoDS_Shape>> others{
      {"part of a face", box({10, 2, 2}, 5, 5, 5)},
      {"half of a face", box({10, 5, 0})},
      {"from corner to the middle of a face", box({10, 0, 0}, 10, 10, 5)},
      {"runs into it", box({5, 5, 5})},
      {"edge in an edge", box({10, 10, 2}, 10, 10, 5)},
      {"edge on a face", prism({{10, 5, 0}, {15, 8, 0}, {15, 2, 0}})},
      {"corner on an edge", prism({{10, 10, 5}, {15, 20, 5}, {20, 15, 5}})},
      {"divided edge", prism({{10, 0, 0}, {20, 0, 0}, {20, 10, 0}, {10, 10, 0}, {10, 5, 0}})},
      {"not convex", prism({{10, 0, 0}, {30, 0, 0}, {15, 5, 0}, {30, 10, 0}, {10, 10, 0}})},
      {"round", BRepPrimAPI_MakeCylinder(3, 10).Shape()},
      {"a little apart", box({10 + 3 * tolerance, 0, 0})},
  };
  for (const auto& [name, other] : others) {
    EXPECT_FALSE(match({block, other})) << name;
    EXPECT_FALSE(match({other, block})) << name;
  }
  EXPECT_TRUE(match({block, box({10, 0, 0})}));
  EXPECT_TRUE(match({block, box({10, 10, 10})}));
  EXPECT_TRUE(match({block, box({12, 3, 0})}));
}

TEST(MatchingParts, TheMeshIsOfOnePiece) {
  std::vector<TopoDS_Shape> blocks = grid(3, 1e-6);
  blocks.erase(blocks.begin() + 13);
  const RunReport report = test::report_of(test::compound(blocks), 5);
  EXPECT_STREQ(verdict(report), "sound");
  EXPECT_EQ(report.components.size(), 1U);
  EXPECT_EQ(report.quality.quads, 4 * 108);
  EXPECT_NEAR(report.quality.mesh_area, 100 * 108, 1e-2);
  EXPECT_TRUE(report.model.unconnected.empty());
}

}  // namespace
}  // namespace paver
