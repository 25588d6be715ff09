// A file that appears whole or not at all: written beside its path, synchronised, closed, renamed.
//
// A path that is a link is followed, so that the link stays. What exists and is not a regular file (a folder, a
// device) is never replaced.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "output/atomic_file_impl.h"
#include "paver/output.h"

namespace paver {
namespace {

constexpr std::size_t buffer_bytes = 1 << 20;
constexpr mode_t new_file_mode = 0666;  // less the user's mask

namespace fs = std::filesystem;

/// The file that `path` means once links are followed.
fs::path followed(const std::string& path) {
  std::error_code ignored;
  if (!fs::is_symlink(path, ignored)) return path;
  fs::path target = fs::weakly_canonical(path, ignored);
  return target.empty() ? fs::path(path) : target;
}

std::string reason_of(int error_number) {
  std::string reason = std::strerror(error_number);
  if (!reason.empty()) reason[0] = static_cast<char>(std::tolower(reason[0]));
  return reason;
}

/// Makes a new name in a folder survive a power cut; not every file system can, and that is no failure.
void synchronise_folder(const fs::path& file) {
  fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace

std::string temporary_name(const std::string& path) {
  fs::path target = followed(path);
  return (target.parent_path() / fmt::format(".{}.{}.part", target.filename().string(), ::getpid())).string();
}

void fail_to_write(const std::string& path, int error_number) {
  throw Error(ErrorCode::unwritable_output, fmt::format("Cannot write '{}': {}.", path, reason_of(error_number)));
}

std::string writable_target(const std::string& path) {
  std::string target = followed(path).string();
  struct stat found {};
  if (::stat(target.c_str(), &found) != 0) return target;
  if (S_ISDIR(found.st_mode)) fail_to_write(path, EISDIR);
  if (!S_ISREG(found.st_mode)) {
    throw Error(ErrorCode::unwritable_output,
                fmt::format("Cannot write '{}': it is a device or pipe, not a regular file.", path));
  }
  if (::access(target.c_str(), W_OK) != 0) fail_to_write(path, errno);
  return target;
}

int create_temporary(const std::string& path) {
  std::string temporary = temporary_name(path);
  constexpr int mode = O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC;
  int descriptor = ::open(temporary.c_str(), mode, new_file_mode);
  if (descriptor < 0 && errno == EEXIST) {  // left by a process of this number that was killed
    ::unlink(temporary.c_str());
    descriptor = ::open(temporary.c_str(), mode, new_file_mode);
  }
  if (descriptor < 0) fail_to_write(path, errno);
  return descriptor;
}

void synchronise_and_close(int descriptor, const std::string& path) {
  // EINVAL, EROFS: a file system that cannot synchronise. Anything else means lost data.
  int fault = ::fsync(descriptor) != 0 && errno != EINVAL && errno != EROFS ? errno : 0;
  if (::close(descriptor) != 0 && errno != EINTR && fault == 0) fault = errno;
  if (fault != 0) fail_to_write(path, fault);
}

void rename_temporary(const std::string& temporary, const std::string& target, const std::string& path) {
  if (::rename(temporary.c_str(), target.c_str()) != 0) fail_to_write(path, errno);
  synchronise_folder(target);
}

AtomicFile::AtomicFile(const std::string& path, const Progress* progress)
    : path_(path), target_(writable_target(path)), temporary_(temporary_name(path)), progress_(progress) {
  descriptor_ = create_temporary(path);
  buffer_.reserve(buffer_bytes);
}

AtomicFile::~AtomicFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!is_committed_) ::unlink(temporary_.c_str());
}

void AtomicFile::write(const void* data, std::size_t bytes) {
  const char* from = static_cast<const char*>(data);
  while (bytes > 0) {
    std::size_t part = std::min(bytes, buffer_bytes - buffer_.size());
    buffer_.insert(buffer_.end(), from, from + part);
    from += part;
    bytes -= part;
    if (buffer_.size() == buffer_bytes) flush();
  }
}

void AtomicFile::flush() {
  if (progress_) progress_->check();
  for (std::size_t at = 0; at < buffer_.size();) {
    ssize_t written = ::write(descriptor_, buffer_.data() + at, buffer_.size() - at);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail_to_write(path_, errno);
    at += static_cast<std::size_t>(written);
  }
  buffer_.clear();
}

void AtomicFile::finish() {
  flush();
  synchronise_and_close(std::exchange(descriptor_, -1), path_);
}

void AtomicFile::commit() {
  rename_temporary(temporary_, target_, path_);
  is_committed_ = true;
}

}  // namespace paver
