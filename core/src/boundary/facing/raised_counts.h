// Larger counts on a chain of edges.
#pragma once

#include <vector>

#include "boundary/parity.h"
#include "topology/model.h"

namespace paver {

/// Counts of all of them together.
long sum_of_counts(const std::vector<int>& edges, const std::vector<EdgeCount>& counts);

/// Counts of edges that are `total` together: more where intervals are longest. Those they have where these are as
/// many; none where an edge is not divided.
std::vector<int> raised_counts(const Model& model, const std::vector<int>& edges, const std::vector<EdgeCount>& counts,
                               long total);

/// The edges get these where they have fewer, and keep them.
void take_counts(const std::vector<int>& edges, const std::vector<int>& number, std::vector<EdgeCount>& counts);

}  // namespace paver
