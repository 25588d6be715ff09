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
  double width = 0;  ///< of a ring whose sides have corners, of a bent strip, of a crescent: its mean width, mm
  bool is_crescent = false;  ///< sides that meet at both ends: rows between them have other lengths unless it is thin

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
/// sides; the parts of strips that bend; the sides of narrow crescents. `loops[f]`: linked_loops of face f without
/// periodic edges.
std::vector<OppositeSides> find_opposite_sides(const Model& model, const std::vector<std::vector<Loop>>& loops);

/// Of both sides together.
double length_of(const Model& model, const OppositeSides& pair);

/// The mean width of a face all of which lies between the two.
double width_between(const Model& model, const OppositeSides& pair);

}  // namespace paver
