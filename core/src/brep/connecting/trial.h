// Reading in a process that may die, before this one reads: for files that are not as a writer leaves them.
#pragma once

#include "brep/reading/read_shape.h"
#include "paver/progress.h"

namespace paver {

/// Tries a doubtful file at most once.
class Trial {
 public:
  /// Readers refer to both as long as it lives.
  Trial(const FileSource& file, Progress& progress) : file_(file), progress_(progress) {}

  /// Lets another process read the file and build its topology. Throws what that process refuses the file with,
  /// Error{damaged_file} when the CAD kernel breaks down there or comes to no end, Error{out_of_memory},
  /// Error{internal} without the program for it. What else is wrong with the file is for this process to find. Nothing
  /// where this process may break down (may_break_down()).
  void run();

 private:
  const FileSource& file_;
  Progress& progress_;
  bool has_run_ = false;
};

}  // namespace paver
