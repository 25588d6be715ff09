// Lengths that bring the mesh as near to the surface as is asked for.
#pragma once

#include <string>
#include <vector>

#include "paver/options.h"
#include "paver/result.h"

namespace paver {

/// From mesh to mesh of one model: faces that are too far off get shorter lengths, until they are not, or until that
/// does not help.
class ChordLengths {
 public:
  /// `most`: largest distance, mm. `order`: of the elements.
  ChordLengths(double most, int order) : most_(most), order_(order) {}

  /// Lengths for faces that are too far off in this mesh; none: done. `length`: per entry of the report what it was
  /// meshed at, mm.
  std::vector<LocalSize> next(const std::vector<FaceReport>& faces, const std::vector<double>& length);
  /// Faces that are still too far off, in a sentence; empty: none.
  std::string note(const std::vector<FaceReport>& faces) const;

 private:
  double most_;
  int order_;
  int rounds_ = 0;
  std::vector<double> last_;  // per face: how far off it was at best
  std::vector<int> stalls_;   // per face: rounds since it got nearer
};

}  // namespace paver
