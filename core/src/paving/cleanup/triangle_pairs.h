// Pairs of triangles that meet across a strip of quads.
#pragma once

#include "paving/cleanup/mesh_edit.h"

namespace paver {

class TrianglePairs {
 public:
  explicit TrianglePairs(const RegionMesh& mesh) : mesh_(mesh) {}

  /// The change that turns a triangle, the nearest other one and the quads
  /// between into quads: every quad is cut along a diagonal and its halves join
  /// with those before and behind; `nearer` others are passed over. False when no triangle is near.
  bool find(int triangle, Change& change, int nearer = 0);

 private:
  bool search(int triangle, int nearer);
  bool make(Change& change) const;

  static constexpr int most_visited = 4000;
  const RegionMesh& mesh_;
  std::vector<int> queue_, parent_, stamp_, path_;
  int run_ = 0;
};

}  // namespace paver
