// Angles of faces at their vertices.
#pragma once

#include <cmath>

#include "topology/model.h"

namespace paver {

/// Radians between two directions; 0 where one is none, also where their product is -0.
inline double angle_between(Vec3 a, Vec3 b) { return std::atan2(norm(cross(a, b)), dot(a, b) + 0.0); }

/// Radians from one direction to the left to the other, above 0, at most 2 pi.
inline double angle_to_left(Vec2 from, Vec2 to) {
  const double angle = std::atan2(cross(from, to), dot(from, to));
  return angle > 0 ? angle : angle + 2 * M_PI;
}

/// Interior angle of the face between the end of `before` and the start of `after`, radians, 0 to 2 pi; at most pi
/// where the surface has no normal. Neither is a pole.
double corner_angle(const Model& model, const Face& face, const Coedge& before, const Coedge& after);

/// Angle of the face about a pole that one of its coedges is: length of a small arc about it by its radius.
double pole_angle(const Model& model, const Face& face, const Coedge& pole);

}  // namespace paver
