// In: surface, wave number. Out: the matrix. Steps: points of product rules on every element once; for each pair of
// elements that do not touch a product rule by their distance; for those that touch a rule for each two triangles of
// theirs, quads being cut in two; rows of one testing element as a task. The electric equation alone has a symmetric
// matrix: each pair is done once.
#include "moments.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <complex>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>

#include "green.h"
#include "quadrature.h"

namespace paver::validation {
namespace {

using Complex = std::complex<double>;
using Block = Eigen::Matrix<Complex, 4, 4>;
constexpr Complex imaginary(0, 1);

/// Points each way by the gap between two elements, in mean sizes of theirs, and the phase over the larger one.
int points_at(double gap, double phase) {
  if (gap >= 8 && phase < 0.5) return 2;
  return gap < 0.3 ? 7 : gap < 0.7 ? 6 : gap < 1.5 ? 5 : gap < 3 ? 4 : 3;
}
constexpr int least_points = 2, most_points = 7;
constexpr std::size_t most_pairs = most_points * most_points * most_points * most_points;

/// Real and imaginary parts of some values, with their own memory.
template <std::size_t n>
struct Buffer {
  double re[n], im[n];
  Values values() { return {re, im}; }
  Complex operator[](std::size_t i) const { return {re[i], im[i]}; }
};

/// What a product rule has on one element; `columns` numbers of each place are laid out as green.h has them.
struct Samples {
  std::size_t count = 0;
  std::vector<double> x[3];     ///< places, by axis
  std::vector<double> density;  ///< of the sides, times the weight; the weight
  std::vector<double> moment;   ///< place about the element's centre x density; magnetic equation only, as what follows
  std::vector<double> beside;   ///< density x normal
  std::vector<double> jacobian;

  Vec place(std::size_t i) const { return {x[0][i], x[1][i], x[2][i]}; }
  double weight(std::size_t i) const { return density[i * columns + weight_column]; }
};

void put(std::vector<double>& rows, std::size_t i, int side, const Vec& v) {
  for (std::size_t axis = 0; axis < 3; ++axis) rows[i * columns + 4 * axis + static_cast<std::size_t>(side)] = v[axis];
}

Vec taken(const std::vector<double>& rows, std::size_t i, int side) {
  const double* at = &rows[i * columns + static_cast<std::size_t>(side)];
  return {at[0], at[4], at[8]};
}

struct SampledElement {
  Vec centre;
  double radius = 0;
  Samples by_points[most_points + 1];
};

/// Where the points of a pair rule lie on one of the elements, and its densities there.
struct PairPoints {
  Eigen::MatrixX3d places, normals;
  Eigen::MatrixX3d density[4];
};

/// Shape functions and densities at the points of a pair rule: the same for all elements of a kind.
class PairTable {
 public:
  struct Key {
    const ShapeFunctions* shape;
    std::array<int, 3> corner;  ///< of the element, at the triangle's (0, 0), (1, 0) and (1, 1)
    int common;
    bool is_first;
    auto operator<=>(const Key&) const = default;
  };

  PairTable(const Key& key, const std::vector<PairPoint>& rule) : sides_(key.shape->corners()) {
    const Eigen::Vector2d p0 = parameters_of(sides_, key.corner[0]), p1 = parameters_of(sides_, key.corner[1]),
                          p2 = parameters_of(sides_, key.corner[2]);
    const auto count = static_cast<Eigen::Index>(rule.size());
    a_.resize(count, sides_), b_.resize(count, sides_);
    for (Eigen::Index i = 0; i < count; ++i) {
      const PairPoint& point = rule[static_cast<std::size_t>(i)];
      const Eigen::Vector2d at = key.is_first ? point.first : point.second;
      const Eigen::Vector2d uv = p0 + at.x() * (p1 - p0) + at.y() * (p2 - p1);
      const Eigen::MatrixXd weights = key.shape->at(uv.x(), uv.y());
      if (i == 0) value_.resize(count, weights.cols()), by_u_ = by_v_ = value_;
      value_.row(i) = weights.row(0), by_u_.row(i) = weights.row(1), by_v_.row(i) = weights.row(2);
      for (int side = 0; side < sides_; ++side) {
        const Density d = rooftop(sides_, side, uv.x(), uv.y());
        a_(i, side) = d.a, b_(i, side) = d.b;
      }
    }
  }

