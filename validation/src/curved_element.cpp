#include "curved_element.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace paver::validation {
namespace {

constexpr int most_order = 3;

/// Places of the nodes on a lattice of `order` steps: corners, sides in turn, then the lattice inside.
std::vector<Eigen::Vector2i> lattice(int corners, int order) {
  if (order < 0) return {};
  if (order == 0) return {{0, 0}};
  const std::vector<Eigen::Vector2i> ends =
      corners == 4 ? std::vector<Eigen::Vector2i>{{0, 0}, {order, 0}, {order, order}, {0, order}}
                   : std::vector<Eigen::Vector2i>{{0, 0}, {order, 0}, {0, order}};
  std::vector<Eigen::Vector2i> found = ends;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const Eigen::Vector2i step = (ends[(i + 1) % ends.size()] - ends[i]) / order;
    for (int k = 1; k < order; ++k) found.push_back(ends[i] + k * step);
  }
  for (const Eigen::Vector2i& inner : lattice(corners, order - (corners == 4 ? 2 : 3)))
    found.push_back(inner + Eigen::Vector2i(1, 1));
  return found;
}

int order_of(int corners, int nodes) {
  for (int order = 1; order <= most_order; ++order)
    if (nodes == (corners == 4 ? (order + 1) * (order + 1) : (order + 1) * (order + 2) / 2)) return order;
  throw std::invalid_argument("no element of order 1 to 3 with " + std::to_string(corners) + " corners has " +
                              std::to_string(nodes) + " nodes");
}

}  // namespace

ShapeFunctions::ShapeFunctions(int corners, int nodes) : corners_(corners) {
  const int order = order_of(corners, nodes);
  for (int j = 0; j <= order; ++j)
    for (int i = 0; i <= order - (corners == 4 ? 0 : j); ++i) powers_.emplace_back(i, j);
  const std::vector<Eigen::Vector2i> places = lattice(corners, order);
  Eigen::MatrixXd values(nodes, nodes);
  for (int n = 0; n < nodes; ++n)
    for (int m = 0; m < nodes; ++m)
      values(n, m) = std::pow(static_cast<double>(places[n].x()) / order, powers_[m].x()) *
                     std::pow(static_cast<double>(places[n].y()) / order, powers_[m].y());
  coefficients_ = values.inverse();
}

Eigen::MatrixXd ShapeFunctions::at(double u, double v) const {
  double pu[most_order + 1] = {1}, pv[most_order + 1] = {1};
  for (int i = 1; i <= most_order; ++i) pu[i] = u * pu[i - 1], pv[i] = v * pv[i - 1];
  Eigen::MatrixXd monomials(3, static_cast<Eigen::Index>(powers_.size()));
  for (Eigen::Index m = 0; m < monomials.cols(); ++m) {
    const int i = powers_[m].x(), j = powers_[m].y();
    monomials(0, m) = pu[i] * pv[j];
    monomials(1, m) = i > 0 ? i * pu[i - 1] * pv[j] : 0;
    monomials(2, m) = j > 0 ? j * pu[i] * pv[j - 1] : 0;
  }
  return monomials * coefficients_;
}

Eigen::Vector2d parameters_of(int corners, int i) {
  static const Eigen::Vector2d quad[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, triangle[] = {{0, 0}, {1, 0}, {0, 1}};
  return corners == 4 ? quad[i] : triangle[i];
}

}  // namespace paver::validation
