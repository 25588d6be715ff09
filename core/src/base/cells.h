// Stretches between rising numbers.
#pragma once

#include <algorithm>
#include <vector>

namespace paver {

/// Index i with ends[i] <= value < ends[i + 1]; beyond the ends the first or last one.
inline std::size_t cell_of(const std::vector<double>& ends, double value) {
  return static_cast<std::size_t>(std::upper_bound(ends.begin() + 1, ends.end() - 1, value) - ends.begin()) - 1;
}

}  // namespace paver
