// The fine nodes along the edges of a coarse mesh, and grids of fine elements inside its elements.
#pragma once

#include <unordered_map>
#include <vector>

#include "multilevel/level_plan.h"
#include "paving/front/front.h"

namespace paver {

/// Fine nodes in a row: along a coarse edge, or a line between two of them.
using Row = std::vector<int>;

/// What is asked for of the fine mesh of `whole`, the region that `plan` is for; the same wherever it is asked for.
/// `front` is on that region or a copy without its loops, its mesh empty at first. References are kept.
class FineMesh {
 public:
  FineMesh(const Region& whole, const LevelPlan& plan, Front& front);

  /// The fine node at a coarse one.
  int corner_node(int v);
  /// Nodes of coarse edge `e`, ends included, from coarse node `from`. Made when first asked for.
  Row row_of(int e, int from);
  /// Whether coarse node `v` is a pole or on the ring of a fan.
  bool is_pole(int v) const { return mesh.is_fixed[v] && mesh.global[v] >= 0 && plan.place_on_loop[v][0] < 0; }
  /// The pole among the element's corners, or -1.
  int pole_of(int e) const;
  /// Divides coarse element `e` in a grid, a triangle in three. False, and nothing done but on its edges, where counts
  /// do not fit or an element would not be sound.
  bool lay(int e);
  /// The node of a fine loop.
  const LoopNode& loop_node(const CoarseEdge& edge, int i) const;

  const LevelPlan& plan;
  const RegionMesh& mesh;  ///< the coarse one
  const CoarseNet& net;
  Front& front;

 private:
  int node_on_loop(std::size_t loop, int i);
  void share(int node, int outline);
  int add_edge_nodes(int e);
  void reverse_nodes(int first, int count);
  Vec3 tangent(int e, int v) const;
  int edge_across(int e, int v) const;
  Vec2 stepped(int from, Vec3 to) const;
  int place(Vec3 y, Vec2 guess);
  bool lay_grid(const Row& bottom, const Row& right, const Row& top, const Row& left);
  bool add_quad(const Corners& v);
  bool lay_triangle(const std::vector<Row>& rows);
  Row straight_row(int a, int b, int n);

  const Region& whole_;
  const std::vector<int>& counts_;
  RegionMesh& fine_;
  std::unordered_map<int, Row> made_;   // by node of the boundary stage: its fine nodes so far
  std::unordered_map<int, int> node_;   // by coarse node: fine node. Maps, since a piece sees few of all
  std::unordered_map<int, int> first_;  // by coarse edge inside: its first fine node between the ends
  Row grid_;
};

}  // namespace paver
