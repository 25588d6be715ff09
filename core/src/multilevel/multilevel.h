// Paving on several levels: the mesh of a coarser target length is the geometry of the finer one.
#pragma once

#include <optional>

#include "multilevel/level_plan.h"
#include "paving/pave_region.h"

namespace paver {

/// The coarse mesh of `region` at `multilevel` times its target length (Options::multilevel; 0: none) and how it is
/// divided into pieces, each a task of its own; itself made about the same way while it is large. `boundary_nodes`:
/// number of nodes of the boundary stage. Deterministic. Nothing where the region is better paved directly.
std::optional<LevelPlan> plan_levels(const Region& region, int multilevel, int boundary_nodes, const Progress& progress,
                                     Elements elements);

/// The fine mesh of piece `i`, smoothed but for its outline. `part`: a copy of the region without its loops, with an
/// evaluator of its own. Throws Error{face_failed} where the mesh would not be sound: the region is to be paved
/// directly.
PavedRegion lay_piece(const Region& region, const Region& part, const LevelPlan& plan, std::size_t i,
                      const Progress& progress, Elements elements);

}  // namespace paver
