// In: surface, box. Out: normals on a grid. Steps: lengths along a few rows and columns tell where lines of constant u
// and v lie about a spacing apart; a normal where two lines meet; at poles, which have none, that of the next line.
#include "sizing/normal_table.h"

#include <algorithm>
#include <numeric>

#include "base/cells.h"

namespace paver {
namespace {

constexpr double nearly_whole = 0.999;  // of a period
constexpr int tracks = 9;               // rows (columns) along which lengths are measured
constexpr int track_steps = 128;        // samples along each
constexpr std::size_t most_lines = 400;
constexpr double degenerate = 1e-6;     // sine between the tangents: no normal there
constexpr double only_rounding = 1e-9;  // of the largest |xu x xv|: a pole

/// xu x xv; zero where the tangents are parallel.
Vec3 long_normal(const Surface& surface, Vec2 uv, Vec3& x) {
  const auto [at, xu, xv] = surface.slope(uv);
  x = at;
  const Vec3 n = cross(xu, xv);
  const double size = norm(n);
  return size > degenerate * norm(xu) * norm(xv) && std::isfinite(size) ? n : Vec3{};
}

/// Unit vectors; zero where the length is only rounding.
void shorten(std::vector<Vec3>& normals) {
  double longest = 0;
  for (Vec3 n : normals) longest = std::max(longest, norm(n));
  for (Vec3& n : normals) n = norm(n) > only_rounding * longest ? unit(n) : Vec3{};
}

/// Values between `lo` and `hi` at equal steps of the length along the longest track; `place` maps a share along it and
/// the share across to (u, v).
template <class Place>
std::vector<double> lines_between(const Surface& surface, double lo, double hi, double spacing, bool is_least,
                                  double& whole, const Place& place) {
  std::vector<double> length(track_steps + 1, 0);
  std::vector<double> longest(track_steps, 0);
  for (int track = 0; track < tracks; ++track) {
    const double across = static_cast<double>(track) / (tracks - 1);
    Vec3 last = surface.point(place(0.0, across));
    for (int i = 0; i < track_steps; ++i) {
      const Vec3 x = surface.point(place(static_cast<double>(i + 1) / track_steps, across));
      const double step = norm(x - last);
      if (std::isfinite(step)) longest[i] = std::max(longest[i], step);
      last = x;
    }
  }
  std::partial_sum(longest.begin(), longest.end(), length.begin() + 1);
  whole = length.back();
  const double fitting = std::min(length.back() / spacing, 1e6);
  const auto cells =
      std::clamp<std::size_t>(static_cast<std::size_t>(is_least ? fitting : std::ceil(fitting)), 2, most_lines);
  std::vector<double> lines;
  std::size_t i = 0;
  for (std::size_t k = 0; k <= cells; ++k) {
    const double wanted = length.back() * static_cast<double>(k) / static_cast<double>(cells);
    while (i + 1 < track_steps && length[i + 1] < wanted) ++i;
    const double step = length[i + 1] - length[i], share = step > 0 ? std::min(1.0, (wanted - length[i]) / step) : 1;
    const double value = lo + (hi - lo) * (static_cast<double>(i) + share) / track_steps;
    if (lines.empty() || value > lines.back()) lines.push_back(value);
  }
  lines.front() = lo;
  if (lines.size() < 2) lines.push_back(hi);
  lines.back() = hi;
  return lines;
}

}  // namespace

NormalTable::NormalTable(const Surface& surface, const SampleBox& box, Vec2 spacing, double reach, bool is_least)
    : reach_(reach) {
  u_.period = surface.period().x, v_.period = surface.period().y;
  double wide, high;
  u_.at = lines_between(surface, box.lo.x, box.hi.x, spacing.x, is_least, wide,
                        [&](double a, double b) { return box.at(a, b); });
  v_.at = lines_between(surface, box.lo.y, box.hi.y, spacing.y, is_least, high,
                        [&](double a, double b) { return box.at(b, a); });
  for (double v : v_.at)
    for (double u : u_.at) {
      points_.emplace_back();
      normals_.push_back(long_normal(surface, {u, v}, points_.back()));
    }
  shorten(normals_);
  const std::size_t nu = u_.at.size(), nv = v_.at.size();
  auto borrow = [&](std::size_t to, std::size_t from) {
    if (normals_[to] == Vec3{}) normals_[to] = normals_[from];
  };
  for (std::size_t i = 0; i < nu; ++i) borrow(i, i + nu), borrow((nv - 1) * nu + i, (nv - 2) * nu + i);
  for (std::size_t j = 0; j < nv; ++j) borrow(j * nu, j * nu + 1), borrow(j * nu + nu - 1, j * nu + nu - 2);
  const Vec2 least = (is_least ? 2.0 : 1.0) * spacing;  // in each of the two cells it has
  if (wide < least.x)
    for (std::size_t j = 0; j < nv; ++j) flatten(j * nu, 1, nu, wide / least.x);
  if (high < least.y)
    for (std::size_t i = 0; i < nu; ++i) flatten(i, nu, nv, high / least.y);
}

// A strip narrower than the spacing: its turn would be spread beyond it, and only its share of that is its own.
void NormalTable::flatten(std::size_t first, std::size_t step, std::size_t count, double share) {
  Vec3 mean;
  for (std::size_t k = 0; k < count; ++k) mean += (1.0 / static_cast<double>(count)) * normals_[first + k * step];
  for (std::size_t k = 0; k < count; ++k) {
    Vec3& n = normals_[first + k * step];
    n = mean + share * (n - mean);
  }
}

double NormalTable::Lines::inside(double value) const {
  const double lo = at.front(), hi = at.back();
  if (period > 0 && (value < lo || value > hi)) {
    value = lo + std::fmod(value - lo, period);
    if (value < lo) value += period;
    if (value > hi && lo + period - value < value - hi) value = lo;
  }
  return value > lo ? std::min(value, hi) : lo;  // NaN lands on lo
}

std::size_t NormalTable::Lines::cell(double value, double& share) const {
  value = inside(value);
  const std::size_t i = cell_of(at, value);
  share = (value - at[i]) / (at[i + 1] - at[i]);
  return i;
}

Vec3 NormalTable::at(Vec2 uv) const {
  double a, b;
  const std::size_t i = u_.cell(uv.x, a), j = v_.cell(uv.y, b);
  return (1 - b) * ((1 - a) * normal(i, j) + a * normal(i + 1, j)) +
         b * ((1 - a) * normal(i, j + 1) + a * normal(i + 1, j + 1));
}

void NormalTable::slopes(Vec2 uv, Vec2 speed, Vec3& by_u, Vec3& by_v) const {
  auto slope = [&](const Lines& lines, double value, double pace, auto place) {
    const double step = std::min(pace > 0 ? reach_ / pace : 0.0, 0.25 * (lines.at.back() - lines.at.front()));
    if (!(step > 0)) return Vec3{};
    const bool is_whole = lines.period > 0 && lines.at.back() - lines.at.front() > nearly_whole * lines.period;
    const double low = is_whole ? value - step : std::max(value - step, lines.at.front()),
                 high = is_whole ? value + step : std::min(value + step, lines.at.back());
    return high > low ? (1 / (high - low)) * (at(place(high)) - at(place(low))) : Vec3{};
  };
  const Vec2 here{u_.inside(uv.x), v_.inside(uv.y)};
  by_u = slope(u_, here.x, speed.x, [&](double u) { return Vec2{u, here.y}; });
  by_v = slope(v_, here.y, speed.y, [&](double v) { return Vec2{here.x, v}; });
}

double NormalTable::stretched_area(double weight) const {
  double plain = 0, stretched = 0;
  const std::size_t nu = u_.at.size();
  for (std::size_t j = 0; j + 1 < v_.at.size(); ++j)
    for (std::size_t i = 0; i + 1 < nu; ++i) {
      const std::size_t k = j * nu + i;
      auto along = [&](const std::vector<Vec3>& x) { return 0.5 * (x[k + 1] - x[k] + x[k + nu + 1] - x[k + nu]); };
      auto across = [&](const std::vector<Vec3>& x) { return 0.5 * (x[k + nu] - x[k] + x[k + nu + 1] - x[k + 1]); };
      const Vec3 s = along(points_), t = across(points_), m = weight * along(normals_), n = weight * across(normals_);
      auto area = [](double ss, double st, double tt) { return std::sqrt(std::max(0.0, ss * tt - st * st)); };
      const double ss = dot(s, s), st = dot(s, t), tt = dot(t, t);
      plain += area(ss, st, tt);
      stretched += area(ss + dot(m, m), st + dot(m, n), tt + dot(n, n));
    }
  return plain > 0 ? stretched / plain : 1;
}

}  // namespace paver
