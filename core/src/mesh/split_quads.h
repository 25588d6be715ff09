// Quads cut into triangles.
#pragma once

#include "mesh/region_mesh.h"

namespace paver {

/// Cuts every quad along the diagonal whose two triangles have the better worst scaled Jacobian; of two as good as each
/// other the one at the corner of smallest number is taken. A quad stays where no diagonal gives two triangles that are
/// positive in the chart and is no side of other elements.
void split_all_quads(RegionMesh& mesh);

}  // namespace paver
