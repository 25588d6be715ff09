// Paves one region: loops in, quads out.
#pragma once

#include "mesh/region_mesh.h"
#include "paver/options.h"
#include "paver/progress.h"
#include "paving/front.h"
#include "regions/region.h"

namespace paver {

struct PavedRegion {
  RegionMesh mesh;
  PavingCounts counts;
};

/// Self-contained and deterministic. Tries again in other ways, and finer, while an element is unsound, and gives the
/// best. Throws Error{face_failed} with a point when the region's loops cross in the chart, Error{cancelled} on cancel.
PavedRegion pave_region(const Region& region, const Progress& progress, Elements elements = Elements::quad_dominant);

/// Paves in the one way `attempt`: 0 the first, 1 to further_attempts for a face that later turned out badly.
PavedRegion pave_region_again(const Region& region, int attempt, const Progress& progress,
                              Elements elements = Elements::quad_dominant);
extern const int further_attempts;

}  // namespace paver
