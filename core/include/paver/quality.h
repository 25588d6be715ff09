// Figures of every single element of a mesh.
#pragma once

#include <cstdint>
#include <vector>

#include "paver/result.h"

namespace paver {

/// Quads first, then triangles, in the order of the mesh. Definitions: core/docs/quality.md.
struct ElementQuality {
  std::vector<double> sj;              ///< straight-sided scaled Jacobian, -1 to 1
  std::vector<double> jacobian_ratio;  ///< lower bound of the curved Jacobian over its mean; 0 or less: not valid
  std::vector<double> area;            ///< mm^2, of the curved element
  std::vector<std::int8_t> validity;   ///< 0: Jacobian proven positive, 1: inverted, 2: undecided
};

ElementQuality element_quality(const SurfaceMesh& mesh);

}  // namespace paver
