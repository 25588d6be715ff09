// Triangles that were one face.
#pragma once

#include <string>
#include <vector>

#include "paver/options.h"
#include "paver/result.h"
#include "topology/model.h"

namespace paver {

/// Where most faces of a part are flat triangles, as of an STL file, its faces in one plane are meshed as one: the
/// largest of them, whose surface the others refer to then. Not across what other parts have, or a user named or gave a
/// length. Nothing with Options::merge 0.
std::vector<Merge> join_coplanar_triangles(Model& model, const Options& options);

/// In one sentence; empty where there are none.
std::string note_coplanar_triangles(const std::vector<Merge>& merges);

}  // namespace paver
