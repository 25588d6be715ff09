// An anonymous file of the kernel, reached through the process's own table of open files.
#include "base/process/memory_file.h"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>

#include "paver/error.h"

namespace paver {
namespace {

bool write_all(int descriptor, std::span<const char> bytes) {
  while (!bytes.empty()) {
    ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return true;
}

}  // namespace

MemoryFile::MemoryFile(std::span<const char> bytes) : descriptor_(::memfd_create("paver", MFD_CLOEXEC)) {
  if (descriptor_ >= 0 && write_all(descriptor_, bytes)) return;
  if (descriptor_ >= 0) ::close(descriptor_);
  throw Error(ErrorCode::out_of_memory,
              fmt::format("No memory for a model of {} bytes; free some, or write the model to a file.", bytes.size()));
}

MemoryFile::~MemoryFile() { ::close(descriptor_); }

std::string MemoryFile::path() const { return fmt::format("/proc/self/fd/{}", descriptor_); }

}  // namespace paver
