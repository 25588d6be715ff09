// A file that appears whole or not at all.
#pragma once

#include <string>

#include "output/byte_sink_impl.h"
#include "paver/progress.h"

namespace paver {

constexpr std::size_t file_buffer_bytes = 1 << 20;

/// The file that `path` means once links are followed. Throws Error{unwritable_output} for what exists and is not a
/// regular file, or may not be written.
std::string writable_target(const std::string& path);

/// Creates the temporary file of `path`, new and empty; its descriptor.
int create_temporary(const std::string& path);

/// Writes at a place of an open file.
void write_at(int descriptor, const char* data, std::size_t bytes, long offset, const std::string& path);

/// Makes what was written safe on disk and closes; where that fails, still closes.
void synchronise_and_close(int descriptor, const std::string& path);

/// Gives the temporary file of `path` its name.
void rename_temporary(const std::string& temporary, const std::string& target, const std::string& path);

/// "Cannot write 'PATH': REASON."
[[noreturn]] void fail_to_write(const std::string& path, int error_number);

/// Written under a temporary name beside its path; finish() makes it safe on disk, commit() gives it its name.
/// Destroyed before commit(): removed. Every failure throws Error{unwritable_output} with the path and the reason.
class AtomicFile : public ByteSink {
 public:
  /// Creates the temporary file. `progress` (may be null) is checked for cancel while writing.
  explicit AtomicFile(const std::string& path, const Progress* progress = nullptr);
  ~AtomicFile() override;
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void finish();
  void commit();

 private:
  void drain(const char* data, std::size_t bytes) override;

  std::string path_, target_, temporary_;
  const Progress* progress_;
  int descriptor_ = -1;
  bool is_committed_ = false;
  long at_ = 0;  // where what waits belongs
};

}  // namespace paver
