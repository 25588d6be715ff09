// Whether elements fit together: side by side in faces, along the B-rep edges at their boundaries, no two the same.
#pragma once

#include "check/checked_mesh.h"

namespace paver {

/// Collective; `faults` are those of this rank. Sides inside a face are in two elements that run opposite; those on a
/// B-rep edge in as many elements of each face as that uses the edge there, and in no more than the edge has faces.
/// At order 2 the elements of a side have the same middle.
void check_sides(const CheckedMesh& checked, int threads, const Progress& progress, Ranks& ranks, MeshFaults& faults);

}  // namespace paver
