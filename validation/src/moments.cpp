// In: surface, wave number. Out: the matrix. Steps: points of product rules on every element once; for each pair of
// elements that do not touch a product rule by their distance; for those that touch a rule for each two triangles of
// theirs, quads being cut in two; rows of one testing element as a task.
#include "moments.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <compare>
#include <complex>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>

#include "quadrature.h"

namespace paver::validation {
namespace {

using Complex = std::complex<double>;
using Block = Eigen::Matrix<Complex, 4, 4>;
constexpr Complex imaginary(0, 1);

/// Points each way by the gap between two elements, in mean sizes of theirs.
int points_at(double gap) { return gap < 0.3 ? 7 : gap < 0.7 ? 6 : gap < 1.5 ? 5 : gap < 3 ? 4 : 3; }
constexpr int least_points = 3, most_points = 7;

/// Densities of an element's sides at one place, with the weight.
struct Sample {
  Vec x, normal;  ///< normal of length one, out of a closed surface
  Vec density[4];
  double weight = 0, jacobian = 1;
};

Sample sample(const CurvedElement& element, double u, double v, double weight, double outward) {
  const ElementPoint at = element.at(u, v);
  const Vec normal = at.by_u.cross(at.by_v);
  Sample found{at.x, outward * normal.normalized(), {}, weight, normal.norm()};
  for (int side = 0; side < element.corners(); ++side) {
    const Density d = rooftop(element.corners(), side, u, v);
    found.density[side] = weight * (d.a * at.by_u + d.b * at.by_v);
  }
  return found;
}

struct SampledElement {
  Vec centre;
  double radius = 0;
  std::vector<Sample> by_points[most_points + 1];
};

/// Where the points of a pair rule lie on one of the elements.
struct PairPoints {
  Eigen::Matrix3Xd places, by_u, by_v, normals;
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

  PairTable(const Key& key, const std::vector<PairPoint>& rule) {
    const int corners = key.shape->corners();
    const Eigen::Vector2d p0 = parameters_of(corners, key.corner[0]), p1 = parameters_of(corners, key.corner[1]),
                          p2 = parameters_of(corners, key.corner[2]);
    const auto count = static_cast<Eigen::Index>(rule.size());
    for (Eigen::Index i = 0; i < count; ++i) {
      const PairPoint& point = rule[static_cast<std::size_t>(i)];
      const Eigen::Vector2d at = key.is_first ? point.first : point.second;
      const Eigen::Vector2d uv = p0 + at.x() * (p1 - p0) + at.y() * (p2 - p1);
      const Eigen::MatrixXd weights = key.shape->at(uv.x(), uv.y());
      if (i == 0) value_.resize(weights.cols(), count), by_u_ = by_v_ = value_;
      value_.col(i) = weights.row(0), by_u_.col(i) = weights.row(1), by_v_.col(i) = weights.row(2);
      for (int side = 0; side < corners; ++side) densities_.push_back(rooftop(corners, side, uv.x(), uv.y()));
    }
    sides_ = corners;
  }

  PairPoints on(const CurvedElement& element, double outward) const {
    PairPoints found{element.nodes * value_, element.nodes * by_u_, element.nodes * by_v_, {}};
    found.normals.resize(3, value_.cols());
    for (Eigen::Index i = 0; i < value_.cols(); ++i)
      found.normals.col(i) = outward * found.by_u.col(i).cross(found.by_v.col(i)).normalized();
    return found;
  }
  Vec density(const PairPoints& points, Eigen::Index i, int side) const {
    const Density& d = densities_[static_cast<std::size_t>(i * sides_ + side)];
    return d.a * points.by_u.col(i) + d.b * points.by_v.col(i);
  }

 private:
  int sides_ = 0;
  Eigen::MatrixXd value_, by_u_, by_v_;
  std::vector<Density> densities_;
};

class MatrixFiller {
 public:
  MatrixFiller(const MeshedSurface& surface, const Settings& settings)
      : surface_(surface), settings_(settings), k_(settings.wave_number) {
    for (int common = 0; common < 4; ++common)
      pair_rules_[common] = pair_rule(common, settings.singular_points + (common == 0 ? 1 : 0));
    for (const CurvedElement& element : surface.elements()) sampled_.push_back(sampled(element));
  }

  Eigen::MatrixXcd run() {
    matrix_ = Eigen::MatrixXcd::Zero(surface_.functions(), surface_.functions());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, sampled_.size(), 4), [&](const auto& range) {
      for (std::size_t p = range.begin(); p < range.end(); ++p) fill_rows(p);
    });
    return std::move(matrix_);
  }

 private:
  SampledElement sampled(const CurvedElement& element) const {
    SampledElement found;
    for (int n = least_points; n <= most_points; ++n)
      for (const RulePoint& q : product_rule(element.corners(), n))
        found.by_points[n].push_back(sample(element, q.u, q.v, q.weight, surface_.outward()));
    const auto& points = found.by_points[least_points];
    found.centre = Vec::Zero();
    for (const Sample& s : points) found.centre += s.x / static_cast<double>(points.size());
    for (Eigen::Index i = 0; i < element.nodes.cols(); ++i)
      found.radius = std::max(found.radius, (element.nodes.col(i) - found.centre).norm());
    return found;
  }

