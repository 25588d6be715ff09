// Every format holds the whole mesh, as other programs read it, and no failure leaves a file.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/quality/wavy_mesh.h"
#include "paver/output.h"
#include "support/folders.h"
#include "support/judge.h"
#include "support/measure_quality.h"

namespace paver {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr const char* python = "/usr/bin/python3";
const fs::path gmsh_summary = test::tests_folder() / "core/output/gmsh_summary.py";

bool has_module(const char* name) {
  return std::system(fmt::format("{} -c 'import {}' >/dev/null 2>&1", python, name).c_str()) == 0;
}

/// What a python script prints about a file.
Json ask(const fs::path& script, const fs::path& file) {
  std::string command = fmt::format("{} -B '{}' '{}'", python, script.string(), file.string());
  std::FILE* pipe = popen(command.c_str(), "r");
  std::string text;
  char part[4096];
  while (std::size_t n = std::fread(part, 1, sizeof part, pipe)) text.append(part, n);
  return pclose(pipe) == 0 ? Json::parse(text) : Json();
}

std::string content(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A folder of its own for each test.
class Writing : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / fmt::format("paver_writing_{}", ::getpid());
    fs::create_directory(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const char* name) const { return (folder_ / name).string(); }
  long files_left() const { return std::distance(fs::directory_iterator(folder_), fs::directory_iterator()); }

  void write(MeshResult& result, const OutputFiles& files) {
    Progress progress;
    write_outputs(result, files, progress);
  }

  fs::path folder_;
};

struct Format {
  const char* name;
  MshVersion version;
  bool is_ascii;
  /// Names the test.
  friend void PrintTo(const Format& f, std::ostream* out) {
    *out << f.name << (f.version == MshVersion::v2_2 ? " 2.2" : "") << (f.is_ascii ? " text" : "");
  }
};

class EveryFormat : public Writing, public testing::WithParamInterface<std::tuple<Format, int>> {
 protected:
  const Format& format() const { return std::get<0>(GetParam()); }

