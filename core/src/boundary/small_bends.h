// Bends of a curve that are as good as corners.
#pragma once

#include <vector>

namespace paver {

/// A place along a curve up to which it has turned by so much.
struct TurnedTo {
  double s = 0, turn = 0;  ///< mm, radians
};

/// Rows `first` to `last` of the curve's table.
struct SmallBend {
  int first = 0, last = 0;
};

/// Stretches no longer than `width` (mm, at each row) that turn by more than `least` (radians), but do not turn back
/// unless it is at an end of the curve, where they are hooks; what is as long beside them turns far less. In order,
/// apart from each other.
std::vector<SmallBend> find_small_bends(const std::vector<TurnedTo>& rows, const std::vector<double>& width,
                                        double least);

}  // namespace paver
