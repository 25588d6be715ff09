// Constrained Delaunay triangulation of what is not yet paved: the one supporting structure of the front.
//
// Its vertices are the front nodes (and, for a moment, a node that is about to join the front); its outer sides are
// the facets. A segment overlaps the front exactly when recovering it would cross a facet.
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "paver/vec.h"

namespace paver {

/// Side of a triangle: the one opposite its corner number `corner`.
struct Side {
  int triangle = -1;
  int corner = 0;
};

struct VoidTriangle {
  std::array<int, 3> v{-1, -1, -1};  ///< counter-clockwise node numbers
  std::array<int, 3> n{-1, -1, -1};  ///< neighbour across the side opposite v[i]; a facet f is stored as -2 - f
  bool is_alive = false;
};

inline bool is_facet(int neighbour) { return neighbour <= -2; }
inline int facet_of(int neighbour) { return -2 - neighbour; }
inline int facet_code(int facet) { return -2 - facet; }

/// Where a walk through the void ended.
struct Location {
  enum class Kind { inside, on_side, on_vertex, blocked } kind = Kind::blocked;
  int triangle = -1;
  int corner = -1;  ///< on_side, blocked: the side opposite this corner; on_vertex: this corner
};

class VoidTriangulation {
 public:
  explicit VoidTriangulation(const std::vector<Vec2>& points) : points_(points) {}

  /// Triangulates the region bounded by the directed `facets` (start, end; region on the left).
  /// Returns a facet that crosses or touches another, or nothing when all is well.
  std::optional<int> build(const std::vector<std::pair<int, int>>& facets);

  /// Frees the triangles.
  void clear() {
    triangles_ = std::vector<VoidTriangle>();
    facet_side_ = std::vector<Side>();
  }

  const VoidTriangle& triangle(int t) const { return triangles_[t]; }
  int triangle_count() const { return static_cast<int>(triangles_.size()); }
  Side facet_side(int facet) const { return facet_side_[facet]; }

  /// Next triangle about `node`, counter-clockwise or clockwise; a facet code at the end of the fan.
  int rotate_ccw(int t, int node) const { return triangles_[t].n[(corner_of(t, node) + 1) % 3]; }
  int rotate_cw(int t, int node) const { return triangles_[t].n[(corner_of(t, node) + 2) % 3]; }
  int corner_of(int t, int node) const {
    const auto& v = triangles_[t].v;
    return v[0] == node ? 0 : (v[1] == node ? 1 : 2);
  }
  bool has_node(int t, int node) const {
    const auto& v = triangles_[t].v;
    return v[0] == node || v[1] == node || v[2] == node;
  }
  /// Corner of `t` opposite the side between the nodes a and b, or -1.
  int side_between(int t, int a, int b) const;

  /// Follows the segment from `node` to `target` through the fan that `start` belongs to.
  Location walk(int start, int node, Vec2 target) const;

  /// Adds `node` where walk() found it (inside or on_side); restores the Delaunay property.
  /// False, and nothing changed, when it would lie on a facet.
  bool insert(int node, const Location& where);

  /// Takes out a node that lies inside the void; `start` is any triangle of the fan at `near` that the node is seen
  /// from.
  void erase(int node, int start, int near);

  /// Makes a-b a side; `start` is any triangle of the fan at a that b is seen from.
  /// False, and nothing changed, when a facet or a node is in the way.
  bool recover(int start, int a, int b);

  /// Puts a facet on a side; the void stays on its left.
  void set_facet(Side side, int facet) { link(side.triangle, side.corner, facet_code(facet)); }
  /// Divides an outer side a-b by two nodes on it; its triangle becomes three, with facets a-node[0]-node[1]-b.
  void divide_side(Side side, const int (&node)[2], const int (&facet)[3]);
  void remove(int t);
  void replace_node(int t, int from, int to) { triangles_[t].v[corner_of(t, from)] = to; }
  /// Makes `neighbour` (triangle or facet code) the neighbour of that side; one direction only.
  void link(int t, int corner, int neighbour);

  /// Restores the Delaunay property about the triangles on the stack, which is emptied.
  void legalise(std::vector<int>& stack);
  /// The same where recover() spoiled it since the last call.
  void legalise_recovered() { legalise(spoiled_); }

 private:
  struct OuterSide {
    int a, b, neighbour;
  };
  Vec2 at(int v) const { return v >= 0 ? points_[v] : frame_[-1 - v]; }
  int triangle_at(int node, int start, int near) const;
  int make(int a, int b, int c);
  template <class Wanted>
  int find_in_fan(int start, int node, Wanted is_wanted) const;
  int find_towards(int start, int node, Vec2 target) const;
  void link_both(int t, int corner, int neighbour);
  void remove_crossed();
  void flip(int t, int corner);
  bool should_flip(int t, int corner) const;
  void legalise_about(int node);
  bool clip_ears(std::vector<int>& polygon);
  void link_cavity();
  bool recover_from_any(int a, int b);
  bool bound_facet(int f, int count, std::pair<int, int> ends);
  void note(int t);
  void carve_outside(const std::vector<std::pair<int, int>>& facets);
  std::optional<int> insert_all(const std::vector<std::pair<int, int>>& facets);

  const std::vector<Vec2>& points_;
  std::array<Vec2, 3> frame_;  // far points -1, -2, -3 while building
  std::vector<VoidTriangle> triangles_;
  std::vector<int> free_;
  std::vector<Side> facet_side_;
  std::vector<int> hint_;  // per node a triangle at it; only while building
  // Scratch of recover() and insert(), kept to avoid allocation.
  std::vector<int> crossed_, made_, left_, right_, stack_;
  std::vector<int> spoiled_;  // triangles that recover() made
  std::vector<OuterSide> outer_;
  int most_crossed_ = 64;  // a side across more triangles is no side of an element that fits
};

}  // namespace paver
