#include "repair/divide_sides.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "curving/near_surface.h"
#include "repair/edits/divide_inside.h"
#include "repair/edits/patch.h"

namespace paver {
namespace {

/// Where chords from both ends of a piece of curve are as long as each other.
double middle_of(const Curve& curve, double t0, double t1) {
  constexpr int bisections = 40;
  const Vec3 a = curve.point(t0), b = curve.point(t1);
  double low = t0, high = t1;
  for (int i = 0; i < bisections; ++i) {
    const double t = 0.5 * (low + high);
    const Vec3 x = curve.point(t);
    (norm(x - a) < norm(b - x) ? low : high) = t;
  }
  return 0.5 * (low + high);
}

/// The interval's middle becomes a node.
void divide(const Curve& curve, std::size_t interval, int node, EdgeDivision& division) {
  auto t = division.t.begin() + static_cast<long>(2 * interval);
  const double first = middle_of(curve, t[0], t[1]), second = middle_of(curve, t[1], t[2]);
  const auto at = static_cast<long>(2 * interval + 1);
  division.t.insert(division.t.begin() + at + 1, second);
  division.t.insert(division.t.begin() + at, first);
  division.x.insert(division.x.begin() + at + 1, curve.point(second));
  division.x.insert(division.x.begin() + at, curve.point(first));
  division.node.insert(division.node.begin() + static_cast<long>(interval) + 1, node);
}

class RegionDivider {
 public:
  RegionDivider(const ElementJudge& judge, const EdgeNodes& nodes, ElementKinds kinds, RegionMesh& mesh)
      : region_(judge.region()), nodes_(nodes), mesh_(mesh), judge_(judge), kinds_(kinds) {
    for (int v = 0; v < mesh.node_count(); ++v)
      if (mesh.global[v] >= 0 && mesh.star[v].size() > 0) copies_[mesh.global[v]].push_back(v);
  }

  void run(const DividedSide& side) {
    const std::vector<int> as = copies_[side.a], bs = copies_[side.b];
    for (int a : as)
      for (int b : bs) divide(a, b, side.node);
  }

 private:
  void divide(int a, int b, int global) {
    const int left = mesh_.across(b, a), right = mesh_.across(a, b);
    if (left < 0 && right < 0) return;
    const int middle = add_node(a, b, global);
    for (int e : {left, right})
      if (e >= 0) insert(e, a, b, middle);
  }

  int add_node(int a, int b, int global) {
    const Vec3 at = nodes_.nodes[global];
    Vec2 p = half_way(region_, mesh_.p[a], mesh_.p[b]);
    nearest_point(region_, p, at, norm(mesh_.x[b] - mesh_.x[a]));
    NodePlace place = region_.place(p);
    place.x = at;
    const int node = mesh_.add_node(place, 0.5 * (mesh_.h[a] + mesh_.h[b]));
    mesh_.is_fixed[node] = 1;
    mesh_.global[node] = global;
    copies_[global].push_back(node);
    return node;
  }

  void insert(int e, int a, int b, int middle) {
    const std::vector<int> outline = with_node_between(mesh_.elements[e], a, b, middle);
    Filling filling = fill_outline(outline, kinds_, judge_);
    if (filling.elements.empty()) filling.elements = fan_at(outline, middle);
    mesh_.remove_element(e);
    for (const Corners& corners : filling.elements) mesh_.add_element(corners);
  }

  /// Whatever they are worth: the other faces at the side have the node as well.
  static std::vector<Corners> fan_at(std::vector<int> outline, int middle) {
    std::rotate(outline.begin(), std::find(outline.begin(), outline.end(), middle), outline.end());
    if (outline.size() == 4)
      return {{outline[0], outline[1], outline[2], -1}, {outline[0], outline[2], outline[3], -1}};
    return {{outline[0], outline[1], outline[2], -1}, {outline[0], outline[2], outline[3], outline[4]}};
  }

  const Region& region_;
  const EdgeNodes& nodes_;
  RegionMesh& mesh_;
  const ElementJudge& judge_;
  const ElementKinds kinds_;
  std::map<int, std::vector<int>> copies_;  // of a node of the boundary stage
};

/// Distance from p to the segment a b by its length, INFINITY next to its ends.
double distance_beside(Vec3 p, Vec3 a, Vec3 b) {
  constexpr double margin = 0.05;  // of the segment
  const Vec3 along = b - a;
  const double square = dot(along, along), t = square > 0 ? dot(p - a, along) / square : 0;
  return t < margin || t > 1 - margin ? INFINITY : norm(p - a - t * along) / std::sqrt(square);
}

}  // namespace

std::vector<SideToDivide> sides_beside_nodes(const ElementJudge& judge) {
  constexpr double least = 0.02, most = 0.1;  // of the side: what is nearer, a few divisions do not put right
  constexpr double straight = 0.02;           // of the side: bent ones may fold what is made of the elements there
  const RegionMesh& mesh = judge.mesh();
  std::vector<SideToDivide> found;
  for (const Element& e : mesh.elements) {
    auto is_inside = [&](int v) { return mesh.global[v] < 0; };
    if (!e.is_alive() || e.corners() == 4 || std::any_of(e.v.begin(), e.v.begin() + 3, is_inside)) continue;
    for (int k = 0; k < 3; ++k) {
      const int a = e.v[k], b = e.v[(k + 1) % 3], beside = e.v[(k + 2) % 3];
      const double away = distance_beside(mesh.x[beside], mesh.x[a], mesh.x[b]);
      if (away < least || away > most || is_too_short(mesh, a, b)) continue;
      const BoundarySide* side = judge.sides().find(mesh.global[a], mesh.global[b]);
      const Vec3 chord = mesh.x[b] - mesh.x[a];
      if (side && norm(side->middle - mesh.x[a] - 0.5 * chord) < straight * norm(chord))
        found.push_back({side->edge, mesh.global[a], mesh.global[b]});
    }
  }
  return found;
}

std::vector<DividedSide> divide_intervals(const Model& model, std::vector<SideToDivide> sides, EdgeNodes& nodes) {
  for (SideToDivide& side : sides)
    if (side.a > side.b) std::swap(side.a, side.b);
  std::sort(sides.begin(), sides.end());
  sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
  std::vector<DividedSide> divided;
  for (const SideToDivide& side : sides) {
    EdgeDivision& division = nodes.edges[side.edge];
    for (int i = 0; i < division.intervals(); ++i) {
      if (std::minmax(division.node[i], division.node[i + 1]) != std::minmax(side.a, side.b)) continue;
      const int node = nodes.add(division.x[2 * static_cast<std::size_t>(i) + 1], side.edge,
                                 0.5 * (nodes.node_target[side.a] + nodes.node_target[side.b]));
      divide(*model.edges[side.edge].curve, static_cast<std::size_t>(i), node, division);
      divided.push_back({side.a, side.b, node});
      break;
    }
  }
  return divided;
}

void divide_boundary_sides(const ElementJudge& judge, const EdgeNodes& nodes, const std::vector<DividedSide>& sides,
                           ElementKinds kinds, RegionMesh& mesh) {
  RegionDivider divider(judge, nodes, kinds, mesh);
  for (const DividedSide& side : sides) divider.run(side);
}

}  // namespace paver
