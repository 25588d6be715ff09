// Target lengths that the user gives for parts of a model, or that its tips, gaps and holes ask for, and what follows
// around them.
#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "paver/options.h"
#include "sizing/parts/size_source.h"
#include "topology/model.h"

namespace paver {

/// Lengths in mm; infinity where nothing is asked for.
class LocalSizes {
  static constexpr double none = std::numeric_limits<double>::infinity();

 public:
  LocalSizes() = default;
  /// Throws bad_option for parts that the model does not have. `h` is the target length of the run.
  LocalSizes(const Model& model, const Options& options, double h);
  /// Sources beside those of parts.
  void add(const std::vector<SizeSource>& sources);

  bool is_empty() const { return !(least_ < none); }
  /// Length asked for on a whole face: its own and those of the solids beside or around it.
  double on_face(int face) const { return is_empty() ? none : of_face_[face]; }
  /// Length asked for on a whole edge: its own and those of its faces, of a wire that of the solids around it.
  double on_edge(const Edge& edge) const;
  /// Least over all parts of their length plus gradation times the distance to their edges or vertex, and `most`.
  double at(Vec3 x, double most = none) const { return nearest_.least(x, most); }
  /// Least of all.
  double least() const { return least_; }
  /// Corners of the face where the surface comes to a point and has a length for that.
  int tips_of(int face) const { return tips_of_face_.empty() ? 0 : tips_of_face_[face]; }
  /// Lengths that have no effect, or less than asked for, in sentences.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  void note_inside(const Model& model, const LocalSize& local);
  void put(const Model& model, const LocalSize& local, double length);
  void put_inside(const Model& model, int solid, double length);
  /// On any of the faces; `most` where that is more.
  double least_on(const std::vector<int>& faces, double most) const;
  void put_on_sharp_edges(const Model& model, const Options& options, double h);
  void put_on_tips(const Model& model, const Options& options, double h);
  void put_on_gaps(const Model& model, const Options& options, double h);
  void put_on_holes(const Model& model, double h);
  void put_on_edges(const Model& model);

  std::vector<double> of_face_;    // per face of the model
  std::vector<int> tips_of_face_;  // empty: there are none
  std::vector<double> of_edge_;    // per edge of the shape as read
  std::vector<double> of_part_;    // of solids: of what lies inside
  std::vector<std::pair<Vec3, double>> points_;
  std::vector<SizeSource> sources_;
  NearestSegment nearest_;  // of them
  double gradation_ = 0;
  double least_ = none;
  std::vector<std::string> notes_;
};

}  // namespace paver
