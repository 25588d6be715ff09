// Shape to Model: sews where faces come without shared edges, connects parts that touch, then lists faces, loops, edges
// and vertices.
#pragma once

#include "base/shared_tasks.h"
#include "brep/read_shape.h"
#include "paver/options.h"
#include "topology/model.h"

namespace paver {

/// Collective.
Model build_model(const Shape& shape, const Options& options, ModelReport report, Progress& progress,
                  SharedTasks& tasks);

}  // namespace paver
