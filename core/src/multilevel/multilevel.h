// Paving on several levels: the mesh of a coarser target length is the geometry of the finer one.
#pragma once

#include "paving/pave_region.h"

namespace paver {

/// Paves `region` at `multilevel` times its target length (Options::multilevel; 0: directly), divides the coarse
/// elements and smooths across their edges; the coarse mesh comes about the same way while it is large. Where that does
/// not give a sound mesh the region is paved directly. Self-contained and deterministic. Throws as pave_region does.
PavedRegion pave_by_levels(const Region& region, int multilevel, const Progress& progress, Elements elements);

}  // namespace paver
