// Which triangles of a tessellation a line meets.
#pragma once

#include <array>
#include <limits>
#include <span>
#include <vector>

#include "paver/vec.h"

namespace paver {

struct PickHit {
  int triangle = -1;
  double along = 0;  ///< origin + along * direction is the point
};

/// Search tree over triangles; a query takes microseconds on a million of them.
class PickTree {
 public:
  /// Arrays as those of a Tessellation: three coordinates per point; per triangle three points and one number that is
  /// not looked at. They are not copied and must live as long as the tree.
  PickTree(std::span<const float> points, std::span<const int> triangles);

  /// All triangles, of either side, that the line meets at `along` >= 0; nearest first. Nothing for a zero direction.
  std::vector<PickHit> hits(Vec3 origin, Vec3 direction) const;

 private:
  struct Box {
    static constexpr float infinity = std::numeric_limits<float>::infinity();
    std::array<float, 3> low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
    void add(const Box& box);
  };
  struct Line;

  void sort_leaves();
  void add_levels();
  Vec3 corner(std::size_t triangle, int k) const;
  void visit(const Line& line, std::size_t level, std::size_t box, std::vector<PickHit>& hits) const;
  void test_leaf(const Line& line, std::size_t leaf, std::vector<PickHit>& hits) const;

  std::span<const float> points_;
  std::span<const int> triangles_;
  std::vector<int> leaves_;               ///< runs of triangles, by their number, in the order of the first level
  std::vector<std::vector<Box>> levels_;  ///< first: boxes of runs; each box of a next one is around `fan_out` of them
};

}  // namespace paver
