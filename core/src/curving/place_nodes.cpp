// Curving by closest points in the charts.
// Nodes are found again in their region by number; where a region shows a node twice (both sides of a cut) the copy
// nearest to the other corners is meant.
#include "curving/place_nodes.h"

#include <algorithm>
#include <cmath>

#include "parallel/tasks.h"

namespace paver {
namespace {

struct Located {
  const Region* region = nullptr;
  Vec2 p[4];
};

/// Chart positions of joined nodes, region by region.
class NodeFinder {
 public:
  explicit NodeFinder(const std::vector<CurvingPart>& parts) : parts_(parts), copies_(parts.size()) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (!parts[i].mesh) continue;
      const std::vector<int>& node_of = *parts[i].node_of;
      for (std::size_t k = 0; k < node_of.size(); ++k)
        if (node_of[k] >= 0) copies_[i].push_back({node_of[k], static_cast<int>(k)});
      std::sort(copies_[i].begin(), copies_[i].end());
    }
  }

  /// Chart points of `count` corners in part i, copies chosen next to one another; false when one is not there.
  bool find(std::size_t i, const int* corners, int count, Vec2* p) const {
    // The corner with the fewest copies anchors the others; where it has several, the one whose neighbours are nearest.
    Range ranges[4];
    int anchor = 0;
    for (int k = 0; k < count; ++k) {
      ranges[k] = copies(i, corners[k]);
      if (ranges[k].first == ranges[k].last) return false;
      if (ranges[k].last - ranges[k].first < ranges[anchor].last - ranges[anchor].first) anchor = k;
    }
    double best = 1e300;
    for (auto at = ranges[anchor].first; at != ranges[anchor].last; ++at) {
      Vec2 q[4];
      double spread = nearest_copies(i, ranges, count, chart(i, at->second), q);
      if (spread < best) best = spread, std::copy_n(q, count, p);
    }
    return true;
  }

 private:
  using Copy = std::pair<int, int>;  // joined node, region node
  struct Range {
    std::vector<Copy>::const_iterator first, last;
  };
  Range copies(std::size_t i, int node) const {
    auto first = std::lower_bound(copies_[i].begin(), copies_[i].end(), Copy{node, -1});
    auto last = first;
    while (last != copies_[i].end() && last->first == node) ++last;
    return {first, last};
  }
  Vec2 chart(std::size_t i, int k) const { return parts_[i].mesh->p[k]; }

  /// The copy of each corner nearest to `at`; the sum of their distances.
  double nearest_copies(std::size_t i, const Range* ranges, int count, Vec2 at, Vec2* p) const {
    double sum = 0;
    for (int k = 0; k < count; ++k) {
      double nearest = 1e300;
      for (auto c = ranges[k].first; c != ranges[k].last; ++c) {
        Vec2 q = chart(i, c->second);
        double d = norm(q - at);
        if (d < nearest) nearest = d, p[k] = q;
      }
      sum += nearest;
    }
    return sum;
  }

  const std::vector<CurvingPart>& parts_;
  std::vector<std::vector<Copy>> copies_;
};

/// Surface point nearest to `target`, by Gauss-Newton in the chart from p; the start itself where that does not settle.
Vec3 nearest_point(const Region& region, Vec2 p, Vec3 target) {
  Vec3 first, x, xp, xq;
  region.evaluate(p, x, xp, xq);
  first = x;
  double best = norm(target - x);
  for (int i = 0; i < 6; ++i) {
    double a = dot(xp, xp), b = dot(xp, xq), c = dot(xq, xq), det = a * c - b * b;
    if (!(det > 1e-12 * a * c)) break;
    Vec3 r = target - x;
    double s = dot(r, xp), t = dot(r, xq);
    Vec2 step{(c * s - b * t) / det, (a * t - b * s) / det};
    Vec3 y, yp, yq;
    region.evaluate(p + step, y, yp, yq);
    double d = norm(target - y);
    if (!(d <= best * (1 + 1e-12))) break;
    double moved = norm(y - x);
    p = p + step, x = y, xp = yp, xq = yq, best = d;
    if (moved < 1e-9 * (1e-300 + norm(xp) + norm(xq)) * norm(step) || moved == 0) break;
  }
  return std::isfinite(norm(x)) ? x : first;
}

/// Distance from `target` to the surface near p. Ends where the foot is nearly below the target: what is left of the
/// way along the tangent plane then counts by Pythagoras.
double distance_to_surface(const Region& region, Vec2 p, Vec3 target) {
  constexpr int most_steps = 6;
  constexpr double nearly_below = 0.05;  // of the distance
  double best = INFINITY;
  for (int i = 0; i <= most_steps; ++i) {
    Vec3 x, xp, xq;
    region.evaluate(p, x, xp, xq);
    Vec3 r = target - x;
    double d = norm(r), a = dot(xp, xp), b = dot(xp, xq), c = dot(xq, xq), det = a * c - b * b;
    if (!(d < best)) break;
    best = d;
    if (!(det > 1e-12 * a * c)) break;
    double s = dot(r, xp), t = dot(r, xq);
    Vec2 step{(c * s - b * t) / det, (a * t - b * s) / det};
    double along = norm(step.x * xp + step.y * xq);
    if (along <= nearly_below * d) return std::sqrt(d * d - along * along);
    p = p + step;
  }
  return best;
}

