// Places between the nodes of a grid, as smooth as the grid: a finer one that starts there needs little smoothing.
#pragma once

#include <algorithm>

#include "paver/vec.h"

namespace paver {

/// Four places that follow each other and the weights of the cubic through them.
struct CubicPlaces {
  int first = 0;
  double weight[4];

  /// At `s`, any number; the place before it and its neighbours.
  explicit CubicPlaces(double s, int first_place) : first(first_place) {
    const double t = s - first;
    weight[0] = -(t - 1) * (t - 2) * (t - 3) / 6;
    weight[1] = t * (t - 2) * (t - 3) / 2;
    weight[2] = -t * (t - 1) * (t - 3) / 2;
    weight[3] = t * (t - 1) * (t - 2) / 6;
  }
};

/// `place(i, j)`: of a node. Sums over the four by four from (along.first, across.first) on.
template <class Place>
Vec2 interpolate(const CubicPlaces& along, const CubicPlaces& across, Place place) {
  Vec2 sum{0, 0};
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i)
      sum = sum + along.weight[i] * across.weight[j] * place(along.first + i, across.first + j);
  return sum;
}

/// In a grid of places 0 to most_s and 0 to most_t; linear where it has fewer than four either way.
template <class Place>
Vec2 interpolate(double s, double t, int most_s, int most_t, Place place) {
  constexpr int fewest = 3;
  const int i = static_cast<int>(s), j = static_cast<int>(t);
  if (most_s >= fewest && most_t >= fewest)
    return interpolate(CubicPlaces(s, std::clamp(i - 1, 0, most_s - fewest)),
                       CubicPlaces(t, std::clamp(j - 1, 0, most_t - fewest)), place);
  const int k = std::clamp(i, 0, most_s - 1), l = std::clamp(j, 0, most_t - 1);
  s -= k, t -= l;
  return (1 - t) * ((1 - s) * place(k, l) + s * place(k + 1, l)) +
         t * ((1 - s) * place(k, l + 1) + s * place(k + 1, l + 1));
}

}  // namespace paver
