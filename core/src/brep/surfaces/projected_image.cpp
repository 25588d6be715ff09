// Image of an edge on a face by projection of the edge's curve, for files whose own images run at another pace than
// the curve or leave it. A table of projected points, walked from the start so that it stays on the right side of a
// periodic surface, gives the guess; a few Gauss-Newton steps give the foot of the perpendicular.
#include <Standard_Failure.hxx>
#include <TopLoc_Location.hxx>
#include <algorithm>
#include <cmath>
#include <vector>

#include "brep/occt_impl.h"
#include "brep/occt_shapes_impl.h"
#include "brep/surfaces/evaluators_impl.h"

namespace paver {
namespace {

constexpr int table_intervals = 128;
constexpr int table_steps = 30, query_steps = 6;
constexpr int halvings = 8;
constexpr int seeds = 24;  // each way
/// A foot farther off than this share of the curve's length is looked for all over the surface.
constexpr double lost_share = 0.01;

struct Foot {
  Vec2 uv;
  double distance2 = 0;
};

/// Nearest point on a surface from a good guess. Has no cache: safe from several threads.
class FootFinder {
 public:
  explicit FootFinder(const TopoDS_Face& face) {
    TopLoc_Location location;
    surface_ = untrimmed(BRep_Tool::Surface(face, location));
    placement_ = location.Transformation();
    surface_->Bounds(lo_.x, hi_.x, lo_.y, hi_.y);
    if (surface_->IsUPeriodic()) period_.x = surface_->UPeriod();
    if (surface_->IsVPeriodic()) period_.y = surface_->VPeriod();
    is_bounded_u_ = !surface_->IsUPeriodic() && !Precision::IsInfinite(lo_.x) && !Precision::IsInfinite(hi_.x);
    is_bounded_v_ = !surface_->IsVPeriodic() && !Precision::IsInfinite(lo_.y) && !Precision::IsInfinite(hi_.y);
  }

  Foot find(Vec3 x, Vec2 guess, int steps) const {
    Foot foot{clamped(guess), 0};
    Vec3 s, su, sv;
    evaluate(foot.uv, s, su, sv);
    foot.distance2 = dot(x - s, x - s);
    for (int i = 0; i < steps && foot.distance2 > 0; ++i) {
      double a = dot(su, su), b = dot(su, sv), c = dot(sv, sv), determinant = a * c - b * b;
      Vec2 gradient{dot(x - s, su), dot(x - s, sv)};
      // Where the surface has no tangent plane, move along the one direction there is.
      Vec2 step = determinant > 1e-14 * a * c
                      ? (1 / determinant) * Vec2{c * gradient.x - b * gradient.y, a * gradient.y - b * gradient.x}
                      : Vec2{a > c ? gradient.x / a : 0, a <= c && c > 0 ? gradient.y / c : 0};
      if (!improve(x, {within(step.x, period_.x), within(step.y, period_.y)}, foot, s, su, sv)) break;
    }
    return foot;
  }

  /// The same from the nearest of many places all over the surface; along a direction without ends only from the guess.
  Foot find_anywhere(Vec3 x, Vec2 guess, int steps) const {
    auto places = [](double lo, double hi, double guessed) {
      std::vector<double> result{guessed};
      for (int i = 0; i <= seeds && !Precision::IsInfinite(lo) && !Precision::IsInfinite(hi); ++i)
        result.push_back(lo + (hi - lo) * i / seeds);
      return result;
    };
    Vec2 nearest = guess;
    double least = INFINITY;
    for (const double u : places(lo_.x, hi_.x, guess.x))
      for (const double v : places(lo_.y, hi_.y, guess.y)) {
        const Vec3 away = x - point({u, v});
        if (dot(away, away) < least) least = dot(away, away), nearest = {u, v};
      }
    return find(x, nearest, steps);
  }

