// Where a surface comes to a point.
#pragma once

#include <vector>

#include "topology/model.h"

namespace paver {

/// A vertex where a closed surface comes to a point, and the longest edge that ends there.
struct Tip {
  int vertex = -1;
  double room = 0;         ///< mm
  std::vector<int> faces;  ///< that meet there
};

/// Vertices about which the angles of the faces sum up to less than pi: the apex of a cone of less than 30 degrees from
/// its axis is one, the corner of a box (3/2 pi) is none. Not where the surface ends or more than two faces meet.
std::vector<Tip> find_tips(const Model& model);

}  // namespace paver
