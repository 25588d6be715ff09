// Figures of a mesh that no ranks share.
#pragma once

#include <vector>

#include "quality/report.h"

namespace paver {

inline QualityReport measure_quality(const SurfaceMesh& mesh, double target_length,
                                     const std::vector<bool>& edge_is_periodic, std::vector<FaceReport>& faces,
                                     const Progress& progress) {
  SingleRank alone;
  MeshShare share{whole_numbers(mesh), {}};
  share.result.mesh = mesh;
  return measure_quality(share, target_length, edge_is_periodic, faces, progress, alone);
}

}  // namespace paver
