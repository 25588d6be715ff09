// Row and polar charts. Both tabulate the surface's mean scale along v once; a chart need only be injective and
// roughly faithful, because lengths and angles are always taken from the surface itself.
#include "charts/chart.h"

#include <algorithm>
#include <cmath>

namespace paver {
namespace {

Vec2 swapped(Vec2 p, bool is_swapped) { return is_swapped ? Vec2{p.y, p.x} : p; }

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

class RowChart : public Chart {
 public:
  RowChart(const MeridianTable& table, const ParameterBox& box)
      : box_(box), mid_(0.5 * (box.lo.x + box.hi.x)), lo_(table.lo()), step_(table.step()), cells_(table.cells()) {
    for (int i = 0; i <= cells_; ++i) width_.push_back(table.width(i));
    double widest = *std::max_element(width_.begin(), width_.end());
    if (!(widest > 0)) widest = 1;
    smallest_ = 1e-9 * widest;
    for (double& w : width_) w = std::max(w, smallest_);
    if (box.low_pole) width_.front() = smallest_;
    if (box.high_pole) width_.back() = smallest_;
    double tallest = 0;
    for (int i = 0; i < cells_; ++i) tallest = std::max(tallest, table.height(i));
    if (!(tallest > 0)) tallest = 1;
    arc_.push_back(0);
    for (int i = 0; i < cells_; ++i) arc_.push_back(arc_.back() + step_ * std::max(table.height(i), 1e-6 * tallest));
    cells_per_arc_ = cells_ / arc_.back();
    sign_ = box.is_swapped ? -1 : 1;
  }

  Vec2 to_chart(Vec2 uv) const override {
    Vec2 q = swapped(uv, box_.is_swapped);
    Cell c = cell_of(q.y, lo_, step_, cells_);
    return {sign_ * (q.x - mid_) * width_at(c), arc_[c.i] + c.t * (arc_[c.i + 1] - arc_[c.i])};
  }

  void to_uv(Vec2 p, Vec2& uv, Vec2& uv_x, Vec2& uv_y) const override {
    const int i = find_cell(p.y);
    double rise = arc_[i + 1] - arc_[i], t = (p.y - arc_[i]) / rise;
    Cell c{i, t};
    double a = width_at(c), da = t < 0 || t > 1 ? 0 : (width_[i + 1] - width_[i]) / rise;
    double u = mid_ + sign_ * p.x / a;
    uv = swapped({u, lo_ + step_ * (i + t)}, box_.is_swapped);
    uv_x = swapped({sign_ / a, 0}, box_.is_swapped);
    uv_y = swapped({-(u - mid_) * da / a, step_ / rise}, box_.is_swapped);
  }

 private:
  double width_at(Cell c) const {
    double t = std::clamp(c.t, 0.0, 1.0);
    return std::max(smallest_, width_[c.i] + t * (width_[c.i + 1] - width_[c.i]));
  }

  // The last cell that starts at or below y, searched from where it is with cells of equal height.
  int find_cell(double y) const {
    const double guess = y * cells_per_arc_;
    int i = guess > 0 ? static_cast<int>(std::min(guess, cells_ - 1.0)) : 0;
    while (i + 1 < cells_ && arc_[i + 1] <= y) ++i;
    while (i > 0 && y < arc_[i]) --i;
    return i;
  }

  ParameterBox box_;
  double mid_, lo_, step_, sign_ = 1, smallest_ = 0, cells_per_arc_ = 0;
  int cells_;
  std::vector<double> width_, arc_;
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

  /// Beyond this the products of four coordinates leave the range of double.
  bool is_usable() const { return span_ < 150 && std::isfinite(span_) && span_ > 0; }

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
    Vec2 q = swapped(uv, box_.is_swapped);
    Cell c = cell_of(q.y, lo_, step_, cells_);
    double phi = sign_ * turn_ * (q.x - box_.lo.x), r = radius_at(c);
    return {r * std::cos(phi), r * std::sin(phi)};
  }

  void to_uv(Vec2 p, Vec2& uv, Vec2& uv_x, Vec2& uv_y) const override {
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
    uv = swapped({box_.lo.x + u, lo_ + step_ * (i + t)}, box_.is_swapped);
    double k = 1 / (sign_ * turn_ * r * r);
    uv_x = swapped({-p.y * k, step_ * dt * p.x / r}, box_.is_swapped);
    uv_y = swapped({p.x * k, step_ * dt * p.y / r}, box_.is_swapped);
  }

 private:
  static Vec2 turned(Vec2 p, Vec2 step) {
    double square = dot(p, p), grow = dot(step, p) / square, turn = cross(p, step) / square;
    double scale = std::exp(std::clamp(grow, -50.0, 50.0)), c = std::cos(turn), s = std::sin(turn);
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
  double turn_, lo_, step_, span_ = 0, least_ = 0;  // nearer to the pole than least_ is at it
  int cells_;
  bool rises_ = false, has_apex_ = false;
  double sign_ = 1;
  std::vector<double> radius_;
  std::vector<double> log_ratio_;  // per cell: of its radii, 0 at a pole
};

constexpr int table_cells = 64;

}  // namespace

MeridianTable::MeridianTable(const Surface& surface, const ParameterBox& box, int cells)
    : lo_(box.lo.y), step_((box.hi.y - box.lo.y) / cells) {
  constexpr int across = 8;
  std::vector<double> height(cells + 1, 0);
  width_.assign(cells + 1, 0);
  for (int i = 0; i <= cells; ++i)
    for (int j = 0; j < across; ++j) {
      double u = box.lo.x + (j + 0.5) / across * (box.hi.x - box.lo.x);
      Vec3 x, a, b;
      surface.d1(swapped({u, lo_ + i * step_}, box.is_swapped), x, a, b);
      if (box.is_swapped) std::swap(a, b);
      width_[i] += norm(a) / across;
      height[i] += norm(b) / across;
    }
  for (int i = 0; i < cells; ++i) height_.push_back(0.5 * (height[i] + height[i + 1]));
}

std::shared_ptr<const Chart> make_row_chart(const Surface& surface, const ParameterBox& box) {
  bool is_even = surface.kind() == SurfaceKind::plane || surface.kind() == SurfaceKind::cylinder;
  return std::make_shared<RowChart>(MeridianTable(surface, box, is_even ? 1 : table_cells), box);
}

std::shared_ptr<const Chart> make_polar_chart(const Surface& surface, const ParameterBox& box, double period) {
  auto chart = std::make_shared<PolarChart>(MeridianTable(surface, box, table_cells), box, period);
  return chart->is_usable() ? chart : nullptr;
}

}  // namespace paver
