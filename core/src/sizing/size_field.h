// Target length on faces and along edges: the global h, limited by curvature.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "paver/options.h"
#include "paver/progress.h"
#include "topology/model.h"

namespace paver {

/// Target length h over one face's (u, v): the global h where the face is flat enough, less where it turns.
class FaceSize {
 public:
  /// Flat face: `h` everywhere.
  explicit FaceSize(double h) : h_(h) {}
  /// Grid of `nu` x `nv` samples (row after row in u) over the box lo..hi of (u, v); bilinear between.
  FaceSize(double h, Vec2 lo, Vec2 hi, int nu, int nv, std::vector<double> samples);
  double at(Vec2 uv) const;
  /// The same field, all values times `factor`.
  FaceSize scaled(double factor) const;
  /// Least value anywhere.
  double least() const;

 private:
  double h_;
  Vec2 lo_, hi_;
  int nu_ = 0, nv_ = 0;
  std::vector<double> samples_;
};

struct SizeField {
  double h = 0;  ///< target length of the run, mm
  double gradation = 0.3;
  double turn_limit = 0.785;  ///< radians per element edge
  /// Radians per boundary edge shorter than h, where it stays as close to its curve as an edge of length h that turns
  /// by turn_limit; 0: turn_limit holds for it, too.
  double short_turn_limit = 0;
  std::vector<FaceSize> faces;    ///< per face of the model
  std::vector<double> predicted;  ///< elements, per face of the model; 0 for faces that are not meshed

  /// Longest boundary edge along a curve of this curvature (1 / mm).
  double longest_edge(double curvature) const;
  /// Whether a boundary edge of this length may turn so much.
  bool may_turn(double turn, double length) const;
  double largest_turn() const { return std::max(turn_limit, short_turn_limit); }
};

/// Samples curvature; predicts the element count and throws too_many_elements above options.max_elements.
SizeField build_size_field(const Model& model, const Options& options, Progress& progress);

}  // namespace paver
