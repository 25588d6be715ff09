// Pieces at their places in one file, by plain calls of the system: core/docs/decisions/parallel-writing.md says why.
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

#include "output/atomic_file_impl.h"
#include "output/shared_file_impl.h"
#include "paver/error.h"
#include "paver/output.h"

namespace paver {
namespace {

/// Takes room for a file on the disk. Where the file system cannot promise it, that is no failure.
int reserve(int descriptor, long bytes) {
#ifdef __linux__
  if (bytes > 0 && ::fallocate(descriptor, 0, 0, bytes) != 0 && errno != EOPNOTSUPP && errno != ENOSYS) return errno;
#endif
  return ::ftruncate(descriptor, bytes) != 0 ? errno : 0;
}

}  // namespace

void do_together(Ranks& ranks, const std::function<void()>& work) {
  std::string mine;  // empty: done; else the code and the sentence
  try {
    work();
  } catch (const Error& error) {
    mine = static_cast<char>(error.code()) + std::string(error.what());
  }
  for (const std::string& fault : ranks.gather(mine)) {
    if (!fault.empty()) throw Error(static_cast<ErrorCode>(fault[0]), fault.substr(1));
  }
}

SharedFile::SharedFile(const std::string& path, long bytes, const Progress& progress, Ranks& ranks)
    : ByteSink(file_buffer_bytes), path_(path), progress_(progress), is_first_(ranks.rank() == 0) {
  try {
    do_together(ranks, [&] {
      if (is_first_) create(bytes);
    });
    temporary_ = ranks.gather(temporary_)[0];
    do_together(ranks, [&] {
      if (is_first_) return;
      descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CLOEXEC);
      if (descriptor_ < 0) fail_to_write(path_, errno);
    });
  } catch (...) {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (is_created_) ::unlink(temporary_.c_str());
    throw;
  }
}

SharedFile::~SharedFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (is_created_) ::unlink(temporary_.c_str());
}

void SharedFile::create(long bytes) {
  target_ = writable_target(path_);
  temporary_ = temporary_name(path_);
  descriptor_ = create_temporary(path_);
  is_created_ = true;
  if (int fault = reserve(descriptor_, bytes); fault != 0) fail_to_write(path_, fault);
}

void SharedFile::seek(long offset) {
  if (offset == at_ + static_cast<long>(waiting())) return;
  flush();
  at_ = offset;
}

void SharedFile::drain(const char* data, std::size_t bytes) {
  progress_.check();
  write_at(descriptor_, data, bytes, at_, path_);
  at_ += static_cast<long>(bytes);
}

void SharedFile::finish() {
  flush();
  synchronise_and_close(std::exchange(descriptor_, -1), path_);
}

void SharedFile::commit() {
  rename_temporary(temporary_, target_, path_);
  is_created_ = false;
}

}  // namespace paver
