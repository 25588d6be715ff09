// Sides of a loop between its corners.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "topology/model.h"

namespace paver {

/// How a loop goes on where two of its edges meet, the region on its left: by an interior angle of 45 to 135 degrees,
/// of 225 to 315, of 150 to 210, or by another one.
enum class Junction { corner, reflex, straight, other };

Junction junction_of(double angle);

/// At the start of each coedge; none where one has no curve or the loop turns back along one.
std::vector<double> angles_of(const Model& model, const Face& face, const Loop& loop);

/// Chains of edges between corners, from the first corner on; one chain where there is no corner.
using Sides = std::vector<std::vector<int>>;

/// The loop's edges from the first junction on that is not straight; a chain begins wherever it bends.
Sides chains_of(const Loop& loop, const std::vector<Junction>& junctions);

/// By its angles_of(). None where it has other junctions than straight ones and corners, or one corner only.
/// `has_reflex`: sides end at corners of a hole, too.
std::optional<Sides> sides_of(const Loop& loop, const std::vector<double>& angles, bool has_reflex);

}  // namespace paver