  void fill_rows(std::size_t p) {
    const CurvedElement& element = surface_.elements()[p];
    Eigen::MatrixXcd rows = Eigen::MatrixXcd::Zero(element.corners(), surface_.functions());
    for (std::size_t q = 0; q < sampled_.size(); ++q) {
      Block block = touching(p, q) ? near_block(p, q) : far_block(p, q);
      if (p == q) add_half(p, block);
      for (int t = 0; t < surface_.elements()[q].corners(); ++t)
        for (const Share& share : surface_.shares(q, t))
          for (int s = 0; s < element.corners(); ++s) rows(s, share.function) += share.sign * block(s, t);
    }
    const std::lock_guard guard(mutex_);
    for (int s = 0; s < element.corners(); ++s)
      for (const Share& share : surface_.shares(p, s)) matrix_.row(share.function) += share.sign * rows.row(s);
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
  Complex green(double r) const { return Complex(std::cos(k_ * r), -std::sin(k_ * r)) / (4 * M_PI * r); }
  /// Its gradient is this times the vector from the source.
  Complex slope(double r, Complex g) const { return -(1.0 + imaginary * (k_ * r)) * g / (r * r); }

  Block far_block(std::size_t p, std::size_t q) const {
    const SampledElement &one = sampled_[p], &two = sampled_[q];
    const double gap = ((one.centre - two.centre).norm() - one.radius - two.radius) / (one.radius + two.radius);
    const int n = points_at(gap);
    const int test_sides = surface_.elements()[p].corners(), sides = surface_.elements()[q].corners();
    const double divergences = divergence(test_sides) * divergence(sides);
    Block block = Block::Zero();
    for (const Sample& x : one.by_points[n]) {
      Complex sum = 0;
      Eigen::Matrix<Complex, 3, 4> flow = Eigen::Matrix<Complex, 3, 4>::Zero(), turn = flow;
      for (const Sample& y : two.by_points[n]) {
        const Vec way = x.x - y.x;
        const double r = way.norm();
        const Complex g = green(r);
        sum += y.weight * g;
        for (int t = 0; t < sides; ++t)
          for (int i = 0; i < 3; ++i) flow(i, t) += y.density[t](i) * g;
        if (has_magnetic()) {
          const Complex by = slope(r, g);
          for (int t = 0; t < sides; ++t) {
            const Vec across = way.cross(y.density[t]);
            for (int i = 0; i < 3; ++i) turn(i, t) += across(i) * by;
          }
        }
      }
      for (int s = 0; s < test_sides; ++s) {
        const Vec beside = x.density[s].cross(x.normal);
        for (int t = 0; t < sides; ++t) {
          Complex vectors = 0, rotated = 0;
          for (int i = 0; i < 3; ++i) vectors += x.density[s](i) * flow(i, t), rotated += beside(i) * turn(i, t);
          block(s, t) += weighted(electric(vectors, x.weight * sum, divergences), rotated);
        }
      }
    }
    return block;
  }

  bool has_magnetic() const { return settings_.electric_share < 1; }
  Complex weighted(Complex of_electric, Complex rotated) const {
    return settings_.electric_share * of_electric - (1 - settings_.electric_share) * free_space_impedance * rotated;
  }

  /// Corners of an element's triangles; a quad's two have corners 0 and 2 in common.
  static std::vector<std::array<int, 3>> triangles(int corners) {
    if (corners == 3) return {{0, 1, 2}};
    return {{0, 1, 2}, {0, 2, 3}};
  }

  Block near_block(std::size_t p, std::size_t q) const {
    Block block = Block::Zero();
    for (const auto& one : triangles(surface_.elements()[p].corners()))
      for (const auto& two : triangles(surface_.elements()[q].corners())) add_triangles(p, q, one, two, block);
    return block;
  }

  // Corners in common come first, in the same order in both.
  void add_triangles(std::size_t p, std::size_t q, std::array<int, 3> one, std::array<int, 3> two, Block& block) const {
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
    const PairTable& first = table({a.shape, one, common, true});
    const PairTable& second = table({b.shape, two, common, false});
    const PairPoints x = first.on(a, surface_.outward()), y = second.on(b, surface_.outward());
    const double divergences = divergence(a.corners()) * divergence(b.corners());
    const std::vector<PairPoint>& rule = pair_rules_[common];
    for (std::size_t n = 0; n < rule.size(); ++n) {
      const auto i = static_cast<Eigen::Index>(n);
      const Vec way = x.places.col(i) - y.places.col(i);
      const double r = way.norm();
      const Complex g = green(r), by = has_magnetic() ? slope(r, g) : 0;
      for (int s = 0; s < a.corners(); ++s) {
        const Vec density = first.density(x, i, s);
        const Vec beside = density.cross(x.normals.col(i)).cross(way);
        for (int t = 0; t < b.corners(); ++t) {
          const Vec other = second.density(y, i, t);
          block(s, t) +=
              rule[n].weight * weighted(electric(density.dot(other) * g, g, divergences), beside.dot(other) * by);
        }
      }
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
    for (const Sample& x : sampled_[p].by_points[most_points])
      for (int s = 0; s < sides; ++s)
        for (int t = 0; t < sides; ++t)
          block(s, t) += (1 - settings_.electric_share) * free_space_impedance * 0.5 * x.density[s].dot(x.density[t]) /
                         (x.weight * x.jacobian);
  }

  const MeshedSurface& surface_;
  const Settings& settings_;
  double k_;
  std::vector<PairPoint> pair_rules_[4];
  std::vector<SampledElement> sampled_;
  Eigen::MatrixXcd matrix_;
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

Eigen::MatrixXcd moment_matrix(const MeshedSurface& surface, const Settings& settings) {
  check(surface, settings);
  MatrixFiller filler(surface, settings);
  tbb::task_arena arena(settings.threads > 0 ? settings.threads : tbb::task_arena::automatic);
  return arena.execute([&] { return filler.run(); });
}

}  // namespace paver::validation
