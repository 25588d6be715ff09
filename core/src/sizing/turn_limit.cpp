#include "sizing/turn_limit.h"

#include <cmath>

namespace paver {

double TurnLimit::longest_edge(double curvature) const {
  if (!(curvature > 0)) return h;
  double strict = usual / curvature;
  if (strict >= h || of_short <= usual) return std::min(strict, h);
  return std::min(of_short / curvature, std::sqrt(strict * h));  // length * turn == h * usual
}

bool TurnLimit::may_turn(double turn, double length) const {
  return turn <= usual || (turn <= of_short && turn * length <= usual * h);
}

TurnLimit turn_limit(const Options& options, double h) {
  constexpr double of_short = 75 * M_PI / 180;  // decision turn-of-short-edges
  return {h, options.turn_limit(), options.max_turn ? 0 : of_short};
}

double curvature(const Curve& curve, double t) {
  const CurveJet at = curve.jet(t);
  const double speed = norm(at.t), value = norm(cross(at.t, at.tt)) / (speed * speed * speed);
  return std::isfinite(value) ? value : 0;
}

}  // namespace paver
