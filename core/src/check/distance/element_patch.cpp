#include "check/distance/element_patch.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace paver {
namespace {

constexpr int most_steps = 20, most_halvings = 20, most_turns = 20;
constexpr double still = 1e-9;  // of the parameters' range, or of a distance

/// Values and slopes at t of the Lagrange polynomials at the ends, and at the middle for order 2.
struct Along {
  Along(int order, double t) {
    if (order == 1) {
      value = {1 - t, t, 0};
      slope = {-1, 1, 0};
    } else {
      value = {(1 - t) * (1 - 2 * t), t * (2 * t - 1), 4 * t * (1 - t)};
      slope = {4 * t - 3, 4 * t - 1, 4 - 8 * t};
    }
  }
  std::array<double, 3> value{}, slope{};
};

// Gmsh's order of a quad's nodes as (along u, along v): 0 and 1 are the ends, 2 the middle.
constexpr std::array<std::array<int, 2>, 9> quad_nodes{
    {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}, {1, 2}, {2, 1}, {0, 2}, {2, 2}}};

struct Weights {
  std::array<double, 9> value{}, by_u{}, by_v{};
};

Weights quad_weights(int order, int count, Vec2 uv) {
  const Along u(order, uv.x), v(order, uv.y);
  Weights w;
  for (int k = 0; k < count; ++k) {
    const auto [i, j] = quad_nodes[k];
    w.value[k] = u.value[i] * v.value[j];
    w.by_u[k] = u.slope[i] * v.value[j];
    w.by_v[k] = u.value[i] * v.slope[j];
  }
  return w;
}

Weights triangle_weights(int order, Vec2 uv) {
  const std::array<double, 3> l{1 - uv.x - uv.y, uv.x, uv.y}, by_u{-1, 1, 0}, by_v{-1, 0, 1};
  Weights w;
  for (int k = 0; k < 3; ++k) {
    const double slope = order == 1 ? 1 : 4 * l[k] - 1;
    w.value[k] = order == 1 ? l[k] : l[k] * (2 * l[k] - 1);
    w.by_u[k] = slope * by_u[k];
    w.by_v[k] = slope * by_v[k];
  }
  for (int k = 0; order == 2 && k < 3; ++k) {
    const int m = (k + 1) % 3;
    w.value[3 + k] = 4 * l[k] * l[m];
    w.by_u[3 + k] = 4 * (by_u[k] * l[m] + l[k] * by_u[m]);
    w.by_v[3 + k] = 4 * (by_v[k] * l[m] + l[k] * by_v[m]);
  }
  return w;
}

Weights line_weights(int order, Vec2 uv) {
  const Along u(order, uv.x);
  Weights w;
  std::copy(u.value.begin(), u.value.end(), w.value.begin());
  std::copy(u.slope.begin(), u.slope.end(), w.by_u.begin());
  return w;
}

Weights weights(const ElementPatch& patch, Vec2 uv) {
  if (patch.corners == 2) return line_weights(patch.order, uv);
  return patch.corners == 3 ? triangle_weights(patch.order, uv) : quad_weights(patch.order, patch.node_count(), uv);
}

Vec3 sum(const ElementPatch& patch, const std::array<double, 9>& w) {
  Vec3 x;
  for (int k = 0; k < patch.node_count(); ++k) x += w[k] * patch.nodes[k];
  return x;
}

Vec2 within(const ElementPatch& patch, Vec2 uv) {
  uv.x = std::clamp(uv.x, 0.0, 1.0);
  uv.y = patch.corners == 2 ? 0 : std::clamp(uv.y, 0.0, 1.0);
  if (patch.corners != 3 || uv.x + uv.y <= 1) return uv;
  const double t = std::clamp(0.5 * (1 + uv.x - uv.y), 0.0, 1.0);
  return {t, 1 - t};
}

/// The step to the foot of x on the tangents at a place; of the border, along it only.
Vec2 step(const ElementPatch& patch, Vec2 uv, Vec3 to_x) {
  const auto [a, b] = patch.slopes(uv);
  const double aa = dot(a, a), ab = dot(a, b), bb = dot(b, b), ax = dot(a, to_x), bx = dot(b, to_x);
  const double det = aa * bb - ab * ab;
  Vec2 full = det > 1e-12 * aa * bb ? Vec2{(bb * ax - ab * bx) / det, (aa * bx - ab * ax) / det}
                                    : Vec2{aa > 0 ? ax / aa : 0, 0};
  const Vec2 reached = within(patch, uv + full);
  if (norm(reached - (uv + full)) == 0) return full;
  // Clipping a step of both parameters may lead away from the foot: there each alone is tried, and along a slant.
  Vec2 best = reached - uv;
  double nearest = norm(patch.at(reached) - (patch.at(uv) + to_x));
  const double aslant = dot(a - b, a - b);
  for (Vec2 tried : {Vec2{aa > 0 ? ax / aa : 0, 0}, Vec2{0, bb > 0 ? bx / bb : 0},
                     aslant > 0 ? dot(a - b, to_x) / aslant * Vec2{1, -1} : Vec2{}}) {
    const Vec2 place = within(patch, uv + tried);
    const double d = norm(patch.at(place) - (patch.at(uv) + to_x));
    if (d < nearest) nearest = d, best = place - uv;
  }
  return best;
}

