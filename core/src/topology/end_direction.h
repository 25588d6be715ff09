// Directions in which curves leave their ends.
#pragma once

#include "brep/surfaces/surface.h"

namespace paver {

/// Direction in which a curve leaves its point at `end` towards `inside`, where `chord` leads: its tangent at `share`
/// of the way; where it bends in between and is as good as straight behind, that behind. Curves of intersection end in
/// such hooks, by rounding.
Vec3 end_direction(const Curve& curve, double end, double inside, Vec3 chord, double share = 0);

}  // namespace paver
