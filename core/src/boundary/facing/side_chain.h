// Opposite sides of a face as chains of edges that run the same way.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "boundary/facing/opposite_sides.h"
#include "topology/model.h"

namespace paver {

/// Edges from one corner of a face to the next.
struct SideChain {
  std::vector<int> edges;
  std::vector<bool> is_against;  ///< the edge runs the other way
  double length = 0;             ///< mm
};

/// Both sides of a pair.
struct ChainPair {
  SideChain first, second;
};

/// Whether sides are so alike in length that equal shares of them face each other.
bool are_alike(double one, double other);

/// The vertex where the chain's edge `i` ends.
Vec3 end_of_edge(const Model& model, const SideChain& chain, std::size_t i);

/// None where an edge closes on itself, or the sides are not alike.
std::optional<ChainPair> chains_of(const Model& model, const OppositeSides& pair);

/// The rims of a ring, each from a vertex of its own on; none where they do not close.
std::optional<ChainPair> rims_of(const Model& model, const OppositeSides& pair);

/// So that it runs the other way.
void turn_round(SideChain& side);

/// The rims of a ring `width` wide, both cut at the two vertices that lie nearest to each other; none where these do
/// not face each other, or the sides are no rims.
std::optional<ChainPair> facing_rims_of(const Model& model, const OppositeSides& pair, double width);

/// A vertex of one side of a narrow face, or of both where two face each other: its distances along the sides, mm.
struct Break {
  double first = 0, second = 0;
  bool is_of_first = true, is_of_second = true;
  bool is_lone() const { return is_of_first != is_of_second; }
};

/// In order, the sides' ends behind them. Vertices face each other where rows would lean little across the width, or
/// the edges are many times as long as one vertex lies behind the other.
std::vector<Break> breaks_between(const Model& model, const ChainPair& sides, double width);

}  // namespace paver
