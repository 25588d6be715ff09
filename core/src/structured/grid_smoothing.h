// Smoothing of a regular grid of quads, laid over a whole closed face or a disc.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "charts/chart.h"
#include "mesh/region_mesh.h"
#include "paver/progress.h"
#include "sizing/size_field.h"

namespace paver {

/// Quads, counter-clockwise in (u, v). `mesh.p` of a node are coordinates of its own chart,
/// `charts[chart[node]]`.
struct GluedGrid {
  std::vector<std::shared_ptr<const Chart>> charts;
  std::vector<int> chart;
  RegionMesh mesh;
  /// Per quad and side from its corner k: the wished length by the target length; empty: 1.
  std::vector<std::array<float, 4>> wishes;

  /// What right angles are worth against equal lengths. On the full sphere 0.1 costs 0.004 in the coefficient of
  /// variation of the lengths and takes the mean scaled Jacobian from 0.986 to 0.991.
  double angle_weight = 0.07;

  double wish(int quad, int side) const { return wishes.empty() ? 1 : wishes[quad][side]; }

  /// Moves a node to chart point p.
  void place(int node, Vec2 p, const Surface& surface, const FaceSize& size);
  Vec2 uv(int node) const { return charts[chart[node]]->uv(mesh.p[node]); }
};

/// Sums over a grid, each per item: edges about one length in h, right angles, and what a solver feels of both.
struct GridFigures {
  double mean_ratio = 0;  ///< of edge length to target length
  double variation = 0;   ///< of the same
  double worst = 0;       ///< scaled Jacobian
  double turn = 0;        ///< radians: largest angle between the normals at opposite corners of a quad
  double energy = 0;      ///< per node, see smooth_grid
};
GridFigures measure_grid(const GluedGrid& grid);

/// `sweeps` over all nodes that are not fixed. A node goes where the energy about it is least: sum over edges of
/// (length / (r w h) - 1)^2, w the wish, r the mean of length / (w h), plus `angle_weight` times the sum over corners
/// of the squared cotangent.
void smooth_grid(GluedGrid& grid, const Surface& surface, const FaceSize& size, int sweeps, const Progress& progress);

}  // namespace paver