/// For each part, the face's items (sides or quads) that it holds; the first part that knows all corners takes one.
template <class Item, class Corners>
std::vector<std::vector<Item>> share_out(const std::vector<CurvingPart>& parts, const NodeFinder& finder,
                                         const std::vector<std::pair<int, Item>>& items, Corners corners) {
  int faces = 0;
  for (const CurvingPart& part : parts) faces = std::max(faces, part.region->face + 1);
  std::vector<std::vector<std::size_t>> parts_of(faces);
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (parts[i].mesh) parts_of[parts[i].region->face].push_back(i);
  std::vector<std::vector<Item>> shares(parts.size());
  for (const auto& [face, item] : items) {
    const auto& candidates = parts_of[face];
    std::size_t chosen = candidates.front();
    if (candidates.size() > 1) {
      Vec2 p[4];
      int v[4];
      int n = corners(item, v);
      for (std::size_t i : candidates)
        if (finder.find(i, v, n, p)) {
          chosen = i;
          break;
        }
    }
    shares[chosen].push_back(item);
  }
  return shares;
}

std::vector<double> sizes(const std::vector<CurvingPart>& parts) {
  std::vector<double> cost;
  for (const CurvingPart& part : parts) cost.push_back(part.mesh ? static_cast<double>(part.mesh->elements.size()) : 0);
  return cost;
}

}  // namespace

SurfaceMesh curve_elements(const SurfaceMesh& linear, const EdgeNodes& edges, const Model& model,
                           const std::vector<CurvingPart>& parts, int threads, const Progress& progress) {
  OrderTwoMesh raised = number_order_2(linear, edges, model);
  SurfaceMesh& mesh = raised.mesh;
  NodeFinder finder(parts);
  std::vector<std::pair<int, InteriorSide>> sides;
  for (const InteriorSide& s : raised.sides) sides.push_back({s.face, s});
  auto side_shares = share_out(parts, finder, sides, [](const InteriorSide& s, int* v) {
    v[0] = s.a, v[1] = s.b;
    return 2;
  });
  std::vector<std::pair<int, int>> quads;
  for (std::size_t q = 0; q < mesh.quad_count(); ++q) quads.push_back({mesh.quad_face[q], static_cast<int>(q)});
  auto quad_shares = share_out(parts, finder, quads, [&](int q, int* v) {
    std::copy_n(&mesh.quads[9 * static_cast<std::size_t>(q)], 4, v);
    return 4;
  });
  run_tasks(threads, sizes(parts), [&](int i) {
    progress.check();
    const Region& region = *parts[i].region;
    for (const InteriorSide& s : side_shares[i]) {
      int v[2] = {s.a, s.b};
      Vec2 p[4];
      Vec3 chord = 0.5 * (mesh.nodes[s.a] + mesh.nodes[s.b]);
      mesh.nodes[s.node] = finder.find(i, v, 2, p) ? nearest_point(region, 0.5 * (p[0] + p[1]), chord) : chord;
    }
  });
  run_tasks(threads, sizes(parts), [&](int i) {
    progress.check();
    for (int q : quad_shares[i]) {
      const int* v = &mesh.quads[9 * static_cast<std::size_t>(q)];
      Vec2 p[4];
      Vec3 blend = blended_centre(mesh, q);
      bool is_found = finder.find(i, v, 4, p);
      mesh.nodes[v[8]] = is_found ? nearest_point(*parts[i].region, 0.25 * (p[0] + p[1] + p[2] + p[3]), blend) : blend;
    }
  });
  return std::move(raised.mesh);
}

double chord_error(const SurfaceMesh& mesh, const std::vector<CurvingPart>& parts, int threads) {
  NodeFinder finder(parts);
  std::vector<std::pair<int, int>> quads;
  for (std::size_t q = 0; q < mesh.quad_count(); ++q) quads.push_back({mesh.quad_face[q], static_cast<int>(q)});
  std::size_t stride = static_cast<std::size_t>(mesh.nodes_per_quad());
  auto corners = [&](int q, int* v) {
    std::copy_n(&mesh.quads[stride * static_cast<std::size_t>(q)], 4, v);
    return 4;
  };
  auto shares = share_out(parts, finder, quads, corners);
  std::vector<double> worst(parts.size(), 0);
  // Lagrange weights of a quad9 at a quarter of either side, corners, sides, centre in Gmsh order.
  constexpr double near = 0.375, mid = 0.75, far = -0.125;
  constexpr double weight[9] = {near * near, far * near, far * far,  near * far, mid * near,
                                far * mid,   mid * far,  near * mid, mid * mid};
  run_tasks(threads, sizes(parts), [&](int i) {
    for (int q : shares[i]) {
      const int* v = &mesh.quads[stride * static_cast<std::size_t>(q)];
      Vec2 p[4];
      if (!finder.find(i, v, 4, p)) continue;
      Vec3 x{0, 0, 0};
      for (std::size_t k = 0; k < (mesh.order == 1 ? 4 : stride); ++k)
        x += (mesh.order == 1 ? 0.25 : weight[k]) * mesh.nodes[v[k]];
      Vec2 start =
          mesh.order == 1 ? 0.25 * (p[0] + p[1] + p[2] + p[3]) : 0.0625 * (9 * p[0] + 3 * p[1] + p[2] + 3 * p[3]);
      worst[i] = std::max(worst[i], distance_to_surface(*parts[i].region, start, x));
    }
  });
  return worst.empty() ? 0 : *std::max_element(worst.begin(), worst.end());
}

}  // namespace paver
