// Parts of a coarse mesh.
#pragma once

#include <set>
#include <vector>

#include "multilevel/fine_mesh.h"

namespace paver {

/// Elements that hang together by nodes, of those in `waits`: each group rising, in the order of their first elements.
std::vector<std::vector<int>> groups_by_nodes(const RegionMesh& mesh, std::set<int> waits);

/// Fine elements that these coarse ones are divided into, about.
double fine_elements(const LevelPlan& plan, const std::vector<int>& elements);

/// Cuts the plan into pieces of about `elements` fine elements; 0: one piece. Coarse elements that are paved together
/// are pieces of their own, a few where they are many; one count on each cut between these may change, so that each
/// has an even number of sides.
void cut_in_pieces(const Region& region, LevelPlan& plan, double elements);

}  // namespace paver
