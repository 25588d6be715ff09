// Small models built in code, free of OpenCASCADE: exact curves and surfaces with known answers.
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "topology/model.h"

namespace paver::fake {

constexpr double pi = std::numbers::pi;

class Line : public Curve {
 public:
  Line(Vec3 a, Vec3 b) : a_(a), b_(b) {}
  Vec3 point(double t) const override { return a_ + t * (b_ - a_); }
  CurveSlope slope(double t) const override { return {point(t), b_ - a_}; }
  CurveJet jet(double t) const override { return {slope(t)}; }

 private:
  Vec3 a_, b_;
};

/// Ellipse in a plane z = const; t is the angle.
class Ellipse : public Curve {
 public:
  Ellipse(Vec3 centre, double a, double b) : centre_(centre), a_(a), b_(b) {}
  Vec3 point(double t) const override { return centre_ + Vec3{a_ * std::cos(t), b_ * std::sin(t), 0}; }
  CurveSlope slope(double t) const override { return {point(t), {-a_ * std::sin(t), b_ * std::cos(t), 0}}; }
  CurveJet jet(double t) const override { return {slope(t), centre_ - point(t)}; }

 private:
  Vec3 centre_;
  double a_, b_;
};

class Plane : public Surface {
 public:
  Plane(Vec3 origin, Vec3 xu, Vec3 xv) : origin_(origin), xu_(xu), xv_(xv) {}
  Vec3 point(Vec2 uv) const override { return origin_ + uv.x * xu_ + uv.y * xv_; }
  SurfaceSlope slope(Vec2 uv) const override { return {point(uv), xu_, xv_}; }
  SurfaceJet jet(Vec2 uv) const override { return {slope(uv)}; }
  SurfaceKind kind() const override { return SurfaceKind::plane; }
  Vec2 period() const override { return {}; }
  std::unique_ptr<Surface> clone() const override { return std::make_unique<Plane>(*this); }

 private:
  Vec3 origin_, xu_, xv_;
};

/// About the z axis; u is the angle, v the height.
class Cylinder : public Surface {
 public:
  explicit Cylinder(double radius) : radius_(radius) {}
  Vec3 point(Vec2 uv) const override { return {radius_ * std::cos(uv.x), radius_ * std::sin(uv.x), uv.y}; }
  SurfaceSlope slope(Vec2 uv) const override {
    const Vec3 x = point(uv);
    return {x, {-x.y, x.x, 0}, {0, 0, 1}};
  }
  SurfaceJet jet(Vec2 uv) const override {
    const SurfaceSlope at = slope(uv);
    return {at, {-at.x.x, -at.x.y, 0}};
  }
  SurfaceKind kind() const override { return SurfaceKind::cylinder; }
  Vec2 period() const override { return {2 * pi, 0}; }
  std::unique_ptr<Surface> clone() const override { return std::make_unique<Cylinder>(*this); }

 private:
  double radius_;
};

/// About the origin; u is the longitude, v the latitude.
class Sphere : public Surface {
 public:
  explicit Sphere(double radius) : radius_(radius) {}
  Vec3 point(Vec2 uv) const override {
    double r = radius_ * std::cos(uv.y);
    return {r * std::cos(uv.x), r * std::sin(uv.x), radius_ * std::sin(uv.y)};
  }
  SurfaceSlope slope(Vec2 uv) const override {
    const Vec3 x = point(uv);
    return {x, {-x.y, x.x, 0}, {-x.z * std::cos(uv.x), -x.z * std::sin(uv.x), radius_ * std::cos(uv.y)}};
  }
  SurfaceJet jet(Vec2 uv) const override {
    const SurfaceSlope at = slope(uv);
    return {at, {-at.x.x, -at.x.y, 0}, {-at.v.y, at.v.x, 0}, -1 * at.x};
  }
  SurfaceKind kind() const override { return SurfaceKind::sphere; }
  Vec2 period() const override { return {2 * pi, 0}; }
  std::unique_ptr<Surface> clone() const override { return std::make_unique<Sphere>(*this); }

