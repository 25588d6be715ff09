// Row and polar charts. Both tabulate the surface's mean scale along v once; a chart need only be injective and
// roughly faithful, because lengths and angles are always taken from the surface itself.
#include "charts/chart.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace paver {
namespace {

/// Position in a table of equal cells; outside it the first or last cell is continued.
struct Cell {
  int i;
  double t;
};
Cell cell_of(double v, double lo, double step, int cells) {
  double s = (v - lo) / step;
  int i = std::clamp(static_cast<int>(std::floor(s)), 0, cells - 1);
  return {i, s - i};
}

/// Arc length along one parameter by its mean speed in equal cells, from lo on; past the ends the last speeds go on.
class ArcTable {
 public:
  ArcTable(double lo, double step, const std::vector<double>& speeds) : lo_(lo), step_(step), arc_{0} {
    double fastest = *std::max_element(speeds.begin(), speeds.end());
    if (!(fastest > 0)) fastest = 1;
    for (double speed : speeds) arc_.push_back(arc_.back() + step_ * std::max(speed, slowest * fastest));
    cells_per_arc_ = static_cast<double>(cells()) / arc_.back();
  }

  int cells() const { return static_cast<int>(arc_.size()) - 1; }
  Cell at(double value) const { return cell_of(value, lo_, step_, cells()); }
  double rise(int cell) const { return arc_[cell + 1] - arc_[cell]; }
  double arc(Cell c) const { return arc_[c.i] + c.t * rise(c.i); }
  /// Searched from where it is with cells of equal height.
  Cell at_arc(double arc) const {
    const double guess = arc * cells_per_arc_;
    int i = guess > 0 ? static_cast<int>(std::min(guess, cells() - 1.0)) : 0;
    while (i + 1 < cells() && arc_[i + 1] <= arc) ++i;
    while (i > 0 && arc < arc_[i]) --i;
    return {i, (arc - arc_[i]) / rise(i)};
  }
  double value(Cell c) const { return lo_ + step_ * (c.i + c.t); }
  double step() const { return step_; }

 private:
  static constexpr double slowest = 1e-6;  // of the fastest cell
  double lo_, step_, cells_per_arc_ = 0;
  std::vector<double> arc_;
};

class RowChart : public Chart {
 public:
  RowChart(const MeridianTable& table, const ParameterBox& box, ArcTable along)
      : box_(box), along_(std::move(along)), across_(table.lo(), table.step(), table.heights()) {
    middle_ = along_.arc(along_.at(0.5 * (box.lo.x + box.hi.x)));
    for (int i = 0; i <= table.cells(); ++i) width_.push_back(table.width(i));
    double widest = *std::max_element(width_.begin(), width_.end());
    if (!(widest > 0)) widest = 1;
    smallest_ = 1e-9 * widest;
    for (double& w : width_) w = std::max(w, smallest_);
    if (box.low_pole) width_.front() = smallest_;
    if (box.high_pole) width_.back() = smallest_;
    sign_ = box.is_swapped ? -1 : 1;
  }

  Vec2 to_chart(Vec2 uv) const override {
    const Vec2 q = box_.uv(uv);
    const Cell c = across_.at(q.y);
    return {sign_ * (along_.arc(along_.at(q.x)) - middle_) * width_at(c), across_.arc(c)};
  }

  ChartSlope slope(Vec2 p) const override {
    const Cell c = across_.at_arc(p.y);
    const double rise = across_.rise(c.i);
    const double a = width_at(c), da = c.t < 0 || c.t > 1 ? 0 : (width_[c.i + 1] - width_[c.i]) / rise;
    const double way = sign_ * p.x / a;
    const Cell b = along_.at_arc(middle_ + way);
    const double pace = along_.step() / along_.rise(b.i);
    return {box_.uv({along_.value(b), across_.value(c)}), box_.uv({pace * sign_ / a, 0}),
            box_.uv({-pace * way * da / a, across_.step() / rise})};
  }

 private:
  double width_at(Cell c) const {
    double t = std::clamp(c.t, 0.0, 1.0);
    return std::max(smallest_, width_[c.i] + t * (width_[c.i + 1] - width_[c.i]));
  }

