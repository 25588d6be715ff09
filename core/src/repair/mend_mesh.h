// Mends a region's mesh: its bad elements, and sides that would be one mesh edge.
#pragma once

#include "repair/mend_region.h"

namespace paver {

/// Mends `bad` elements of the judge's mesh, `mesh`; then, where triangles may be, fills places with twin sides anew
/// without these, gives a node to those that stay, and mends again, in a bounded number of rounds.
Mended mend_mesh(const ElementJudge& judge, ElementKinds kinds, std::vector<int> bad, RegionMesh& mesh);

}  // namespace paver