  MeshResult written(const std::string& file) {
    int order = std::get<1>(GetParam());
    MeshResult result = fake::WavyMesh(order, 10, 0.3 / order).result();
    result.mesh.nodes.push_back({1e6, 1e6, 1e6});  // used by nothing: must not be written
    result.mesh.node_edge.push_back(-1);
    write(result, {file, "", format().version, format().is_ascii});
    return result;
  }
};

constexpr Format msh4{"a.msh", MshVersion::v4_1, false}, msh4_text{"b.msh", MshVersion::v4_1, true};
constexpr Format msh2{"c.msh", MshVersion::v2_2, false}, msh2_text{"d.msh", MshVersion::v2_2, true};
constexpr Format vtu{"e.vtu", MshVersion::v4_1, false}, vtu_text{"f.vtu", MshVersion::v4_1, true};

INSTANTIATE_TEST_SUITE_P(FormatsAndOrders, EveryFormat,
                         testing::Combine(testing::Values(msh4, msh4_text, msh2, msh2_text, vtu, vtu_text),
                                          testing::Range(1, 4)));

TEST_P(EveryFormat, IsReadByTheIndependentJudge) {
  std::string file = path(format().name);
  MeshResult result = written(file);
  QualityReport q = measure_quality(result.mesh, 10, std::vector<bool>(5, false), result.report.faces, Progress());
  const Json found =
      test::verdict_on(fmt::format("{} order {}", testing::PrintToString(format()), result.mesh.order), file);
  EXPECT_EQ(found.at("/counts/quads"), q.quads);
  EXPECT_EQ(found.at("/counts/triangles"), q.triangles);
  EXPECT_EQ(found.at("/counts/nodes"), q.nodes);
  EXPECT_EQ(found.at("/topology/unused_nodes"), 0);
  EXPECT_EQ(found.at("/topology/edge_middle_node_mismatch"), 0);
  EXPECT_NEAR(found.at("/area/mesh").get<double>(), q.mesh_area, 1e-5 * q.mesh_area);
  EXPECT_NEAR(found.at("/curved/min_jacobian_ratio/min").get<double>(), q.min_jacobian_ratio, 1e-5);
}

TEST_P(EveryFormat, IsReadByGmsh) {
  std::string file = path(format().name);
  if (file.ends_with(".vtu")) return;
  if (!has_module("gmsh")) GTEST_SKIP() << python << " has no gmsh";
  MeshResult result = written(file);
  QualityReport q = measure_quality(result.mesh, 10, std::vector<bool>(5, false), result.report.faces, Progress());
  Json found = ask(gmsh_summary, file);
  ASSERT_FALSE(found.is_null());
  EXPECT_EQ(found["order"], result.mesh.order);
  EXPECT_EQ(found["quads"], q.quads);
  EXPECT_EQ(found["triangles"], q.triangles);
  EXPECT_EQ(found["lines"], 50);
  EXPECT_EQ(found["nodes"], q.nodes);
  EXPECT_NEAR(found["area"].get<double>(), q.mesh_area, 1e-4 * q.mesh_area);
  EXPECT_EQ(found["groups"], Json::parse(R"({"left 'wing'": [1], "Face2": [2]})"));
  EXPECT_EQ(found["per_face"]["1"], result.report.faces[0].quads + result.report.faces[0].triangles);
  EXPECT_EQ(found["per_edge"]["5"], 10);
  if (format().version == MshVersion::v4_1) {
    EXPECT_EQ(found["sides_of_face"], Json::parse(R"({"1": [1, 3, 4, 5], "2": [1, 2, 3, 5]})"));
  }
}

using WriteOutputs = Writing;

/// The values of an array of a .vtu in text.
std::vector<double> values(const std::string& file, const std::string& name) {
  const std::size_t declared = file.find("Name=\"" + name + "\""), begin = file.find('>', declared) + 1;
  std::istringstream text(file.substr(begin, file.find('<', begin) - begin));
  return {std::istream_iterator<double>(text), {}};
}

TEST_F(WriteOutputs, PutsTheLinesOfWiresBehindTheElementsOfAVtu) {
  for (int order : {1, 2}) {
    MeshResult result = fake::WavyMesh(order, 10, 0).result();
    result.edge_groups = {"", "", junctions, "", "Wire1"};
    write(result, {path("a.vtu"), "", MshVersion::v4_1, true});
    const std::string file = content(path("a.vtu"));
    const std::vector<double> types = values(file, "types"), faces = values(file, "face");
    const std::size_t elements = result.mesh.quad_count() + result.mesh.triangle_count(), lines = 10;
    ASSERT_EQ(types.size(), elements + lines);
    ASSERT_EQ(faces.size(), types.size());
    for (std::size_t i = 0; i < types.size(); ++i) {
      EXPECT_EQ(types[i] == (order == 1 ? 3 : 68), i >= elements);
      EXPECT_EQ(faces[i] == -5, i >= elements);
    }
    const std::vector<double> nodes = values(file, "connectivity"), points = values(file, "Points");
    EXPECT_EQ(values(file, "offsets").back(), nodes.size());
    const std::size_t row = result.mesh.lines.size() - static_cast<std::size_t>(order + 1);
    ASSERT_EQ(result.mesh.line_edge.back(), 4);
    for (std::size_t k = 0; k < static_cast<std::size_t>(order + 1); ++k) {
      const auto point = static_cast<std::size_t>(nodes[nodes.size() - static_cast<std::size_t>(order + 1) + k]);
      EXPECT_EQ(points[3 * point], result.mesh.nodes[static_cast<std::size_t>(result.mesh.lines[row + k])].x);
    }
  }
}

TEST_F(WriteOutputs, GivesFacesOfOneNameOneGroup) {
  MeshResult result = fake::WavyMesh(1, 4, 0).result();
  result.face_names = {"skin", "skin"};
  write(result, {path("a.msh"), "", MshVersion::v2_2, true});
  EXPECT_NE(content(path("a.msh")).find("$PhysicalNames\n1\n2 1 \"skin\"\n$EndPhysicalNames"), std::string::npos);
}

TEST_F(WriteOutputs, KeepsNamesApartThatAreTheSameWhenCut) {
  MeshResult result = fake::WavyMesh(1, 4, 0).result();
  const std::string begin(127, 'a');
  result.face_names = {begin + "left", begin + "right"};
  write(result, {path("a.msh"), "", MshVersion::v2_2, true});
  EXPECT_NE(
      content(path("a.msh")).find("$PhysicalNames\n2\n2 1 \"" + begin + "\"\n2 2 \"" + begin.substr(4) + " (2)\"\n"),
      std::string::npos);
}

TEST_F(WriteOutputs, WritesTheSameFileEachTime) {
  MeshResult result = fake::WavyMesh(2, 6, 0.3).result();
  write(result, {path("a.msh"), "", MshVersion::v4_1, false});
  write(result, {path("b.msh"), "", MshVersion::v4_1, false});
  EXPECT_EQ(content(path("a.msh")), content(path("b.msh")));
}

TEST_F(WriteOutputs, FollowsALinkAndReplacesAnOldFile) {
  MeshResult result = fake::WavyMesh(1, 2, 0).result();
  std::ofstream(path("real.msh")) << "old";
  fs::create_symlink("real.msh", path("link.msh"));
  write(result, {path("link.msh"), "", MshVersion::v4_1, false});
  EXPECT_TRUE(fs::is_symlink(path("link.msh")));
  EXPECT_TRUE(content(path("real.msh")).starts_with("$MeshFormat"));
  EXPECT_EQ(files_left(), 2);
}

TEST_F(WriteOutputs, LeavesTheOldFileAndNothingElseWhenCancelled) {
  MeshResult result = fake::WavyMesh(2, 60, 0).result();
  std::ofstream(path("a.msh")) << "old";
  Progress progress;
  progress.begin(Stage::write);
  progress.cancel();
  EXPECT_THROW(write_outputs(result, {path("a.msh"), path("r.json"), MshVersion::v4_1, true}, progress), Error);
  EXPECT_EQ(content(path("a.msh")), "old");
  EXPECT_EQ(files_left(), 1);
}

TEST_F(WriteOutputs, LeavesNothingWhenTheDiskIsFull) {
  MeshResult result = fake::WavyMesh(2, 60, 0).result();
  auto old_handler = ::signal(SIGXFSZ, SIG_IGN);
  rlimit old_limit{};
  getrlimit(RLIMIT_FSIZE, &old_limit);
  rlimit limit = old_limit;
  limit.rlim_cur = 100'000;
  setrlimit(RLIMIT_FSIZE, &limit);
  try {
    write(result, {path("a.msh"), path("r.json"), MshVersion::v4_1, false});
    ADD_FAILURE() << "written all the same";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::unwritable_output);
    EXPECT_NE(std::string(error.what()).find("a.msh"), std::string::npos);
  }
  setrlimit(RLIMIT_FSIZE, &old_limit);
  ::signal(SIGXFSZ, old_handler);
  EXPECT_EQ(files_left(), 0);
}

