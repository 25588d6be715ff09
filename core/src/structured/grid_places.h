// Places of a grid's nodes, and between them as smooth as these: a finer grid that starts there needs little smoothing.
#pragma once

#include <vector>

#include "paver/vec.h"

namespace paver {

struct GridPlaces {
  int m = 1, n = 1;      ///< quads either way
  std::vector<Vec2> at;  ///< row by row

  Vec2 operator()(int i, int j) const { return at[static_cast<std::size_t>(j) * (m + 1) + i]; }
  /// In cell (i, j), bilinear, s and t from 0 to 1.
  Vec2 in_cell(int i, int j, double s, double t) const {
    const GridPlaces& place = *this;
    return (1 - t) * ((1 - s) * place(i, j) + s * place(i + 1, j)) +
           t * ((1 - s) * place(i, j + 1) + s * place(i + 1, j + 1));
  }
  /// At s = 0..m, t = 0..n: by cubics through four by four places, linear where there are fewer than four either way.
  Vec2 between(double s, double t) const;
};

}  // namespace paver
