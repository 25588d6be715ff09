// Paves one region: loops in, quads out.
#pragma once

#include "mesh/region_mesh.h"
#include "paver/options.h"
#include "paver/progress.h"
#include "paving/front/front.h"
#include "regions/region.h"

namespace paver {

struct PavedRegion {
  RegionMesh mesh;
  long closed_by_triangulation = 0;  ///< how often its void was
};

/// Self-contained and deterministic. Where few elements tangle a second way is tried, and the better one given. Where
/// no triangle is wanted other ways are tried while one is left or an element is unsound, and the best is given. Throws
/// Error{face_failed} with a point when the region's loops cross in the chart, Error{cancelled} on cancel.
PavedRegion pave_region(const Region& region, const Progress& progress, Elements elements = Elements::quad_dominant);

/// Which rows are laid first: by how well they fit to the sides at their ends as well, or not.
enum class RowRule { fit, no_fit };

/// In one way only, whatever comes out.
PavedRegion pave_region_once(const Region& region, const Progress& progress,
                             Elements elements = Elements::quad_dominant, RowRule rule = RowRule::fit);

/// The same of a coarse mesh, whose elements will be divided. Throws Error{face_failed}, too, where they come out far
/// shorter than the target length.
PavedRegion pave_coarse_region(const Region& region, const Progress& progress, Elements elements);

}  // namespace paver
