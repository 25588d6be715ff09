// Places the nodes of order 2 inside faces: on the surface, found in the charts in which the regions were paved.
#pragma once

#include <vector>

#include "curving/order2.h"
#include "join/join.h"
#include "paver/progress.h"
#include "regions/region.h"

namespace paver {

/// One paved region with its mesh and its nodes' numbers in the joined mesh.
struct CurvingPart {
  const Region* region = nullptr;
  const RegionMesh* mesh = nullptr;  ///< null: failed, has no elements
  const std::vector<int>* node_of = nullptr;
};

/// The order-2 mesh of `linear`: middles of B-rep edges as divided, all others the surface point nearest to the middle
/// of the chord, centres the one nearest to the blend of the sides. Runs on `threads` threads.
SurfaceMesh curve_elements(const SurfaceMesh& linear, const EdgeNodes& edges, const Model& model,
                           const std::vector<CurvingPart>& parts, int threads, const Progress& progress);

/// Largest distance from a point inside each element (order 1: its centre; order 2: half way from the centre to its
/// first corner) to the surface, mm.
double chord_error(const SurfaceMesh& mesh, const std::vector<CurvingPart>& parts, int threads);

}  // namespace paver
