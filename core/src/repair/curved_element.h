// Elements of one part as they will be: curved, judged one by one, before anything is joined.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "boundary/edge_nodes.h"
#include "curving/edge_bulges.h"
#include "mesh/region_mesh.h"
#include "regions/region.h"

namespace paver {

constexpr double fair = 0.2;  ///< value of an element that is not poor
/// Of an element that is valid only if its sides leave their edges: less than others have that are valid.
constexpr double value_of_cusp = 1e-3;
constexpr double very_poor = 0.1;  ///< of one for which triangles may come

/// B-rep edges on regions' borders.
std::set<int> bounding_edges(std::span<const Region> regions);

/// An interval of a B-rep edge.
struct BoundarySide {
  int edge = -1;
  Vec3 middle;
};

/// The sides on B-rep edges that bound a region, by their nodes' numbers in the boundary stage.
class BoundarySides {
 public:
  BoundarySides(const Region& region, const EdgeNodes& edges);
  /// Null for sides inside the face.
  const BoundarySide* find(int a, int b) const;
  const EdgeBulges& bulges() const { return bulges_; }

 private:
  std::map<std::pair<int, int>, BoundarySide> sides_;
  EdgeBulges bulges_;
};

/// mm^2.
struct ElementArea {
  double area = 0;
  double slack = 0;  ///< what it may lack of the surface's
};

/// Judges elements between nodes of a part's mesh, whether they are in it or not. References are kept.
class ElementJudge {
 public:
  ElementJudge(const Region& region, const RegionMesh& mesh, const BoundarySides& sides, int order)
      : region_(region), mesh_(mesh), sides_(sides), order_(order) {}

  /// No element may have a side between these nodes any more: it counts as folded.
  void forbid(int a, int b) { forbidden_.push_back(std::minmax(a, b)); }

  /// From 1, as good as can be, down to 0: the lesser of scaled Jacobian and of the lower bound of the curved Jacobian
  /// over its mean. Negative where it is folded, turned over, farther off the surface than may be, or has a node of the
  /// boundary twice. Elements of a scaled Jacobian up to `floor` are not looked at any further: theirs is the value.
  double value(const Corners& v, double floor = -1) const;
  double value(int element) const { return value(mesh_.elements[element].v); }
  /// Of all elements of the mesh.
  double worst_value() const;

  ElementArea area(const Corners& v) const;

  const Region& region() const { return region_; }
  const RegionMesh& mesh() const { return mesh_; }
  const BoundarySides& sides() const { return sides_; }
  int order() const { return order_; }

 private:
  static constexpr std::size_t most_known = 1024;
  static constexpr double least_height = 1e-6;  // scaled Jacobian: flatter ones are not curved to be judged

  bool has_forbidden_side(const Corners& v, int n) const;
  /// Cosine between the element's normal and that of the surface at the corner where it is least; below 0 where the
  /// element runs against the surface.
  double least_along(const Corners& v, int n) const;
  /// Of the corners in the chart.
  std::array<Vec2, 4> places(const Corners& v, int n) const;
  bool runs_against(const Corners& v, int n, const std::array<Vec3, 9>& x) const;
  double off_surface(const Corners& v, int n, const std::array<Vec3, 9>& x) const;
  double chords_off(const Corners& v, int n) const;
  /// Whether it is valid once its sides on two edges that touch without an angle are straight.
  bool is_valid_cusp(const Corners& v, int n, std::array<Vec3, 9> x) const;
  /// Inside the face, between nodes a < b. Elements about one place ask for the same sides again and again: known as
  /// long as the ends lie where they did.
  struct KnownSide {
    int a = -1, b = -1;
    Vec2 from, to;  ///< of the ends in the chart
    Vec2 place;     ///< of the middle
    Vec3 middle;
  };
  const KnownSide& known_side(int a, int b) const;
  /// In Gmsh's order.
  std::array<Vec3, 9> nodes(const Corners& v, int n) const;
  /// The same of order 2, as curving places them.
  std::array<Vec3, 9> curved(const Corners& v, int n) const;

  const Region& region_;
  const RegionMesh& mesh_;
  const BoundarySides& sides_;
  const int order_;
  std::vector<std::pair<int, int>> forbidden_;
  mutable std::vector<KnownSide> known_;  // by a hash of the nodes; a judge serves one thread
};

}  // namespace paver