/// The range of a patch along a direction.
std::pair<double, double> extent(const ElementPatch& patch, Vec3 direction) {
  ElementPatch along = patch;
  for (int k = 0; k < patch.node_count(); ++k) along.nodes[k] = {dot(direction, patch.nodes[k]), 0, 0};
  const Box box = along.bounds();
  return {box.low.x, box.high.x};
}

bool are_apart_along(const ElementPatch& a, const ElementPatch& b, Vec3 direction, double near) {
  const auto [a_low, a_high] = extent(a, direction);
  const auto [b_low, b_high] = extent(b, direction);
  const double margin = near * norm(direction);
  return a_low > b_high + margin || b_low > a_high + margin;
}

Vec3 middle_of(const ElementPatch& patch) {
  const Box box = patch.bounds();
  return 0.5 * (box.low + box.high);
}

}  // namespace

int ElementPatch::node_count() const {
  if (corners == 2) return order + 1;
  return corners == 4 ? (order + 1) * (order + 1) : (order + 1) * (order + 2) / 2;
}

Vec2 ElementPatch::node_place(int k) const {
  static constexpr std::array<double, 3> at{0, 1, 0.5};
  static constexpr std::array<Vec2, 6> triangle{{{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}}};
  if (corners == 2) return {at[k], 0};
  return corners == 3 ? triangle[k] : Vec2{at[quad_nodes[k][0]], at[quad_nodes[k][1]]};
}

Vec3 ElementPatch::at(Vec2 uv) const { return sum(*this, weights(*this, uv).value); }

std::array<Vec3, 2> ElementPatch::slopes(Vec2 uv) const {
  const Weights w = weights(*this, uv);
  return {sum(*this, w.by_u), sum(*this, w.by_v)};
}

Box ElementPatch::bounds() const {
  Box box;
  for (int k = 0; k < corners; ++k) box.add(nodes[k]);
  if (order == 1) return box;
  auto middle = [](Vec3 a, Vec3 on_curve, Vec3 b) { return 2 * on_curve - 0.5 * (a + b); };
  if (corners == 2) {
    box.add(middle(nodes[0], nodes[2], nodes[1]));
    return box;
  }
  std::array<Vec3, 4> sides;
  for (int k = 0; k < corners; ++k) {
    sides[k] = middle(nodes[k], nodes[corners + k], nodes[(k + 1) % corners]);
    box.add(sides[k]);
  }
  if (corners == 4) box.add(middle(sides[3], middle(nodes[4], nodes[8], nodes[6]), sides[1]));
  return box;
}

Vec3 ElementPatch::mean_normal() const {
  if (corners == 2) return {};
  return corners == 3 ? cross(nodes[1] - nodes[0], nodes[2] - nodes[0])
                      : cross(nodes[2] - nodes[0], nodes[3] - nodes[1]);
}

Vec2 ElementPatch::nearest(Vec3 x, Vec2 start) const {
  Vec2 uv = start;
  double distance = norm(at(uv) - x);
  for (int k = 0; k < most_steps; ++k) {
    Vec2 move = step(*this, uv, x - at(uv));
    bool is_nearer = false;
    for (int h = 0; h < most_halvings && norm(move) > still && !is_nearer; ++h, move = 0.5 * move) {
      const Vec2 place = within(*this, uv + move);
      const double d = norm(at(place) - x);
      if ((is_nearer = d < distance)) uv = place, distance = d;
    }
    if (!is_nearer) break;
  }
  return uv;
}

PatchDistance distance(const ElementPatch& a, const ElementPatch& b) {
  Vec2 on_a, on_b;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < a.node_count(); ++i)
    for (int j = 0; j < b.node_count(); ++j)
      if (const double d = norm(a.nodes[i] - b.nodes[j]); d < least) {
        least = d;
        on_a = a.node_place(i);
        on_b = b.node_place(j);
      }
  for (int k = 0; k < most_turns; ++k) {
    on_b = b.nearest(a.at(on_a), on_b);
    on_a = a.nearest(b.at(on_b), on_a);
    const double d = norm(a.at(on_a) - b.at(on_b));
    if (d >= (1 - still) * least) break;
    least = d;
  }
  return {least, a.at(on_a), b.at(on_b) - a.at(on_a)};
}

bool are_apart(const ElementPatch& a, const ElementPatch& b, double near) {
  if (are_apart_along(a, b, middle_of(b) - middle_of(a), near)) return true;
  for (const ElementPatch* one : {&a, &b}) {
    const Vec3 normal = one->mean_normal();
    if (are_apart_along(a, b, normal, near)) return true;
    for (int k = 0; k < one->corners; ++k)
      if (are_apart_along(a, b, cross(normal, one->nodes[(k + 1) % one->corners] - one->nodes[k]), near)) return true;
  }
  return false;
}

}  // namespace paver
