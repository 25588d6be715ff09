// How many elements and facets the lengths of parts ask for.
#pragma once

#include "sizing/sample_box.h"
#include "sizing/size_field.h"

namespace paver {

struct LocalCounts {
  double more_density = 0;  ///< what other parts add to the mean of 1 / h^2 over the box of the face, as rows come out
  double perimeter = 0;     ///< integral of ds / h over its loops
  SampleBox near;           ///< all of the face where other parts shorten h
  bool is_graded = false;   ///< other parts shorten h somewhere on the face
};

/// `size` with local lengths; `field` needs h, local and gradation.
LocalCounts count_with_local(const Model& model, const Face& face, const FaceSize& size, const SizeField& field);

}  // namespace paver
