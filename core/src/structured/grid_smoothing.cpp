// Gauss-Newton steps of one node at a time, in its tangent plane and its own chart.
// In and out: the grid. Each step is taken back when the energy about the node does not fall, so a sweep never makes a
// grid worse. Sweeps move waves of a few edges only: long ones are settled on coarser grids before (block_grid.cpp).
#include "structured/grid_smoothing.h"

#include <algorithm>
#include <cmath>

namespace paver {
namespace {

// Over-relaxation: five sweeps make lengths as even as twelve of full steps do; the shorter share is for where the
// energy does not fall.
constexpr double shares[] = {1.7, 0.4};
constexpr double still = 0.004;       // of the grid's edges: when no node moves further it is smooth
constexpr double longest_step = 0.3;  // of the same
constexpr double flat_sine = 0.2;     // corners may not become flatter than this: behind it lie folded elements
constexpr double least_area = 0.05;   // of the product of two sides: flatter corners count as if they were no flatter
constexpr double damping = 1e-3;

/// Energy about one node as a function of its position, with gradient and Gauss-Newton matrix in the tangent basis.
class NodeEnergy {
 public:
  NodeEnergy(const GluedGrid& grid, int node, double ratio)
      : grid_(grid), mesh_(grid.mesh), node_(node), ratio_(ratio) {
    n_ = mesh_.normal(node);
    t_ = unit(mesh_.xp[node]);
    s_ = cross(n_, t_);
  }

  /// `has_slopes`: with what step() needs.
  template <bool has_slopes>
  double value(Vec3 at) {
    sum_ = g1_ = g2_ = h11_ = h12_ = h22_ = 0;
    least_sine_ = 1;
    for (int q : mesh_.star[node_]) {
      const Element& e = mesh_.elements[q];
      int k = e.corner_of(node_);
      const int next = e.v[(k + 1) % 4];
      const Vec3 a = mesh_.x[next], b = mesh_.x[e.v[(k + 2) % 4]], c = mesh_.x[e.v[(k + 3) % 4]];
      add_edge<has_slopes>(at - a, grid_.wish(q, k) * (mesh_.h[node_] + mesh_.h[next]));
      const Vec3 to_a = a - at, to_c = c - at;
      if (const Corner own = corner_of(to_a, to_c); has_slopes)
        add_slope(grid_.angle_weight, own.cotangent,
                  -1 * (own.slope(to_c, cross(to_c, n_)) + own.slope(to_a, cross(n_, to_a))));
      if (const Corner second = corner_of(b - a, at - a); has_slopes)
        add_slope(grid_.angle_weight, second.cotangent, second.slope(b - a, cross(n_, b - a)));
      if (const Corner first = corner_of(at - c, b - c); has_slopes)
        add_slope(grid_.angle_weight, first.cotangent, first.slope(b - c, cross(b - c, n_)));
    }
    return sum_;
  }

  /// Of all corners at the last value().
  double least_sine() const { return least_sine_; }

  /// The step that would be best if the residuals were linear.
  Vec3 step() const {
    double extra = damping * (h11_ + h22_), a = h11_ + extra, c = h22_ + extra, det = a * c - h12_ * h12_;
    if (!(det > 0)) return {0, 0, 0};
    return ((h12_ * g2_ - c * g1_) / det) * t_ + ((h12_ * g1_ - a * g2_) / det) * s_;
  }

 private:
  template <bool has_slopes>
  void add_edge(Vec3 d, double twice_target) {
    double length = norm(d), wish = 0.5 * ratio_ * twice_target, residual = length / wish - 1;
    sum_ += residual * residual;
    if (has_slopes) add_slope(1, residual, (1 / (length * wish)) * d);
  }

  struct Corner {
    double cotangent, area;  // area of the parallelogram
    // By a side: how a.b and (a x b).n change with it.
    Vec3 slope(Vec3 product, Vec3 turn) const { return (1 / area) * (product - cotangent * turn); }
  };

  Corner corner_of(Vec3 a, Vec3 b) {
    double scale = std::sqrt(dot(a, a) * dot(b, b)), area = dot(cross(a, b), n_);
    least_sine_ = std::min(least_sine_, area / scale);
    area = std::max(area, least_area * scale);
    const double cotangent = dot(a, b) / area;
    sum_ += grid_.angle_weight * cotangent * cotangent;
    return {cotangent, area};
  }

  void add_slope(double weight, double residual, Vec3 slope) {
    double j1 = dot(slope, t_), j2 = dot(slope, s_);
    g1_ += weight * residual * j1, g2_ += weight * residual * j2;
    h11_ += weight * j1 * j1, h12_ += weight * j1 * j2, h22_ += weight * j2 * j2;
  }

