// Bounds of the Jacobian determinant of one element: nodes -> control points -> det in Bernstein form -> sign.
//
//   1. control points x, relative to the first node; mean of x_u x x_v gives the normal n and the mean of det
//   2. x is projected along n: det = 2-D cross product of the projected x_u and x_v, divided by its mean
//   3. all coefficients positive (above what rounding may hide): valid; a value at a corner or on the lattice not
//      positive: invalid
//   4. else split in four and look again; 8 levels, then undecided
// The steps and limits follow core/docs/quality.md, "Curved elements". Source: [Johnen13].
#include "quality/jacobian/jacobian.h"

#include <algorithm>
#include <limits>

#include "mesh/element_table.h"

namespace paver {
namespace {

constexpr int most_levels = 8;   // of splitting for the sign
constexpr int close_levels = 2;  // of splitting for a closer bound

/// Unit vectors s, t with s x t = n.
void plane_of(Vec3 n, Vec3& s, Vec3& t) {
  double x = std::fabs(n.x), y = std::fabs(n.y), z = std::fabs(n.z);
  Vec3 axis = x <= y && x <= z ? Vec3{1, 0, 0} : (y <= z ? Vec3{0, 1, 0} : Vec3{0, 0, 1});
  s = unit(cross(axis, n));
  t = cross(n, s);
}

double least(const double* c, int count) { return *std::min_element(c, c + count); }

double least_of(const double* c, const std::vector<int>& which) {
  double result = c[which[0]];
  for (int i : which) result = std::min(result, c[i]);
  return result;
}

}  // namespace

struct JacobianForm::Split {
  double enough;
  bool is_invalid = false;
  double low = std::numeric_limits<double>::infinity();
};

bool JacobianForm::coefficients(const Vec3* x, Coefficients& c) const {
  std::array<Vec3, max_nodes> control{};
  for (const Weight& term : to_control_) control[term.out] += term.weight * (x[term.in] - x[0]);
  Vec3 vector;
  for (const Pair& pair : mean_) vector += pair.weight * cross(control[pair.a], control[pair.b]);
  double mean = norm(vector);
  if (!(mean > 0 && mean < std::numeric_limits<double>::infinity())) return false;
  Vec3 s, t;
  plane_of((1 / mean) * vector, s, t);
  std::array<Vec2, max_nodes> flat, u, v;
  for (int i = 0; i < nodes_; ++i) flat[i] = {dot(control[i], s), dot(control[i], t)};
  for (std::size_t i = 0; i < du_.size(); ++i) u[i] = flat[du_[i].to] - flat[du_[i].from];
  for (std::size_t i = 0; i < dv_.size(); ++i) v[i] = flat[dv_[i].to] - flat[dv_[i].from];
  std::fill_n(c.begin(), count_, 0.0);
  for (const Product& term : products_) c[term.out] += term.weight * cross(u[term.u], v[term.v]);
  for (int i = 0; i < count_; ++i) c[i] /= mean;
  return std::all_of(c.begin(), c.begin() + count_, [](double value) { return std::isfinite(value); });
}

// Column by column: sums of the same terms in the same order as row by row, side by side in the registers.
void JacobianForm::apply(const std::vector<double>& columns, const Coefficients& c, Coefficients& result) const {
  std::fill_n(result.begin(), count_, 0.0);
  const double* column = columns.data();
  for (int k = 0; k < count_; ++k, column += count_)
    for (int i = 0; i < count_; ++i) result[i] += column[i] * c[k];
}

// Quarters of quarters have no lower bound than these, so the lowest goes first and those above what is known stay.
void JacobianForm::split(const Coefficients& c, int level, Split& state) const {
  std::array<Coefficients, 4> quarters;
  std::array<std::pair<double, int>, 4> order;
  for (int k = 0; k < 4; ++k) {
    apply(children_[k], c, quarters[k]);
    if (least_of(quarters[k].data(), corners_) <= flat_ratio) {
      state.is_invalid = true;
      return;
    }
    order[k] = {least(quarters[k].data(), count_), k};
  }
  std::ranges::sort(order);
  for (const auto& [low, k] : order) {
    const bool is_doubtful = low <= flat_ratio || (low < state.enough && low < state.low && level < close_levels);
    if (is_doubtful && level < most_levels - 1) {
      split(quarters[k], level + 1, state);
      if (state.is_invalid) return;
    } else {
      state.low = std::min(state.low, low);
    }
  }
}

JacobianBound JacobianForm::bound(const Vec3* x, double enough) const {
  Coefficients c;
  if (!coefficients(x, c)) return {Validity::invalid, 0};
  double low = least(c.data(), count_);
  if (low > flat_ratio && low >= enough) return {Validity::valid, low};
  double sampled = low;
  if (low <= flat_ratio) {
    Coefficients values;
    apply(samples_, c, values);
    sampled = std::min(least_of(c.data(), corners_), least(values.data(), count_));
  }
  if (sampled > flat_ratio) {
    Split state{enough};
    split(c, 0, state);
    if (!state.is_invalid) return {state.low > flat_ratio ? Validity::valid : Validity::undecided, state.low};
  }
  return {Validity::invalid, std::min(sampled, 0.0)};
}

double JacobianForm::area(const Vec3* x) const {
  double area = 0;
  for (auto q = quadrature_.begin(); q != quadrature_.end(); q += 1 + 2 * nodes_) {
    Vec3 xu, xv;
    for (int k = 0; k < nodes_; ++k) {
      xu += *(q + 1 + k) * x[k];
      xv += *(q + 1 + nodes_ + k) * x[k];
    }
    area += *q * norm(cross(xu, xv));
  }
  return area;
}

namespace {

template <ElementShape shape, int order>
const JacobianForm& built_form() {
  static const JacobianForm form(shape, order);
  return form;
}

}  // namespace

const JacobianForm& jacobian_form(ElementShape shape, int order) {
  using Get = const JacobianForm& (*)();
  static constexpr std::array<Get, JacobianForm::max_order> quads{
      built_form<ElementShape::quad, 1>, built_form<ElementShape::quad, 2>, built_form<ElementShape::quad, 3>,
      built_form<ElementShape::quad, 4>};
  static constexpr std::array<Get, JacobianForm::max_order> triangles{
      built_form<ElementShape::triangle, 1>, built_form<ElementShape::triangle, 2>,
      built_form<ElementShape::triangle, 3>, built_form<ElementShape::triangle, 4>};
  return (shape == ElementShape::quad ? quads : triangles).at(static_cast<std::size_t>(order) - 1)();
}

bool is_valid(const SurfaceMesh& mesh, bool is_quad, int element) {
  const JacobianForm& form = jacobian_form(is_quad ? ElementShape::quad : ElementShape::triangle, mesh.order);
  const int* nodes = ElementTable(mesh, is_quad).row(static_cast<std::size_t>(element));
  std::array<Vec3, JacobianForm::max_nodes> x;
  for (int k = 0; k < form.node_count(); ++k) x[k] = mesh.nodes[nodes[k]];
  return form.is_valid(x.data());
}

}  // namespace paver
