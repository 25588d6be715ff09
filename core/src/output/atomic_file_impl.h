// A file that appears whole or not at all.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "paver/progress.h"

namespace paver {

/// Written under a temporary name beside its path; finish() makes it safe on disk, commit() gives it its name.
/// Destroyed before commit(): removed. Every failure throws Error{unwritable_output} with the path and the reason.
class AtomicFile {
 public:
  /// Creates the temporary file. `progress` (may be null) is checked for cancel while writing.
  explicit AtomicFile(const std::string& path, const Progress* progress = nullptr);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(const void* data, std::size_t bytes);
  void write(std::string_view text) { write(text.data(), text.size()); }
  /// Array as it lies in memory.
  template <class T>
  void write_packed(const std::vector<T>& values) {
    write(values.data(), values.size() * sizeof(T));
  }
  template <class T>
  void write_packed(T value) {
    write(&value, sizeof value);
  }

  void finish();
  void commit();

 private:
  void flush();
  void close();
  [[noreturn]] void fail(int error_number) const;

  std::string path_, target_, temporary_;
  const Progress* progress_;
  int descriptor_ = -1;
  bool is_committed_ = false;
  std::vector<char> buffer_;
};

}  // namespace paver
