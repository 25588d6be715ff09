// Smoothing of a finished mesh, all nodes at a time.
#pragma once

#include <vector>

#include "paving/front.h"

namespace paver {

/// Corners of the square (equilateral triangle) of the target length nearest to
/// the element. Returns their number, 0 for a degenerate element.
int wished_corners(const RegionMesh& mesh, const Element& e, Vec3 at[4]);

/// Sweeps over all elements: each fits its best square (equilateral triangle)
/// of the target length, and each free node goes to
/// the mean of the places its elements want it at. A node stays where moving
/// would turn an element over in the chart or make the worst one about it worse
/// than `good_jacobian` and than it was.
class Sweeper {
 public:
  static constexpr double good_jacobian = 0.7;

  explicit Sweeper(Front& front);
  void sweep();

 private:
  void move_nodes();
  void take_back_bad();
  bool check(int e);
  double capped_jacobian(const Element& e) const;

  Front& front_;
  RegionMesh& mesh_;
  std::vector<Vec3> sum_;
  std::vector<Vec2> old_p_;
  std::vector<Vec3> old_x_, old_xp_, old_xq_;
  std::vector<char> has_moved_;
  std::vector<double> old_sj_, sj_;  // per element, at most good_jacobian
  std::vector<int> stack_;
};

}  // namespace paver
