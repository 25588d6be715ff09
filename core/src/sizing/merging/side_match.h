// The two long sides of a narrow face, edge for edge.
#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "sizing/merging/model_edits.h"

namespace paver {

/// A place on a side: one of its edges, and the edge's parameter.
struct SidePlace {
  std::size_t at = 0;
  double t = 0;
  double share = 0;  ///< of the side's length
};

/// Points along a side.
class SideCurve {
 public:
  SideCurve(const ModelEdits& edits, const Side& side);

  double length() const { return length_; }
  /// At a share of the length, as the edges' parameters go.
  SidePlace at(double share) const;
  Vec3 point(const SidePlace& place) const;
  /// Nearest to x.
  SidePlace nearest(Vec3 x) const;
  /// Of x; where it is less than `enough` any such number.
  double distance(Vec3 x, double enough) const;
  /// Share of the vertex before edge i.
  double begin(std::size_t i) const { return begins_[i]; }

 private:
  struct Sample {
    std::size_t index = 0;
    double distance = 0;
  };

  const std::vector<Vec3>& samples() const;
  Sample nearest_sample(Vec3 x) const;
  SidePlace nearest(Vec3 x, const Sample& sample) const;

  const ModelEdits& edits_;
  const Side& side_;
  std::vector<double> begins_;  // one more than edges
  double length_ = 0;
  mutable std::vector<Vec3> samples_;  // at equal shares, made when first asked for
};

/// Largest distance of points of either side from the other one; where it is beyond `limit` any such number.
double distance_between(const ModelEdits& edits, const Side& one, const Side& two, double limit = INFINITY);

/// Angle between the planes of two closed sides that run the same way.
double tilt_between(const ModelEdits& edits, const Side& one, const Side& two);

/// Divides edges of both sides until their vertices lie opposite each other. False, and nothing has changed, where
/// those would be farther apart than `most` or would leave edges shorter than it.
bool divide_alike(ModelEdits& edits, Side& one, Side& two, double most);

/// Of each parameter of edge `one` the opposite one of edge `two`, which runs the same way unless `is_against`.
std::shared_ptr<const ParameterMatch> match_edges(const Edge& one, const Edge& two, bool is_against);

}  // namespace paver
