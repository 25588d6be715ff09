#include "surface.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "quadrature.h"

namespace paver::validation {

Density rooftop(int corners, int side, double u, double v) {
  if (corners == 4)
    return side == 0 ? Density{0, v - 1} : side == 1 ? Density{u, 0} : side == 2 ? Density{0, v} : Density{u - 1, 0};
  return side == 0 ? Density{u, v - 1} : side == 1 ? Density{u, v} : Density{u - 1, v};
}

MeshedSurface::MeshedSurface(const Eigen::MatrixX3d& nodes, const Eigen::MatrixXi& quads,
                             const Eigen::MatrixXi& triangles) {
  add(nodes, quads, 4);
  add(nodes, triangles, 3);
  if (elements_.empty()) throw std::invalid_argument("the mesh has no elements");
  pair_sides();
  double volume = 0;
  for (const CurvedElement& element : elements_)
    for (const RulePoint& q : product_rule(element.corners(), 3)) {
      const ElementPoint at = element.at(q.u, q.v);
      volume += q.weight * at.x.dot(at.by_u.cross(at.by_v));
    }
  outward_ = volume < 0 ? -1 : 1;
}

void MeshedSurface::add(const Eigen::MatrixX3d& nodes, const Eigen::MatrixXi& rows, int corners) {
  if (rows.rows() == 0) return;
  if (rows.minCoeff() < 0 || rows.maxCoeff() >= nodes.rows())
    throw std::invalid_argument("an element names a node that is not there");
  shapes_.push_back(std::make_unique<ShapeFunctions>(corners, static_cast<int>(rows.cols())));
  for (Eigen::Index e = 0; e < rows.rows(); ++e) {
    CurvedElement& element = elements_.emplace_back();
    element.shape = shapes_.back().get();
    element.nodes.resize(3, rows.cols());
    for (Eigen::Index i = 0; i < rows.cols(); ++i) element.nodes.col(i) = nodes.row(rows(e, i)).transpose();
    for (int i = 0; i < corners; ++i) element.corner.push_back(rows(e, i));
  }
}

void MeshedSurface::pair_sides() {
  struct Side {
    std::size_t element;
    int side;
  };
  std::map<std::pair<long, long>, std::vector<Side>> sides;
  for (std::size_t e = 0; e < elements_.size(); ++e)
    for (int i = 0; i < elements_[e].corners(); ++i) {
      const std::vector<long>& corner = elements_[e].corner;
      const auto ends = std::minmax(corner[i], corner[(i + 1) % corner.size()]);
      sides[{ends.first, ends.second}].push_back({e, i});
    }
  shares_.resize(elements_.size());
  for (const auto& [ends, there] : sides) {
    is_closed_ = is_closed_ && there.size() == 2;
    for (std::size_t k = 1; k < there.size(); ++k, ++functions_) {
      shares_[there[0].element][static_cast<std::size_t>(there[0].side)].push_back({functions_, 1});
      shares_[there[k].element][static_cast<std::size_t>(there[k].side)].push_back({functions_, -1});
    }
  }
}

}  // namespace paver::validation
