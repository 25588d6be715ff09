// The elementary changes of connectivity about one node.
#pragma once

#include <span>

#include "paving/cleanup/mesh_edit.h"

namespace paver {

/// Lists every elementary change about a node: doublets, collapsed quads,
/// turned edges, pairs with a triangle split otherwise, opened nodes.
class Moves {
 public:
  explicit Moves(MeshEdit& edit) : edit_(edit), mesh_(edit.mesh()) {}

  /// For each change asks wanted(energy gain, elements gone, number of elements made), which is cheap: only then the
  /// change is put together and visit(change, gain) called, until one returns true; the change is only valid during
  /// the call.
  template <class Wanted, class Visit>
  void each(int node, Wanted wanted, Visit visit) {
    if (make_doublet(node) && offer(wanted, visit)) return;
    const Star star = mesh_.star[node];  // a copy: visitors may edit and take back
    for (int e : star) {
      for (int k = 0; k < 2; ++k) {
        if (!find_collapse(e, k)) continue;
        const Star& about = mesh_.star[lost_];
        if (!wanted(gain_, std::span(about.begin(), about.end()), about.size() - 1)) continue;
        make_collapse(e);
        if (visit(change_, gain_)) return;
      }
      for (int k = 0, n = mesh_.elements[e].corners(); k < n - 1; ++k)
        if (find_pair(e, node, k) && each_division(wanted, visit)) return;
    }
    if (!collect_ring(node)) return;
    const int n = static_cast<int>(ring_.size()), step = n <= most_openings ? 1 : n / few_openings;
    for (int from = 0; from < n; from += step)
      for (int count = 1 + step; find_opening(node, from, count); count += step) {
        if (!wanted(gain_, std::span<const int>(taken_), count + 1)) continue;
        make_opening(node);
        if (visit(change_, gain_)) return;
      }
  }

 private:
  template <class Wanted, class Visit>
  bool offer(Wanted& wanted, Visit& visit) {
    gain_ = edit_.energy_gain(change_);
    return wanted(gain_, std::span<const int>(change_.gone), static_cast<int>(change_.made.size())) &&
           visit(change_, gain_);
  }
  template <class Wanted, class Visit>
  bool each_division(Wanted& wanted, Visit& visit) {
    if (outline_size_ < 6) {
      for (int turn = 0; make_small_division(turn); ++turn)
        if (offer(wanted, visit)) return true;
      return false;
    }
    weigh_outline();
    for (int turn = 0; turn < hexagon_divisions; ++turn) {
      double gain = division_gain(turn);
      if (!wanted(gain, std::span<const int>(pair_), turn < 2 ? 2 : turn < 4 ? 3 : 4)) continue;
      make_hexagon(turn);
      if (visit(change_, gain)) return true;
    }
    return false;
  }

  bool make_doublet(int node);
  bool find_collapse(int e, int k);
  void make_collapse(int e);
  bool find_pair(int e, int node, int k);
  bool make_small_division(int turn);
  void weigh_outline();
  double division_gain(int turn) const;
  void make_hexagon(int turn);
  bool collect_ring(int node);
  bool find_opening(int node, int from, int count);
  void make_opening(int node);

  static constexpr int hexagon_divisions = 7;
  // Of the openings of a node with very many elements, which are as many as their square, only some are tried.
  static constexpr int most_openings = 40, few_openings = 10;
  MeshEdit& edit_;
  RegionMesh& mesh_;
  Change change_;
  double gain_ = 0;
  int keep_ = -1, lost_ = -1;  // corners a collapse merges
  std::array<int, 2> pair_{};  // two neighbours and the outline of both
  std::array<int, 6> outline_{};
  int outline_size_ = 0;
  std::array<double, 6> less_{}, more_{};  // energy of each outline node with one element less, one more
  std::vector<int> ring_;                  // elements about a node, counter-clockwise
  bool is_closed_ = false;                 // whether the last is followed by the first
  std::vector<int> taken_;                 // of the ring: what an opening gives to the new node
};

}  // namespace paver
