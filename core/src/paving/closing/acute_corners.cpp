// Columns of quads in a corner that is acute, or about which the surface turns far.
// In: a loop. Out: elements, and the loop without the corner.
//
//          apex
//          / \          The first quad has the apex and one node of the middle line; rows of two quads follow.
//        a1   b1
//        | \m1/ |
//       a2--m2--b2      The loop runs on b2 -> m2 -> a2.
//
// Two columns, or four or six with two or three quads at the apex where the turn from side to side asks for them. They
// end where they are wide enough, where the sides run on side by side or nodes do not face each other.
#include "paving/closing/acute_corners.h"

#include <algorithm>
#include <cmath>

#include "base/predicates.h"

namespace paver {
namespace {

constexpr double acute = 45 * M_PI / 180;    // interior angle
constexpr double obtuse = 150 * M_PI / 180;  // the same: such a node is on a side
constexpr double wide_turn = 2.3;            // target lengths from side to side, turns counted: for two more columns
constexpr int most_columns = 6;
constexpr double bent = 1.5;           // of the width: the same, where the surface turns about the apex
constexpr int width_steps = 8;         // in which they are measured
constexpr double wide_enough = 0.6;    // of the target length: width of a column
constexpr double dip = 0.35;           // of the first row's width: the apex quad's fourth node lies so far behind it
constexpr double most_uneven = 1.25;   // ratio of the two sides' lengths up to facing nodes
constexpr double least_opening = 0.4;  // of the mean of the rows before: sides that run side by side end the corner
constexpr double room = 0.5;           // of the last row's depth: nothing else lies so near before it
constexpr int most_rows = 64;

/// At the loop's first node.
class AcuteCorner {
 public:
  AcuteCorner(const Region& region, RegionMesh& mesh, const std::vector<int>& nodes)
      : region_(region), mesh_(mesh), nodes_(nodes) {}

  /// Only corners about which the surface turns far are fans though they are not acute.
  bool is_fan(double angle) {
    const double turned = width(1, target(1) / region_.turn_limit);
    columns_ = std::clamp(2 * static_cast<int>(std::ceil(turned / (wide_turn * target(1)))), 2, most_columns);
    is_bent_ = turned > bent * width(1, 0);
    return angle < acute || columns_ > 2;
  }

  /// Rows it can have; 0: none.
  int rows(const std::vector<Vec2>& others) {
    const int n = static_cast<int>(nodes_.size()), most = std::min(most_rows, (n - 4) / 2);
    double left = 0, right = 0, last = 0;
    int count = 0;
    for (int k = 1; k <= most; ++k) {
      left += distance(a(k), a(k - 1)), right += distance(b(k), b(k - 1));
      const double wide = width(k, 0);
      if (!(wide - last > least_opening * last / std::max(1, k - 1)) ||
          std::max(left, right) > most_uneven * std::min(left, right))
        break;
      count = k, last = wide;
      if (wide > columns_ * wide_enough * target(k)) break;
    }
    while (count > 0 && holds_any(count, others)) --count;
    return columns_ == 2 && count < 2 ? 0 : count;
  }

  /// The nodes within the last row, over which the loop runs from b to a.
  std::vector<int> lay(int count) {
    // Skew of elements that turn far counts for little in smoothing: their rows would lean.
    const bool is_kept = mesh_.has_turns() || is_bent_;
    std::vector<int> before, row;
    for (int k = 1; k <= count; ++k, before = std::move(row)) {
      row = {a(k)};
      for (int j = 1; j < columns_; ++j)
        row.push_back(add_node(region_, inner(k, j), mesh_)), mesh_.is_fixed[row.back()] = is_kept && k < count;
      row.push_back(b(k));
      for (int j = 0; k == 1 && j < columns_; j += 2) mesh_.add_element({a(0), row[j], row[j + 1], row[j + 2]});
      for (int j = 0; k > 1 && j < columns_; ++j) mesh_.add_element({before[j], row[j], row[j + 1], before[j + 1]});
    }
    return {before.rbegin() + 1, before.rend() - 1};
  }

