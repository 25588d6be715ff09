// What ranks tell whoever started them: one JSON object per line. core/docs/ranks.md lists the keys.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "paver/error.h"
#include "paver/progress.h"

namespace paver {

/// One line, read.
struct Event {
  enum class Kind { progress, error, done, other };
  Kind kind = Kind::other;
  Stage stage = Stage::read;
  double fraction = 0;         ///< of the stage
  std::optional<Error> error;  ///< of an error
  std::vector<double> busy;    ///< of done: seconds per rank
};

/// A pipe with a name in a folder, which ranks open for writing; this end goes with the object, and then a rank that
/// polls its end is told so.
class EventPipe {
 public:
  /// Throws Error{unwritable_output}.
  explicit EventPipe(std::string path);
  ~EventPipe() { close(); }
  EventPipe(const EventPipe&) = delete;
  EventPipe& operator=(const EventPipe&) = delete;

  const std::string& path() const { return path_; }
  /// To wait for with poll(); -1 when closed.
  int descriptor() const { return descriptor_; }
  /// The whole lines that have come.
  std::vector<Event> read();
  void close();

 private:
  std::string path_;
  int descriptor_ = -1;
  std::string unfinished_;
};

}  // namespace paver
