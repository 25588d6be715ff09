// All files of one run, or none: each is written whole under a temporary name, and only when all are safe on disk do
// they get their names.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <filesystem>
#include <optional>

#include "output/atomic_file_impl.h"
#include "output/mesh_writers_impl.h"
#include "output/share_writers_impl.h"
#include "output/shared_file_impl.h"
#include "paver/output.h"

namespace paver {
namespace {

/// Ending of a file name in lower case, with its dot.
std::string ending(const std::string& path) {
  std::string text = std::filesystem::path(path).extension().string();
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

bool is_vtu(const OutputFiles& files) { return ending(files.mesh) == ".vtu"; }

bool is_same_file(const std::string& a, const std::string& b) {
  std::error_code ignored;
  auto full = [&](const std::string& path) { return std::filesystem::weakly_canonical(path, ignored); };
  return full(a) == full(b);
}

void check_share_formats(const OutputFiles& files) {
  if (files.mesh.empty() || (!files.is_ascii && (is_vtu(files) || files.msh_version == MshVersion::v4_1))) return;
  throw Error(ErrorCode::bad_option,
              fmt::format("Several processes write binary .msh 4.1 and .vtu only, not '{}' as {}; "
                          "choose one of these or a single process (--ranks 0).",
                          files.mesh, files.is_ascii ? "text" : ".msh 2.2"));
}

void check_names(const OutputFiles& files) {
  if (!files.mesh.empty() && ending(files.mesh) != ".msh" && ending(files.mesh) != ".vtu") {
    throw Error(ErrorCode::bad_option,
                fmt::format("The name of the mesh file '{}' must end in .msh or .vtu.", files.mesh));
  }
  if (!files.mesh.empty() && !files.report.empty() && is_same_file(files.mesh, files.report)) {
    throw Error(ErrorCode::bad_option, fmt::format("Mesh and report have the same file name '{}'.", files.mesh));
  }
  for (const std::string& output : {files.mesh, files.report}) {
    std::error_code ignored;
    if (!output.empty() && !files.input.empty() && std::filesystem::equivalent(files.input, output, ignored)) {
      throw Error(ErrorCode::bad_option,
                  fmt::format("'{}' is the input, which is not written over; choose another name.", output));
    }
  }
}

void write_mesh(const MeshResult& result, const OutputFiles& files, AtomicFile& file) {
  if (is_vtu(files)) {
    write_vtu(result, files.is_ascii, file);
  } else if (files.msh_version == MshVersion::v2_2) {
    write_msh2(result, files.is_ascii, file);
  } else {
    write_msh4(result, files.is_ascii, file);
  }
}

void add_stage_seconds(MeshResult& result, std::chrono::steady_clock::time_point start) {
  std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  result.report.stage_seconds.emplace_back(stage_name(Stage::write), seconds.count());
}

/// The mesh last: who waits for it finds the report, too.
template <class MeshFile>
void commit_both(const OutputFiles& files, std::optional<AtomicFile>& report, std::optional<MeshFile>& mesh) {
  if (report) report->commit();
  try {
    if (mesh) mesh->commit();
  } catch (const Error&) {
    if (!files.report.empty()) std::filesystem::remove(files.report);
    throw;
  }
}

}  // namespace

void check_outputs(const OutputFiles& files) {
  check_names(files);
  for (const std::string& path : {files.mesh, files.report}) {
    if (!path.empty()) AtomicFile trial(path);  // created and removed again: the only sure test
  }
}

void write_outputs(MeshResult& result, const OutputFiles& files, Progress& progress) {
  check_names(files);
  progress.begin(Stage::write, 2);
  auto start = std::chrono::steady_clock::now();
  std::optional<AtomicFile> mesh, report;
  if (!files.mesh.empty()) {
    mesh.emplace(files.mesh, &progress);
    write_mesh(result, files, *mesh);
    mesh->finish();
  }
  progress.advance();
  add_stage_seconds(result, start);
  if (!files.report.empty()) {
    report.emplace(files.report, &progress);
    report->write(report_json(result));
    report->finish();
  }
  progress.advance();
  commit_both(files, report, mesh);
}

void check_share_outputs(const OutputFiles& files) {
  check_share_formats(files);
  check_outputs(files);
}

void write_share(MeshShare& share, const OutputFiles& files, Progress& progress, Ranks& ranks) {
  do_together(ranks, [&] {
    check_share_formats(files);
    check_names(files);
    progress.begin(Stage::write, 2);
  });
  auto start = std::chrono::steady_clock::now();
  std::optional<SharedFile> mesh;
  std::optional<AtomicFile> report;
  if (!files.mesh.empty()) {
    auto writer = is_vtu(files) ? vtu_share_writer(share, ranks) : msh4_share_writer(share, ranks);
    mesh.emplace(files.mesh, writer->file_bytes(), progress, ranks);
    do_together(ranks, [&] {
      writer->write(*mesh);
      mesh->finish();
    });
  }
  add_stage_seconds(share.result, start);
  std::uint64_t sum = files.report.empty() ? 0 : checksum(share, ranks);
  do_together(ranks, [&] {
    progress.advance();
    if (ranks.rank() == 0 && !files.report.empty()) {
      report.emplace(files.report, &progress);
      report->write(report_json(share.result, sum));
      report->finish();
    }
    progress.advance();
  });
  do_together(ranks, [&] {
    if (ranks.rank() == 0) commit_both(files, report, mesh);
  });
}

}  // namespace paver
