// Remeshing of a piece of the mesh with as few irregular nodes as its outline
// allows.
#pragma once

#include "paving/cleanup_edit.h"

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
  /// Finds the fill of least energy. False when none lowers the energy by
  /// `least` or more.
  bool find_fill(double least, Change& fill);

 private:
  void absorb_star(int node);
  bool make_convex(int most_elements);
  bool trace_outline();
  bool weigh_corners();
  double energy_now() const;
  double best_corners(double limit);
  bool is_fillable(const std::vector<int>& corners);
  void make_fill(Change& fill);
  void make_grid(int a, int b, Change& fill);
  Vec2 place(int node, const Change& fill) const;
  int around(int i) const { return loop_[(i + 2 * loop_.size()) % loop_.size()]; }
  int& grid(int s, int t) { return grid_[s * 64 + t]; }

  MeshEdit& edit_;
  RegionMesh& mesh_;
  std::vector<int> elements_;
  std::vector<int> stamp_;            // per element: run_ when inside
  std::vector<int> next_, next_run_;  // per node: the outline node after it
  int run_ = 0, trace_ = 0;
  std::vector<int> loop_, wanted_;
  std::vector<double> as_flat_, as_corner_;
  std::vector<int> corners_, trial_, spokes_, grid_;
};

}  // namespace paver
