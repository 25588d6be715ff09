// What is small against the target length.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "paver/options.h"
#include "sizing/merging/model_edits.h"
#include "sizing/parts/local_sizes.h"

namespace paver {

/// Up to here edges and faces run on without a corner (degrees): merging changes their shape little.
inline constexpr double smooth_angle = 40;
/// Of the target length: no mesh could show what is narrower.
inline constexpr double hairline = 1e-4;
/// Of short edges.
inline constexpr double tiny_share = 0.2;

/// Limits at places of a model. Keeps references to its arguments.
class MergeLimits {
 public:
  /// `lasting`: thin faces that cannot be merged.
  MergeLimits(const ModelEdits& edits, const Options& options, const std::vector<int>& lasting);

  /// Of the run.
  double target_length() const { return h_; }
  /// Target length at an edge: no longer than the largest of the faces about it.
  double length(int edge) const;
  /// Edges shorter than this are merged, mm.
  double short_edge(int edge) const { return edge_share_ * length(edge); }
  /// What is smaller than this goes whatever angles it makes.
  double tiny(int edge) const { return tiny_share * short_edge(edge); }
  /// The same for faces narrower than this.
  double thin_face(int edge) const { return face_share_ * length(edge); }
  double extent(int face) const;
  /// Longest edge that is no periodic one, or -1.
  int longest_edge(int face) const;
  /// Mean width: area by half the length of the border.
  double width(int face) const;
  /// Whether it is one of the thin faces that cannot be merged.
  bool lasts(int face) const { return std::ranges::find(lasting_, face) != lasting_.end(); }
  /// Whether the face is narrower than thin_face() of its longest edge, in the mean.
  bool is_thin(int face) const;
  /// Whether it is, and a neighbour at one of its long edges goes on from it without a corner.
  bool may_be_merged(int face) const;
  /// The other face of one of two, or -1.
  int neighbour(int face, int edge) const;
  /// Largest angle between the face and its neighbour along an edge; nothing where both must stay as they are.
  std::optional<double> corner_across(int face, int edge) const;
  /// Whether the face has a sharp corner, or a spike, where the edge is once that has become a point.
  bool sharpens(int face, int edge) const;
  /// A wire, where more than two faces meet, or where the user asks for a length.
  bool is_protected(int edge) const;
  bool is_protected_face(int face) const;
  /// Whether the user asks for a length of the edge, or it is a wire.
  bool has_own_length(int edge) const;
  /// A free edge, one where more than two faces meet, one that separates parts, or a corner of the surface.
  bool is_sharp(int edge) const;
  /// Whether an edge that is sharp and not short ends at the vertex, `ignored` aside: nodes lie at both its ends. It
  /// may end elsewhere by a distance that is nothing against the target length.
  bool holds(int vertex, const std::vector<int>& ignored, double distance) const;
  /// What lies in front of two faces or behind them differs, or one of them is a sheet on a solid and the other bare.
  bool separates_parts(int face, int other) const;

 private:
  double angle_along(int one, int two, int edge) const;
  Vec3 normal(int face, int edge, double share) const;

  const ModelEdits& edits_;
  const std::vector<int>& lasting_;
  double h_, edge_share_, face_share_;
  LocalSizes local_;
  mutable std::vector<double> extent_;  // per face; negative: not measured yet
  std::vector<char> is_local_face_, is_local_edge_;
};

}  // namespace paver
