// Target length on faces and along edges: the global h, limited by curvature.
#pragma once

#include <algorithm>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "paver/options.h"
#include "paver/progress.h"
#include "sizing/normal_table.h"
#include "sizing/parts/local_sizes.h"
#include "sizing/sample_box.h"
#include "sizing/turn_limit.h"
#include "topology/model.h"

namespace paver {

/// Target length h over one face's (u, v): the face's own h where it is flat enough, less where it turns and near parts
/// of the model with a length of their own.
class FaceSize {
 public:
  /// Flat face: `h` everywhere.
  explicit FaceSize(double h) : h_(h) {}
  /// Grid of `side` x `side` samples (row after row in u) over the box of (u, v); bilinear between.
  FaceSize(double h, const SampleBox& box, int side, std::vector<double> samples)
      : h_(h), box_(box), side_(side), samples_(std::move(samples)) {}
  /// `surface` is the face's: only asked where lengths of parts are given.
  double at(Vec2 uv, const Surface& surface) const {
    double limited = by_curvature(uv);
    return local_ && near_parts_.contains(uv) ? around_parts(surface.point(uv), limited) : limited;
  }
  /// Without the part of other parts of the model.
  double by_curvature(Vec2 uv) const;
  /// What lengths of parts leave of `most` around them.
  double around_parts(Vec3 x, double most) const {
    return local_ ? std::min(most, scale_ * local_->at(x, most / scale_)) : most;
  }
  /// Without curvature, at a point of the surface.
  double given_at(Vec3 x) const { return around_parts(x, h_); }
  /// What a radian of the normal counts, in target lengths; 0: nothing, at() comes down where the face turns.
  double turn_weight() const { return turn_weight_; }
  /// Null where turns count for nothing.
  const NormalTable* normals() const { return normals_.get(); }
  void count_turns(double weight, std::shared_ptr<const NormalTable> normals) {
    samples_.clear(), turn_weight_ = weight, normals_ = std::move(normals);
  }
  void count_no_turns() { turn_weight_ = 0, normals_.reset(); }
  /// Length where neither curvature nor other parts shorten it.
  double own() const { return h_; }
  /// Other parts shorten h somewhere on the face.
  bool is_graded() const { return is_graded_; }
  void set_graded(bool is_graded) { is_graded_ = is_graded; }
  /// Lengths of parts, which count for at() where (u, v) lies in the box.
  void set_local(std::shared_ptr<const LocalSizes> local, const SampleBox& near) {
    local_ = std::move(local), near_parts_ = near;
  }
  /// The same field, all values times `factor`.
  FaceSize scaled(double factor) const;
  /// The same field, `h` where that is longer.
  FaceSize at_most(double h) const;
  /// Least value by the face itself and its curvature.
  double least() const;

 private:
  double h_, scale_ = 1, turn_weight_ = 0;
  bool is_graded_ = false;
  std::shared_ptr<const NormalTable> normals_;
  std::shared_ptr<const LocalSizes> local_;  // null: none are given
  SampleBox near_parts_;
  SampleBox box_;
  int side_ = 0;  // of the grid
  std::vector<double> samples_;
};

/// An edge on a face whose turns count.
struct TurningSide {
  int face = -1;
  std::shared_ptr<const ParameterCurve> pcurve;  ///< over the edge's t
};

struct SizeField {
  double h = 0;  ///< target length of the run, mm
  std::shared_ptr<const LocalSizes> local = std::make_shared<LocalSizes>();
  double gradation = 0.3;
  double turn_limit = 0.785;  ///< radians per element edge
  /// Radians per boundary edge shorter than h, where it stays as close to its curve as an edge of length h that turns
  /// by turn_limit; 0: turn_limit holds for it, too.
  double short_turn_limit = 0;
  /// Bends of edges shorter than this, in target lengths, are corners; 0: none.
  double small_bend = 0;
  std::vector<FaceSize> faces;                    ///< per face of the model
  std::vector<std::vector<TurningSide>> turning;  ///< per edge of the model
  std::vector<double> predicted;                  ///< elements, per face of the model; 0 for faces that are not meshed

  std::vector<double> face_h;     ///< per face of the model: h, or what is given for the face
  std::vector<double> perimeter;  ///< per face of the model: length of its loops in target lengths, curvature aside

  /// An edge on faces whose turns count.
  std::span<const TurningSide> turning_sides(std::size_t edge) const {
    return edge < turning.size() ? std::span<const TurningSide>(turning[edge]) : std::span<const TurningSide>();
  }
  /// h, or what is given for parts of the model, at a point of an edge.
  double given_at(const Edge& edge, Vec3 x) const {
    return local->is_empty() ? h : local->at(x, std::min(h, local->on_edge(edge)));
  }
  /// Short edges turn no more than others where one face is on both sides: about a bent pipe that is thinner than
  /// their bulge the elements along them would lie on its inner side.
  TurnLimit turn_limit_of(const Edge& edge) const;
};

/// Samples curvature; predicts the element count and throws too_many_elements above options.max_elements. `places` have
/// lengths of their own, too.
SizeField build_size_field(const Model& model, const Options& options, Progress& progress,
                           const std::vector<SizeSource>& places = {});

}  // namespace paver
