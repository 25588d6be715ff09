// Each cell has the polynomials through its values at Gauss's points, written by Legendre's: their last shares tell how
// near they are, and their integrals are differences of neighbours.
#include "brep/surfaces/speed_table.h"

#include <algorithm>
#include <math.hxx>
#include <math_Vector.hxx>

namespace paver {
namespace {

constexpr int order = SpeedTable::order;

constexpr double accuracy = 1e-5;         // of the last shares; what is left out is a tenth of them or less
constexpr int most_halves = 6;            // of a cell either way
constexpr std::size_t most_extra = 4000;  // cells that come of halving: a crease across them never gets near
constexpr int coarse = 8;                 // places either way for the mean speed

/// Legendre polynomials up to the degree `order`.
std::array<double, order + 1> legendre(double x) {
  std::array<double, order + 1> p{1, x};
  for (int k = 1; k < order; ++k) p[k + 1] = ((2 * k + 1) * x * p[k] - k * p[k - 1]) / (k + 1);
  return p;
}

struct Gauss {
  SpeedTable::Values at{};                            ///< points within [-1, 1]
  std::array<SpeedTable::Values, order> to_shares{};  ///< [polynomial][point]: from values at the points
};

Gauss make_gauss() {
  math_Vector points(1, order), weights(1, order);
  math::GaussPoints(order, points);
  math::GaussWeights(order, weights);
  Gauss rule;
  for (int k = 0; k < order; ++k) {
    rule.at[k] = points(k + 1);
    const auto p = legendre(rule.at[k]);
    for (int i = 0; i < order; ++i) rule.to_shares[i][k] = (i + 0.5) * weights(k + 1) * p[i];
  }
  return rule;
}

/// Place within [a, b] as one within [-1, 1].
double place_within(double t, double a, double b) { return std::clamp((2 * t - a - b) / (b - a), -1.0, 1.0); }

/// The last of `parts` that begins at or before t, else the first.
template <class Part>
const Part& part_at(const std::vector<Part>& parts, double t, double Part::*begin) {
  const auto after = std::ranges::upper_bound(parts, t, {}, begin);
  return after == parts.begin() ? *after : *std::prev(after);
}

}  // namespace

SpeedTable::SpeedTable(const Surface& surface, const std::vector<double>& u, const std::vector<double>& v)
    : surface_(surface), u_(u) {
  auto between = [](const std::vector<double>& t, int k) {
    return t.front() + (t.back() - t.front()) * (k + 0.5) / coarse;
  };
  double sum = 0;
  for (int i = 0; i < coarse; ++i)
    for (int j = 0; j < coarse; ++j) sum += speed({between(u, i), between(v, j)});
  allowed_ = accuracy * sum / (coarse * coarse) * (u.back() - u.front());
  for (std::size_t j = 1; j < v.size(); ++j) add_column(v[j - 1], v[j], most_halves);
}

double SpeedTable::up_to(Vec2 uv, double v) const {
  const Column& column = part_at(columns_, v, &Column::v0);
  const Cell& cell = part_at(column.cells, uv.x, &Cell::u0);
  const double x = place_within(uv.x, cell.u0, cell.u1);
  const auto p = legendre(x), q = legendre(place_within(uv.y, column.v0, column.v1));
  double sum = 0;
  for (int j = 0; j < order; ++j) {
    double along = cell.before[j] + (x + 1) * cell.shares[0][j];
    for (int i = 1; i < order; ++i) along += (p[i + 1] - p[i - 1]) / (2 * i + 1) * cell.shares[i][j];
    sum += along * q[j];
  }
  return sum;
}

std::vector<double> SpeedTable::lines_between(double from, double to) const {
  std::vector<double> lines;
  for (auto column = std::ranges::upper_bound(columns_, from, {}, &Column::v0);
       column != columns_.end() && column->v0 < to; ++column)
    lines.push_back(column->v0);
  return lines;
}

double SpeedTable::speed(Vec2 uv) const {
  const auto [x, xu, xv] = surface_.slope(uv);
  return norm(cross(xu, xv));
}

void SpeedTable::add_column(double v0, double v1, int halves) {
  Column column{v0, v1, {}};
  for (std::size_t i = 1; i < u_.size(); ++i)
    if (!add_cells(column, u_[i - 1], u_[i], most_halves, halves > 0)) {
      const double middle = 0.5 * (v0 + v1);
      add_column(v0, middle, halves - 1);
      return add_column(middle, v1, halves - 1);
    }
  columns_.push_back(std::move(column));
}

/// False: the column must be halved.
bool SpeedTable::add_cells(Column& column, double u0, double u1, int halves, bool may_halve_column) {
  const Cell cell = make_cell(column, u0, u1);
  // Of an even or odd speed the last share is 0, whatever comes then.
  double last_u = 0, last_v = 0;
  for (int k = 0; k < order; ++k) {
    last_u += std::abs(cell.shares[order - 1][k]) + 0.1 * std::abs(cell.shares[order - 2][k]);
    last_v += std::abs(cell.shares[k][order - 1]) + 0.1 * std::abs(cell.shares[k][order - 2]);
  }
  if (extra_cells_ < most_extra) {
    if (may_halve_column && last_v > allowed_) {
      extra_cells_ += column.cells.size() + 1;
      return false;
    }
    if (halves > 0 && last_u > allowed_) {
      ++extra_cells_;
      const double middle = 0.5 * (u0 + u1);
      return add_cells(column, u0, middle, halves - 1, may_halve_column) &&
             add_cells(column, middle, u1, halves - 1, may_halve_column);
    }
  }
  column.cells.push_back(cell);
  return true;
}

SpeedTable::Cell SpeedTable::make_cell(const Column& column, double u0, double u1) const {
  static const Gauss rule = make_gauss();
  const double middle_u = 0.5 * (u0 + u1), half_u = 0.5 * (u1 - u0);
  const double middle_v = 0.5 * (column.v0 + column.v1), half_v = 0.5 * (column.v1 - column.v0);
  Cell cell{u0, u1};
  for (int k = 0; k < order; ++k) {
    Values along{};  // v
    for (int l = 0; l < order; ++l) {
      const double value = half_u * speed({middle_u + half_u * rule.at[k], middle_v + half_v * rule.at[l]});
      for (int j = 0; j < order; ++j) along[j] += rule.to_shares[j][l] * value;
    }
    for (int i = 0; i < order; ++i)
      for (int j = 0; j < order; ++j) cell.shares[i][j] += rule.to_shares[i][k] * along[j];
  }
  if (column.cells.empty()) return cell;
  const Cell& last = column.cells.back();
  for (int j = 0; j < order; ++j) cell.before[j] = last.before[j] + 2 * last.shares[0][j];
  return cell;
}

}  // namespace paver
