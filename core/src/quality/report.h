// Figures of a whole mesh and of each of its faces.
#pragma once

#include <vector>

#include "paver/mesher.h"
#include "paver/progress.h"
#include "paver/result.h"

namespace paver {

/// Measures a mesh of order 1 to 4 that all ranks hold together, collective: every rank gets the figures of the whole,
/// bit for bit those of one rank. Definitions: core/docs/quality.md.
/// `target_length`: h of the run, mm, > 0. `edge_is_periodic`: per B-rep edge, whether one face uses it twice; nodes on
/// such edges count as nodes inside the face. The mesh's lines must hold every divided edge that is not a pole.
/// `faces`: one per B-rep face of the whole, the same on all ranks; quads, triangles, worst_sj, longest_side and
/// mesh_area are filled in, cad_area is summed. distance stays 0: the caller knows the surfaces. Checks `progress` for
/// cancel and credits nothing. Runs on the threads of the calling arena; the figures do not depend on their number.
QualityReport measure_quality(const MeshShare& share, double target_length, const std::vector<bool>& edge_is_periodic,
                              std::vector<FaceReport>& faces, const Progress& progress, Ranks& ranks);

}  // namespace paver