  ParameterBox box_;
  ArcTable along_, across_;
  double middle_ = 0, sign_ = 1, smallest_ = 0;  // along_ at the middle of the box
  std::vector<double> width_;
};

class PolarChart : public Chart {
 public:
  PolarChart(const MeridianTable& table, const ParameterBox& box, double period)
      : box_(box), turn_(2 * M_PI / period), lo_(table.lo()), step_(table.step()), cells_(table.cells()) {
    // log R rises along v by (2 pi / period) |S_v| / |S_u|; the cell at a pole is linear in R instead.
    std::vector<double> log_r(cells_ + 1, 0);
    for (int i = 0; i < cells_; ++i) {
      double w = 0.5 * (table.width(i) + table.width(i + 1));
      log_r[i + 1] = log_r[i] + (w > 0 ? turn_ * step_ * table.height(i) / w : 0);
    }
    // About the pole of a slim cone it would rise beyond all numbers; there it rises more slowly everywhere.
    const double steep = log_r.back() / most_span;
    if ((box.low_pole || box.high_pole) && steep > 1)
      for (double& value : log_r) value /= steep;
    span_ = log_r.back();
    rises_ = box.low_pole;
    double middle = 0.5 * span_;
    for (int i = 0; i <= cells_; ++i) radius_.push_back(std::exp(rises_ ? log_r[i] - middle : middle - log_r[i]));
    if (box.low_pole) radius_.front() = 0;
    if (box.high_pole) radius_.back() = 0;
    for (int i = 0; i < cells_; ++i) {
      const bool is_at_pole = !(radius_[i] > 0 && radius_[i + 1] > 0);
      log_ratio_.push_back(is_at_pole ? 0 : std::log(radius_[i + 1] / radius_[i]));
    }
    least_ = 1e300;
    for (double r : radius_)
      if (r > 0) least_ = std::min(least_, 1e-9 * r);
    has_apex_ = has_apex(table);
    sign_ = rises_ == box.is_swapped ? 1 : -1;  // keeps the chart's orientation that of (u, v)
  }

  bool is_usable() const { return span_ <= most_span * (1 + 1e-9) && span_ > 0; }

  // Without a pole the chart is the exponential of (phi, meridian): in complex numbers p exp(step / p).
  bool bends() const override { return !box_.low_pole && !box_.high_pole; }
  Vec2 walk(Vec2 p, Vec2 step) const override { return bends() ? turned(p, step) : p + step; }
  Vec2 approach(Vec2 p, Vec2 step) const override {
    return (bends() || has_apex_) && dot(p, p) > 0 ? turned(p, step) : p + step;
  }
  Vec2 step_to(Vec2 p, Vec2 q) const override {
    if (!bends()) return q - p;
    double grow = 0.5 * std::log(dot(q, q) / dot(p, p)), turn = std::atan2(cross(p, q), dot(p, q));
    return {grow * p.x - turn * p.y, grow * p.y + turn * p.x};
  }

  Vec2 to_chart(Vec2 uv) const override {
    Vec2 q = box_.uv(uv);
    Cell c = cell_of(q.y, lo_, step_, cells_);
    double phi = sign_ * turn_ * (q.x - box_.lo.x), r = radius_at(c);
    return {r * std::cos(phi), r * std::sin(phi)};
  }

  ChartSlope slope(Vec2 p) const override {
    double r = norm(p);
    if (!(r > least_)) p = {r = least_, 0};
    int i = find_cell(r);
    double r0 = radius_[i], r1 = radius_[i + 1], t, dt;  // t in the cell and its derivative by r
    if (r0 > 0 && r1 > 0) {
      t = std::log(r / r0) / log_ratio_[i];
      dt = 1 / (r * log_ratio_[i]);
    } else {
      dt = 1 / (r1 - r0);
      t = (r - r0) * dt;
    }
    double phi = std::atan2(p.y, p.x);
    double u = phi / (sign_ * turn_);
    double period = 2 * M_PI / turn_;
    if (u < 0) u += period;
    double k = 1 / (sign_ * turn_ * r * r);
    return {box_.uv({box_.lo.x + u, lo_ + step_ * (i + t)}), box_.uv({-p.y * k, step_ * dt * p.x / r}),
            box_.uv({p.x * k, step_ * dt * p.y / r})};
  }

 private:
  static Vec2 turned(Vec2 p, Vec2 step) {
    double square = dot(p, p), grow = dot(step, p) / square, turn = cross(p, step) / square;
    double scale = std::exp(std::clamp(grow, -150.0, 150.0)), c = std::cos(turn), s = std::sin(turn);
    return scale * Vec2{c * p.x - s * p.y, s * p.x + c * p.y};
  }
  /// Whether the surface about a pole is sharper than a disc: log R rises faster than that of the distance.
  bool has_apex(const MeridianTable& table) const {
    constexpr double sharp = 1.2;
    const int i = box_.low_pole ? 1 : cells_ - 1;
    const double distance = step_ * table.height(box_.low_pole ? 0 : cells_ - 1), width = table.width(i);
    return (box_.low_pole || box_.high_pole) && cells_ > 1 && turn_ * distance > sharp * width;
  }
  double radius_at(Cell c) const {
    double r0 = radius_[c.i], r1 = radius_[c.i + 1];
    if (r0 > 0 && r1 > 0) return r0 * std::exp(c.t * log_ratio_[c.i]);
    return std::max(0.0, r0 + c.t * (r1 - r0));
  }
  int find_cell(double r) const {
    auto at = rises_ ? std::upper_bound(radius_.begin(), radius_.end(), r)
                     : std::upper_bound(radius_.begin(), radius_.end(), r, std::greater<>());
    return std::clamp(static_cast<int>(at - radius_.begin()) - 1, 0, cells_ - 1);
  }

