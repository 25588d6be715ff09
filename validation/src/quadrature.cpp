#include "quadrature.h"

#include <cmath>
#include <utility>

namespace paver::validation {

std::vector<std::pair<double, double>> gauss(int points) {
  // Eigenvalues of the Jacobi matrix of Legendre's polynomials [Golub69].
  Eigen::MatrixXd jacobi = Eigen::MatrixXd::Zero(points, points);
  for (int i = 1; i < points; ++i) jacobi(i, i - 1) = jacobi(i - 1, i) = i / std::sqrt(4.0 * i * i - 1);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(jacobi);
  std::vector<std::pair<double, double>> rule;
  for (int i = 0; i < points; ++i) {
    const double share = solver.eigenvectors()(0, i);
    rule.emplace_back(0.5 * (1 + solver.eigenvalues()(i)), share * share);
  }
  return rule;
}

std::vector<RulePoint> product_rule(int corners, int points) {
  std::vector<RulePoint> rule;
  for (auto [s, ws] : gauss(points))
    for (auto [t, wt] : gauss(points)) {
      if (corners == 4)
        rule.push_back({s, t, ws * wt});
      else
        rule.push_back({s * (1 - t), s * t, ws * wt * s});
    }
  return rule;
}

namespace {

using Point = Eigen::Vector2d;

/// Each region of [0, 1]^4 for two points; the weight without that of the place.
void add_same(std::vector<PairPoint>& rule, double x, double a, double b, double c, double w) {
  w *= x * x * x * a * a * b;
  const Point p[6] = {{1, 1 - a + a * b},       {1 - a * b * c, 1 - a},           {1, a * (1 - b + b * c)},
                      {1 - a * b, a * (1 - b)}, {1 - a * b * c, a * (1 - b * c)}, {1, a * (1 - b)}};
  for (int i = 0; i < 6; i += 2) {
    rule.push_back({x * p[i], x * p[i + 1], w});
    rule.push_back({x * p[i + 1], x * p[i], w});
  }
}

void add_edge(std::vector<PairPoint>& rule, double x, double a, double b, double c, double w) {
  w *= x * x * x * a * a;
  rule.push_back({x * Point(1, a * c), x * Point(1 - a * b, a * (1 - b)), w});
  w *= b;
  rule.push_back({x * Point(1, a), x * Point(1 - a * b * c, a * b * (1 - c)), w});
  rule.push_back({x * Point(1 - a * b, a * (1 - b)), x * Point(1, a * b * c), w});
  rule.push_back({x * Point(1 - a * b * c, a * b * (1 - c)), x * Point(1, a), w});
  rule.push_back({x * Point(1 - a * b * c, a * (1 - b * c)), x * Point(1, a * b), w});
}

void add_corner(std::vector<PairPoint>& rule, double x, double a, double b, double c, double w) {
  w *= x * x * x * b;
  rule.push_back({x * Point(1, a), x * b * Point(1, c), w});
  rule.push_back({x * b * Point(1, c), x * Point(1, a), w});
}

}  // namespace

std::vector<PairPoint> pair_rule(int common, int points) {
  std::vector<PairPoint> rule;
  const auto line = gauss(points);
  for (auto [x, wx] : line)
    for (auto [a, wa] : line)
      for (auto [b, wb] : line)
        for (auto [c, wc] : line) {
          const double w = wx * wa * wb * wc;
          if (common == 3)
            add_same(rule, x, a, b, c, w);
          else if (common == 2)
            add_edge(rule, x, a, b, c, w);
          else if (common == 1)
            add_corner(rule, x, a, b, c, w);
          else
            rule.push_back({x * Point(1, a), b * Point(1, c), w * x * b});
        }
  return rule;
}

}  // namespace paver::validation
