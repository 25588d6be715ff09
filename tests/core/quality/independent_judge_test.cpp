// Holds our figures against those of an independent judge, on meshes made in code: straight and curved, smooth and
// torn, of order 1 to 4.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "core/quality/wavy_mesh.h"
#include "paver/output.h"
#include "support/judge.h"
#include "support/measure_quality.h"

namespace paver {
namespace {

namespace fs = std::filesystem;

constexpr double target_length = 11;

class AgainstTheJudge : public testing::TestWithParam<std::tuple<int, double>> {};

// The noisiest meshes have concave, folded and undecidable elements.
INSTANTIATE_TEST_SUITE_P(OrdersAndNoise, AgainstTheJudge,
                         testing::Combine(testing::Range(1, 5), testing::Values(0, 0.4, 1.2, 6.0)));

TEST_P(AgainstTheJudge, AllFiguresAreEqual) {
  auto [order, noise] = GetParam();
  MeshResult result = fake::WavyMesh(order, 16, noise).result();
  QualityReport q =
      measure_quality(result.mesh, target_length, std::vector<bool>(5, false), result.report.faces, Progress());
  fs::path file = fs::temp_directory_path() / fmt::format("paver_judged_{}.msh", ::getpid());
  Progress progress;
  write_outputs(result, {file.string(), "", MshVersion::v4_1, false}, progress);
  const auto theirs = test::verdict_on(fmt::format("order {} noise {}", order, noise), file, target_length);
  fs::remove(file);
  auto expect_near = [&](double ours, const char* pointer) {
    double value = theirs.at(pointer).get<double>();
    EXPECT_NEAR(ours, value, 2e-5 * std::max(std::fabs(value), 1e-3)) << pointer;
  };
  EXPECT_EQ(q.quads, theirs.at("/counts/quads"));
  EXPECT_EQ(q.triangles, theirs.at("/counts/triangles"));
  EXPECT_EQ(q.nodes, theirs.at("/counts/nodes"));
  EXPECT_EQ(q.inverted, theirs.at("/curved/invalid"));
  EXPECT_TRUE(noise < 6 || q.inverted > 0) << "the torn meshes are there to be found out";
  EXPECT_EQ(q.undecided, theirs.at("/curved/undecided"));
  EXPECT_EQ(q.border_edges, theirs.at("/topology/edges_on_one_element"));
  EXPECT_EQ(q.nonmanifold_edges, theirs.at("/topology/edges_on_more"));
  EXPECT_EQ(q.face_interior_nodes, theirs.at("/valence/face_interior_vertices"));
  expect_near(q.irregular_share, "/valence/irregular_fraction_face_interior");
  expect_near(q.sj_all.min, "/shape/all/scaled_jacobian/min");
  expect_near(q.sj_all.mean, "/shape/all/scaled_jacobian/mean");
  expect_near(q.sj_all.below_03, "/shape/all/fraction_sj_below_0.3");
  expect_near(q.sj_quads.mean, "/shape/quads/scaled_jacobian/mean");
  expect_near(q.sj_triangles.min, "/shape/tris/scaled_jacobian/min");
  expect_near(q.length_mean, "/edges/chord/mean_rel");
  expect_near(q.length_cv, "/edges/chord/cov");
  expect_near(q.mesh_area, "/area/mesh");
  expect_near(q.min_jacobian_ratio, "/curved/min_jacobian_ratio/min");
}

TEST(RecordedVerdict, IsOfOneFileAlone) {
  const fs::path file = fs::temp_directory_path() / fmt::format("paver_other_{}.msh", ::getpid());
  Progress progress;
  MeshResult other = fake::WavyMesh(1, 16, 0.1).result();
  write_outputs(other, {file.string(), "", MshVersion::v4_1, false}, progress);
  try {
    test::verdict_on("order 1 noise 0", file, target_length);
    ADD_FAILURE() << "a verdict on another file";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("tests/judge/record asks the judge afresh"), std::string::npos);
  }
  fs::remove(file);
}

}  // namespace
}  // namespace paver
