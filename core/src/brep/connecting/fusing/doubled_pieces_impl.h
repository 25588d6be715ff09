// Pieces of parts that touch but were written differently, which the kernel's fuse leaves side by side.
#pragma once

#include <IntTools_Context.hxx>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "brep/connecting/connect_impl.h"

namespace paver {

/// Pieces of different parts that lie along each other but are two: a surface and its approximation cross along many
/// lines, two planes of which one is turned by rounding along one, and the kernel keeps both.
class DoubledPieces {
 public:
  /// `fusion`: of the work; kept.
  DoubledPieces(const Workpiece& work, const Fusion& fusion);

  /// The largest distance between such pieces, or width of what is left beside common ones, mm; 0 where there are none.
  double gap(const Progress& progress);
  /// Found by gap(): parts with such pieces.
  const std::set<int>& parts() const { return doubled_; }
  /// Likewise, along each other between two common edges.
  const std::set<int>& in_lenses() const { return in_lenses_; }

  /// Pairs of parts that have a vertex in common.
  std::set<std::array<int, 2>> touching() const;

 private:
  using Pair = std::array<int, 2>;

  std::map<Pair, std::vector<TopoDS_Edge>> shared_edges() const;
  bool has_common_part(int a, int b) const;
  void note(int image, std::set<int>& parts) const { parts.insert(parts_[image].begin(), parts_[image].end()); }
  double sliver_width(const TopoDS_Face& piece) const;
  double gap_between(Pair pair, const std::vector<TopoDS_Edge>& edges) const;
  std::optional<double> distance(const gp_Pnt& point, const TopoDS_Face& face) const;

  const Fusion& fusion_;
  const double diagonal_;
  std::vector<int> pieces_of_;        // of each face
  std::vector<std::set<int>> parts_;  // of each image
  std::set<int> doubled_, in_lenses_;
  Handle(IntTools_Context) context_ = new IntTools_Context;
};

}  // namespace paver
