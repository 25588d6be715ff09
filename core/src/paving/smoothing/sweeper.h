// Smoothing of a finished mesh, all nodes at a time.
#pragma once

#include <vector>

#include "paving/front/front.h"

namespace paver {

/// Sweeps over the elements: each fits its best square (equilateral triangle)
/// of the target length, and each free node goes to
/// the mean of the places its elements want it at. A node stays where moving
/// would turn an element over in the chart or make the worst one about it worse
/// than `good_jacobian` and than it was; after the first sweep only nodes near
/// those that still moved are looked at.
class Sweeper {
 public:
  static constexpr double good_jacobian = 0.7;

  explicit Sweeper(Front& front);
  /// False when nothing moved far any more.
  bool sweep();

 private:
  void collect_elements();
  void gather_wishes();
  void move_nodes();
  void take_back_bad();
  void collect_nodes();
  void add_node(int node);
  bool check(int e);
  float capped_jacobian(const Element& e) const;

  Front& front_;
  RegionMesh& mesh_;
  std::vector<int> nodes_, elements_, next_;  // nodes to look at and the elements about them
  std::vector<MetricVec> sum_;                // per node: of its elements' wishes, then where it was
  std::vector<Vec2> last_;                    // per node: its last step in the chart
  std::vector<float> scale_;                  // per node: of the mesh there at the start
  std::vector<Vec2> old_;                     // per entry of nodes_: where it was in the chart
  std::vector<int> moved_as_;                 // per node: its entry of nodes_ when it moved in this sweep, or -1
  std::vector<int> seen_, seen_node_;         // per element, per node: the sweep that listed it last
  std::vector<float> old_sj_, sj_;            // per element, at most good_jacobian
  std::vector<int> stack_;
  int run_ = 0;
};

}  // namespace paver
