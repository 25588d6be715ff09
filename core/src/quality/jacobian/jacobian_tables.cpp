// Builds the tables of JacobianForm.
//
// With x in Bernstein form, x_u and x_v are differences of its control points and
//   det = sum over a, b of weight(a, b) * (x_u[a] x x_v[b]) . n  per coefficient,
// the weights being quotients of binomials (product of two Bernstein polynomials). The mean of x_u x x_v over the
// element, which gives n, is the mean of these coefficients; expanded in pairs of control points only those on the
// element's border remain. Matrices for values and for quarters come from sampling and one inverse.
#include <cmath>

#include "quality/jacobian/jacobian.h"
#include "quality/jacobian/lattice.h"

namespace paver {
namespace {

/// Rows: points; columns: Bernstein polynomials. `place` maps the lattice of the degree into the element.
template <class Map>
Dense bernstein_matrix(ElementShape shape, int degree, const std::vector<LatticePoint>& points, Map place) {
  auto lattice = bernstein_lattice(shape, degree);
  Dense m(static_cast<int>(points.size()));
  long double step = degree > 0 ? 1.0L / degree : 0.0L;
  for (int r = 0; r < m.n; ++r) {
    auto [u, v] = place(points[r].first * step, points[r].second * step);
    for (int c = 0; c < m.n; ++c) m.at(r, c) = bernstein(shape, degree, lattice[c], u, v);
  }
  return m;
}

using Uv = std::pair<long double, long double>;
Uv in_place(long double u, long double v) { return {u, v}; }

/// Weight of coefficients a and b of two factors in coefficient a + b of their product, along one direction.
long double weight1(int degree_a, int a, int degree_b, int b) {
  return binomial(degree_a, a) * binomial(degree_b, b) / binomial(degree_a + degree_b, a + b);
}

long double multinomial(int degree, LatticePoint p) {
  return binomial(degree, p.first) * binomial(degree - p.first, p.second);
}

}  // namespace

Dense node_to_control(ElementShape shape, int order) {
  return inverse(bernstein_matrix(shape, order, lagrange_nodes(shape, order), in_place));
}

JacobianForm::JacobianForm(ElementShape shape, int order) : shape_(shape), order_(order) {
  const Dense control = node_to_control(shape, order);
  nodes_ = control.n;
  degree_ = shape == ElementShape::quad ? 2 * order - 1 : 2 * order - 2;
  count_ = static_cast<int>(bernstein_lattice(shape, degree_).size());
  node_weights_ = control.rounded();
  build_control();
  build_products();
  build_mean();
  build_children();
  build_quadrature();
}

void JacobianForm::build_control() {
  constexpr double nothing = 1e-13;  // zeros but for rounding
  for (int out = 0; out < nodes_; ++out) {
    for (int in = 1; in < nodes_; ++in) {
      double weight = node_weights_[static_cast<std::size_t>(out) * nodes_ + in];
      if (std::fabs(weight) > nothing) to_control_.push_back({out, in, weight});
    }
  }
}

void JacobianForm::build_products() {
  bool is_quad = shape_ == ElementShape::quad;
  int p = order_;
  std::vector<LatticePoint> at_u, at_v;  // of each difference, in the lattice of x_u and of x_v
  for (int i = 0; i <= p; ++i) {
    for (int j = 0; j <= (is_quad ? p : p - i); ++j) {
      int here = bernstein_index(shape_, p, i, j);
      bool has_u = i < p && (is_quad || i + j < p), has_v = j < p && (is_quad || i + j < p);
      if (has_u) at_u.emplace_back(i, j), du_.push_back({here, bernstein_index(shape_, p, i + 1, j)});
      if (has_v) at_v.emplace_back(i, j), dv_.push_back({here, bernstein_index(shape_, p, i, j + 1)});
    }
  }
  for (std::size_t a = 0; a < at_u.size(); ++a) {
    for (std::size_t b = 0; b < at_v.size(); ++b) {
      auto [i, j] = at_u[a];
      auto [k, l] = at_v[b];
      long double weight =
          is_quad ? weight1(p - 1, i, p, k) * weight1(p, j, p - 1, l)
                  : multinomial(p - 1, at_u[a]) * multinomial(p - 1, at_v[b]) / multinomial(degree_, {i + k, j + l});
      products_.push_back({bernstein_index(shape_, degree_, i + k, j + l), static_cast<int>(a), static_cast<int>(b),
                           static_cast<double>(weight * p * p)});
    }
  }
}

void JacobianForm::build_mean() {
  Dense pairs(nodes_);
  for (const Product& term : products_) {
    long double w = static_cast<long double>(term.weight) / count_;
    Difference u = du_[term.u], v = dv_[term.v];
    pairs.at(u.to, v.to) += w;
    pairs.at(u.from, v.from) += w;
    pairs.at(u.to, v.from) -= w;
    pairs.at(u.from, v.to) -= w;
  }
  constexpr long double nothing = 1e-13L;  // pairs inside the element cancel but for rounding
  for (int a = 0; a < nodes_; ++a) {
    for (int b = a + 1; b < nodes_; ++b) {
      long double w = pairs.at(a, b) - pairs.at(b, a);
      if (std::fabs(w) > nothing) mean_.push_back({a, b, static_cast<double>(w)});
    }
  }
}

void JacobianForm::build_children() {
  auto lattice = bernstein_lattice(shape_, degree_);
  Dense values = bernstein_matrix(shape_, degree_, lattice, in_place);
  Dense back = inverse(values);
  samples_ = values.rounded_columns();
  bool is_quad = shape_ == ElementShape::quad;
  for (int k = 0; k < 4; ++k) {
    auto quarter = [&](long double u, long double v) -> Uv {
      if (!is_quad && k == 3) return {0.5L - u / 2, 0.5L - v / 2};
      return {(u + (k & 1)) / 2, (v + (k >> 1)) / 2};
    };
    children_[k] = product(back, bernstein_matrix(shape_, degree_, lattice, quarter)).rounded_columns();
  }
  int d = degree_;
  corners_ = {bernstein_index(shape_, d, 0, 0), bernstein_index(shape_, d, d, 0), bernstein_index(shape_, d, 0, d)};
  if (is_quad) corners_.push_back(bernstein_index(shape_, d, d, d));
}

void JacobianForm::build_quadrature() {
  auto rule = gauss_rule(order_ + 2);
  auto lattice = bernstein_lattice(shape_, order_);
  for (auto [s, ws] : rule) {
    for (auto [t, wt] : rule) {
      bool is_quad = shape_ == ElementShape::quad;  // the triangle is the square with one side drawn together
      double u = is_quad ? s : s * (1 - t);
      quadrature_.push_back(is_quad ? ws * wt : ws * wt * (1 - t));
      for (int by_v = 0; by_v < 2; ++by_v) {
        for (int node = 0; node < nodes_; ++node) {
          long double slope = 0;
          for (int c = 0; c < nodes_; ++c) {
            auto [du, dv] = bernstein_slope(shape_, order_, lattice[c], u, t);
            slope += (by_v ? dv : du) * node_weights_[static_cast<std::size_t>(c) * nodes_ + node];
          }
          quadrature_.push_back(static_cast<double>(slope));
        }
      }
    }
  }
}

}  // namespace paver