  /// Whether a good part of the surface lies between two places, either way.
  bool are_far_apart(Vec2 a, Vec2 b) const {
    constexpr double far_share = 0.125;
    const Vec2 size{period_.x > 0 ? period_.x : hi_.x - lo_.x, period_.y > 0 ? period_.y : hi_.y - lo_.y};
    return std::fabs(a.x - b.x) > far_share * size.x || std::fabs(a.y - b.y) > far_share * size.y;
  }

  /// The same place of a periodic surface nearest to `other`.
  Vec2 next_to(Vec2 uv, Vec2 other) const { return nearest_image(uv, other, period_); }

  Vec3 point(Vec2 uv) const {
    Vec3 s, su, sv;
    evaluate(uv, s, su, sv);
    return s;
  }

 private:
  bool improve(Vec3 x, Vec2 step, Foot& foot, Vec3& s, Vec3& su, Vec3& sv) const {
    for (int h = 0; h < halvings; ++h, step = 0.5 * step) {
      Vec2 uv = clamped(foot.uv + step);
      Vec3 p, pu, pv;
      evaluate(uv, p, pu, pv);
      double distance2 = dot(x - p, x - p);
      if (distance2 >= foot.distance2) continue;
      foot = {uv, distance2};
      s = p;
      su = pu;
      sv = pv;
      return true;
    }
    return false;
  }

  /// Beside a pole a step may be of any length.
  static double within(double step, double period) {
    return period > 0 ? std::clamp(step, -0.5 * period, 0.5 * period) : step;
  }

  Vec2 clamped(Vec2 uv) const {
    if (is_bounded_u_) uv.x = std::clamp(uv.x, lo_.x, hi_.x);
    if (is_bounded_v_) uv.y = std::clamp(uv.y, lo_.y, hi_.y);
    return uv;
  }

  void evaluate(Vec2 uv, Vec3& s, Vec3& su, Vec3& sv) const {
    gp_Pnt p;
    gp_Vec u, v;
    surface_->D1(uv.x, uv.y, p, u, v);
    s = to_vec(p.Transformed(placement_));
    su = to_vec(u.Transformed(placement_));
    sv = to_vec(v.Transformed(placement_));
  }

  Handle(Geom_Surface) surface_;
  gp_Trsf placement_;
  Vec2 lo_, hi_, period_;
  bool is_bounded_u_ = false, is_bounded_v_ = false;
};

class ProjectedImage : public ParameterCurve {
 public:
  ProjectedImage(const TopoDS_Face& face, std::shared_ptr<const Curve> curve, const ParameterCurve& rough, double t0,
                 double t1)
      : finder_(face), curve_(std::move(curve)), t0_(t0), t1_(t1) {
    const double lost = lost_share * curve_length();
    for (int i = 0; i <= table_intervals; ++i) {
      double t = t0 + (t1 - t0) * i / table_intervals;
      Vec3 x = curve_->point(t);
      Foot foot = finder_.find(x, rough.uv(t), table_steps);
      if (i > 0) {
        Foot walked = finder_.find(x, table_.back(), table_steps);
        if (walked.distance2 <= foot.distance2) foot = walked;
      }
      if (foot.distance2 > lost * lost) {
        const Foot found = finder_.find_anywhere(x, foot.uv, table_steps);
        if (found.distance2 < foot.distance2) foot = found;
      }
      table_.push_back(i > 0 ? finder_.next_to(foot.uv, table_.back()) : foot.uv);
    }
    leave_poles();
    const Vec2 shift = finder_.next_to(table_[1], rough.uv(t0)) - table_[1];
    for (Vec2& uv : table_) uv = uv + shift;
    keep_end(rough, 0, 1);
    keep_end(rough, table_intervals, table_intervals - 1);
  }

