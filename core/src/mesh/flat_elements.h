// Last repairs of connectivity: quads cut into triangles, triangles without height dissolved.
#pragma once

#include "mesh/region_mesh.h"

namespace paver {

/// Cuts a quad along the diagonal whose two triangles have the better worst scaled Jacobian. False, and nothing has
/// changed, when no diagonal gives two triangles that are positive in the chart.
bool split_quad(RegionMesh& mesh, int quad);

/// split_quad() for every quad; of two diagonals as good as each other the one at the corner of smallest number is
/// taken.
void split_all_quads(RegionMesh& mesh);

/// Elements with a flat corner, scaled Jacobian below 0.05: quads are split, triangles take the neighbour across their
/// longest side and the two are divided anew. Only where that makes the worst of them better, of quads by 0.02. No node
/// moves and none is added. Without `may_split_quads` quads stay as they are. Returns how many were mended.
long mend_flat_elements(RegionMesh& mesh, bool may_split_quads = true);

}  // namespace paver
