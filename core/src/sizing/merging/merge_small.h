// What is small against the target length is not resolved: chains of short edges are divided as one, thin and tiny
// faces are left to their neighbours. Triangles that were one face are one again.
#pragma once

#include <string>
#include <vector>

#include "paver/options.h"
#include "paver/result.h"
#include "topology/model.h"

namespace paver {

struct CoplanarTriangles {
  std::vector<Merge> merges;
  long small = 0;  ///< faces left of these parts that are smaller than half the target length: elements are no larger
};

/// Where most faces of a part are flat triangles, as of an STL file, its faces in one plane are meshed as one: the
/// largest of them, whose surface the others refer to then. Not across what other parts have, or a user named or gave a
/// length. Nothing with Options::merge 0.
CoplanarTriangles join_coplanar_triangles(Model& model, const Options& options);

/// In a sentence each.
std::vector<std::string> notes_of(const CoplanarTriangles& joined);

/// Changes the model; gives what was merged. Nothing where options.merge is 0.
std::vector<Merge> merge_small(Model& model, const Options& options);

/// One sentence, or nothing.
std::string note_merges(const std::vector<Merge>& merges);

}  // namespace paver
