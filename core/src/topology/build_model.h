// Shape to Model: sews where faces come without shared edges, connects parts that touch, then lists faces, loops, edges
// and vertices.
#pragma once

#include <string>

#include "base/tasks/shared_tasks.h"
#include "brep/reading/read_shape.h"
#include "paver/options.h"
#include "topology/model.h"

namespace paver {

/// `brep`: gets the model as meshed, as the text of a BREP file. Throws damaged_file for a model that strict options
/// refuse. Collective.
Model build_model(const Shape& shape, const Options& options, ModelReport report, Progress& progress,
                  SharedTasks& tasks, std::string* brep = nullptr);

/// Lists in the model's report the edges that one face has, those that more than two have, and the solids that are
/// open; takes out what is closed since the file was read.
void note_free_edges(Model& model);

}  // namespace paver
