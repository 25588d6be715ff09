// Names of the stages, and what users read of them.
#include "paver/progress.h"

#include "paver/stage_table.h"

namespace paver {

const std::array<StageInfo, static_cast<int>(Stage::done)>& stage_table() {
  static constexpr std::array<StageInfo, static_cast<int>(Stage::done)> table = {{
      {"read", "Reading the shape", 8},
      {"topology", "Joining faces", 2},
      {"sizing", "Sizes", 2},
      {"boundary", "Dividing edges", 12},
      {"regions", "Regions", 4},
      {"paving", "Paving", 48},
      {"repair", "Repairing elements", 4},
      {"join", "Joining meshes", 3},
      {"curving", "Curving", 9},
      {"quality", "Measuring quality", 4},
      {"write", "Storing", 2},
  }};
  return table;
}

const char* stage_name(Stage stage) {
  return stage == Stage::done ? "done" : stage_table()[static_cast<std::size_t>(stage)].name;
}

}  // namespace paver
