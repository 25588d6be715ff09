// Area of a part of a surface from its border alone: by Green's theorem the integral over (u, v) becomes one along the
// border, of what lies between it and a line of one v.
#include <cmath>

#include "brep/surfaces/evaluators_impl.h"

namespace paver {
namespace {

constexpr int coarse_pieces = 64;  // of each image
/// Gauss-Legendre rule of four points on [0, 1].
constexpr std::array<std::array<double, 2>, 4> rule{{{0.06943184420297371, 0.17392742256872692},
                                                     {0.33000947820757187, 0.32607257743127307},
                                                     {0.66999052179242813, 0.32607257743127307},
                                                     {0.93056815579702629, 0.17392742256872692}}};
constexpr int coarse_strips = 4;  // between the line and the border

/// Integral of |xu x xv| from v = `from` to uv along v.
double area_per_u(const Surface& surface, double from, Vec2 uv, int strips) {
  double sum = 0;
  for (int strip = 0; strip < strips; ++strip)
    for (const auto& [at, weight] : rule) {
      const auto [x, xu, xv] = surface.slope({uv.x, from + (uv.y - from) * (strip + at) / strips});
      sum += weight * norm(cross(xu, xv));
    }
  return sum * (uv.y - from) / strips;
}

}  // namespace

std::optional<double> area_within(const Surface& surface, const std::vector<BorderImage>& border, int finer) {
  const int pieces = finer * coarse_pieces, strips = finer * coarse_strips;
  if (border.empty() || surface.period().y > 0) return std::nullopt;
  const double from = border.front().image->uv(border.front().t0).y;
  double area = 0, round = 0, walked = 0;
  for (const BorderImage& piece : border) {
    auto uv = [&](double share) { return piece.image->uv(piece.t0 + share * (piece.t1 - piece.t0)); };
    Vec2 last = uv(0);
    for (int i = 1; i <= pieces; ++i) {
      const Vec2 next = uv(static_cast<double>(i) / pieces);
      const double du = piece.is_reversed ? last.x - next.x : next.x - last.x;
      for (const auto& [at, weight] : rule)
        area -= weight * du * area_per_u(surface, from, uv((i - 1 + at) / pieces), strips);
      round += du, walked += std::abs(du);
      last = next;
    }
  }
  // A border that goes once round encloses something only with the pole.
  if (std::abs(round) > 1e-3 * walked || !(area > 0)) return std::nullopt;
  return area;
}

}  // namespace paver
