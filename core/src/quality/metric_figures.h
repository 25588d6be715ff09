// Figures of elements by the lengths that they were made for.
#pragma once

#include <vector>

#include "mesh/region_mesh.h"
#include "paver/progress.h"
#include "paver/ranks.h"
#include "paver/result.h"

namespace paver {

/// `meshes`: of the parts, null where one is on another rank or failed. Lengths count how far the surface turns
/// (core/docs/decisions/metric.md), the target length is the mean of that at both ends; sides inside a part count with
/// both elements. `predicted` is left 0. Collective, the same for any number of threads and ranks.
MetricFigures measure_metric(const std::vector<const RegionMesh*>& meshes, int threads, const Progress& progress,
                             Ranks& ranks);

}  // namespace paver
