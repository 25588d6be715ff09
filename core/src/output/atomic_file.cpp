// A file that appears whole or not at all: written beside its path, synchronised, closed, renamed. Several ranks put
// pieces at their places by plain calls of the system: core/docs/decisions/parallel-writing.md says why.
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

#include "base/tasks/gather.h"
#include "output/atomic_file_impl.h"
#include "paver/output.h"

namespace paver {
namespace {

constexpr mode_t new_file_mode = 0666;  // less the user's mask
constexpr std::size_t buffer_bytes = 1 << 20;

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

const char* remedy_for(int error_number) {
  switch (error_number) {
    case ENOSPC:
    case EDQUOT:
      return "make room there, or choose another place";
    case EFBIG:
      return "allow larger files (ulimit -f), or choose a larger target length";
    case ENOENT:
    case ENOTDIR:
      return "make that folder, or choose another one";
    case EISDIR:
    case ENAMETOOLONG:
    case ELOOP:
      return "choose another name";
    default:
      return "choose another place, or see to it that this one may be written";
  }
}

/// Makes a new name in a folder survive a power cut; not every file system can, and that is no failure.
void synchronise_folder(const fs::path& file) {
  fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

/// The file that `path` means once links are followed. Throws Error{unwritable_output} for what exists and is not a
/// regular file, or may not be written.
std::string writable_target(const std::string& path) {
  std::string target = followed(path).string();
  struct stat found = {};
  if (::stat(target.c_str(), &found) != 0) return target;
  if (S_ISDIR(found.st_mode)) fail_to_write(path, EISDIR);
  if (!S_ISREG(found.st_mode)) {
    throw Error(
        ErrorCode::unwritable_output,
        fmt::format("Cannot write '{}': it is a device or pipe, not a regular file; choose another name.", path));
  }
  if (::access(target.c_str(), W_OK) != 0) fail_to_write(path, errno);
  return target;
}

/// Creates the temporary file of `path`, new and empty; its descriptor.
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

/// Takes room for a file on the disk. Where the file system cannot promise it, that is no failure.
void reserve(int descriptor, long bytes, const std::string& path) {
#ifdef __linux__
  if (bytes > 0 && ::fallocate(descriptor, 0, 0, bytes) != 0 && errno != EOPNOTSUPP && errno != ENOSYS)
    fail_to_write(path, errno);
#endif
  if (::ftruncate(descriptor, bytes) != 0) fail_to_write(path, errno);
}

/// Writes at a place of an open file.
void write_to(int descriptor, const char* data, std::size_t bytes, long offset, const std::string& path) {
  std::size_t done = 0;
  while (done < bytes) {
    ssize_t written = ::pwrite(descriptor, data + done, bytes - done, offset + static_cast<long>(done));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail_to_write(path, errno);
    done += static_cast<std::size_t>(written);
  }
#ifdef __linux__
  // The disk begins now; synchronising at the end then has less to wait for. What fails here fails there again.
  if (bytes > 0) ::sync_file_range(descriptor, offset, static_cast<long>(bytes), SYNC_FILE_RANGE_WRITE);
#endif
}

/// Makes what was written safe on disk and closes; where that fails, still closes.
void synchronise_and_close(int descriptor, const std::string& path) {
  // EINVAL, EROFS: a file system that cannot synchronise. Anything else means lost data.
  int fault = ::fsync(descriptor) != 0 && errno != EINVAL && errno != EROFS ? errno : 0;
  if (::close(descriptor) != 0 && errno != EINTR && fault == 0) fault = errno;
  if (fault != 0) fail_to_write(path, fault);
}

}  // namespace

std::string temporary_name(const std::string& path, long process) {
  fs::path target = followed(path);
  const long owner = process != 0 ? process : ::getpid();
  return (target.parent_path() / fmt::format(".{}.{}.part", target.filename().string(), owner)).string();
}

void fail_to_write(const std::string& path, int error_number) {
  throw Error(ErrorCode::unwritable_output,
              fmt::format("Cannot write '{}': {}; {}.", path, reason_of(error_number), remedy_for(error_number)));
}

AtomicFile::AtomicFile(const Progress* progress, const std::string& path)
    : PlacedSink(buffer_bytes), path_(path), progress_(progress) {}

AtomicFile::AtomicFile(const std::string& path, const Progress* progress) : AtomicFile(progress, path) { create(0); }

// The object counts as made once the private constructor is through: what throws here calls the destructor.
AtomicFile::AtomicFile(const std::string& path, long bytes, const Progress* progress, Ranks& ranks)
    : AtomicFile(progress, path) {
  do_together(ranks, [&] {
    if (ranks.rank() == 0) create(bytes);
  });
  temporary_ = ranks.gather(temporary_)[0];
  do_together(ranks, [&] {
    if (ranks.rank() == 0) return;
    descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) fail_to_write(path_, errno);
  });
}

AtomicFile::~AtomicFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (is_created_) ::unlink(temporary_.c_str());
  if (has_earlier_) ::unlink(earlier_.c_str());
}

void AtomicFile::create(long bytes) {
  target_ = writable_target(path_);
  temporary_ = temporary_name(path_);
  descriptor_ = create_temporary(path_);
  is_created_ = true;
  reserve(descriptor_, bytes, path_);
}

void AtomicFile::write_at(const char* data, std::size_t bytes, long offset) const {
  if (progress_) progress_->check();
  write_to(descriptor_, data, bytes, offset, path_);
}

void AtomicFile::finish() {
  flush();
  synchronise_and_close(std::exchange(descriptor_, -1), path_);
}

void AtomicFile::commit() {
  earlier_ = temporary_ + ".earlier";
  has_earlier_ = ::link(target_.c_str(), earlier_.c_str()) == 0;
  is_new_ = !has_earlier_ && errno == ENOENT;
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail_to_write(path_, errno);
  is_created_ = false;
  synchronise_folder(target_);
}

void AtomicFile::undo() {
  if (std::exchange(has_earlier_, false)) ::rename(earlier_.c_str(), target_.c_str());
  if (std::exchange(is_new_, false)) ::unlink(target_.c_str());
}

}  // namespace paver
