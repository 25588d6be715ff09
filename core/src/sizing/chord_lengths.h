// Lengths that bring the mesh as near to the surface as is asked for.
#pragma once

#include <string>
#include <vector>

#include "mesh/far_place.h"
#include "paver/options.h"
#include "paver/result.h"
#include "sizing/parts/size_source.h"

namespace paver {

/// Of faces, and about places inside them.
struct ShorterLengths {
  std::vector<LocalSize> faces;
  std::vector<SizeSource> places;

  bool is_empty() const { return faces.empty() && places.empty(); }
};

/// From mesh to mesh of one model: where it is too far off it gets shorter lengths, until it is not, or until that does
/// not help.
class ChordLengths {
 public:
  /// Of `most`: how far places are off that are looked at. Between those that are too far off, and about them after
  /// the next paving, others will be.
  static constexpr double near_enough = 0.5;

  /// `most`: largest distance, mm. `order`: of the elements.
  ChordLengths(double most, int order) : most_(most), order_(order) {}

  /// Lengths for what is too far off in this mesh; none: done. `length`: per entry of the report what it was meshed at,
  /// mm. `far`: by entries of the report, all from near_enough on; lengths are about these where they are few.
  ShorterLengths next(const std::vector<FaceReport>& faces, const std::vector<double>& length,
                      const std::vector<FarPlace>& far);
  /// Faces that are still too far off, in a sentence; empty: none.
  std::string note(const std::vector<FaceReport>& faces) const;

 private:
  double share(double distance, double less) const;

  double most_;
  int order_;
  int rounds_ = 0;
  std::vector<double> last_;  // per face: how far off it was at best
  std::vector<int> stalls_;   // per face: rounds since it got nearer
};

}  // namespace paver
