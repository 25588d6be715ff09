// The surface about a pole: smooth, or the apex of a cone.
#pragma once

#include "charts/chart.h"

namespace paver {

struct PoleShape {
  Vec3 apex;
  double spread = 0;      ///< radians: how far normals about the pole differ from their mean
  double slant = 0;       ///< mm from the pole, where this was measured
  double cone_angle = 0;  ///< radians: length of a circle about the pole per length of its slant, 2 pi where smooth
  double small = 0;       ///< the same distance in the meridian's parameter
  /// 15 degrees: normals that differ more make it an apex.
  bool is_sharp() const { return spread >= 0.26; }
};

/// The pole at the low or the high end of the box; `period` of the direction that goes round.
PoleShape measure_pole(const Surface& surface, const ParameterBox& box, double period, bool is_low);

}  // namespace paver
