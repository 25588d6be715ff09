// Notes of the report about the mesh that was made.
#pragma once

#include "paver/result.h"

namespace paver {

/// How many places were repaired, in which ways.
void note_repairs(RunReport& report);

/// Faces with elements other than those asked for.
void note_remaining(RunReport& report);

/// Faces that elements are far off: where the surface bends within less than the narrowest elements, or curved ones
/// would fold.
void note_far_faces(RunReport& report);

}  // namespace paver
