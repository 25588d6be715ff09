// What the target length grows from.
#pragma once

#include "base/boxes/nearest_segment.h"

namespace paver {

/// Its value is the target length on it, mm.
using SizeSource = Segment;

}  // namespace paver
