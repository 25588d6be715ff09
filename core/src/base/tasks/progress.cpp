// Names of the stages as users read them.
#include "paver/progress.h"

namespace paver {

const char* stage_name(Stage stage) {
  switch (stage) {
    case Stage::read:
      return "read";
    case Stage::topology:
      return "topology";
    case Stage::sizing:
      return "sizing";
    case Stage::boundary:
      return "boundary";
    case Stage::regions:
      return "regions";
    case Stage::paving:
      return "paving";
    case Stage::repair:
      return "repair";
    case Stage::join:
      return "join";
    case Stage::curving:
      return "curving";
    case Stage::quality:
      return "quality";
    case Stage::write:
      return "write";
    case Stage::done:
      return "done";
  }
  return "unknown";
}

}  // namespace paver