  ParameterBox box_;
  static constexpr double most_span = 150;  // of log R: beyond, products of four coordinates leave the range of double
  double turn_, lo_, step_, span_ = 0, least_ = 0;  // nearer to the pole than least_ is at it
  int cells_;
  bool rises_ = false, has_apex_ = false;
  double sign_ = 1;
  std::vector<double> radius_;
  std::vector<double> log_ratio_;  // per cell: of its radii, 0 at a pole
};

constexpr int table_cells = 64;
constexpr int tracks = 8;  // across, on which speeds are averaged

/// |S_u| and |S_v| at a share of the box along u and a value of v.
std::array<double, 2> speeds_at(const Surface& surface, const ParameterBox& box, double share, double v) {
  auto [x, along, across] = surface.slope(box.uv({box.lo.x + share * (box.hi.x - box.lo.x), v}));
  if (box.is_swapped) std::swap(along, across);
  return {norm(along), norm(across)};
}

/// Mean |S_u| of some rows at a share of the box along u.
double row_speed(const Surface& surface, const ParameterBox& box, double share) {
  double sum = 0;
  for (int j = 0; j < tracks; ++j) {
    const double v = box.lo.y + (j + 0.5) / tracks * (box.hi.y - box.lo.y);
    const double speed = speeds_at(surface, box, share, v)[0];
    if (std::isfinite(speed)) sum += speed / tracks;
  }
  return sum;
}

/// Lengths along u where rows start or end slowly, else u by itself. A slow stretch in the middle, such as a lip, keeps
/// the room that u gives it.
ArcTable rows_of(const Surface& surface, const ParameterBox& box) {
  constexpr double slow = 0.2;  // of the mean
  std::vector<double> speeds, from_end;
  for (int i = 0; surface.kind() == SurfaceKind::other && i < table_cells; ++i)
    speeds.push_back(row_speed(surface, box, (i + 0.5) / table_cells));
  from_end = speeds;
  for (std::size_t i = 1; i < speeds.size(); ++i) speeds[i] = std::max(speeds[i], speeds[i - 1]);
  for (std::size_t i = speeds.size(); i-- > 1;) from_end[i - 1] = std::max(from_end[i - 1], from_end[i]);
  double mean = 0;
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    speeds[i] = std::min(speeds[i], from_end[i]);
    mean += speeds[i] / table_cells;
  }
  if (speeds.empty() || !(std::min(speeds.front(), speeds.back()) < slow * mean))
    return {0.5 * (box.lo.x + box.hi.x), 1, {1}};
  for (double& speed : speeds) speed /= mean;
  return {box.lo.x, (box.hi.x - box.lo.x) / table_cells, speeds};
}

}  // namespace

MeridianTable::MeridianTable(const Surface& surface, const ParameterBox& box, int cells)
    : lo_(box.lo.y), step_((box.hi.y - box.lo.y) / cells) {
  std::vector<double> height(cells + 1, 0);
  width_.assign(cells + 1, 0);
  for (int i = 0; i <= cells; ++i)
    for (int j = 0; j < tracks; ++j) {
      const auto [along, across] = speeds_at(surface, box, (j + 0.5) / tracks, lo_ + i * step_);
      width_[i] += along / tracks;
      height[i] += across / tracks;
    }
  for (int i = 0; i < cells; ++i) height_.push_back(0.5 * (height[i] + height[i + 1]));
}

std::shared_ptr<const Chart> make_row_chart(const Surface& surface, const ParameterBox& box) {
  const bool is_even = surface.kind() == SurfaceKind::plane || surface.kind() == SurfaceKind::cylinder;
  return std::make_shared<RowChart>(MeridianTable(surface, box, is_even ? 1 : table_cells), box, rows_of(surface, box));
}

std::shared_ptr<const Chart> make_polar_chart(const Surface& surface, const ParameterBox& box, double period) {
  auto chart = std::make_shared<PolarChart>(MeridianTable(surface, box, table_cells), box, period);
  return chart->is_usable() ? chart : nullptr;
}

}  // namespace paver
