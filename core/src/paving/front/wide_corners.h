// Corners of a boundary that are as near to a row's end as to its side.
#pragma once

#include <cstddef>
#include <vector>

namespace paver {

/// Numbers of the corners that rows run past, of those about 120 degrees wide: where a row ends it is two facets
/// shorter, the boundary by less, so only some of such corners end rows. `angles`: of the region at the nodes of a
/// loop, radians.
std::vector<std::size_t> passed_corners(const std::vector<double>& angles);

}  // namespace paver
