// Bytes under a path, for readers that want a file.
#pragma once

#include <span>
#include <string>

namespace paver {

/// A file in memory that goes away with this object, also when the process dies. Throws Error{out_of_memory}.
class MemoryFile {
 public:
  explicit MemoryFile(std::span<const char> bytes);
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  /// May be opened any number of times as long as this object lives.
  std::string path() const;

 private:
  int descriptor_;
};

}  // namespace paver
