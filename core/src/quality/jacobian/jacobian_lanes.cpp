// JacobianForm and scaled Jacobian for several elements side by side: the same operations in the same order as for one,
// so the figures are the same bit for bit, on processors with wide registers several times faster.
#include <algorithm>
#include <type_traits>

#include "base/wide_registers.h"
#include "quality/jacobian/jacobian.h"
#include "quality/metrics.h"

#pragma GCC diagnostic ignored "-Wpsabi"  // no function here passes vectors to another object file

namespace paver {
namespace {

// As wide as the registers: wider vectors are slower than numbers one by one.
typedef double TwoDoubles __attribute__((vector_size(2 * sizeof(double))));
typedef double FourDoubles __attribute__((vector_size(4 * sizeof(double))));

template <int width>
struct Wide {
  using Lane = std::conditional_t<width == 4, FourDoubles, TwoDoubles>;

  struct Lane2 {
    Lane x, y;
  };
  struct Lane3 {
    Lane x, y, z;
  };

  static PAVER_IN_PLACE Lane all(double value) { return Lane{} + value; }
  static PAVER_IN_PLACE Lane3 load(const JacobianForm::Lanes* x) {
    return {*reinterpret_cast<const Lane*>(x[0].of), *reinterpret_cast<const Lane*>(x[1].of),
            *reinterpret_cast<const Lane*>(x[2].of)};
  }
  static PAVER_IN_PLACE void store(Lane value, double* to) { *reinterpret_cast<Lane*>(to) = value; }
  static PAVER_IN_PLACE Lane3 minus(const Lane3& a, const Lane3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  static PAVER_IN_PLACE void add(Lane3& sum, double weight, const Lane3& a) {
    sum.x += weight * a.x;
    sum.y += weight * a.y;
    sum.z += weight * a.z;
  }
  static PAVER_IN_PLACE Lane dot(const Lane3& a, const Lane3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  static PAVER_IN_PLACE Lane3 cross(const Lane3& a, const Lane3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
  static PAVER_IN_PLACE Lane root(Lane a) {
    Lane result;
    for (int i = 0; i < width; ++i) result[i] = std::sqrt(a[i]);
    return result;
  }
  static PAVER_IN_PLACE Lane norm(const Lane3& a) { return root(dot(a, a)); }
  static PAVER_IN_PLACE Lane smaller(Lane a, Lane b) { return b < a ? b : a; }
  static PAVER_IN_PLACE Lane magnitude(Lane a) { return a < 0 ? -a : a; }
  static PAVER_IN_PLACE Lane3 unit(const Lane3& a) {
    Lane n = norm(a), scale = 1 / (n > 0 ? n : all(1));
    return {scale * a.x, scale * a.y, scale * a.z};
  }

  /// Unit vectors s, t with s x t = n.
  static PAVER_IN_PLACE void plane_of(const Lane3& n, Lane3& s, Lane3& t) {
    Lane x = magnitude(n.x), y = magnitude(n.y), z = magnitude(n.z);
    Lane one = all(1), zero = all(0);
    Lane is_x = x <= y ? (x <= z ? one : zero) : zero;
    Lane is_y = is_x > 0 ? zero : (y <= z ? one : zero);
    Lane is_z = one - is_x - is_y;
    s = unit(cross({is_x, is_y, is_z}, n));
    t = cross(n, s);
  }

  static PAVER_IN_PLACE Lane corner_jacobian(const Lane3& next, const Lane3& previous, const Lane3& normal) {
    Lane lengths = root(dot(next, next) * dot(previous, previous));
    return lengths > 0 ? dot(cross(next, previous), normal) / (lengths > 0 ? lengths : all(1)) : all(0);
  }

  /// Straight-sided scaled Jacobian from the corners.
  static PAVER_IN_PLACE Lane least_corner(const JacobianForm::Lanes* x, int corners) {
    Lane3 first = load(x), second = load(x + 3), third = load(x + 6);
    Lane3 normal = corners == 4 ? unit(cross(minus(third, first), minus(load(x + 9), second)))
                                : unit(cross(minus(second, first), minus(third, first)));
    Lane least = all(0);
    for (int k = 0; k < corners; ++k) {
      Lane3 at = load(x + 3 * k);
      Lane3 next = minus(load(x + 3 * ((k + 1) % corners)), at);
      Lane3 previous = minus(load(x + 3 * ((k + corners - 1) % corners)), at);
      Lane value = corner_jacobian(next, previous, normal);
      least = k == 0 ? value : smaller(least, value);
    }
    return least;
  }
};

}  // namespace

template <int width>
PAVER_IN_PLACE void JacobianForm::bound_wide(const Lanes* x, int lane, Lanes& least) const {
  using W = Wide<width>;
  using Lane = typename W::Lane;
  using Lane3 = typename W::Lane3;
  x = reinterpret_cast<const Lanes*>(x->of + lane);
  Lane3 control[max_nodes], origin = W::load(x);
  std::fill_n(control, nodes_, Lane3{});
  for (const Weight& term : to_control_)
    W::add(control[term.out], term.weight, W::minus(W::load(x + 3 * term.in), origin));
  Lane3 vector{};
  for (const Pair& pair : mean_) W::add(vector, pair.weight, W::cross(control[pair.a], control[pair.b]));
  Lane mean = W::norm(vector), inverse = 1 / mean;
  Lane3 s, t;
  W::plane_of({inverse * vector.x, inverse * vector.y, inverse * vector.z}, s, t);
  typename W::Lane2 flat[max_nodes], u[max_nodes], v[max_nodes];
  for (int i = 0; i < nodes_; ++i) flat[i] = {W::dot(control[i], s), W::dot(control[i], t)};
  for (std::size_t i = 0; i < du_.size(); ++i)
    u[i] = {flat[du_[i].to].x - flat[du_[i].from].x, flat[du_[i].to].y - flat[du_[i].from].y};
  for (std::size_t i = 0; i < dv_.size(); ++i)
    v[i] = {flat[dv_[i].to].x - flat[dv_[i].from].x, flat[dv_[i].to].y - flat[dv_[i].from].y};
  Lane c[max_coefficients] = {};
  for (const Product& term : products_)
    c[term.out] += term.weight * (u[term.u].x * v[term.v].y - u[term.u].y * v[term.v].x);
  Lane low = c[0] / mean, sum = low;
  for (int i = 1; i < count_; ++i) {
    Lane value = c[i] / mean;
    low = W::smaller(low, value);
    sum += value;
  }
  // A sum that is not finite betrays any coefficient that is not.
  W::store(sum - sum == 0 ? low : W::all(-1), least.of + lane);
}

template <int width>
PAVER_IN_PLACE void JacobianForm::measure_wide(const Lanes* x, int lane, LaneFigures& figures) const {
  using W = Wide<width>;
  using Lane = typename W::Lane;
  using Lane3 = typename W::Lane3;
  bound_wide<width>(x, lane, figures.low);
  x = reinterpret_cast<const Lanes*>(x->of + lane);
  W::store(shape_ == ElementShape::quad ? W::least_corner(x, 4) : triangle_scale * W::least_corner(x, 3),
           figures.sj.of + lane);

  Lane area = W::all(0);
  const double* q = quadrature_.data();
  for (std::size_t points = quadrature_.size() / (1 + 2 * static_cast<std::size_t>(nodes_)); points > 0; --points) {
    const double *by_u = q + 1, *by_v = by_u + nodes_;
    Lane3 xu{}, xv{};
    for (int k = 0; k < nodes_; ++k) {
      Lane3 node = W::load(x + 3 * k);
      W::add(xu, by_u[k], node);
      W::add(xv, by_v[k], node);
    }
    area += *q * W::norm(W::cross(xu, xv));
    q = by_v + nodes_;
  }
  W::store(area, figures.area.of + lane);
}

#ifdef PAVER_HAS_AVX2
__attribute__((target("avx2"))) void JacobianForm::measure_lanes_avx2(const Lanes* x, LaneFigures& figures) const {
  measure_wide<4>(x, 0, figures);
}
__attribute__((target("avx2"))) void JacobianForm::bound_lanes_avx2(const Lanes* x, Lanes& low) const {
  bound_wide<4>(x, 0, low);
}
#endif

void JacobianForm::measure_lanes(const Lanes* x, LaneFigures& figures) const {
#ifdef PAVER_HAS_AVX2
  if (has_avx2()) return measure_lanes_avx2(x, figures);
#endif
  for (int lane = 0; lane < lanes; lane += 2) measure_wide<2>(x, lane, figures);
}

void JacobianForm::bound_lanes(const Lanes* x, Lanes& low) const {
#ifdef PAVER_HAS_AVX2
  if (has_avx2()) return bound_lanes_avx2(x, low);
#endif
  for (int lane = 0; lane < lanes; lane += 2) bound_wide<2>(x, lane, low);
}

}  // namespace paver
