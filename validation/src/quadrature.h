// Rules for integrals over one element and over two of them.
#pragma once

#include <Eigen/Dense>
#include <vector>

namespace paver::validation {

struct RulePoint {
  double u, v, weight;
};

/// Gauss-Legendre over [0, 1]: places and weights.
std::vector<std::pair<double, double>> gauss(int points);

/// Over a quad's or a triangle's parameters, `points` each way; on triangles by Duffy's map.
std::vector<RulePoint> product_rule(int corners, int points);

/// Points of two triangles over {0 <= y <= x <= 1} each.
struct PairPoint {
  Eigen::Vector2d first, second;
  double weight;
};

/// Rules for kernels that are singular where two triangles meet, [Sauter11] section 5.2: `common` corners of theirs are
/// the same (0 to 3), those at (0, 0), (1, 0) and (1, 1), in that order. `points` in each of four directions.
std::vector<PairPoint> pair_rule(int common, int points);

}  // namespace paver::validation
