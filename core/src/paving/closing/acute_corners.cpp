// Two columns of quads in an acute corner.
// In: a loop. Out: elements, and the loop without the corner.
//
//          apex
//          / \          The first quad has the apex and one node of the middle line; rows of two quads follow.
//        a1   b1
//        | \m1/ |
//       a2--m2--b2      The loop runs on b2 -> m2 -> a2.
//
// They end where they are wide enough, where the sides run apart or nodes do not face each other.
#include "paving/closing/acute_corners.h"

#include <algorithm>
#include <cmath>

#include "base/predicates.h"

namespace paver {
namespace {

constexpr double acute = 45 * M_PI / 180;  // interior angle
constexpr double wide_enough = 0.6;        // of the target length: width of a column
constexpr double dip = 0.35;          // of the first row's width: the apex quad's fourth node lies so far behind it
constexpr double most_uneven = 1.25;  // ratio of the two sides' lengths up to facing nodes
constexpr int most_rows = 64;

class AcuteCorner {
 public:
  AcuteCorner(const Region& region, RegionMesh& mesh, const std::vector<int>& nodes, std::size_t apex)
      : region_(region), mesh_(mesh), nodes_(nodes), apex_(apex) {}

  /// Rows it can have; 0: none.
  int rows(const std::vector<Vec2>& others) {
    const int n = static_cast<int>(nodes_.size()), most = std::min(most_rows, (n - 4) / 2);
    double left = 0, right = 0, last = 0;
    int count = 0;
    for (int k = 1; k <= most; ++k) {
      left += distance(a(k), a(k - 1)), right += distance(b(k), b(k - 1));
      double width = distance(a(k), b(k)), h = 0.5 * (mesh_.h[a(k)] + mesh_.h[b(k)]);
      if (!(width > last) || std::max(left, right) > most_uneven * std::min(left, right)) break;
      count = k, last = width;
      if (width > 2 * wide_enough * h) break;
    }
    if (count < 2 || holds_any(count, others)) return 0;
    return count;
  }

  /// The node of the middle line the loop runs on over.
  int lay(int count) {
    int before = -1;
    for (int k = 1; k <= count; ++k) {
      int middle = add_middle(k);
      if (k == 1)
        mesh_.add_element({a(0), a(1), middle, b(1)});
      else
        mesh_.add_element({a(k - 1), a(k), middle, before}), mesh_.add_element({before, middle, b(k), b(k - 1)});
      before = middle;
    }
    return before;
  }

 private:
  // The loop runs b2, b1, apex, a1, a2.
  int a(int k) const { return nodes_[(apex_ + static_cast<std::size_t>(k)) % nodes_.size()]; }
  int b(int k) const { return nodes_[(apex_ + nodes_.size() - static_cast<std::size_t>(k)) % nodes_.size()]; }
  // In space: where a corner turns sharply its two columns share the turn, however wide it is.
  double distance(int u, int v) const { return norm(mesh_.x[u] - mesh_.x[v]); }

  Vec2 middle(int k) const {
    Vec2 p = 0.5 * (mesh_.p[a(k)] + mesh_.p[b(k)]);
    if (k > 1) return p;
    Vec2 ahead = 0.5 * (mesh_.p[a(2)] + mesh_.p[b(2)]) - p;
    double length = norm(0.5 * (mesh_.x[a(2)] + mesh_.x[b(2)] - mesh_.x[a(1)] - mesh_.x[b(1)]));
    return p + std::min(0.5, dip * distance(a(1), b(1)) / length) * ahead;
  }

  int add_middle(int k) {
    Vec2 p = middle(k);
    return mesh_.add_node(region_.place(p), region_.target(p));
  }

  // All quads turn left in the chart, and nothing lies among them.
  bool holds_any(int count, const std::vector<Vec2>& others) const {
    std::vector<Vec2> outline;
    for (int k = count; k > 0; --k) outline.push_back(mesh_.p[b(k)]);
    for (int k = 0; k <= count; ++k) outline.push_back(mesh_.p[a(k)]);
    for (int k = 1; k <= count; ++k) {
      Vec2 before = k > 1 ? middle(k - 1) : mesh_.p[a(0)], here = middle(k);
      bool is_positive = orientation(before, mesh_.p[a(k)], here) > 0 && orientation(before, here, mesh_.p[b(k)]) > 0;
      if (k > 1)
        is_positive = is_positive && orientation(mesh_.p[a(k - 1)], mesh_.p[a(k)], before) > 0 &&
                      orientation(before, mesh_.p[b(k)], mesh_.p[b(k - 1)]) > 0;
      if (!is_positive) return true;
    }
    return std::any_of(others.begin(), others.end(), [&](Vec2 p) { return is_inside(outline, p); });
  }

  // Strictly; the outline's own nodes are not.
  static bool is_inside(const std::vector<Vec2>& outline, Vec2 p) {
    bool inside = false;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      Vec2 from = outline[i], to = outline[(i + 1) % outline.size()];
      if (from.x == p.x && from.y == p.y) return false;
      if ((from.y > p.y) == (to.y > p.y)) continue;
      bool is_up = to.y > from.y;
      if ((orientation(from, to, p) > 0) == is_up) inside = !inside;
    }
    return inside;
  }

  const Region& region_;
  RegionMesh& mesh_;
  const std::vector<int>& nodes_;
  std::size_t apex_;
};

// Interior angle of the loop at its node i: the true one, or where the surface has no tangent plane that of the chords.
double angle_at(const RegionMesh& mesh, const std::vector<LoopNode>& loop, const std::vector<int>& nodes,
                std::size_t i) {
  if (loop[i].angle >= 0) return loop[i].angle;
  int here = nodes[i], ahead = nodes[(i + 1) % nodes.size()], back = nodes[(i + nodes.size() - 1) % nodes.size()];
  if (orientation(mesh.p[back], mesh.p[here], mesh.p[ahead]) <= 0) return M_PI;
  Vec3 u = mesh.x[ahead] - mesh.x[here], v = mesh.x[back] - mesh.x[here];
  return std::atan2(norm(cross(u, v)), dot(u, v));
}

}  // namespace

void lay_acute_corners(const Region& region, RegionMesh& mesh, const std::vector<LoopNode>& loop,
                       std::vector<int>& nodes, const std::vector<Vec2>& others, double sharpest) {
  if (nodes.size() % 2 != 0) return;
  std::vector<int> apexes;
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (double angle = angle_at(mesh, loop, nodes, i); angle >= sharpest && angle < acute) apexes.push_back(nodes[i]);
  for (int apex : apexes) {
    auto at = std::find(nodes.begin(), nodes.end(), apex);
    if (at == nodes.end() || mesh.star[apex].size() > 0) continue;
    std::rotate(nodes.begin(), at, nodes.end());
    AcuteCorner corner(region, mesh, nodes, 0);
    int rows = corner.rows(others);
    if (rows == 0) continue;
    int middle = corner.lay(rows);
    nodes.erase(nodes.end() - (rows - 1), nodes.end());
    nodes.erase(nodes.begin(), nodes.begin() + rows);
    nodes.push_back(middle);
  }
}

}  // namespace paver
