// Holds our figures against those of tools/quality.py in the shared folder, an independent judge, on meshes made in
// code: straight and curved, smooth and torn, of order 1 to 4. Skipped where the judge or its python is missing.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/quality/wavy_mesh.h"
#include "paver/output.h"
#include "quality/report.h"

namespace paver {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr const char* python = "/usr/bin/python3";
constexpr double target_length = 11;

fs::path judge() {
  const char* shared = std::getenv("PAVER_SHARED");
  return fs::path(shared && *shared ? shared : PAVER_SHARED) / "tools" / "quality.py";
}

/// What quality.py says of a mesh file.
Json verdict_on(const fs::path& mesh) {
  std::string command = fmt::format("{} '{}' '{}' --size {}", python, judge().string(), mesh.string(), target_length);
  std::FILE* pipe = popen(command.c_str(), "r");
  std::string text;
  char part[4096];
  while (std::size_t n = std::fread(part, 1, sizeof part, pipe)) text.append(part, n);
  return pclose(pipe) == 0 ? Json::parse(text) : Json();
}

class AgainstQualityPy : public testing::TestWithParam<std::tuple<int, double>> {
 protected:
  void SetUp() override {
    if (!fs::exists(judge())) GTEST_SKIP() << judge() << " is missing: set PAVER_SHARED to the folder that has it";
    if (std::system((std::string(python) + " -c 'import numpy, scipy' 2>/dev/null").c_str()) != 0) {
      GTEST_SKIP() << python << " has no numpy and scipy";
    }
  }
};

// The noisiest meshes have concave, folded and undecidable elements.
INSTANTIATE_TEST_SUITE_P(OrdersAndNoise, AgainstQualityPy,
                         testing::Combine(testing::Range(1, 5), testing::Values(0, 0.4, 1.2, 6.0)));

TEST_P(AgainstQualityPy, AllFiguresAreEqual) {
  auto [order, noise] = GetParam();
  MeshResult result = fake::WavyMesh(order, 16, noise).result();
  QualityReport q =
      measure_quality(result.mesh, target_length, std::vector<bool>(5, false), result.report.faces, Progress());
  fs::path file = fs::temp_directory_path() / fmt::format("paver_judged_{}.msh", ::getpid());
  Progress progress;
  write_outputs(result, {file.string(), "", MshVersion::v4_1, false}, progress);
  Json theirs = verdict_on(file);
  fs::remove(file);
  ASSERT_FALSE(theirs.is_null());
  auto expect_near = [&](double ours, const char* pointer) {
    double value = theirs.at(Json::json_pointer(pointer)).get<double>();
    EXPECT_NEAR(ours, value, 2e-5 * std::max(std::fabs(value), 1e-3)) << pointer;
  };
  EXPECT_EQ(q.quads, theirs["counts"]["quads"]);
  EXPECT_EQ(q.triangles, theirs["counts"]["triangles"]);
  EXPECT_EQ(q.nodes, theirs["counts"]["nodes"]);
  EXPECT_EQ(q.inverted, theirs["curved"]["invalid"]);
  EXPECT_TRUE(noise < 6 || q.inverted > 0) << "the torn meshes are there to be found out";
  EXPECT_EQ(q.undecided, theirs["curved"]["undecided"]);
  EXPECT_EQ(q.border_edges, theirs["topology"]["edges_on_one_element"]);
  EXPECT_EQ(q.nonmanifold_edges, theirs["topology"]["edges_on_more"]);
  EXPECT_EQ(q.face_interior_nodes, theirs["valence"]["face_interior_vertices"]);
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

}  // namespace
}  // namespace paver
