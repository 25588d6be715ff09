// In: a block with coarse places. Out: fine places between them.
#include "structured/mapped_fill.h"

#include <algorithm>
#include <cmath>

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

Vec2 MappedBlock::place(int i, int j) const {
  const double s = static_cast<double>(static_cast<long>(i) * coarse.m) / fine[0];
  const double t = static_cast<double>(static_cast<long>(j) * coarse.n) / fine[1];
  return coarse.between(s, t);
}

std::vector<std::array<int, 2>> MappedFill::outline() const {
  std::vector<std::array<int, 2>> nodes;
  for (int i = first[0]; i < last[0]; ++i) nodes.push_back({i, first[1]});
  for (int j = first[1]; j < last[1]; ++j) nodes.push_back({last[0], j});
  for (int i = last[0]; i > first[0]; --i) nodes.push_back({i, last[1]});
  for (int j = last[1]; j > first[1]; --j) nodes.push_back({first[0], j});
  if (block->is_clockwise) std::reverse(nodes.begin(), nodes.end());
  return nodes;
}

std::vector<MappedFill> divided(const std::shared_ptr<const MappedBlock>& block, double quads) {
  const double side = std::sqrt(quads);
  std::array<int, 2> parts{};
  for (std::size_t k = 0; k < 2; ++k) parts[k] = std::max(1, static_cast<int>(std::lround(block->fine[k] / side)));
  auto cut = [&](std::size_t k, int part) {
    return static_cast<int>(static_cast<long>(block->fine[k]) * part / parts[k]);
  };
  std::vector<MappedFill> fills;
  for (int j = 0; j < parts[1]; ++j)
    for (int i = 0; i < parts[0]; ++i) fills.push_back({block, {cut(0, i), cut(1, j)}, {cut(0, i + 1), cut(1, j + 1)}});
  return fills;
}

}  // namespace paver
