// From paved parts to the mesh: joined, curved, checked; on several ranks each has the share that its own parts make.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "boundary/edge_nodes.h"
#include "check/check_mesh.h"
#include "check/distance/surface_distance.h"
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

  /// Joins and curves the parts: fills in the share's mesh. What folds all the same is straightened.
  void run();
  /// After run(), and after the report has the figures of the mesh that it gave, for each of the model's faces. Faces
  /// that have faults all the same fail, and the mesh is made again without them; false when there are none.
  bool drop_faulty();
  /// When nothing is left to do to the mesh: notes what was straightened.
  void note_straightened();
  /// Fills in the share's numbers.
  void number();

  /// On all ranks, with the places that are farther off than `listed`, mm. Collective.
  MeshDistances distances(double listed) const;
  /// All but the prediction. Collective.
  MetricFigures metric() const;

 private:
  void straighten_last();
  RepairResult straighten();
  void join();
  BoundaryUse boundary_use() const;
  void curve();
  void find_invalid();
  void take_over(const RepairResult& repaired);
  void check();

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
  std::vector<MeshPart> parts_;
  std::optional<Cuts> cuts_;
  CurvedMesh curved_;  // its mesh is mesh_
  std::vector<int> invalid_quads_, invalid_triangles_;
  std::vector<int> moved_;  // nodes that mending moved, rising
  std::optional<MeshCheck> check_;
  long straightened_ = 0;
  double off_edge_ = 0;
};

}  // namespace paver
