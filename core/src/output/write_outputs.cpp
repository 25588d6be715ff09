// All files of one run, or none: each is written whole under a temporary name, and only when all are safe on disk do
// they get their names.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <filesystem>
#include <memory>

#include "base/tasks/gather.h"
#include "base/tasks/tasks.h"
#include "output/atomic_file_impl.h"
#include "output/mesh_writers_impl.h"
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

void check_format(const OutputFiles& files, int ranks) {
  if (ranks == 1 || files.mesh.empty() || (!files.is_ascii && (is_vtu(files) || files.msh_version == MshVersion::v4_1)))
    return;
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
  if (!files.repaired.empty() && ending(files.repaired) != ".brep" && ending(files.repaired) != ".brp") {
    throw Error(ErrorCode::bad_option,
                fmt::format("The name of the repaired model '{}' must end in .brep.", files.repaired));
  }
  const std::vector<std::string> outputs = files.paths();
  for (std::size_t i = 1; i < outputs.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (is_same_file(outputs[i], outputs[k]))
        throw Error(ErrorCode::bad_option, fmt::format("Two outputs have the same file name '{}'.", outputs[i]));
  for (const std::string& output : outputs) {
    std::error_code ignored;
    if (!files.input.empty() && std::filesystem::equivalent(files.input, output, ignored)) {
      throw Error(ErrorCode::bad_option,
                  fmt::format("'{}' is the input, which is not written over; choose another name.", output));
    }
  }
}

std::unique_ptr<MeshWriter> mesh_writer(HeldMesh held, const OutputFiles& files, Ranks& ranks) {
  if (is_vtu(files)) return vtu_writer(held, files.is_ascii, ranks);
  return files.msh_version == MshVersion::v2_2 ? msh2_writer(held, files.is_ascii, ranks)
                                               : msh4_writer(held, files.is_ascii, ranks);
}

/// The mesh, whole under its temporary name; collective. Null where there is no file for it.
std::unique_ptr<AtomicFile> write_mesh(HeldMesh held, const OutputFiles& files, Progress& progress, Ranks& ranks) {
  if (files.mesh.empty()) return nullptr;
  const std::unique_ptr<MeshWriter> writer = mesh_writer(held, files, ranks);
  auto file = std::make_unique<AtomicFile>(files.mesh, writer->file_bytes(), &progress, ranks);
  do_together(ranks, [&] {
    writer->write(*file);
    file->finish();
  });
  return file;
}

void add_stage_seconds(MeshResult& result, std::chrono::steady_clock::time_point start) {
  std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  result.report.stage_seconds.emplace_back(stage_name(Stage::write), seconds.count());
}

/// The files beside the mesh, whole under their temporary names.
std::vector<std::unique_ptr<AtomicFile>> write_texts(const OutputFiles& files, const std::string& report,
                                                     Progress& progress) {
  std::vector<std::unique_ptr<AtomicFile>> written;
  auto write = [&](const std::string& path, const std::string& text) {
    if (path.empty()) return;
    written.push_back(std::make_unique<AtomicFile>(path, &progress));
    written.back()->write(text);
    written.back()->finish();
  };
  write(files.repaired, files.repaired_text);
  write(files.report, report);
  return written;
}

/// The mesh last: who waits for it finds the others, too.
void commit_all(std::vector<std::unique_ptr<AtomicFile>>& texts, AtomicFile* mesh) {
  std::size_t committed = 0;
  try {
    for (; committed < texts.size(); ++committed) texts[committed]->commit();
    if (mesh) mesh->commit();
  } catch (const Error&) {
    for (std::size_t i = 0; i < committed; ++i) texts[i]->undo();
    throw;
  }
}

void write_held(MeshResult& result, const ShareNumbers& numbers, const OutputFiles& files, Progress& progress,
                Ranks& ranks) {
  do_together(ranks, [&] {
    check_format(files, ranks.count());
    check_names(files);
    progress.begin(Stage::write, 2);
  });
  auto start = std::chrono::steady_clock::now();
  const std::unique_ptr<AtomicFile> mesh = write_mesh({result, numbers}, files, progress, ranks);
  add_stage_seconds(result, start);
  const std::uint64_t sum = files.report.empty() ? 0 : checksum(result.mesh, numbers, ranks);
  std::vector<std::unique_ptr<AtomicFile>> texts;
  do_together(ranks, [&] {
    progress.advance();
    if (ranks.rank() == 0)
      texts = write_texts(files, files.report.empty() ? std::string() : report_json(result, sum), progress);
    progress.advance();
  });
  do_together(ranks, [&] {
    if (ranks.rank() == 0) commit_all(texts, mesh.get());
  });
}

}  // namespace

std::optional<MshVersion> msh_version(std::string_view text) {
  if (text == "4.1") return MshVersion::v4_1;
  return text == "2.2" ? std::optional(MshVersion::v2_2) : std::nullopt;
}

std::vector<std::string> OutputFiles::paths() const {
  std::vector<std::string> list;
  for (const std::string& path : {mesh, report, repaired})
    if (!path.empty()) list.push_back(path);
  return list;
}

void check_outputs(const OutputFiles& files, int ranks) {
  check_format(files, ranks);
  check_names(files);
  for (const std::string& path : files.paths()) AtomicFile trial(path);  // created and removed: the only sure test
}

void write_outputs(MeshResult& result, const OutputFiles& files, Progress& progress) {
  SingleRank alone;
  run_in_arena(files.threads, [&] { write_held(result, whole_numbers(result.mesh), files, progress, alone); });
}

void write_outputs(MeshShare& share, const OutputFiles& files, Progress& progress, Ranks& ranks) {
  run_in_arena(files.threads, [&] { write_held(share.result, share, files, progress, ranks); });
}

}  // namespace paver
