// Several ranks write the file that one process writes, byte for byte, and no failure leaves one.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>

#include "base/tasks/gather.h"
#include "core/quality/wavy_mesh.h"
#include "output/atomic_file_impl.h"
#include "paver/output.h"
#include "support/deal_shares.h"
#include "support/folders.h"
#include "support/thread_ranks.h"

namespace paver {
namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class WriteShare : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / fmt::format("paver_write_share_{}", ::getpid());
    fs::create_directory(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  long files_left() const { return std::distance(fs::directory_iterator(folder_), fs::directory_iterator()); }

  /// Writes `whole` dealt to `ranks` shares.
  void write_dealt(const MeshResult& whole, int count, unsigned seed, int longest_run, const OutputFiles& files) {
    std::vector<MeshShare> shares = test::deal_shares(whole, count, seed, longest_run);
    test::run_on_ranks(count, [&](Ranks& ranks) {
      Progress progress;
      write_outputs(shares[static_cast<std::size_t>(ranks.rank())], files, progress, ranks);
    });
  }

  void expect_same_bytes(MeshResult whole, const std::string& what) {
    for (const char* name : {"whole.msh", "whole.vtu"}) {
      OutputFiles files{path(name), "", MshVersion::v4_1, false};
      Progress progress;
      write_outputs(whole, files, progress);
      std::string expected = content(files.mesh);
      for (int count : {1, 2, 5}) {
        for (int longest_run : {1, 9, 1000}) {
          OutputFiles shared = files;
          shared.mesh = path(std::string("shared") + fs::path(name).extension().string());
          write_dealt(whole, count, 7, longest_run, shared);
          EXPECT_TRUE(content(shared.mesh) == expected)
              << what << ", " << name << ", " << count << " ranks, runs up to " << longest_run;
        }
      }
    }
    EXPECT_EQ(files_left(), 4) << "two files of one process, two of several";
  }

  fs::path folder_;
};

TEST_F(WriteShare, WritesTheFileOfOneProcess) {
  for (int order = 1; order <= 3; ++order) {
    MeshResult whole = fake::WavyMesh(order, 10, 0.3 / order).result();
    expect_same_bytes(whole, fmt::format("order {}", order));
  }
}

TEST_F(WriteShare, ThreadsWritePartsOfALargeMesh) {
  MeshResult whole = fake::WavyMesh(1, 300, 0.3).result();
  ASSERT_GT(whole.mesh.quad_count(), std::size_t{2} << 15) << "in parts";
  for (const std::string ending : {".msh", ".vtu"}) {
    OutputFiles files{path("one" + ending), "", MshVersion::v4_1, false};
    files.threads = 1;
    Progress progress;
    write_outputs(whole, files, progress);
    OutputFiles others = files;
    others.mesh = path("more" + ending);
    others.threads = 4;
    write_outputs(whole, others, progress);
    EXPECT_TRUE(content(others.mesh) == content(files.mesh)) << ending;
    write_dealt(whole, 2, 7, 1000, others);
    EXPECT_TRUE(content(others.mesh) == content(files.mesh)) << ending;
  }
}

TEST_F(WriteShare, LeavesOutNodesThatNothingUses) {
  MeshResult whole = fake::WavyMesh(2, 8, 0).result();
  SurfaceMesh& mesh = whole.mesh;
  std::size_t half = mesh.quad_count() / 2;  // as when a face has failed: its nodes stay, and so do its lines
  mesh.quads.resize(half * 9), mesh.quad_face.resize(half);
  mesh.triangles.clear(), mesh.triangle_face.clear();
  expect_same_bytes(whole, "half of the elements");
  whole.edge_groups = {"", "Wire1", junctions, "", "Wire1"};
  expect_same_bytes(whole, "half of the elements and wires");
  mesh.points = {mesh.quads[8], mesh.quads[0]};
  whole.point_names = {"Feed", "Probe"};
  expect_same_bytes(whole, "half of the elements, wires and points");
  mesh.lines.clear(), mesh.line_edge.clear(), mesh.points.clear();
  expect_same_bytes(whole, "no lines");
  mesh.quads.clear(), mesh.quad_face.clear();
  expect_same_bytes(whole, "nothing");
}

TEST_F(WriteShare, KeepsFacesApartWhoseNodesAreMixed) {
  MeshResult whole = fake::WavyMesh(2, 12, 0).result();
  std::mt19937 random(4);
  for (std::vector<int>* faces : {&whole.mesh.quad_face, &whole.mesh.triangle_face})
    for (int& face : *faces) face = static_cast<int>(random() % 5);  // nodes off lines in several faces
  whole.face_names = {"a", "b", "a", "", "c", "without elements"};
  expect_same_bytes(whole, "mixed faces");
}

TEST_F(WriteShare, HandlesZerosOfBothSigns) {
  MeshResult whole = fake::WavyMesh(1, 6, 0).result();
  std::mt19937 random(4);
  for (Vec3& x : whole.mesh.nodes) x.z = random() % 2 ? 0.0 : -0.0;
  expect_same_bytes(whole, "zeros");
}

TEST_F(WriteShare, DoesSoForMeshesOfModels) {
  for (const char* name : {"torus", "box_cylinder", "sphere"}) {
    Options options;
    options.size = 25;
    Progress progress;
    MeshResult whole = mesh_file(test::examples_folder() / fmt::format("{}.step", name), options, progress);
    expect_same_bytes(whole, name);
  }
}

TEST_F(WriteShare, WritesTheReportOfTheWhole) {
  MeshResult whole = fake::WavyMesh(2, 8, 0.1).result();
  for (const char* mesh : {"a.msh", ""}) {
    OutputFiles files{*mesh ? path(mesh) : "", path("r.json"), MshVersion::v4_1, false};
    write_dealt(whole, 3, 1, 5, files);
    auto json = nlohmann::json::parse(content(files.report));
    EXPECT_EQ(json["checksum"], fmt::format("{:016x}", checksum(whole.mesh)));
    EXPECT_TRUE(json["stage_seconds"].contains("write"));
  }
  EXPECT_EQ(files_left(), 2);
}

/// What each rank throws while it writes `whole` to `files`.
std::vector<std::string> failures(const MeshResult& whole, int count, const OutputFiles& files,
                                  const std::function<void(Ranks&, Progress&)>& before = {}) {
  std::vector<MeshShare> shares = test::deal_shares(whole, count, 1, 40);
  std::vector<std::string> thrown(static_cast<std::size_t>(count));
  test::run_on_ranks(count, [&](Ranks& ranks) {
    std::size_t rank = static_cast<std::size_t>(ranks.rank());
    Progress progress;
    try {
      if (before) before(ranks, progress);
      write_outputs(shares[rank], files, progress, ranks);
    } catch (const Error& error) {
      thrown[rank] = fmt::format("{}: {}", code_name(error.code()), error.what());
    }
  });
  return thrown;
}

void expect_all(const std::vector<std::string>& thrown, const std::string& part) {
  for (const std::string& text : thrown) {
    EXPECT_EQ(text, thrown[0]) << "all ranks must say the same";
    EXPECT_NE(text.find(part), std::string::npos) << text;
  }
}

TEST_F(WriteShare, RefusesWhatItCannotWrite) {
  MeshResult whole = fake::WavyMesh(1, 4, 0).result();
  expect_all(failures(whole, 3, {path("a.msh"), "", MshVersion::v2_2, false}), "bad_option: ");
  expect_all(failures(whole, 3, {path("a.vtu"), "", MshVersion::v4_1, true}), "bad_option: ");
  expect_all(failures(whole, 3, {path("a.stl"), "", MshVersion::v4_1, false}), "bad_option: ");
  EXPECT_THROW(check_outputs({path("a.msh"), "", MshVersion::v2_2, false}, 2), Error);
  EXPECT_THROW(check_outputs({path("a.msh"), "", MshVersion::v4_1, true}, 2), Error);
  EXPECT_NO_THROW(check_outputs({path("a.vtu"), path("r.json"), MshVersion::v2_2, false}, 2));
  EXPECT_EQ(files_left(), 0);
}

TEST_F(WriteShare, TellsAllRanksOfAFolderThatCannotBeWritten) {
  MeshResult whole = fake::WavyMesh(1, 4, 0).result();
  std::string where = path("no/such/a.msh");
  expect_all(failures(whole, 3, {where, "", MshVersion::v4_1, false}),
             fmt::format("unwritable_output: Cannot write '{}': no such file or directory; make that folder, or choose "
                         "another one.",
                         where));
  where = path("no/such/r.json");
  expect_all(failures(whole, 3, {path("a.vtu"), where, MshVersion::v4_1, false}),
             "unwritable_output: Cannot write '" + where);
  fs::create_directory(path("folder.msh"));
  expect_all(failures(whole, 2, {path("folder.msh"), "", MshVersion::v4_1, false}), "is a directory");
  EXPECT_EQ(files_left(), 1);
}

TEST_F(WriteShare, LeavesNothingOnAFullDisk) {
  MeshResult whole = fake::WavyMesh(2, 60, 0).result();
  std::ofstream(path("a.msh")) << "old";
  auto old_handler = ::signal(SIGXFSZ, SIG_IGN);
  rlimit old_limit{};
  getrlimit(RLIMIT_FSIZE, &old_limit);
  rlimit limit = old_limit;
  limit.rlim_cur = 100'000;
  setrlimit(RLIMIT_FSIZE, &limit);
  std::vector<std::string> thrown = failures(whole, 3, {path("a.msh"), path("r.json"), MshVersion::v4_1, false});
  setrlimit(RLIMIT_FSIZE, &old_limit);
  ::signal(SIGXFSZ, old_handler);
  expect_all(thrown, "unwritable_output: Cannot write '" + path("a.msh"));
  EXPECT_EQ(content(path("a.msh")), "old");
  EXPECT_EQ(files_left(), 1);
}

TEST_F(WriteShare, FailsTogetherWhenOneRankCannotGoOn) {
  MeshResult whole = fake::WavyMesh(2, 60, 0).result();
  auto cancel_one = [](Ranks& ranks, Progress& progress) {
    if (ranks.rank() == 1) progress.cancel();
  };
  for (const char* name : {"a.msh", "a.vtu"})
    expect_all(failures(whole, 3, {path(name), path("r.json"), MshVersion::v4_1, false}, cancel_one), "cancelled: ");
  EXPECT_EQ(files_left(), 0);
}

TEST_F(WriteShare, RemovesTheFileWhenOneRankCannotWriteItsPieces) {
  std::vector<std::string> thrown(3);
  test::run_on_ranks(3, [&](Ranks& ranks) {
    Progress progress;
    try {
      AtomicFile file(path("a.msh"), 1000, &progress, ranks);
      do_together(ranks, [&] {
        file.seek(100 * ranks.rank());
        file.write("piece");
        if (ranks.rank() == 2) fail_to_write(path("a.msh"), ENOSPC);
        file.finish();
      });
      if (ranks.rank() == 0) file.commit();
    } catch (const Error& error) {
      thrown[static_cast<std::size_t>(ranks.rank())] = error.what();
    }
  });
  expect_all(thrown, "no space left on device");
  EXPECT_EQ(files_left(), 0);
}

TEST_F(WriteShare, WhatHadTheNameComesBack) {
  std::ofstream(path("old.json")) << "earlier";
  for (bool is_undone : {true, false}) {
    AtomicFile old(path("old.json")), fresh(path("fresh.json"));
    for (AtomicFile* file : {&old, &fresh}) {
      file->write("new");
      file->finish();
      file->commit();
      if (is_undone) file->undo();
    }
    EXPECT_EQ(content(path("old.json")), is_undone ? "earlier" : "new");
    EXPECT_EQ(fs::exists(path("fresh.json")), !is_undone);
  }
  EXPECT_EQ(files_left(), 2);
}

}  // namespace
}  // namespace paver