ErrorCode refusal(const OutputFiles& files) {
  try {
    check_outputs(files);
  } catch (const Error& error) {
    return error.code();
  }
  return ErrorCode::internal;
}

using CheckOutputs = Writing;

TEST_F(CheckOutputs, RefusesBadNamesAndPlaces) {
  EXPECT_EQ(refusal({path("a.stl"), "", MshVersion::v4_1, false}), ErrorCode::bad_option);
  EXPECT_EQ(refusal({path("a"), "", MshVersion::v4_1, false}), ErrorCode::bad_option);
  EXPECT_EQ(refusal({path("a.msh"), path("./a.msh"), MshVersion::v4_1, false}), ErrorCode::bad_option);
  EXPECT_EQ(refusal({path("no/such/a.msh"), "", MshVersion::v4_1, false}), ErrorCode::unwritable_output);
  fs::create_directory(path("folder.msh"));
  EXPECT_EQ(refusal({path("folder.msh"), "", MshVersion::v4_1, false}), ErrorCode::unwritable_output);
  EXPECT_EQ(refusal({path("a.msh"), "/dev/null", MshVersion::v4_1, false}), ErrorCode::unwritable_output);
  fs::create_symlink("/dev/null", path("null.msh"));
  EXPECT_EQ(refusal({path("null.msh"), "", MshVersion::v4_1, false}), ErrorCode::unwritable_output);
}

TEST_F(CheckOutputs, NeverTheModelItself) {
  std::ofstream(path("model.msh")) << "a model";
  fs::create_symlink(path("model.msh"), path("link.msh"));
  for (const char* name : {"model.msh", "link.msh"}) {
    EXPECT_EQ(refusal({path(name), "", MshVersion::v4_1, false, path("model.msh")}), ErrorCode::bad_option);
    EXPECT_EQ(refusal({"", path(name), MshVersion::v4_1, false, path("model.msh")}), ErrorCode::bad_option);
  }
  EXPECT_NO_THROW(check_outputs({path("other.msh"), "", MshVersion::v4_1, false, path("model.msh")}));
  EXPECT_EQ(content(path("model.msh")), "a model");
}

TEST_F(CheckOutputs, LeavesNothingBehind) {
  EXPECT_NO_THROW(check_outputs({path("A.MSH"), path("r.json"), MshVersion::v4_1, false}));
  EXPECT_EQ(files_left(), 0);
}

TEST(ReportJson, HasEveryFaceAndSurvivesNamesThatAreNotUtf8) {
  MeshResult result = fake::WavyMesh(2, 4, 0).result();
  result.face_names[1] = "K\xf6rper";
  result.report.faces[1].status = FaceStatus::failed;
  result.report.faces[1].reason = "no room";
  result.report.faces[1].where = Vec3{1, 2, 3};
  result.report.stage_seconds = {{"read", 0.5}, {"paving", 1.5}};
  Json json = Json::parse(report_json(result));
  EXPECT_EQ(json["faces"][0]["status"], "meshed");
  EXPECT_EQ(json["faces"][1]["status"], "failed");
  EXPECT_EQ(json["faces"][1]["where"].size(), 3u);
  EXPECT_EQ(json["stage_seconds"]["paving"], 1.5);
  EXPECT_EQ(json["checksum"].get<std::string>().size(), 16u);
}

TEST(ReportTable, NamesAtMostTenFacesTheFailedFirst) {
  RunReport report;
  report.faces.resize(40);
  for (std::size_t i = 0; i < report.faces.size(); ++i) {
    report.faces[i].name = "Face" + std::to_string(i + 1);
    report.faces[i].quads = 1;
    report.faces[i].worst_sj = 0.01 * static_cast<double>(i);
  }
  report.faces[39].status = FaceStatus::failed;
  report.faces[39].reason = "no room";
  std::string table = report_table(report);
  EXPECT_NE(table.find("faces         Face40 failed"), std::string::npos) << table;
  EXPECT_EQ(table.find("Face10:"), std::string::npos) << table;
  EXPECT_NE(table.find("and 21 more"), std::string::npos) << table;
}

}  // namespace
}  // namespace paver
