// The temporary folders of one run in several processes.
#pragma once

#include <string>

namespace paver {

/// Two folders that exist as long as this object, readable by this user only: one for files, and one for memory that
/// processes share, where the system has a place for that.
class RunFolder {
 public:
  /// Throws Error{unwritable_output}.
  RunFolder();
  ~RunFolder();
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  std::string file(const std::string& name) const { return path_ + "/" + name; }
  const std::string& path() const { return path_; }
  const std::string& shared_memory() const { return shared_memory_; }

 private:
  std::string path_, shared_memory_;
};

}  // namespace paver
