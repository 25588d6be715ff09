// Sides inside a region that bridge a bend of the surface get a node there.
#pragma once

#include "repair/edits/refill.h"

namespace paver {

/// On all sides of a bad element, and of the bad ones about it that hang together with it, between whose ends the
/// surface turns by more than 60 degrees; the elements there are filled anew. All back, and 0, where not fewer elements
/// are bad then; else the number of nodes.
int divide_bend(const ElementJudge& judge, int element, ElementKinds kinds, RegionMesh& mesh);

/// A new node where the walk along a side has the same angle to the surface's normals at both ends; half way where
/// these are alike.
int add_node_between(const Region& region, int a, int b, RegionMesh& mesh);

/// Whether a side is too short against the target length to be divided.
bool is_too_short(const RegionMesh& mesh, int a, int b);

}  // namespace paver
