// Sides and elements all of whose corners are nodes that several parts may have.
#pragma once

#include "check/checked_mesh.h"

namespace paver {

/// How an element leaves its side, at the side's middle.
struct Heading {
  Vec3 inward;      ///< square to the side in the element's plane there, of length one; zero: no element
  double bend = 0;  ///< how far it leaves that plane, by the square of the way inward, in lengths of the side
};

/// One element's side, from the node of lower number to the other or against that.
struct SharedSide {
  long low = 0, high = 0, middle = -1;  ///< numbers in the whole mesh; middle: -1 at order 1
  int face = -1, direction = 1;
  Vec3 where;
  Heading heading{};
};

struct SharedElement {
  std::array<long, 4> corners{-1, -1, -1, -1};  ///< rising; -1 first for a triangle
  int face = -1;
  Vec3 where;
};

/// What the parts on this rank have.
struct SharedLists {
  std::vector<SharedSide> sides;
  std::vector<SharedElement> elements;
};

/// Collective; each rank answers for some of the sides and elements.
void check_shared(const CheckedMesh& checked, const SharedLists& mine, Ranks& ranks, MeshFaults& faults);

}  // namespace paver
