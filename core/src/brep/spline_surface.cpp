// Basis functions by the recurrence of Cox and de Boor, then one pass over the poles of the span.
#include "brep/spline_surface.h"

#include <algorithm>

namespace paver {
namespace {

// Derivatives are differences: N'[r] = degree (q[r - 1] - q[r]), q the basis functions of one degree less by the widths
// of their supports.
void differentiate(const double* quotients, int degree, double* out) {
  double before = 0;
  for (int r = 0; r < degree; ++r) {
    out[r] = degree * (before - quotients[r]);
    before = quotients[r];
  }
  out[degree] = degree * before;
}

void add(Pole& sum, double weight, const Pole& p) {
  sum.xy += weight * p.xy;
  sum.zw += weight * p.zw;
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

void SplineBasis::evaluate(int span, double t, int order, Values& out) const {
  double left[most_degree + 1], right[most_degree + 1], quotient[most_degree + 1], lower_first[most_degree + 1];
  double* value = out.value;
  value[0] = 1;
  out.first[0] = out.second[0] = lower_first[0] = 0;
  for (int k = 1; k <= degree_; ++k) {
    left[k] = t - knots_[span + 1 - k];
    right[k] = knots_[span + k] - t;
    const double* share = shares(k, span);
    double saved = 0;
    for (int r = 0; r < k; ++r) {
      quotient[r] = value[r] * share[r];
      value[r] = saved + right[r + 1] * quotient[r];
      saved = left[k - r] * quotient[r];
    }
    value[k] = saved;
    if (order > 1 && k == degree_ - 1) differentiate(quotient, k, lower_first);
    if (order > 0 && k == degree_) differentiate(quotient, k, out.first);
    if (order > 1 && k == degree_) {
      for (int r = 0; r < k; ++r) quotient[r] = lower_first[r] * share[r];
      differentiate(quotient, k, out.second);
    }
  }
}

template <int order>
void SplineSurface::sum_poles(double u, double v, SurfaceJet& jet) const {
  const SplineNet& net = *net_;
  const int m = net.u.degree(), n = net.v.degree();
  SplineBasis::Values bu, bv;
  net.u.evaluate(span_u_, u, order, bu);
  net.v.evaluate(span_v_, v, order, bv);
  Pole sum[6]{};  // x, u, v, uu, uv, vv
  for (int i = 0; i <= m; ++i) {
    const Pole* row = &net.poles[static_cast<std::size_t>(span_u_ - m + i) * net.v.count() + span_v_ - n];
    Pole at{}, along{}, bend{};
    for (int j = 0; j <= n; ++j) {
      add(at, bv.value[j], row[j]);
      if constexpr (order > 0) add(along, bv.first[j], row[j]);
      if constexpr (order > 1) add(bend, bv.second[j], row[j]);
    }
    add(sum[0], bu.value[i], at);
    if constexpr (order > 0) add(sum[1], bu.first[i], at), add(sum[2], bu.value[i], along);
    if constexpr (order > 1)
      add(sum[3], bu.second[i], at), add(sum[4], bu.first[i], along), add(sum[5], bu.value[i], bend);
  }
  if (net.is_rational) return divide_by_weight(sum, order, jet);
  jet = {head(sum[0]), head(sum[1]), head(sum[2]), head(sum[3]), head(sum[4]), head(sum[5])};
}

void SplineSurface::evaluate(double u, double v, int order, SurfaceJet& jet) const {
  span_u_ = net_->u.find_span(u, span_u_);
  span_v_ = net_->v.find_span(v, span_v_);
  if (order == 0) return sum_poles<0>(u, v, jet);
  if (order == 1) return sum_poles<1>(u, v, jet);
  sum_poles<2>(u, v, jet);
}

}  // namespace paver
