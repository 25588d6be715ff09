#include "structured/grid_places.h"

#include <algorithm>

namespace paver {
namespace {

/// Four places that follow each other and the weights of the cubic through them.
struct Cubic {
  int first = 0;
  double weight[4];

  /// At `s`, any number; the place before it and its neighbours, of 0 to `most`.
  Cubic(double s, int most) : first(std::clamp(static_cast<int>(s) - 1, 0, most - 3)) {
    const double t = s - first;
    weight[0] = -(t - 1) * (t - 2) * (t - 3) / 6;
    weight[1] = t * (t - 2) * (t - 3) / 2;
    weight[2] = -t * (t - 1) * (t - 3) / 2;
    weight[3] = t * (t - 1) * (t - 2) / 6;
  }
};

}  // namespace

Vec2 GridPlaces::between(double s, double t) const {
  if (m >= 3 && n >= 3) {
    const Cubic along(s, m), across(t, n);
    Vec2 sum{0, 0};
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i)
        sum = sum + along.weight[i] * across.weight[j] * (*this)(along.first + i, across.first + j);
    return sum;
  }
  const int k = std::clamp(static_cast<int>(s), 0, m - 1), l = std::clamp(static_cast<int>(t), 0, n - 1);
  return in_cell(k, l, s - k, t - l);
}

}  // namespace paver