  PairPoints on(const CurvedElement& element, double outward, bool with_normals) const {
    const Eigen::MatrixX3d nodes = element.nodes.transpose(), by_u = by_u_ * nodes, by_v = by_v_ * nodes;
    PairPoints found{value_ * nodes, {}, {}};
    for (int side = 0; side < sides_; ++side)
      found.density[side] =
          by_u.array().colwise() * a_.col(side).array() + by_v.array().colwise() * b_.col(side).array();
    if (with_normals) {
      found.normals.resize(by_u.rows(), 3);
      for (Eigen::Index i = 0; i < by_u.rows(); ++i)
        found.normals.row(i) = outward * by_u.row(i).cross(by_v.row(i)).normalized();
    }
    return found;
  }

 private:
  int sides_;
  Eigen::MatrixXd value_, by_u_, by_v_, a_, b_;
};

/// Cross products of rows.
Eigen::MatrixX3d crossed(const Eigen::MatrixX3d& a, const Eigen::MatrixX3d& b) {
  Eigen::MatrixX3d found(a.rows(), 3);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    found.col(i) = a.col(j).cwiseProduct(b.col(k)) - a.col(k).cwiseProduct(b.col(j));
  }
  return found;
}

class MatrixFiller {
 public:
  MatrixFiller(const MeshedSurface& surface, const Settings& settings)
      : surface_(surface), settings_(settings), k_(settings.wave_number), has_magnetic_(settings.electric_share < 1) {
    for (int common = 0; common < 4; ++common)
      pair_rules_[common] = pair_rule(common, settings.singular_points + (common == 0 ? 1 : 0));
    for (const CurvedElement& element : surface.elements()) sampled_.push_back(sampled(element));
  }