  Vec2 uv(double t) const override {
    double s = std::clamp((t - t0_) / (t1_ - t0_), 0.0, 1.0) * table_intervals;
    auto i = std::min(static_cast<std::size_t>(s), static_cast<std::size_t>(table_intervals - 1));
    double share = s - static_cast<double>(i);
    if (share == 0 || share == 1) return share == 0 ? table_[i] : table_[i + 1];
    Vec2 guess = (1 - share) * table_[i] + share * table_[i + 1];
    try {
      return finder_.find(curve_->point(t), guess, query_steps).uv;
    } catch (const Standard_Failure&) {
      return guess;
    }
  }

 private:
  /// Beside a pole steps from there lead to poor feet, and some periods away; those from the other side are better.
  void leave_poles() {
    constexpr double better = 0.5;  // of the distance
    for (int i = table_intervals - 1; i > 0; --i) {
      const Vec3 x = curve_->point(t0_ + (t1_ - t0_) * i / table_intervals), off = x - finder_.point(table_[i]);
      const Foot walked = finder_.find(x, table_[i + 1], table_steps);
      if (walked.distance2 < better * better * dot(off, off)) table_[i] = finder_.next_to(walked.uv, table_[i + 1]);
    }
  }

  /// Where the image as given ends in the same point, it does so exactly, in the period of the entry beside; at poles
  /// it goes on as from there.
  void keep_end(const ParameterCurve& rough, int i, int beside) {
    const double reach = 1e-6 * (curve_length() + 1e-300);
    const Vec3 x = finder_.point(table_[i]);
    auto is_there = [&](Vec2 uv) { return norm(finder_.point(uv) - x) <= reach; };
    const Vec2 uv = finder_.next_to(rough.uv(i == 0 ? t0_ : t1_), table_[beside]);
    if (!is_there(uv)) return;
    table_[i] = uv;
    for (const Vec2 straight : {Vec2{table_[beside].x, uv.y}, Vec2{uv.x, table_[beside].y}})
      if (is_there(straight)) table_[i] = straight;
  }

  double curve_length() const { return length_of(sampled(curve_, t0_, t1_, 16)); }

  FootFinder finder_;
  std::shared_ptr<const Curve> curve_;
  double t0_, t1_;
  std::vector<Vec2> table_;
};

}  // namespace

std::shared_ptr<const ParameterCurve> make_shifted_image(std::shared_ptr<const ParameterCurve> image, Vec2 shift) {
  return image_by([image = std::move(image), shift](double t) { return image->uv(t) + shift; });
}

std::shared_ptr<const ParameterCurve> make_image_with_ends(const TopoDS_Face& face,
                                                           std::shared_ptr<const ParameterCurve> image, double t0,
                                                           double t1, const std::array<Vec3, 2>& ends, double allowed,
                                                           double& off) {
  try {
    const FootFinder finder(face);
    std::array<Vec2, 2> uv{image->uv(t0), image->uv(t1)};
    bool is_changed = false;
    for (std::size_t i = 0; i < 2; ++i) {
      const double distance = norm(ends[i] - finder.point(uv[i]));
      if (distance <= allowed) continue;
      const Foot foot = finder.find(ends[i], uv[i], table_steps);
      // Beside a pole the foot may be on its other side.
      if (!(foot.distance2 < 0.25 * distance * distance) || finder.are_far_apart(foot.uv, uv[i])) continue;
      uv[i] = foot.uv;
      off = std::max(off, distance);
      is_changed = true;
    }
    if (!is_changed) return nullptr;
    return image_by([image = std::move(image), t0, t1, uv](double t) {
      return t <= t0 ? uv[0] : t >= t1 ? uv[1] : image->uv(t);
    });
  } catch (const Standard_Failure&) {
    return nullptr;
  }
}

std::shared_ptr<const ParameterCurve> make_projected_image(const TopoDS_Face& face, std::shared_ptr<const Curve> curve,
                                                           const ParameterCurve& rough, double t0, double t1) {
  try {
    return std::make_shared<ProjectedImage>(face, std::move(curve), rough, t0, t1);
  } catch (const Standard_Failure&) {
    return nullptr;
  }
}

}  // namespace paver
