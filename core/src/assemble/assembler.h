// From paved parts to the mesh: joined, curved, mended where elements turn out invalid; on several ranks each has the
// share that its own parts make.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <set>
#include <vector>

#include "boundary/edge_nodes.h"
#include "check/check_mesh.h"
#include "curving/place_nodes.h"
#include "curving/repair.h"
#include "join/cuts.h"
#include "join/join.h"
#include "parallel/pave_parts.h"
#include "paver/mesher.h"
#include "repair/divide_sides.h"
#include "topology/model.h"

namespace paver {

/// References are kept. Members are collective.
class Assembler {
 public:
  /// `begin`: told which stage begins. Failures and notes go to the share's report, whose faces are those of the model.
  Assembler(const Model& model, EdgeNodes& nodes, const std::vector<Region>& regions, PartPaver& paver,
            const Options& options, Progress& progress, Ranks& ranks, std::function<void(Stage)> begin,
            MeshShare& share);

  /// Paves all, joins and curves: fills in the share's mesh. Elements that are not as they should be are mended.
  /// Divides edges in `nodes` for that.
  void run();
  /// After run(), and after the report has the figures of the mesh that it gave, for each of the model's faces. Faces
  /// that have faults all the same fail, and the mesh is made again without them; false when there are none.
  bool drop_faulty();
  /// When nothing is left to do to the mesh: notes what was done to mend it.
  void note_mending();
  /// Fills in the share's numbers.
  void number();

  /// Largest distance to the surface, of the parts here (see chord_error()).
  double chord_error() const;

 private:
  using Faults = std::vector<long>;  // number per face, over all ranks

  void fail(const std::vector<RegionFailure>& failures);
  bool mend_parts();
  long divide_sides(const std::vector<SideToDivide>& sides);
  Faults divide_shared(const Faults& faults);
  std::vector<std::pair<int, int>> faulty_sides(std::size_t part) const;
  /// In the whole mesh, of a node of the mesh here.
  long number_of(int node) const {
    return ranks_.count() == 1 ? node : share_.node_number[static_cast<std::size_t>(node)];
  }
  Faults keep_better(const std::vector<Part>& before, std::vector<char> is_kept, const Faults& faults);
  void straighten_last(Faults& faults);
  RepairResult straighten();
  Faults join_and_curve();
  void join();
  BoundaryUse boundary_use() const;
  void curve();
  void find_invalid();
  void take_over(const RepairResult& repaired);
  Faults check();

  const Model& model_;
  EdgeNodes& nodes_;
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
  std::vector<int> moved_;  // nodes that mending moved, rising
  std::optional<MeshCheck> check_;
  std::set<PartElement> hopeless_;  // bad elements that were not to be mended as the part is
  std::array<long, 4> repairs_{};   // by moves, by filling anew, nodes inside, nodes on edges
  long straightened_ = 0;
  double off_edge_ = 0;
};

}  // namespace paver
