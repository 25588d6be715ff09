// What is wrong with the elements of a paved region: reasons to pave it another way.
#pragma once

#include "mesh/region_mesh.h"
#include "regions/region.h"

namespace paver {

struct Faults {
  long flat = 0;         ///< elements of hardly any scaled Jacobian
  long off_surface = 0;  ///< sound by themselves, but facing away from the surface or with sides through the body
  long sum() const { return flat + off_surface; }
};

Faults count_faults(const RegionMesh& mesh);

/// Scaled Jacobian without the corners that are as the region has them, whatever is done inside: sharp ones that are
/// the only ones at a fixed node, and those at apexes.
double free_jacobian(const Region& region, const RegionMesh& mesh, const Element& e);

}  // namespace paver