 private:
  double radius_;
};

/// One bicubic span, as a B-spline evaluates between knots; control point i + 4 j belongs to u^i, v^j.
class CubicPatch : public Surface {
 public:
  explicit CubicPatch(std::array<Vec3, 16> points) : points_(points) {}
  Vec3 point(Vec2 uv) const override { return sum(uv, 0, 0); }
  SurfaceSlope slope(Vec2 uv) const override { return {sum(uv, 0, 0), sum(uv, 1, 0), sum(uv, 0, 1)}; }
  SurfaceJet jet(Vec2 uv) const override { return {slope(uv), sum(uv, 2, 0), sum(uv, 1, 1), sum(uv, 0, 2)}; }
  SurfaceKind kind() const override { return SurfaceKind::other; }
  Vec2 period() const override { return {}; }
  std::unique_ptr<Surface> clone() const override { return std::make_unique<CubicPatch>(*this); }

 private:
  static std::array<double, 4> basis(double t, int derivative) {
    double s = 1 - t;
    if (derivative == 0) return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
    if (derivative == 1) return {-3 * s * s, 3 * s * s - 6 * s * t, 6 * s * t - 3 * t * t, 3 * t * t};
    return {6 * s, -12 * s + 6 * t, 6 * s - 12 * t, 6 * t};
  }
  Vec3 sum(Vec2 uv, int du, int dv) const {
    std::array<double, 4> bu = basis(uv.x, du), bv = basis(uv.y, dv);
    Vec3 total;
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t i = 0; i < 4; ++i) total += bu[i] * bv[j] * points_[i + 4 * j];
    }
    return total;
  }
  std::array<Vec3, 16> points_;
};

/// A gentle hill over the unit square.
inline CubicPatch hill(double height) {
  std::array<Vec3, 16> points;
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t i = 0; i < 4; ++i) {
      bool is_inner = (i == 1 || i == 2) && (j == 1 || j == 2);
      points[i + 4 * j] = {static_cast<double>(i) / 3, static_cast<double>(j) / 3, is_inner ? height : 0};
    }
  }
  return CubicPatch(points);
}

/// Straight in (u, v) between its values at t0 and t1.
inline std::shared_ptr<const ParameterCurve> straight_image(double t0, double t1, Vec2 a, Vec2 b) {
  return image_by([=](double t) { return a + ((t - t0) / (t1 - t0)) * (b - a); });
}

/// Builds a Model item by item. Edges count 0, 1, 2 ... in order of adding.
class Builder {
 public:
  int vertex(Vec3 x) {
    model_.vertices.push_back(x);
    return static_cast<int>(model_.vertices.size()) - 1;
  }
  int edge(std::shared_ptr<const Curve> curve, double t0, double t1, int start, int end, double length) {
    Edge edge;
    edge.name = "Edge" + std::to_string(model_.edges.size() + 1);
    edge.start = start;
    edge.end = end;
    edge.t0 = t0;
    edge.t1 = t1;
    edge.length = length;
    edge.is_degenerate = !curve;
    edge.curve = std::move(curve);
    model_.edges.push_back(std::move(edge));
    return static_cast<int>(model_.edges.size()) - 1;
  }
  int line(int start, int end) {
    Vec3 a = model_.vertices[static_cast<std::size_t>(start)], b = model_.vertices[static_cast<std::size_t>(end)];
    return edge(std::make_shared<Line>(a, b), 0, 1, start, end, norm(b - a));
  }
  int pole(int vertex) { return edge(nullptr, 0, 1, vertex, vertex, 0); }
  /// Arc about the z axis from `angle0` to `angle1`.
  int arc(Vec3 centre, double radius, double angle0, double angle1, int start, int end) {
    return edge(std::make_shared<Ellipse>(centre, radius, radius), angle0, angle1, start, end,
                radius * (angle1 - angle0));
  }
  /// Coedge without a parameter curve.
  Coedge use(int edge, bool is_reversed = false) const { return {edge, is_reversed, nullptr}; }
  /// Coedge whose image runs from `a` (at t0) to `b` (at t1).
  Coedge use(int edge, bool is_reversed, Vec2 a, Vec2 b) const {
    const Edge& e = model_.edges[static_cast<std::size_t>(edge)];
    return {edge, is_reversed, straight_image(e.t0, e.t1, a, b)};
  }
  int face(std::shared_ptr<const Surface> surface, double area, std::vector<std::vector<Coedge>> loops) {
    const int index = static_cast<int>(model_.faces.size());
    Face face;
    face.name = "Face" + std::to_string(index + 1);
    face.surface = std::move(surface);
    face.area = area;
    for (std::vector<Coedge>& coedges : loops) {
      for (const Coedge& coedge : coedges) {
        Edge& edge = model_.edges[static_cast<std::size_t>(coedge.edge)];
        for (int other : edge.faces) edge.is_periodic = edge.is_periodic || other == index;
        edge.faces.push_back(index);
      }
      face.loops.push_back({std::move(coedges)});
    }
    model_.faces.push_back(std::move(face));
    return index;
  }
  Model take() { return std::move(model_); }