 private:
  // The loop runs b2, b1, apex, a1, a2.
  int a(int k) const { return nodes_[static_cast<std::size_t>(k) % nodes_.size()]; }
  int b(int k) const { return nodes_[(nodes_.size() - static_cast<std::size_t>(k)) % nodes_.size()]; }
  // In space: where a corner turns sharply its two columns share the turn, however wide it is.
  double distance(int u, int v) const { return norm(mesh_.x[u] - mesh_.x[v]); }
  double target(int k) const { return 0.5 * (mesh_.h[a(k)] + mesh_.h[b(k)]); }

  /// From side to side along the surface; `turn_weight`: what a radian of its turn counts besides, mm.
  double width(int k, double turn_weight) const {
    double sum = 0;
    MetricVec last;
    for (int i = 0; i <= width_steps; ++i) {
      const double share = static_cast<double>(i) / width_steps;
      const NodePlace at = region_.place((1 - share) * mesh_.p[a(k)] + share * mesh_.p[b(k)]);
      const MetricVec here{at.x, turn_weight * unit(cross(at.xp, at.xq))};
      if (i > 0) sum += norm(here - last);
      last = here;
    }
    return sum;
  }

  /// Node j of row k, counted from a; of the first row every other one lies behind the line between the sides.
  Vec2 inner(int k, int j) const {
    auto across = [&](int row) {
      const double share = static_cast<double>(j) / columns_;
      return (1 - share) * mesh_.p[a(row)] + share * mesh_.p[b(row)];
    };
    Vec2 p = across(k);
    if (k > 1 || j % 2 == 0) return p;
    Vec2 ahead = across(2) - p;
    double length = norm(0.5 * (mesh_.x[a(2)] + mesh_.x[b(2)] - mesh_.x[a(1)] - mesh_.x[b(1)]));
    return p + std::min(0.5, dip * 2 / columns_ * distance(a(1), b(1)) / length) * ahead;
  }

  // All quads turn left in the chart, and nothing lies among them or so near before them that no row fits in between.
  bool holds_any(int count, const std::vector<Vec2>& others) const {
    std::vector<Vec2> outline;
    for (int k = count; k > 0; --k) outline.push_back(mesh_.p[b(k)]);
    for (int k = 0; k <= count; ++k) outline.push_back(mesh_.p[a(k)]);
    const Vec2 ahead =
        room * (0.5 * (mesh_.p[a(count)] + mesh_.p[b(count)]) - 0.5 * (mesh_.p[a(count - 1)] + mesh_.p[b(count - 1)]));
    outline.push_back(mesh_.p[a(count)] + ahead), outline.push_back(mesh_.p[b(count)] + ahead);
    auto at = [&](int k, int j) {
      return k == 0 ? mesh_.p[a(0)] : j == 0 ? mesh_.p[a(k)] : j == columns_ ? mesh_.p[b(k)] : inner(k, j);
    };
    for (int k = 1; k <= count; ++k)
      for (int j = 0; j < columns_; ++j) {
        if (orientation(at(k - 1, j), at(k, j), at(k, j + 1)) <= 0) return true;
        if (k > 1 && orientation(at(k - 1, j), at(k, j + 1), at(k - 1, j + 1)) <= 0) return true;
      }
    return std::any_of(others.begin(), others.end(), [&](Vec2 p) { return is_inside(outline, p); });
  }

  const Region& region_;
  RegionMesh& mesh_;
  const std::vector<int>& nodes_;
  int columns_ = 2;
  bool is_bent_ = false;
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
  std::vector<std::pair<int, double>> apexes;
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (double angle = angle_at(mesh, loop, nodes, i); angle >= sharpest && angle < obtuse)
      apexes.emplace_back(nodes[i], angle);
  for (auto [apex, angle] : apexes) {
    auto at = std::find(nodes.begin(), nodes.end(), apex);
    if (at == nodes.end() || mesh.star[apex].size() > 0) continue;
    std::rotate(nodes.begin(), at, nodes.end());
    AcuteCorner corner(region, mesh, nodes);
    if (!corner.is_fan(angle)) continue;
    const int rows = corner.rows(others);
    if (rows == 0) continue;
    const std::vector<int> inner = corner.lay(rows);
    nodes.erase(nodes.end() - (rows - 1), nodes.end());
    nodes.erase(nodes.begin(), nodes.begin() + rows);
    nodes.insert(nodes.end(), inner.begin(), inner.end());
  }
}

}  // namespace paver
