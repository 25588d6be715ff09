// Whether two curves in a plane keep apart, however near their chords are.
#pragma once

#include <functional>
#include <vector>

#include "paver/vec.h"

namespace paver {

/// A piece of curve, its parameter from 0 to 1. Ends are given apart: a node may lie off its curve by rounding.
struct PlaneCurve {
  Vec2 start, end;
  std::function<Vec2(double)> at;  ///< null: straight

  Vec2 point(double t) const { return t <= 0 ? start : (t >= 1 ? end : (at ? at(t) : start + t * (end - start))); }
  /// How far the curve leaves the chord between two of its parameters.
  double bulge(double from, double to) const;
};

/// Ends that two curves share: `first` and `second` as parameters, 0 or 1.
struct SharedEnd {
  double first, second;
};

/// What two curves whose chords meet do themselves.
struct Meeting {
  enum class Kind {
    apart,  ///< they keep apart
    meet,   ///< they cross, touch or lie on one another, within 1e-9 of their length
    near,   ///< so near to each other that it is not worth finding out
  } kind = Kind::apart;
  Vec2 at;  ///< of those that do not keep apart
};

/// Other than in the ends that they share (`shared`: up to two).
Meeting find_meeting(const PlaneCurve& one, const PlaneCurve& other, const std::vector<SharedEnd>& shared);

/// Whether the chords ab and cd have a point in common within both, exactly.
bool do_cross(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

/// Where two chords come nearest to each other: where they cross, or the end that lies nearest to the other.
Vec2 nearest_point(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

}  // namespace paver
