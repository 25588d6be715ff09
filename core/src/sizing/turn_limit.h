// How far boundary edges may turn.
#pragma once

#include <algorithm>

#include "brep/surfaces/surface.h"
#include "paver/options.h"

namespace paver {

/// Radians, per boundary edge of the mesh.
struct TurnLimit {
  double h = 0;         ///< mm
  double usual = 0;     ///< at any length
  double of_short = 0;  ///< of edges shorter than h that lie no farther off their curve; 0: the usual one

  /// Longest boundary edge along a curve of this curvature (1 / mm).
  double longest_edge(double curvature) const;
  /// Whether a boundary edge of this length may turn so much.
  bool may_turn(double turn, double length) const;
  double largest() const { return std::max(usual, of_short); }
};

/// What the options ask for where the target length is `h`.
TurnLimit turn_limit(const Options& options, double h);

/// At t, 1 / mm; 0 where the curve has none.
double curvature(const Curve& curve, double t);

}  // namespace paver