  Matrix run() {
    matrix_ = Matrix::Zero(surface_.functions(), surface_.functions());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, sampled_.size(), 4), [&](const auto& range) {
      for (std::size_t p = range.begin(); p < range.end(); ++p) fill_rows(p);
    });
    if (!has_magnetic_) mirror();
    return std::move(matrix_);
  }

 private:
  SampledElement sampled(const CurvedElement& element) const {
    SampledElement found;
    found.centre = Vec::Zero();
    const auto rule = product_rule(element.corners(), 3);
    for (const RulePoint& q : rule) found.centre += element.at(q.u, q.v).x / static_cast<double>(rule.size());
    for (Eigen::Index i = 0; i < element.nodes.cols(); ++i)
      found.radius = std::max(found.radius, (element.nodes.col(i) - found.centre).norm());
    for (int n = least_points; n <= most_points; ++n) found.by_points[n] = samples(element, n, found.centre);
    return found;
  }

  Samples samples(const CurvedElement& element, int points, const Vec& centre) const {
    const auto rule = product_rule(element.corners(), points);
    Samples found;
    found.count = rule.size();
    found.density.resize(found.count * columns);
    if (has_magnetic_) found.moment = found.beside = found.density, found.jacobian.resize(found.count);
    for (std::size_t i = 0; i < found.count; ++i) {
      const auto [u, v, weight] = rule[i];
      const ElementPoint at = element.at(u, v);
      const Vec normal = at.by_u.cross(at.by_v);
      for (std::size_t axis = 0; axis < 3; ++axis) found.x[axis].push_back(at.x[axis]);
      found.density[i * columns + weight_column] = weight;
      if (has_magnetic_) found.jacobian[i] = normal.norm();
      for (int side = 0; side < element.corners(); ++side) {
        const Density d = rooftop(element.corners(), side, u, v);
        const Vec density = weight * (d.a * at.by_u + d.b * at.by_v);
        put(found.density, i, side, density);
        if (!has_magnetic_) continue;
        put(found.moment, i, side, (at.x - centre).cross(density));
        put(found.beside, i, side, density.cross(surface_.outward() * normal.normalized()));
      }
    }
    return found;
  }

  void fill_rows(std::size_t p) {
    const CurvedElement& element = surface_.elements()[p];
    Matrix rows = Matrix::Zero(element.corners(), surface_.functions());
    for (std::size_t q = has_magnetic_ ? 0 : p; q < sampled_.size(); ++q) {
      const double gap = gap_between(p, q);
      Block block = gap <= 0 && touching(p, q) ? near_block(p, q) : far_block(p, q, gap);
      if (p == q && has_magnetic_) add_half(p, block);
      if (p == q && !has_magnetic_) block /= 2;  // the mirrored matrix brings the other half
      for (int t = 0; t < surface_.elements()[q].corners(); ++t)
        for (const Share& share : surface_.shares(q, t))
          for (int s = 0; s < element.corners(); ++s) rows(s, share.function) += share.sign * block(s, t);
    }
    const std::lock_guard guard(mutex_);
    for (int s = 0; s < element.corners(); ++s)
      for (const Share& share : surface_.shares(p, s)) matrix_.row(share.function) += share.sign * rows.row(s);
  }

  /// Adds the transposed matrix, by tiles that fit the cache.
  void mirror() {
    constexpr Eigen::Index tile = 32;
    const Eigen::Index n = matrix_.rows();
    for (Eigen::Index i0 = 0; i0 < n; i0 += tile)
      for (Eigen::Index j0 = 0; j0 <= i0; j0 += tile)
        for (Eigen::Index i = i0; i < std::min(i0 + tile, n); ++i)
          for (Eigen::Index j = j0; j < std::min(j0 + tile, i + 1); ++j)
            matrix_(i, j) = matrix_(j, i) = matrix_(i, j) + matrix_(j, i);
  }

  /// Between the spheres about two elements, in mean sizes of theirs.
  double gap_between(std::size_t p, std::size_t q) const {
    const SampledElement &one = sampled_[p], &two = sampled_[q];
    return ((one.centre - two.centre).norm() - one.radius - two.radius) / (one.radius + two.radius);
  }

  bool touching(std::size_t p, std::size_t q) const {
    for (long a : surface_.elements()[p].corner)
      for (long b : surface_.elements()[q].corner)
        if (a == b) return true;
    return false;
  }

  // What both equations have in common: jk eta of [A A' - d d' / k^2] G, and (A x n) (grad G x A').
  Complex electric(Complex vectors, Complex green, double divergences) const {
    return imaginary * k_ * free_space_impedance * (vectors - divergences / (k_ * k_) * green);
  }
  Complex weighted(Complex of_electric, Complex rotated) const {
    return settings_.electric_share * of_electric - (1 - settings_.electric_share) * free_space_impedance * rotated;
  }

  Block far_block(std::size_t p, std::size_t q, double gap) const {
    const int n = points_at(gap, std::sqrt(2.) * k_ * std::max(sampled_[p].radius, sampled_[q].radius));
    const Samples &one = sampled_[p].by_points[n], &two = sampled_[q].by_points[n];
    double squares[most_pairs];
    for (std::size_t i = 0; i < one.count; ++i)
      for (std::size_t j = 0; j < two.count; ++j) {
        const double x = one.x[0][i] - two.x[0][j], y = one.x[1][i] - two.x[1][j], z = one.x[2][i] - two.x[2][j];
        squares[i * two.count + j] = x * x + y * y + z * z;
      }
    Buffer<most_pairs> kernel;
    green(squares, one.count * two.count, k_, kernel.values());
    Buffer<most_points * most_points * columns> sums;
    add_sources(kernel.values(), one.count, two.count, two.density.data(), sums.values());
    Buffer<16> vectors, rotated{};
    add_tests(one.density.data(), sums.values(), one.count, vectors.values());
    Complex charges = 0;
    for (std::size_t i = 0; i < one.count; ++i) charges += one.weight(i) * sums[i * columns + weight_column];
    if (has_magnetic_) {
      slope(squares, kernel.values(), one.count * two.count, k_, kernel.values());
      add_turned(one, two, sampled_[q].centre, kernel.values(), sums.values());
      add_tests(one.beside.data(), sums.values(), one.count, rotated.values());
    }
    const int sides[2] = {surface_.elements()[p].corners(), surface_.elements()[q].corners()};
    const double divergences = divergence(sides[0]) * divergence(sides[1]);
    Block block = Block::Zero();
    for (int s = 0; s < sides[0]; ++s)
      for (int t = 0; t < sides[1]; ++t) {
        const auto at = static_cast<std::size_t>(4 * s + t);
        block(s, t) = weighted(electric(vectors[at], charges, divergences), rotated[at]);
      }
    return block;
  }

  /// Sums of (x - y) x A' slope over the sources: (x - centre) x sum of A' slope - sum of (y - centre) x A' slope.
  void add_turned(const Samples& one, const Samples& two, const Vec& centre, Values slopes, Values found) const {
    Buffer<most_points * most_points * columns> flow;
    add_sources(slopes, one.count, two.count, two.density.data(), flow.values());
    add_sources(slopes, one.count, two.count, two.moment.data(), found);
    for (std::size_t i = 0; i < one.count; ++i) {
      const Vec way = one.place(i) - centre;
      for (std::size_t t = i * columns; t < i * columns + 4; ++t)
        for (auto [sum, part] : {std::pair{found.re, flow.re}, std::pair{found.im, flow.im}}) {
          const Vec turned = way.cross(Vec(part[t], part[t + 4], part[t + 8]));
          for (int axis = 0; axis < 3; ++axis) sum[t + 4 * axis] = turned[axis] - sum[t + 4 * axis];
        }
    }
  }

  /// Corners of an element's triangles; a quad's two have corners 0 and 2 in common.
  static std::vector<std::array<int, 3>> triangles(int corners) {
    if (corners == 3) return {{0, 1, 2}};
    return {{0, 1, 2}, {0, 2, 3}};
  }

  using Corners = std::array<int, 3>;

  Block near_block(std::size_t p, std::size_t q) const {
    Block block = Block::Zero();
    for (const Corners& one : triangles(surface_.elements()[p].corners()))
      for (const Corners& two : triangles(surface_.elements()[q].corners())) {
        Block part = Block::Zero();
        const int common = add_triangles(p, q, one, two, part);
        // The rule for a common side depends on which comes first: their mean is symmetric whatever their order.
        if (common == 2 && !has_magnetic_) {
          Block other = Block::Zero();
          add_triangles(q, p, two, one, other);
          part = 0.5 * (part + other.transpose());
        }
        block += part;
      }
    return block;
  }

  // Corners in common come first, in the same order in both; their number is returned.
  int add_triangles(std::size_t p, std::size_t q, Corners one, Corners two, Block& block) const {
    const CurvedElement &a = surface_.elements()[p], &b = surface_.elements()[q];
    int common = 0;
    for (int i = 0; i < 3; ++i)
      for (int k = common; k < 3 && i >= common; ++k)
        if (a.corner[static_cast<std::size_t>(one[i])] == b.corner[static_cast<std::size_t>(two[k])]) {
          std::swap(one[i], one[common]);
          std::swap(two[k], two[common]);
          ++common;
          break;
        }
    const PairPoints x = table({a.shape, one, common, true}).on(a, surface_.outward(), has_magnetic_),
                     y = table({b.shape, two, common, false}).on(b, surface_.outward(), false);
    add_pair(x, y, pair_rules_[common], a.corners(), b.corners(), block);
    return common;
  }

  void add_pair(const PairPoints& x, const PairPoints& y, const std::vector<PairPoint>& rule, int tests, int sources,
                Block& block) const {
    const std::size_t count = rule.size();
    const Eigen::MatrixX3d way = x.places - y.places;
    const Eigen::VectorXd squares = way.rowwise().squaredNorm();
    std::vector<double> re(count), im(count);
    const Values values{re.data(), im.data()};
    green(squares.data(), count, k_, values);
    for (std::size_t i = 0; i < count; ++i) re[i] *= rule[i].weight, im[i] *= rule[i].weight;
    Complex charges = 0;
    for (std::size_t i = 0; i < count; ++i) charges += Complex(re[i], im[i]);
    const double divergences = divergence(tests) * divergence(sources);
    for (int s = 0; s < tests; ++s)
      for (int t = 0; t < sources; ++t)
        block(s, t) += weighted(
            electric(paired_sum(x.density[s].data(), y.density[t].data(), values, count), charges, divergences), 0);
    if (!has_magnetic_) return;
    slope(squares.data(), values, count, k_, values);
    for (int s = 0; s < tests; ++s) {
      const Eigen::MatrixX3d beside = crossed(crossed(x.density[s], x.normals), way);
      for (int t = 0; t < sources; ++t)
        block(s, t) += weighted(0, paired_sum(beside.data(), y.density[t].data(), values, count));
    }
  }

  const PairTable& table(const PairTable::Key& key) const {
    const std::lock_guard guard(table_mutex_);
    std::unique_ptr<PairTable>& found = tables_[key];
    if (!found) found = std::make_unique<PairTable>(key, pair_rules_[key.common]);
    return *found;
  }

  // Of the magnetic equation: half the current, tested.
  void add_half(std::size_t p, Block& block) const {
    const int sides = surface_.elements()[p].corners();
    const Samples& all = sampled_[p].by_points[most_points];
    for (std::size_t i = 0; i < all.count; ++i)
      for (int s = 0; s < sides; ++s)
        for (int t = 0; t < sides; ++t)
          block(s, t) += (1 - settings_.electric_share) * free_space_impedance * 0.5 *
                         taken(all.density, i, s).dot(taken(all.density, i, t)) / (all.weight(i) * all.jacobian[i]);
  }

  const MeshedSurface& surface_;
  const Settings& settings_;
  double k_;
  bool has_magnetic_;
  std::vector<PairPoint> pair_rules_[4];
  std::vector<SampledElement> sampled_;
  Matrix matrix_;
  std::mutex mutex_;
  mutable std::map<PairTable::Key, std::unique_ptr<PairTable>> tables_;
  mutable std::mutex table_mutex_;
};

}  // namespace

void check(const MeshedSurface& surface, const Settings& settings) {
  if (!(settings.wave_number > 0)) throw std::invalid_argument("the wave number must be above 0");
  if (!(settings.electric_share >= 0 && settings.electric_share <= 1))
    throw std::invalid_argument("electric_share must be from 0 to 1");
  if (settings.electric_share < 1 && !surface.is_closed())
    throw std::invalid_argument("the magnetic field equation needs a closed surface; use electric_share 1");
  if (surface.functions() == 0) throw std::invalid_argument("no two elements of the mesh have a side in common");
}

Matrix moment_matrix(const MeshedSurface& surface, const Settings& settings) {
  check(surface, settings);
  MatrixFiller filler(surface, settings);
  tbb::task_arena arena(settings.threads > 0 ? settings.threads : tbb::task_arena::automatic);
  return arena.execute([&] { return filler.run(); });
}

}  // namespace paver::validation
