// Weights of the nodes at each point: Bernstein polynomials there, times the matrix that turns nodes into control
// points.
#include "display/shape_table.h"

#include "quality/jacobian/lattice.h"

namespace paver {
namespace {

Vec3 combination(const Vec3* x, const double* weights, int count) {
  Vec3 sum;
  for (int k = 0; k < count; ++k) sum += weights[k] * x[k];
  return sum;
}

}  // namespace

ShapeTable::ShapeTable(ElementShape shape, int order, int n) : shape_(shape), n_(n) {
  Dense control = node_to_control(shape, order);
  std::vector<LatticePoint> controls = bernstein_lattice(shape, order);
  nodes_ = control.n;
  points_ = shape == ElementShape::quad ? (n + 1) * (n + 1) : (n + 1) * (n + 2) / 2;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= (shape == ElementShape::quad ? n : n - j); ++i) {
      long double u = static_cast<long double>(i) / n, v = static_cast<long double>(j) / n;
      for (int k = 0; k < nodes_; ++k) {
        long double value = 0, du = 0, dv = 0;
        for (int c = 0; c < nodes_; ++c) {
          auto [slope_u, slope_v] = bernstein_slope(shape, order, controls[c], u, v);
          value += bernstein(shape, order, controls[c], u, v) * control.at(c, k);
          du += slope_u * control.at(c, k);
          dv += slope_v * control.at(c, k);
        }
        value_.push_back(static_cast<double>(value));
        du_.push_back(static_cast<double>(du));
        dv_.push_back(static_cast<double>(dv));
      }
    }
  }
}

int ShapeTable::index(int i, int j) const { return bernstein_index(shape_, n_, j, i); }

Vec3 ShapeTable::position(const Vec3* x, int point) const {
  return combination(x, value_.data() + static_cast<std::size_t>(point) * nodes_, nodes_);
}

Vec3 ShapeTable::normal(const Vec3* x, int point) const {
  std::size_t at = static_cast<std::size_t>(point) * nodes_;
  return cross(combination(x, du_.data() + at, nodes_), combination(x, dv_.data() + at, nodes_));
}

}  // namespace paver
