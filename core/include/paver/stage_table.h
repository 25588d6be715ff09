// The stages of a run as programs show them: from one list, as the options.
#pragma once

#include <array>

#include "paver/progress.h"

namespace paver {

struct StageInfo {
  const char* name;  ///< as printed, e.g. "paving"
  const char* text;  ///< for people, e.g. "Dividing edges"
  int share;         ///< of the time of a common run, percent: a bar that never goes back needs some
};

/// All stages but Stage::done, in order.
const std::array<StageInfo, static_cast<int>(Stage::done)>& stage_table();

}  // namespace paver
