// Cubes of space by their places, each with what is known of what lies in it.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include "base/box.h"

namespace paver {

/// Of a cube with the side s: from s times these to s times one more.
using CellPlace = std::array<int, 3>;

/// Cubes of one size.
class Cells {
 public:
  explicit Cells(double side) : by_side_(1 / side) {}

  CellPlace at(Vec3 x) const { return {along(x.x), along(x.y), along(x.z)}; }
  /// visit(place) for those that the box meets.
  template <class Visit>
  void visit(const Box& box, Visit visit) const {
    const CellPlace a = at(box.low), b = at(box.high);
    for (int x = a[0]; x <= b[0]; ++x)
      for (int y = a[1]; y <= b[1]; ++y)
        for (int z = a[2]; z <= b[2]; ++z) visit(CellPlace{x, y, z});
  }

 private:
  int along(double x) const { return static_cast<int>(std::floor(x * by_side_)); }

  double by_side_;
};

struct CellHash {
  std::size_t operator()(const CellPlace& place) const {
    std::uint64_t hash = 0;
    for (int x : place) hash = (hash ^ static_cast<std::uint32_t>(x)) * 0x9e3779b97f4a7c15ULL;
    return hash ^ (hash >> 32);
  }
};

/// Neighbours in a mesh are often in one cell: the last one is found at once.
template <class Content>
class CellTable {
 public:
  using Map = std::unordered_map<CellPlace, Content, CellHash>;

  Content& at(const CellPlace& place) {
    if (!last_ || last_->first != place) last_ = &*map_.try_emplace(place).first;
    return last_->second;
  }
  /// nullptr: there is none.
  const Content* find(const CellPlace& place) const {
    const auto found = map_.find(place);
    return found == map_.end() ? nullptr : &found->second;
  }
  const Map& map() const { return map_; }
  Map& map() { return map_; }

 private:
  Map map_;
  typename Map::value_type* last_ = nullptr;
};

}  // namespace paver
