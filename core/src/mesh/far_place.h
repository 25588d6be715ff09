// Where a mesh is far off.
#pragma once

#include <array>

#include "paver/vec.h"

namespace paver {

/// An element inside a face, or a side on its border, that is farther off than it may be.
struct FarPlace {
  int face = -1;
  int corners = 4;        ///< 2: a side
  double distance = 0;    ///< mm
  double target = 0;      ///< target length there, mm
  std::array<Vec3, 4> x;  ///< of the corners
};

}  // namespace paver
