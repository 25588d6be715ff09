// Sides of elements that two parts share inside a face: along artificial cuts and the outlines of pieces.
#pragma once

#include <vector>

#include "regions/region.h"

namespace paver {

/// Between shared nodes a < b (see shared_node).
struct CutSide {
  int face = -1, a = -1, b = -1;
  /// Where its nodes are in a chart that all agree on; null: all parts have them at the same place in the same chart.
  const Region* region = nullptr;
  Vec2 pa, pb;
};

/// All of a model, each once, in the order (face, a, b); their numbers are their places.
class Cuts {
 public:
  /// Cuts between the regions' loops, and `outlines`.
  Cuts(const std::vector<Region>& regions, std::vector<CutSide> outlines);
  /// Number of the side between two shared nodes in either order, or -1.
  int find(int face, int a, int b) const;
  const std::vector<CutSide>& sides() const { return sides_; }

 private:
  std::vector<CutSide> sides_;
};

}  // namespace paver
