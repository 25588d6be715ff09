// Temporary folders: in TMPDIR and in /dev/shm.
#include "launch/run_folder.h"

#include <fmt/format.h>
#include <stdlib.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "paver/error.h"

namespace paver {
namespace {

namespace fs = std::filesystem;

constexpr const char* shared_memory_root = "/dev/shm";

/// Empty where none can be made.
std::string make_folder(const fs::path& parent) {
  std::string name = (parent / "paver-XXXXXX").string();
  return ::mkdtemp(name.data()) ? name : std::string();
}

void remove(const std::string& folder) {
  std::error_code ignored;
  if (!folder.empty()) fs::remove_all(folder, ignored);
}

}  // namespace

RunFolder::RunFolder() {
  std::error_code error;
  fs::path parent = fs::temp_directory_path(error);
  if (!error) path_ = make_folder(parent);
  if (path_.empty()) {
    std::string reason = error ? error.message() : std::strerror(errno);
    throw Error(ErrorCode::unwritable_output,
                fmt::format("No temporary folder can be made in '{}' ({}); set TMPDIR to a folder that can be written.",
                            error ? "TMPDIR" : parent.string(), reason));
  }
  shared_memory_ = make_folder(shared_memory_root);
  if (shared_memory_.empty()) shared_memory_ = path_;
}

RunFolder::~RunFolder() {
  remove(path_);
  if (shared_memory_ != path_) remove(shared_memory_);
}

}  // namespace paver
