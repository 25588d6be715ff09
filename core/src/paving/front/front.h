// The front of one region: its facets, the void they enclose, and the edits that keep both in step with the mesh.
#pragma once

#include <vector>

#include "mesh/region_mesh.h"
#include "paving/front/void_triangulation.h"
#include "regions/region.h"

namespace paver {

/// One front edge a -> b with the void on its left. `next` starts at b, in the same sector of the void.
struct Facet {
  int a = -1, b = -1;
  int next = -1, prev = -1;
  int level = 0;  ///< number of rows between it and the boundary
  bool is_alive = true;
};

/// Facet of a loop that the region came with, on B-rep edge `edge` (-1 on artificial cuts).
struct BoundaryFacet {
  int a = -1, b = -1;
  int edge = -1;
  double angle = -1;  ///< of the region at `a`, between the edges themselves, radians; -1 where it is not known
};

class Front {
 public:
  Front(const Region& region, RegionMesh& mesh);

  /// For a mesh that is there already: triangulates the void between `loops` of its nodes, void on the left. Boundary
  /// facets are taken from the region's loops and found by their nodes.
  std::optional<int> start_at(const std::vector<std::vector<int>>& loops);
  /// For a mesh without any void, whose boundary nodes are there: nodes and elements may be added and moved.
  void start_whole();
  /// Adds a boundary node of the region.
  int add_boundary_node(const std::vector<LoopNode>& loop, std::size_t i);
  /// Triangulates the void inside the region's loops; with `sharpest_corner` (radians) acute corners from there on, and
  /// rounded ones, are filled first (acute_corners.h, rounded_corners.h). Returns a facet where loops cross or touch.
  std::optional<int> start(std::optional<double> sharpest_corner = std::nullopt);

  const Region& region;
  RegionMesh& mesh;
  VoidTriangulation empty;  ///< the void
  std::vector<Facet> facets;
  std::vector<BoundaryFacet> boundary;  ///< all loops the region came with, facet after facet
  long closed_by_triangulation = 0;     ///< how often; goes to the face's report
  double misfit_weight = 1;             ///< weight of the fit to the sides at its ends in the choice of a row

  /// A facet that starts at `node`, or -1 when it is not on the front.
  int facet_from(int node) const { return at_node_[node].out_facet; }
  /// Number of sectors of the void that meet at `node`.
  int sectors(int node) const { return at_node_[node].sectors; }
  /// New node at p, not yet in the void.
  int add_node(Vec2 p);
  /// The same where the surface has been evaluated there.
  int add_placed_node(const NodePlace& at);
  /// Takes back the node added last.
  void drop_last_node();
  /// Angle of the void at facet f's end node, radians in (0, 2 pi). Between two boundary facets it is that of the true
  /// edges: two chords of a smooth arc are a side, however coarse they are.
  double angle_after(int f) const;
  /// The same between the chords themselves.
  double chord_angle_after(int f) const;
  /// Whether rows run on past this corner of the boundary, which might end them as well (wide_corners.h).
  bool is_passed(int node) const { return at_node_[node].is_passed; }
  double length(int f) const { return mesh.length(facets[f].a, facets[f].b); }
  /// `use(facet)` for those of f's loop, starting with f.
  template <class Use>
  void each_of_loop(int f, Use use) const {
    int g = f;
    do {
      use(g);
      g = facets[g].next;
    } while (g != f);
  }
  /// All of them.
  void collect_loop(int f, std::vector<int>& loop) const;

  /// Whether a mesh edge between two front nodes leaves all loops even.
  bool may_connect(int a, int b) const;

  /// Element on facet f with the further corners c (and d): corners a, b, c[, d]. Nodes must be in the void or on
  /// the front. False, and the front unchanged, when a side would cross the front or something lies inside.
  bool form_element(int f, int c, int d, int level);
  /// Joins the two facets at f's end: node `gone` (start of f or end of its next) merges into the other at `p`.
  /// False, and nothing changed, when an element or the void would be turned over.
  bool close_seam(int f, Vec2 p);
  /// Whether the void that facet f borders has no other loop than f's, which has `size` facets.
  bool is_alone(int f, int size) const;
  /// Divides facet f in three; the quad behind it becomes four (a 1-to-3 transition), so parity is kept. Returns the
  /// first of the three facets, or -1, and nothing changed, when f is boundary or the quad has no room.
  int divide_facet(int f);
  /// Removes the void that facet f borders with all its facets and returns its triangles (fourth entry -1).
  std::vector<Corners> take_void(int f);
  /// The facet made last, of those that start at `from` if given, that is still on the front, or -1.
  int newest_facet(int from = -1) const;
  /// To be called for nodes that were moved: the void about them is triangulated well again.
  void renew_void(const std::vector<int>& nodes);
  /// Moves a node, not the void about it. Near the place of its last evaluation it follows the tangent
  /// plane there, which is off by a hundredth of the target length or so and costs no evaluation.
  void slide(int node, Vec2 p) { slide(node, p, mesh.scale_at(node)); }
  /// The same where the scale of the mesh there is known.
  void slide(int node, Vec2 p, double scale);
  /// Puts all nodes that slid on the surface.
  void end_slides();
  /// Whether all elements and void triangles about the node stay positive in the chart with it at p.
  bool can_move(int node, Vec2 p) const;

  /// Frees what only a void needs; there must be none left.
  void end_void();
  /// Nodes and elements of a large mesh without void get new numbers, near each other in memory where they are so in
  /// the chart.
  void order_nodes();

  /// Colours a loop's nodes alternately as a set of its own. The loop must be even.
  void colour_loop(int f);

 private:
  static constexpr float most_drift = 0.2F;
  static constexpr int fewest_to_order = 100000;  // two rows of smaller meshes fit in a cache as they are
  struct Colour {
    int set = -1;
    bool bit = false;
  };
  struct NodeOnFront {
    int out_facet = -1;
    int sectors = 0;
    Colour colour;
    bool is_passed = false;
  };
  struct Outline;
  void link_sectors();
  void set_apex(int centre, const std::vector<int>& ring);
  std::optional<int> open_void();
  void add_start_loop(const std::vector<int>& nodes);
  void find_passed_corners(const std::vector<std::vector<int>>& loops);
  void note_boundary(const std::vector<std::vector<int>>& loops);
  bool find_outline(int f, int c, int d, Outline& o);
  void collect_fan(int f, std::vector<int>& fan) const;
  void relink(const Outline& o, int level);
  int add_facet(int a, int b, int level);
  void note_start(int f);
  void kill(int f);
  void join(int prev, int next);
  Colour root(Colour c) const;
  Colour root(int node) const;
  void unite(int a, int b);
  bool colours_allow(const Outline& o);

  std::vector<double> true_angle_;  // per start node; -1 where not known
  std::vector<NodeOnFront> at_node_;
  mutable std::vector<Colour> parent_;  // per set: its parent set and whether colours are swapped
  std::vector<int> stack_;
};

}  // namespace paver
