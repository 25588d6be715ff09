// From paved parts to the mesh: joined, curved, mended where elements turn out invalid; on several ranks each has the
// share that its own parts make.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "boundary/edge_nodes.h"
#include "curving/place_nodes.h"
#include "curving/repair.h"
#include "join/cuts.h"
#include "join/join.h"
#include "parallel/pave_parts.h"
#include "paver/mesher.h"
#include "topology/model.h"

namespace paver {

/// References are kept. Members are collective.
class Assembler {
 public:
  /// `begin`: told which stage begins. Failures and notes go to the share's report, whose faces are those of the model.
  Assembler(const Model& model, const EdgeNodes& nodes, const std::vector<Region>& regions, PartPaver& paver,
            const Options& options, Progress& progress, Ranks& ranks, std::function<void(Stage)> begin,
            MeshShare& share);

  /// Paves all, joins and curves: fills in the share's mesh. Faces with invalid elements are paved with other rows,
  /// then mended element by element; where that is not enough they are paved finer and mended again.
  void run();
  /// Fills in the share's numbers.
  void number();

  /// Largest distance to the surface, of the parts here (see chord_error()).
  double chord_error() const;

 private:
  using Invalid = std::vector<long>;  // per face, over all ranks

  void fail(const std::vector<RegionFailure>& failures);
  Invalid pave_invalid(Invalid invalid, int attempt);
  Invalid split_invalid(Invalid invalid);
  void straighten_last(Invalid& invalid);
  RepairResult straighten();
  Invalid join_and_curve();
  void join();
  BoundaryUse boundary_use() const;
  Invalid curve();
  Invalid count_invalid();
  void note_invalid(const Invalid& invalid);

  const Model& model_;
  const EdgeNodes& nodes_;
  const std::vector<Region>& regions_;
  PartPaver& paver_;
  const Options& options_;
  Progress& progress_;
  Ranks& ranks_;
  const std::function<void(Stage)> begin_;
  MeshShare& share_;
  RunReport& report_;  // the share's
  SurfaceMesh& mesh_;  // the share's
  JoinedMesh joined_;
  std::vector<CurvingPart> parts_;
  std::optional<Cuts> cuts_;
  CurvedMesh curved_;  // its mesh is mesh_
  std::vector<int> invalid_quads_, invalid_triangles_;
  long straightened_ = 0;
};

}  // namespace paver
