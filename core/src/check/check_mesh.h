// Whether a mesh is what it should be: nothing that is wrong may pass as good.
#pragma once

#include "check/checked_mesh.h"

namespace paver {

struct MeshCheck {
  MeshFaults faults;  ///< of all ranks
  AreaSlack slack;    ///< how far the faces' areas may be off, for check_areas()
};

/// Collective. `folded`: the elements of this rank whose Jacobian is not proven positive; all else is found here.
MeshCheck check_mesh(const CheckedMesh& checked, MeshFaults folded, int threads, const Progress& progress,
                     Ranks& ranks);

/// Adds faces whose mesh has an area that its elements' turn and its boundary's chords do not explain.
void check_areas(const Model& model, const std::vector<FaceReport>& faces, MeshCheck& check);

}  // namespace paver
