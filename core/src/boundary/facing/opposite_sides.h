// Pairs of sides that a grid over a face would join.
#pragma once

#include <vector>

#include "topology/model.h"

namespace paver {

/// Two sides of one face, chains of edges; where both have equally many, edge i of one lies opposite edge i of the
/// other.
struct OppositeSides {
  int face = -1;
  std::vector<int> first, second;
  int partner = -1;  ///< the other pair of the same face, by its place in the list; -1 for rings and bent strips
  double width = 0;  ///< the mean, of a ring whose sides have corners, a bent strip, a crescent, a gap, mm
  bool is_crescent = false;  ///< sides that meet at both ends: rows between them have other lengths unless it is thin
  bool is_moon = false;      ///< of a crescent: both sides close, and touch in one vertex, or all but do in two
  bool is_gap = false;       ///< a narrow part of a face lies between the two, not all of it

  /// Of both sides.
  std::vector<int> edges() const {
    std::vector<int> both;
    both.reserve(first.size() + second.size());
    for (const std::vector<int>* side : {&first, &second})
      for (int e : *side) both.push_back(e);
    return both;
  }
};

/// Of all faces: sides between four corners, and the two loops of rings, or where both have as many corners their
/// sides; the parts of strips that bend; the sides of narrow crescents, also between loops that touch; of faces
/// without such sides, and of these loops, edges that face each other across a narrow gap, as both sides of a wall
/// between two holes. `loops[f]`: linked_loops of face f without periodic edges.
std::vector<OppositeSides> find_opposite_sides(const Model& model, const std::vector<std::vector<Loop>>& loops);

/// Of both sides together.
double length_of(const Model& model, const OppositeSides& pair);

/// The mean width of what lies between the two: of a gap, or of the whole face.
double width_between(const Model& model, const OppositeSides& pair);

}  // namespace paver
