// Basis functions by the recurrence of Cox and de Boor, then one pass over the poles of the span.
#include "brep/surfaces/spline_surface.h"

#include <algorithm>

#include "base/wide_registers.h"

#pragma GCC diagnostic ignored "-Wpsabi"  // no function here passes vectors to another object file
#define PAVER_UNROLL _Pragma("GCC unroll 16")

namespace paver {
namespace {

/// A sum of poles in registers of two numbers.
struct NarrowSum {
  Pole::Pair xy, zw;
  PAVER_IN_PLACE void load(const Pole& p) { xy = p.xy, zw = p.zw; }
  PAVER_IN_PLACE void store(Pole& p) const { p.xy = xy, p.zw = zw; }
  PAVER_IN_PLACE void add(double weight, const NarrowSum& p) {
    xy += weight * p.xy;
    zw += weight * p.zw;
  }
};

/// The same in one of four: for processors that have these, gcc keeps it in memory on others.
struct WideSum {
  typedef double Four __attribute__((vector_size(32), may_alias));
  Four xyzw;
  PAVER_IN_PLACE void load(const Pole& p) { xyzw = *reinterpret_cast<const Four*>(&p); }
  PAVER_IN_PLACE void store(Pole& p) const { *reinterpret_cast<Four*>(&p) = xyzw; }
  PAVER_IN_PLACE void add(double weight, const WideSum& p) { xyzw += weight * p.xyzw; }
};

// Derivatives are differences: N'[r] = degree (q[r - 1] - q[r]), q the basis functions of one degree less by the widths
// of their supports.
PAVER_IN_PLACE void differentiate(const double* quotients, int degree, double* out) {
  double before = 0;
  PAVER_UNROLL for (int r = 0; r < degree; ++r) {
    out[r] = degree * (before - quotients[r]);
    before = quotients[r];
  }
  out[degree] = degree * before;
}

Vec3 head(const Pole& p) { return {p.xy[0], p.xy[1], p.zw[0]}; }
double weight(const Pole& p) { return p.zw[1]; }

// From homogeneous coordinates by the rule for derivatives of a quotient.
void divide_by_weight(const Pole (&sum)[6], int order, SurfaceJet& jet) {
  const Pole &a = sum[0], &u = sum[1], &v = sum[2], &uu = sum[3], &uv = sum[4], &vv = sum[5];
  double scale = 1 / weight(a);
  jet.x = scale * head(a);
  if (order < 1) return;
  jet.u = scale * (head(u) - weight(u) * jet.x);
  jet.v = scale * (head(v) - weight(v) * jet.x);
  if (order < 2) return;
  jet.uu = scale * (head(uu) - 2 * weight(u) * jet.u - weight(uu) * jet.x);
  jet.uv = scale * (head(uv) - weight(u) * jet.v - weight(v) * jet.u - weight(uv) * jet.x);
  jet.vv = scale * (head(vv) - 2 * weight(v) * jet.v - weight(vv) * jet.x);
}

}  // namespace

SplineBasis::SplineBasis(int degree, std::vector<double> knots)
    : degree_(degree), count_(static_cast<int>(knots.size()) - degree - 1), knots_(std::move(knots)) {
  share_.assign(knots_.size() * degree_, 0);
  for (int k = 1; k <= degree_; ++k)
    for (std::size_t i = 0; i + k < knots_.size(); ++i)
      if (double width = knots_[i + k] - knots_[i]; width > 0) share_[(k - 1) * knots_.size() + i] = 1 / width;
}

int SplineBasis::find_span(double t, int last) const {
  if (last >= degree_ && last < count_ && knots_[last] <= t && t < knots_[last + 1]) return last;
  auto begin = knots_.begin() + degree_, end = knots_.begin() + count_ + 1;
  auto after = std::upper_bound(begin, end, t);
  if (after == begin) after = std::upper_bound(begin, end, *begin);
  if (after == end) after = std::lower_bound(begin, end, knots_[count_]);
  return static_cast<int>(after - knots_.begin()) - 1;
}

template <int fixed, int order>
PAVER_IN_PLACE void SplineBasis::recur(int span, double t, Values& out) const {
  constexpr int room = (fixed > 0 ? fixed : most_degree) + 1;
  const int degree = fixed > 0 ? fixed : degree_;
  double left[room], right[room], quotient[room], lower_first[room], value[room];
  value[0] = 1;
  out.first[0] = out.second[0] = lower_first[0] = 0;
  PAVER_UNROLL for (int k = 1; k <= degree; ++k) {
    left[k] = t - knots_[span + 1 - k];
    right[k] = knots_[span + k] - t;
    const double* share = shares(k, span);
    double saved = 0;
    PAVER_UNROLL for (int r = 0; r < k; ++r) {
      quotient[r] = value[r] * share[r];
      value[r] = saved + right[r + 1] * quotient[r];
      saved = left[k - r] * quotient[r];
    }
    value[k] = saved;
    if (order > 1 && k == degree - 1) differentiate(quotient, k, lower_first);
    if (order > 0 && k == degree) differentiate(quotient, k, out.first);
    if (order > 1 && k == degree) {
      PAVER_UNROLL for (int r = 0; r < k; ++r) quotient[r] = lower_first[r] * share[r];
      differentiate(quotient, k, out.second);
    }
  }
  PAVER_UNROLL for (int r = 0; r <= degree; ++r) out.value[r] = value[r];
}

// With the degree known the compiler keeps the recurrence in registers.
template <int order>
void SplineBasis::evaluate(int span, double t, Values& out) const {
  switch (degree_) {
    case 1:
      return recur<1, order>(span, t, out);
    case 2:
      return recur<2, order>(span, t, out);
    case 3:
      return recur<3, order>(span, t, out);
    case 4:
      return recur<4, order>(span, t, out);
    case 5:
      return recur<5, order>(span, t, out);
    case 6:
      return recur<6, order>(span, t, out);
    case 7:
      return recur<7, order>(span, t, out);
    case 8:
      return recur<8, order>(span, t, out);
    default:
      return recur<0, order>(span, t, out);
  }
}

// Adds the poles of `rows` basis functions of u from i on: several at a time share the values of those of v.
template <int order, class Sum, int rows>
PAVER_IN_PLACE void SplineSurface::add_rows(int i, const SplineBasis::Values& bu, const SplineBasis::Values& bv,
                                            Sum (&sum)[6]) const {
  const SplineNet& net = *net_;
  const int m = net.u.degree(), n = net.v.degree();
  const std::size_t stride = static_cast<std::size_t>(net.v.count());
  const Pole* row = &net.poles[static_cast<std::size_t>(span_u_ - m + i) * stride + span_v_ - n];
  Sum at[rows]{}, along[rows]{}, bend[rows]{};
  for (int j = 0; j <= n; ++j) {
    PAVER_UNROLL for (int k = 0; k < rows; ++k) {
      Sum pole;
      pole.load(row[k * stride + j]);
      at[k].add(bv.value[j], pole);
      if constexpr (order > 0) along[k].add(bv.first[j], pole);
      if constexpr (order > 1) bend[k].add(bv.second[j], pole);
    }
  }
  PAVER_UNROLL for (int k = 0; k < rows; ++k) {
    sum[0].add(bu.value[i + k], at[k]);
    if constexpr (order > 0) sum[1].add(bu.first[i + k], at[k]), sum[2].add(bu.value[i + k], along[k]);
    if constexpr (order > 1)
      sum[3].add(bu.second[i + k], at[k]), sum[4].add(bu.first[i + k], along[k]), sum[5].add(bu.value[i + k], bend[k]);
  }
}

template <int order, class Sum>
PAVER_IN_PLACE void SplineSurface::sum_poles(const SplineBasis::Values& bu, const SplineBasis::Values& bv,
                                             Pole (&result)[6]) const {
  Sum sum[6]{};  // x, u, v, uu, uv, vv
  constexpr int rows = 3;
  int i = 0;
  for (; i + rows <= net_->u.degree() + 1; i += rows) add_rows<order, Sum, rows>(i, bu, bv, sum);
  for (; i <= net_->u.degree(); ++i) add_rows<order, Sum, 1>(i, bu, bv, sum);
  for (int k = 0; k < (order + 1) * (order + 2) / 2; ++k) sum[k].store(result[k]);
}

#ifdef PAVER_HAS_AVX2
template <int order>
__attribute__((target("avx2"))) void SplineSurface::sum_poles_avx2(const SplineBasis::Values& bu,
                                                                   const SplineBasis::Values& bv,
                                                                   Pole (&sum)[6]) const {
  sum_poles<order, WideSum>(bu, bv, sum);
}
#endif

template <int order>
void SplineSurface::evaluate(double u, double v, SurfaceJet& jet) const {
  SplineBasis::Values bu, bv;
  net_->u.evaluate<order>(span_u_, u, bu);
  net_->v.evaluate<order>(span_v_, v, bv);
  Pole sum[6];
#ifdef PAVER_HAS_AVX2
  if (has_avx2())
    sum_poles_avx2<order>(bu, bv, sum);
  else
#endif
    sum_poles<order, NarrowSum>(bu, bv, sum);
  if (net_->is_rational) return divide_by_weight(sum, order, jet);
  jet.x = head(sum[0]);
  if constexpr (order > 0) jet.u = head(sum[1]), jet.v = head(sum[2]);
  if constexpr (order > 1) jet.uu = head(sum[3]), jet.uv = head(sum[4]), jet.vv = head(sum[5]);
}

void SplineSurface::evaluate(double u, double v, int order, SurfaceJet& jet) const {
  span_u_ = net_->u.find_span(u, span_u_);
  span_v_ = net_->v.find_span(v, span_v_);
  if (order == 0) return evaluate<0>(u, v, jet);
  if (order == 1) return evaluate<1>(u, v, jet);
  evaluate<2>(u, v, jet);
}

}  // namespace paver
