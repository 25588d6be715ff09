// The one exception type of the core.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include "paver/vec.h"

namespace paver {

/// What went wrong; each has its own remedy (see the message).
enum class ErrorCode {
  bad_option,         ///< a value out of range, NaN, or options that exclude each other
  file_missing,       ///< the input does not exist or may not be read
  not_a_cad_file,     ///< the content is not STEP, IGES or BREP
  damaged_file,       ///< right format, but truncated or unreadable
  no_faces,           ///< read, but nothing in it has a surface
  too_many_elements,  ///< predicted count above Options::max_elements
  unwritable_output,  ///< output folder missing, no permission, disk full
  cancelled,          ///< Progress::cancel() was called
  out_of_memory,      ///< an allocation failed
  face_failed,        ///< one face cannot be meshed (kept as data, see FaceReport)
  internal,           ///< a broken invariant: a defect of ours
};

/// Name as in the enumeration, e.g. "bad_option".
const char* code_name(ErrorCode code);

/// Exit code of a program that ends with such an error; 0 is left for success.
int exit_code(ErrorCode code);

/// Where it went wrong. Ids are 0-based; the text of an Error uses the names Face1, Edge1 ...
struct Where {
  std::string stage;
  int face = -1;
  int edge = -1;
  std::optional<Vec3> point;
};

/// One sentence: what, where, and what to do.
class Error : public std::runtime_error {
 public:
  Error(ErrorCode code, const std::string& text, Where where = {})
      : std::runtime_error(text), code_(code), where_(std::move(where)) {}
  ErrorCode code() const { return code_; }
  const Where& where() const { return where_; }
  /// What to do, without an end mark: what the sentence says after its last semicolon, else what helps against this
  /// code.
  std::string remedy() const;

 private:
  ErrorCode code_;
  Where where_;
};

/// The exception that is being handled, as an Error.
Error current_error();

}  // namespace paver
