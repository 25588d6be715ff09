// The elementary changes of connectivity about one node.
#pragma once

#include "paving/cleanup_edit.h"

namespace paver {

/// Lists every elementary change about a node: doublets, collapsed quads,
/// turned edges, pairs with a triangle split otherwise, opened nodes.
class Moves {
 public:
  explicit Moves(MeshEdit& edit) : edit_(edit), mesh_(edit.mesh()) {}

  /// Calls visit(change) for each until one returns true; the change is only
  /// valid during the call.
  template <class Visit>
  void each(int node, Visit visit) {
    if (make_doublet(node) && visit(change_)) return;
    const Star star = mesh_.star[node];  // a copy: visitors may edit and take back
    for (int e : star) {
      for (int k = 0; k < 2; ++k)
        if (make_collapse(e, k) && visit(change_)) return;
      for (int k = 0, n = mesh_.elements[e].corners(); k < n - 1; ++k)
        for (int turn = 0; make_pair(e, node, k, turn); ++turn)
          if (visit(change_)) return;
    }
    if (!collect_ring(node)) return;
    for (int from = 0, n = static_cast<int>(ring_.size()); from < n; ++from)
      for (int count = 2; make_opening(node, from, count); ++count)
        if (visit(change_)) return;
  }

 private:
  bool make_doublet(int node);
  bool make_collapse(int e, int k);
  bool make_pair(int e, int node, int k, int turn);
  bool make_hexagon(const int* outline, int turn);
  bool collect_ring(int node);
  bool make_opening(int node, int from, int count);

  MeshEdit& edit_;
  RegionMesh& mesh_;
  Change change_;
  std::vector<int> ring_;   // elements about a node, counter-clockwise
  bool is_closed_ = false;  // whether the last is followed by the first
};

}  // namespace paver
