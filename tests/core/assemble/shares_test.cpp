// Any number of ranks and threads makes the mesh that one makes, bit for bit.
#include "support/shares.h"

#include <gtest/gtest.h>

#include "paver/mesher.h"
#include "support/folders.h"

namespace paver {
namespace {

struct Case {
  const char* model;
  double size;
  int multilevel;
  int order = 2;
  Elements elements = Elements::quad_dominant;
};

CadModel read(const std::string& name) {
  Progress progress;
  return read_file(test::examples_folder() / name, progress);
}

Options options_of(const Case& c, int threads) {
  Options options;
  options.size = c.size;
  options.multilevel = c.multilevel;
  options.order = c.order;
  options.elements = c.elements;
  options.threads = threads;
  return options;
}

void expect_same_on_all(const Case& c) {
  const CadModel model = read(c.model);
  Progress progress;
  const MeshResult alone = mesh_model(model, options_of(c, 1), progress);
  EXPECT_GT(alone.mesh.quad_count() + alone.mesh.triangle_count(), 0u);
  test::expect_same(mesh_model(model, options_of(c, 2), progress).mesh, alone.mesh);
  for (int count : {1, 2, 3, 5}) test::expect_same_on_ranks(model, options_of(c, 1), alone, count, count == 3 ? 2 : 1);
}

TEST(Shares, OfAModelOfSeveralFaces) { expect_same_on_all({"box_cylinder.step", 5, 0}); }
TEST(Shares, OfOrderOne) { expect_same_on_all({"wing.step", 20, 0, 1}); }
TEST(Shares, OfTriangles) { expect_same_on_all({"box_cylinder.step", 6, 0, 2, Elements::all_triangle}); }
TEST(Shares, OfAClosedFaceInPatches) { expect_same_on_all({"sphere.step", 8, 0}); }
TEST(Shares, OfATorusWithCuts) { expect_same_on_all({"torus.step", 12, 0}); }
TEST(Shares, OfOneFaceOnLevels) { expect_same_on_all({"plate_circular_hole.step", 1.6, 4}); }
TEST(Shares, OfAPoleOnLevels) { expect_same_on_all({"conesphere_gap.step", 1.6, 4}); }

}  // namespace
}  // namespace paver
