// One paving task, complete in itself: a piece of one surface with its loops of fixed nodes.
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "brep/surfaces/surface.h"
#include "charts/chart.h"
#include "mesh/region_mesh.h"
#include "sizing/size_field.h"
#include "structured/mapped_fill.h"
#include "topology/corner_angle.h"

namespace paver {

/// Node of a loop: on the boundary stage's node `global`, at chart point p.
struct LoopNode {
  int global = -1;
  int edge = -1;  ///< B-rep edge of the facet that starts here; -1 on artificial cuts
  Vec2 p;
  Vec3 x;
  double h = 0;
  double angle = -1;  ///< interior angle between the true tangents, radians; -1: not known, take the chords'
};

/// Quads laid in advance about a point that must be a node, the apex of a cone: (centre, r0, r1, r2), (centre, r2,
/// ...).
struct Fan {
  LoopNode centre;
  std::vector<LoopNode> ring;  ///< counter-clockwise in the chart, even number; these nodes are new and may move
  bool is_apex = false;        ///< the surface has no normal at the centre
};

/// What is asked for, without any shape.
struct RegionTask {
  int face = -1;
  std::shared_ptr<const Surface> surface;  ///< this region's own evaluator
  std::shared_ptr<const Chart> chart;
  bool goes_round = false;  ///< about the chart's origin, which is a pole or no point of the surface
  FaceSize size{1};
  double h = 1;  ///< target length of the run, or what is given for the face
  double gradation = 0.3;
  double turn_limit = M_PI / 4;  ///< radians per element edge
  double evenness = 1;           ///< what even lengths are worth against regular nodes
  double area = 0;               ///< mm^2, of the whole face: bounds the work
};

struct Region : RegionTask {
  double own_area = 0;                       ///< mm^2, of the region alone; 0: not known
  std::vector<std::vector<LoopNode>> loops;  ///< region on the left of each loop
  std::vector<Fan> fans;
  std::optional<MappedFill> fill;  ///< of its one loop, where it is part of a structured layout

  /// Surface point at a chart point.
  Vec3 point(Vec2 p) const { return surface->point(chart->uv(p)); }
  /// By the chart coordinates.
  SurfaceSlope slope(Vec2 p) const { return slope_at(*chart, *surface, p); }
  /// The same with the normal, where turns count.
  NodePlace place(Vec2 p) const;
  /// Target length at a chart point: by what is given and, where turns do not count by themselves, by curvature.
  double target(Vec2 p) const { return size.at(chart->uv(p), *surface); }
};

/// Radians that the surface turns by along a line, as a few of its points tell. `at(share)`: from 0 to 1, in the chart.
template <class At>
double turn_along(const Region& region, At at) {
  constexpr int steps = 8;
  const auto normal = [&](int i) {
    const SurfaceSlope slope = region.slope(at(static_cast<double>(i) / steps));
    return unit(cross(slope.u, slope.v));
  };
  double turn = 0;
  Vec3 last = normal(0);
  for (int i = 1; i <= steps; ++i) {
    const Vec3 next = normal(i);
    turn += angle_between(last, next);
    last = next;
  }
  return turn;
}

/// Nodes of two sides of a region, each facing the same one of the other side.
using FacingSides = std::vector<std::array<const LoopNode*, 2>>;

/// Whether the surface between these is a prism that bends: parallel lines from side to side, along which it does not
/// turn, as far as it does from one to the next, and intervals about as long as is asked for.
bool are_sides_of_prism(const Region& region, const FacingSides& sides);

/// Distance to the nearest node of the loops, infinite where there is none.
double nearest_node(const Region& region, Vec3 at);

/// The same to the nearest of their facets.
double nearest_facet(const Region& region, Vec3 at);

/// The shorter way round a surface within `reach` of a place, mm; infinite where none goes round. About a pole it
/// grows.
double way_round(const Surface& surface, Vec2 uv, double reach);

/// Per loop and place in it: its node in a mesh of the region, -1 where there is none. Of two copies, on both sides of
/// a cut, the nearer one is meant.
std::vector<std::vector<int>> find_loop_nodes(const Region& region, const RegionMesh& mesh);

/// A node of the boundary, held, in a mesh of the region.
int add_node(const Region& region, const LoopNode& known, RegionMesh& mesh);

/// A node inside, with its target length.
int add_node(const Region& region, Vec2 p, RegionMesh& mesh);

/// A region still without loops and fans. The evaluator is shared.
inline Region task_of(const RegionTask& task) { return {task, 0, {}, {}, {}}; }

/// The region without its loops, with an evaluator of its own: for a task that makes a piece of it.
inline Region without_loops(const Region& region) {
  Region part = task_of(region);
  part.surface = region.surface->clone();
  part.fans = region.fans;
  return part;
}

}  // namespace paver