 private:
  Model model_;
};

/// Flat polygon over the given corners, counter-clockwise in z = 0; edge i runs from corner i to corner i + 1.
inline Model polygon(const std::vector<Vec3>& corners) {
  Builder builder;
  const int n = static_cast<int>(corners.size());
  for (Vec3 corner : corners) builder.vertex(corner);
  std::vector<Coedge> loop;
  double area = 0;
  for (int i = 0; i < n; ++i) {
    int edge = builder.line(i, (i + 1) % n);
    Vec3 a = corners[static_cast<std::size_t>(i)], b = corners[static_cast<std::size_t>((i + 1) % n)];
    loop.push_back(builder.use(edge, false, {a.x, a.y}, {b.x, b.y}));
    area += 0.5 * cross(a, b).z;
  }
  builder.face(std::make_shared<Plane>(Vec3{}, Vec3{1, 0, 0}, Vec3{0, 1, 0}), area, {loop});
  return builder.take();
}

/// Square ring in z = 0: edges 0 to 3 outside, counter-clockwise, 4 to 7 inside, each beside its own outside.
inline Model frame(double side, double width) {
  Builder builder;
  for (const double inset : {0.0, width})
    for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
      builder.vertex({inset + x * (side - 2 * inset), inset + y * (side - 2 * inset), 0});
  std::vector<std::vector<Coedge>> loops(2);
  for (int ring : {0, 4})
    for (int i = 0; i < 4; ++i) {
      const int edge = builder.line(ring + i, ring + (i + 1) % 4);
      if (ring == 0) loops[0].push_back(builder.use(edge));
      if (ring > 0) loops[1].insert(loops[1].begin(), builder.use(edge, true));
    }
  builder.face(std::make_shared<Plane>(Vec3{}, Vec3{1, 0, 0}, Vec3{0, 1, 0}), 4 * width * (side - width), loops);
  return builder.take();
}

/// Disc in z = 0 less one that touches its border in (outer, 0, 0): edges 0 outside, 1 inside.
inline Model moon(double outer, double inner) {
  Builder builder;
  const int tip = builder.vertex({outer, 0, 0});
  builder.arc({}, outer, 0, 2 * pi, tip, tip);
  builder.arc({outer - inner, 0, 0}, inner, 0, 2 * pi, tip, tip);
  builder.face(std::make_shared<Plane>(Vec3{}, Vec3{1, 0, 0}, Vec3{0, 1, 0}), pi * (outer * outer - inner * inner),
               {{builder.use(0)}, {builder.use(1, true)}});
  return builder.take();
}

