// What a run will come to, before any face is meshed.
#pragma once

#include <vector>

#include "paver/options.h"
#include "sizing/size_field.h"
#include "topology/model.h"

namespace paver {

/// Elements per face of the model, from the sizes on it and from the interval counts of its edges; 0 for faces that are
/// not meshed.
std::vector<double> predict_elements(const Model& model, const SizeField& size, const std::vector<int>& counts,
                                     Elements kind);

/// MiB that meshing so many elements takes on top of what the process has before.
double predict_memory_mib(double elements, const Options& options);

}  // namespace paver
