#include "regions/face_layout.h"

#include <gtest/gtest.h>

#include "support/fake_model.h"

namespace paver {
namespace {

using fake::pi;

/// About an arc that starts along z and bends towards x; u is the angle about it, v the length along it.
class BentTube : public Surface {
 public:
  BentTube(double radius, double bend) : radius_(radius), bend_(bend) {}
  Vec3 point(Vec2 uv) const override {
    const double a = uv.y / bend_, reach = bend_ - radius_ * std::cos(uv.x);
    return {bend_ - reach * std::cos(a), radius_ * std::sin(uv.x), reach * std::sin(a)};
  }
  SurfaceSlope slope(Vec2 uv) const override {
    const double a = uv.y / bend_, c = std::cos(a), s = std::sin(a);
    return {point(uv), radius_ * Vec3{-std::sin(uv.x) * c, std::cos(uv.x), std::sin(uv.x) * s},
            (1 - radius_ / bend_ * std::cos(uv.x)) * Vec3{s, 0, c}};
  }
  SurfaceJet jet(Vec2 uv) const override { return {slope(uv)}; }
  SurfaceKind kind() const override { return SurfaceKind::other; }
  Vec2 period() const override { return {2 * pi, 0}; }
  std::unique_ptr<Surface> clone() const override { return std::make_unique<BentTube>(*this); }

 private:
  double radius_, bend_;
};

/// Curve of constant v (`is_rim`) or u on a surface.
class Isoline : public Curve {
 public:
  Isoline(std::shared_ptr<const Surface> surface, double at, bool is_rim)
      : surface_(std::move(surface)), at_(at), is_rim_(is_rim) {}
  Vec3 point(double t) const override { return surface_->point(is_rim_ ? Vec2{t, at_} : Vec2{at_, t}); }
  CurveSlope slope(double t) const override {
    const auto [x, xu, xv] = surface_->slope(is_rim_ ? Vec2{t, at_} : Vec2{at_, t});
    return {x, is_rim_ ? xu : xv};
  }
  CurveJet jet(double t) const override { return {slope(t)}; }

 private:
  std::shared_ptr<const Surface> surface_;
  double at_;
  bool is_rim_;
};

Model tube(const std::shared_ptr<const Surface>& surface, double length) {
  fake::Builder builder;
  const int low = builder.vertex(surface->point({0, 0})), high = builder.vertex(surface->point({0, length}));
  const auto rim = [&](double v) { return std::make_shared<Isoline>(surface, v, true); };
  const int first = builder.edge(rim(0), 0, 2 * pi, low, low, 2 * pi);
  const int seam = builder.edge(std::make_shared<Isoline>(surface, 0, false), 0, length, low, high, length);
  const int last = builder.edge(rim(length), 0, 2 * pi, high, high, 2 * pi);
  builder.face(
      surface, 2 * pi * length,
      {{builder.use(first, false, {0, 0}, {2 * pi, 0}), builder.use(seam, false, {2 * pi, 0}, {2 * pi, length}),
        builder.use(last, true, {0, length}, {2 * pi, length}), builder.use(seam, true, {0, 0}, {0, length})}});
  return builder.take();
}

LayoutKind kind_of(const std::shared_ptr<const Surface>& surface, double length) {
  const Model model = tube(surface, length);
  Options options;
  options.size = 1;
  Progress progress;
  const SizeField size = build_size_field(model, options, progress);
  return plan_layouts(model, size, ClosedLayouts::made, progress).front().kind;
}

TEST(PlanLayouts, LongBentTubesKeepTheirSeam) {
  EXPECT_EQ(kind_of(std::make_shared<BentTube>(1, 30), 60), LayoutKind::row);
}

TEST(PlanLayouts, ShortTubesAndStraightOnesHaveNone) {
  EXPECT_EQ(kind_of(std::make_shared<BentTube>(1, 10), 20), LayoutKind::polar);
  EXPECT_EQ(kind_of(std::make_shared<BentTube>(1, 200), 60), LayoutKind::polar);
  EXPECT_EQ(kind_of(std::make_shared<fake::Cylinder>(1), 60), LayoutKind::polar);
}

}  // namespace
}  // namespace paver