/// Box a x b x c: six planes, twelve shared edges. Edges 0-3 bottom, 4-7 top (0, 2, 4, 6 along x), 8-11 upright.
inline Model box(double a, double b, double c) {
  Builder builder;
  for (double z : {0.0, c}) {
    for (Vec3 corner : {Vec3{0, 0, z}, Vec3{a, 0, z}, Vec3{a, b, z}, Vec3{0, b, z}}) builder.vertex(corner);
  }
  for (int level : {0, 4}) {
    for (int i = 0; i < 4; ++i) builder.line(level + i, level + (i + 1) % 4);
  }
  for (int i = 0; i < 4; ++i) builder.line(i, i + 4);
  auto plane = [](Vec3 origin, Vec3 xu, Vec3 xv) { return std::make_shared<Plane>(origin, xu, xv); };
  Vec3 ex{1, 0, 0}, ey{0, 1, 0}, ez{0, 0, 1};
  builder.face(plane({}, ey, ex), a * b,
               {{builder.use(3, true), builder.use(2, true), builder.use(1, true), builder.use(0, true)}});
  builder.face(plane({0, 0, c}, ex, ey), a * b, {{builder.use(4), builder.use(5), builder.use(6), builder.use(7)}});
  for (int i = 0; i < 4; ++i) {
    Vec3 along = i == 0 ? ex : i == 1 ? ey : i == 2 ? -1 * ex : -1 * ey;
    Vec3 origin = i == 0 ? Vec3{} : i == 1 ? Vec3{a, 0, 0} : i == 2 ? Vec3{a, b, 0} : Vec3{0, b, 0};
    builder.face(plane(origin, along, ez), (i % 2 == 0 ? a : b) * c,
                 {{builder.use(i), builder.use(8 + (i + 1) % 4), builder.use(4 + i, true), builder.use(8 + i, true)}});
  }
  return builder.take();
}

/// Open tube about z: edge 0 bottom circle, 1 periodic edge, 2 top circle.
inline Model tube(double radius, double height) {
  Builder builder;
  int low = builder.vertex({radius, 0, 0}), high = builder.vertex({radius, 0, height});
  int bottom = builder.arc({}, radius, 0, 2 * pi, low, low);
  int upright = builder.line(low, high);
  int top = builder.arc({0, 0, height}, radius, 0, 2 * pi, high, high);
  builder.face(
      std::make_shared<Cylinder>(radius), 2 * pi * radius * height,
      {{builder.use(bottom, false, {0, 0}, {2 * pi, 0}), builder.use(upright, false, {2 * pi, 0}, {2 * pi, height}),
        builder.use(top, true, {0, height}, {2 * pi, height}), builder.use(upright, true, {0, 0}, {0, height})}});
  return builder.take();
}

/// Whole sphere: edge 0 periodic edge from south to north, 1 and 2 the poles.
inline Model ball(double radius) {
  Builder builder;
  int south = builder.vertex({0, 0, -radius}), north = builder.vertex({0, 0, radius});
  class Meridian : public Curve {
   public:
    explicit Meridian(double radius) : radius_(radius) {}
    Vec3 point(double t) const override { return {radius_ * std::cos(t), 0, radius_ * std::sin(t)}; }
    CurveSlope slope(double t) const override {
      const Vec3 x = point(t);
      return {x, {-x.z, 0, x.x}};
    }
    CurveJet jet(double t) const override { return {slope(t), -1 * point(t)}; }

   private:
    double radius_;
  };
  int meridian = builder.edge(std::make_shared<Meridian>(radius), -pi / 2, pi / 2, south, north, pi * radius);
  int at_south = builder.pole(south), at_north = builder.pole(north);
  builder.face(std::make_shared<Sphere>(radius), 4 * pi * radius * radius,
               {{builder.use(at_south, false, {0, -pi / 2}, {2 * pi, -pi / 2}),
                 builder.use(meridian, false, {2 * pi, -pi / 2}, {2 * pi, pi / 2}),
                 builder.use(at_north, true, {0, pi / 2}, {2 * pi, pi / 2}),
                 builder.use(meridian, true, {0, -pi / 2}, {0, pi / 2})}});
  return builder.take();
}

}  // namespace paver::fake