  const GluedGrid& grid_;
  const RegionMesh& mesh_;
  int node_;
  double ratio_;
  Vec3 n_, t_, s_;
  double least_sine_ = 1;
  double sum_ = 0, g1_ = 0, g2_ = 0, h11_ = 0, h12_ = 0, h22_ = 0;
};

/// Means over the edges of a grid.
struct EdgeMeans {
  double ratio = 0;   // of length to what is wished
  double length = 0;  // by the target length, which edges of a coarse grid exceed by far
};

/// How far the node went, by the length of edges about it.
double improve(GluedGrid& grid, int node, EdgeMeans means, const Surface& surface, const FaceSize& size) {
  RegionMesh& mesh = grid.mesh;
  NodeEnergy energy(grid, node, means.ratio);
  const Vec2 p = mesh.p[node];
  const Vec3 x = mesh.x[node];
  const double before = energy.value<true>(x), sine = std::min(energy.least_sine(), flat_sine);
  Vec3 step = energy.step();
  const double edge = means.length * mesh.h[node], length = norm(step), most = longest_step * edge;
  if (!(length > 0)) return 0;
  if (length > most) step = (most / length) * step;
  Vec2 move = mesh.pull_back(node, {step, {}});
  for (double share : shares) {
    grid.place(node, p + share * move, surface, size);
    if (energy.value<false>(mesh.x[node]) < before && energy.least_sine() >= sine) return norm(mesh.x[node] - x) / edge;
  }
  grid.place(node, p, surface, size);
  return 0;
}

EdgeMeans mean_edges(const GluedGrid& grid) {
  const RegionMesh& mesh = grid.mesh;
  EdgeMeans sums;
  for (std::size_t q = 0; q < mesh.elements.size(); ++q)
    for (int k = 0; k < 4; ++k) {
      const int a = mesh.elements[q].v[k], b = mesh.elements[q].v[(k + 1) % 4];
      const double length = 2 * norm(mesh.x[a] - mesh.x[b]) / (mesh.h[a] + mesh.h[b]);
      sums.length += length;
      sums.ratio += length / grid.wish(static_cast<int>(q), k);
    }
  const double sides = 4.0 * static_cast<double>(mesh.elements.size());
  return {sums.ratio / sides, sums.length / sides};
}

}  // namespace

void GluedGrid::place(int node, Vec2 p, const Surface& surface, const FaceSize& size) {
  mesh.p[node] = p;
  const ChartSlope at = charts[chart[node]]->slope(p);
  const auto [x, xp, xq] = slope_at(at, surface);
  mesh.x[node] = x, mesh.xp[node] = xp, mesh.xq[node] = xq;
  mesh.h[node] = size.at(at.uv, surface);
}

GridFigures measure_grid(const GluedGrid& grid) {
  const RegionMesh& mesh = grid.mesh;
  GridFigures figures;
  figures.mean_ratio = mean_edges(grid).ratio;
  figures.worst = 2;
  double squares = 0, cotangents = 0, least_cosine = 1;
  for (std::size_t q = 0; q < mesh.elements.size(); ++q) {
    const Element& e = mesh.elements[q];
    figures.worst = std::min(figures.worst, scaled_jacobian(mesh, e));
    for (int k = 0; k < 2; ++k)
      least_cosine = std::min(least_cosine, dot(mesh.normal(e.v[k]), mesh.normal(e.v[k + 2])));
    for (int k = 0; k < 4; ++k) {
      int a = e.v[k], b = e.v[(k + 1) % 4], c = e.v[(k + 3) % 4];
      Vec3 out = mesh.x[b] - mesh.x[a], back = mesh.x[c] - mesh.x[a];
      double off =
          2 * norm(out) / (figures.mean_ratio * grid.wish(static_cast<int>(q), k) * (mesh.h[a] + mesh.h[b])) - 1;
      double cotangent = dot(out, back) / std::max(norm(cross(out, back)), least_area * norm(out) * norm(back));
      squares += off * off;
      cotangents += cotangent * cotangent;
    }
  }
  figures.turn = std::acos(std::max(-1.0, least_cosine));
  double sides = 4.0 * static_cast<double>(mesh.elements.size());
  figures.variation = std::sqrt(squares / sides);
  figures.energy = (0.5 * squares + grid.angle_weight * cotangents) / static_cast<double>(mesh.node_count());
  return figures;
}

void smooth_grid(GluedGrid& grid, const Surface& surface, const FaceSize& size, int sweeps, const Progress& progress) {
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    progress.check();
    const EdgeMeans means = mean_edges(grid);
    double furthest = 0;
    for (int node = 0; node < grid.mesh.node_count(); ++node)
      if (!grid.mesh.is_fixed[node]) furthest = std::max(furthest, improve(grid, node, means, surface, size));
    if (furthest < still) return;
  }
}

}  // namespace paver
