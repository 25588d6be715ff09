// Two loops that face each other.
#pragma once

#include <cmath>
#include <cstddef>

#include "paver/vec.h"

namespace paver {

/// Of two loops of n places that run opposite ways round, the place of the second that faces place 0 of the first: for
/// it the sum of squared distances is least, by more than a share of `margin` where a later one wins. `way(i, j)`: from
/// place i of the first to place j of the second.
template <class Way>
std::size_t nearest_turn(std::size_t n, Way way, double margin = 0) {
  std::size_t best = 0;
  double least = INFINITY;
  for (std::size_t turn = 0; turn < n; ++turn) {
    double sum = 0;
    for (std::size_t i = 0; i < n && sum < least; ++i) {
      const auto across = way(i, (turn + n - i) % n);
      sum += dot(across, across);
    }
    if (sum < least * (1 - margin)) least = sum, best = turn;
  }
  return best;
}

}  // namespace paver
