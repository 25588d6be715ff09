// Angles of faces at their vertices.
#pragma once

#include <cmath>

#include "topology/model.h"

namespace paver {

/// Radians between two directions.
inline double angle_between(Vec3 a, Vec3 b) { return std::atan2(norm(cross(a, b)), dot(a, b)); }

/// Interior angle of the face between the end of `before` and the start of `after`, radians, 0 to 2 pi; at most pi
/// where the surface has no normal. Neither is a pole.
double corner_angle(const Model& model, const Face& face, const Coedge& before, const Coedge& after);

/// Angle of the face about a pole that one of its coedges is: length of a small arc about it by its radius.
double pole_angle(const Model& model, const Face& face, const Coedge& pole);

}  // namespace paver
