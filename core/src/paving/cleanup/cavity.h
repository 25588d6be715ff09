// Remeshing of a piece of the mesh with as few irregular nodes as its outline
// allows.
#pragma once

#include <optional>

#include "paving/cleanup/mesh_edit.h"

namespace paver {

/// A disk of elements that grows about a node and can be filled anew: as a grid
/// when its outline has four corners, or as three or five grids about one node.
/// Outline nodes where that costs no more may serve as corner or not.
class Cavity {
 public:
  explicit Cavity(MeshEdit& edit) : edit_(edit), mesh_(edit.mesh()) {}

  void start(int node);
  /// A number that tells outlines apart, for those tried before.
  std::size_t outline_key() const;
  /// One more ring of elements, and more where the outline is re-entrant. False
  /// when it is no disk or too large.
  bool grow(int most_elements);
  /// What the fill of least energy adds to it (below 0: lowers), -`least` or less; nothing when there is none.
  std::optional<double> find_fill(double least);
  /// Lays the fill found last. False, and the fill is not whole, where its spread, new nodes taken where they are laid,
  /// is more than `most_spread` above that of the elements it replaces.
  bool make_fill(Change& fill, double most_spread);

 private:
  void absorb_star(int node);
  void absorb(int e);
  void add_node(int node);
  void cut_side(int a, int b);
  bool make_convex(int most_elements);
  bool trace_outline();
  bool weigh_corners();
  bool has_fixed_inside() const;
  double best_corners(double limit);
  bool is_fillable(const std::vector<int>& corners);
  bool make_star(Change& fill);
  bool make_grid(int a, int b, Change& fill);
  double side_spread(int a, int b, bool is_outer) const;
  int add_fresh(Vec2 p, const MetricVec& x, Change& fill);
  Vec2 chart_place(int node, const Change& fill) const;
  MetricVec place(int node) const;
  int around(int i) const { return loop_[(i + 2 * loop_.size()) % loop_.size()]; }
  int& grid(int s, int t) { return grid_[s * 64 + t]; }

  MeshEdit& edit_;
  RegionMesh& mesh_;
  struct Rim {  // of one node, valid when run is run_
    int run = 0;
    int inside = 0;                   // its elements within the cavity
    std::array<int, 2> next{-1, -1};  // ends of the outline sides that start here; two where the outline touches itself
  };

  std::vector<int> elements_, nodes_;
  std::vector<int> stamp_;  // per element: run_ when inside
  std::vector<Rim> rim_;
  int run_ = 0;
  int sides_ = 0;          // of the outline
  int doubled_ = 0;        // nodes where the outline touches itself
  std::size_t first_ = 0;  // the nodes before this one are not on the outline any more
  bool is_knot_ = false;   // an outline node has more than two sides ahead
  double energy_ = 0;      // of all nodes and triangles
  std::vector<int> loop_, wanted_;
  std::vector<double> as_flat_, as_corner_;
  std::vector<int> corners_, spokes_, grid_;
  std::vector<int> trial_, trial_spokes_;  // of the corners looked at; spokes_ belong to corners_
  std::vector<int> cheap_;                 // outline nodes that may yet be corners or not against their wish
  std::vector<MetricVec> fresh_x_;         // of the fill's new nodes, blended like their chart places
  double fresh_h_ = 0;                     // their target length
  double spread_left_ = 0;                 // that the rest of the fill may have
};

}  // namespace paver
