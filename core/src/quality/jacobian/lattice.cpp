// Lattices, Bernstein polynomials and Gauss points: what the tables of jacobian.h are made of.
#include "quality/jacobian/lattice.h"

#include <cmath>
#include <numbers>

namespace paver {
namespace {

long double power(long double x, int n) {
  long double result = 1;
  for (int i = 0; i < n; ++i) result *= x;
  return result;
}

long double bernstein1(int degree, int i, long double t) {
  return i < 0 || i > degree ? 0 : binomial(degree, i) * power(t, i) * power(1 - t, degree - i);
}

long double slope1(int degree, int i, long double t) {
  return degree * (bernstein1(degree - 1, i - 1, t) - bernstein1(degree - 1, i, t));
}

/// Bernstein polynomial (i, j) of the triangle; 0 outside its lattice.
long double bernstein_triangle(int degree, int i, int j, long double u, long double v) {
  int k = degree - i - j;
  if (i < 0 || j < 0 || k < 0) return 0;
  return binomial(degree, i) * binomial(degree - i, j) * power(u, i) * power(v, j) * power(1 - u - v, k);
}

void add_inside(std::vector<LatticePoint>& nodes, const std::vector<LatticePoint>& inside) {
  for (auto [i, j] : inside) nodes.emplace_back(i + 1, j + 1);
}

}  // namespace

std::vector<LatticePoint> lagrange_nodes(ElementShape shape, int p) {
  if (p < 0) return {};
  if (p == 0) return {{0, 0}};
  bool is_quad = shape == ElementShape::quad;
  std::vector<LatticePoint> nodes{{0, 0}, {p, 0}};
  if (is_quad) nodes.emplace_back(p, p);
  nodes.emplace_back(0, p);
  for (int i = 1; i < p; ++i) nodes.emplace_back(i, 0);
  for (int i = 1; i < p; ++i) nodes.emplace_back(is_quad ? p : p - i, i);
  if (is_quad) {
    for (int i = 1; i < p; ++i) nodes.emplace_back(p - i, p);
  }
  for (int i = 1; i < p; ++i) nodes.emplace_back(0, p - i);
  add_inside(nodes, lagrange_nodes(shape, is_quad ? p - 2 : p - 3));
  return nodes;
}

std::vector<LatticePoint> bernstein_lattice(ElementShape shape, int degree) {
  std::vector<LatticePoint> points;
  for (int i = 0; i <= degree; ++i) {
    int last = shape == ElementShape::quad ? degree : degree - i;
    for (int j = 0; j <= last; ++j) points.emplace_back(i, j);
  }
  return points;
}

int bernstein_index(ElementShape shape, int degree, int i, int j) {
  if (shape == ElementShape::quad) return i * (degree + 1) + j;
  return i * (degree + 1) - i * (i - 1) / 2 + j;
}

long double binomial(int degree, int i) {
  long double result = 1;
  for (int k = 1; k <= i; ++k) result = result * (degree - i + k) / k;
  return result;
}

long double bernstein(ElementShape shape, int degree, LatticePoint index, long double u, long double v) {
  auto [i, j] = index;
  if (shape == ElementShape::triangle) return bernstein_triangle(degree, i, j, u, v);
  return bernstein1(degree, i, u) * bernstein1(degree, j, v);
}

std::pair<long double, long double> bernstein_slope(ElementShape shape, int degree, LatticePoint index, long double u,
                                                    long double v) {
  auto [i, j] = index;
  if (shape == ElementShape::triangle) {
    long double rest = bernstein_triangle(degree - 1, i, j, u, v);
    return {degree * (bernstein_triangle(degree - 1, i - 1, j, u, v) - rest),
            degree * (bernstein_triangle(degree - 1, i, j - 1, u, v) - rest)};
  }
  return {slope1(degree, i, u) * bernstein1(degree, j, v), bernstein1(degree, i, u) * slope1(degree, j, v)};
}

std::vector<std::pair<double, double>> gauss_rule(int n) {
  std::vector<std::pair<double, double>> rule;
  for (int k = 0; k < n; ++k) {
    long double x = std::cos(std::numbers::pi_v<long double> * (k + 0.75L) / (n + 0.5L)), slope = 1;
    for (int step = 0; step < 20; ++step) {  // Newton on the Legendre polynomial, by its three-term recurrence
      long double before = 1, value = x;
      for (int m = 2; m <= n; ++m) {
        long double next = ((2 * m - 1) * x * value - (m - 1) * before) / m;
        before = value;
        value = next;
      }
      slope = n * (x * value - before) / (x * x - 1);
      x -= value / slope;
    }
    rule.emplace_back(static_cast<double>((1 - x) / 2), static_cast<double>(1 / ((1 - x * x) * slope * slope)));
  }
  return rule;
}

}  // namespace paver
