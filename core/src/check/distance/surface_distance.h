// How far a mesh is from the surfaces and curves that it stands for.
#pragma once

#include <limits>
#include <vector>

#include "boundary/edge_nodes.h"
#include "curving/order2.h"
#include "join/join.h"
#include "mesh/far_place.h"
#include "paver/progress.h"
#include "paver/ranks.h"
#include "paver/result.h"
#include "regions/region.h"
#include "topology/model.h"

namespace paver {

struct DistanceTask {
  const Model& model;
  const EdgeNodes& edges;
  const SurfaceMesh& mesh;  ///< what the parts that are here were joined to, curved or not
  const std::vector<MeshPart>& parts;
  const std::vector<PartSizes>& sizes;  ///< per part: what of the mesh is its
  double target_length = 0;
  int threads = 1;
  double most = std::numeric_limits<double>::infinity();  ///< what is farther off is listed
};

struct MeshDistances {
  std::vector<SurfaceDistance> faces;  ///< of the model
  std::vector<FarPlace> far;           ///< in any order, without targets
};

/// Collective: the same on all ranks, for any number of them. A point of the mesh is no farther
/// from the surface than `largest`; and since the foot points of a mesh that covers its face do so, too, and sides are
/// measured against their curves, no point of the face is farther from the mesh. Sampled: within about a tenth where
/// the surface is smooth over an element.
MeshDistances measure_distances(const DistanceTask& task, const Progress& progress, Ranks& ranks);

/// Of several faces.
SurfaceDistance join_distances(const SurfaceDistance& a, long a_elements, const SurfaceDistance& b, long b_elements);

}  // namespace paver
