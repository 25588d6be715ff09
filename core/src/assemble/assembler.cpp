// What is straightened follows from counts over all ranks.
#include "assemble/assembler.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "assemble/neighbourhood.h"
#include "mesh/element_table.h"
#include "quality/element_figures.h"
#include "quality/jacobian/jacobian.h"
#include "quality/metric_figures.h"

namespace paver {

Assembler::Assembler(const Model& model, const EdgeNodes& nodes, const std::vector<Region>& regions, PartPaver& paver,
                     const Options& options, Progress& progress, Ranks& ranks, std::function<void(Stage)> begin,
                     MeshShare& share)
    : model_(model),
      nodes_(nodes),
      regions_(regions),
      paver_(paver),
      options_(options),
      progress_(progress),
      ranks_(ranks),
      begin_(std::move(begin)),
      share_(share),
      report_(share.result.report),
      mesh_(share.result.mesh) {}

void Assembler::run() {
  begin_(Stage::join);
  join();
  begin_(Stage::curving);
  curve();
  check();
  straighten_last();
}

bool Assembler::drop_faulty() {
  if (report_.quality.inverted + report_.quality.undecided > 0) {
    find_invalid();
    check();
  }
  check_areas(model_, report_.faces, *check_);
  const MeshFaults faults = check_->faults;
  for (int f : faults.faces()) {
    FaceReport& face = report_.faces[f];
    face.fail(stage_name(Stage::quality), faults.reason(f), faults.where(f));
    face.worst_sj = 1;
  }
  if (faults.empty()) return false;
  run();
  return true;
}

// Of faces that failed nothing stays: what no other face uses would hang in the mesh.
BoundaryUse Assembler::boundary_use() const {
  BoundaryUse use{std::vector<char>(nodes_.nodes.size(), 0), std::vector<char>(nodes_.edges.size(), 0)};
  for (const Region& region : regions_) {
    if (report_.faces[region.face].status != FaceStatus::meshed) continue;
    for (const auto& loop : region.loops)
      for (const LoopNode& node : loop) {
        use.nodes[node.global] = 1;
        if (node.edge >= 0) use.edges[node.edge] = 1;
      }
    for (const Fan& fan : region.fans) use.nodes[fan.centre.global] = 1;
  }
  for (std::size_t e = 0; e < nodes_.edges.size(); ++e) {
    if (model_.edges[e].is_wire()) use.edges[e] = 1;
    if (use.edges[e])
      for (int node : nodes_.edges[e].node) use.nodes[node] = 1;
  }
  return use;
}

void Assembler::join() {
  while (true) {
    parts_.clear();
    for (const Part& part : paver_.parts()) {
      const Region& region = paver_.place_of(part);
      const bool is_here = part.paved && report_.faces[region.face].status == FaceStatus::meshed;
      parts_.push_back({&region, is_here ? &part.paved->mesh : nullptr, nullptr, paver_.outline_of(part.region)});
    }
    std::vector<RegionFailure> failures;
    try {
      joined_ = join_regions(model_, nodes_, boundary_use(), parts_,
                             {paver_.outline_nodes(), options_.order, options_.threads});
    } catch (const Error& error) {
      if (error.code() != ErrorCode::face_failed) throw;
      auto is_of = [&](const Region& region) { return region.face == error.where().face; };
      const auto region = std::find_if(regions_.begin(), regions_.end(), is_of);
      failures.push_back(
          {static_cast<int>(region - regions_.begin()), stage_name(Stage::join), error.what(), error.where().point});
    }
    failures = gather_failures(failures, ranks_);
    if (failures.empty()) break;
    report_failures(failures, regions_, report_);
  }
  for (std::size_t i = 0; i < parts_.size(); ++i) parts_[i].node_of = &joined_.node_of[i];
}

// Raises the order and finds the elements whose Jacobian is not proven positive.
void Assembler::curve() {
  straightened_ = 0, off_edge_ = 0;
  moved_.clear();
  if (options_.order == 1) {
    mesh_ = std::move(joined_.mesh);
    find_invalid();
    return;
  }
  std::vector<CutSide> outlines;
  for (std::size_t r = 0; r < regions_.size(); ++r)
    for (auto [a, b] : paver_.outline_sides(static_cast<int>(r)))
      outlines.push_back({regions_[r].face, std::min(a, b), std::max(a, b), nullptr, {}, {}});
  cuts_.emplace(regions_, std::move(outlines));
  curved_ = curve_elements(std::move(joined_.mesh), {joined_.sizes, nodes_, model_, *cuts_, parts_, options_.threads},
                           progress_);
  mesh_ = std::move(curved_.mesh);
  find_invalid();
}

void Assembler::find_invalid() {
  invalid_quads_ = paver::find_invalid(mesh_, true);
  invalid_triangles_ = paver::find_invalid(mesh_, false);
}

void Assembler::take_over(const RepairResult& repaired) {
  invalid_quads_ = repaired.invalid_quads;
  invalid_triangles_ = repaired.invalid_triangles;
  std::vector<int> moved;
  std::set_union(moved_.begin(), moved_.end(), repaired.moved.begin(), repaired.moved.end(), std::back_inserter(moved));
  moved_ = std::move(moved);
}

void Assembler::check() {
  begin_(Stage::quality);
  MeshFaults folded;
  auto add = [&](const ElementTable& table, const std::vector<int>& invalid) {
    for (int element : invalid) {
      const int* v = table.row(static_cast<std::size_t>(element));
      folded.add(table.face[element], FaultKind::folded, 0.5 * (mesh_.nodes[v[0]] + mesh_.nodes[v[2]]));
    }
  };
  add({mesh_, true}, invalid_quads_);
  add({mesh_, false}, invalid_triangles_);
  number();
  CheckedMesh checked{model_, nodes_, mesh_, parts_, joined_.sizes, share_.node_number, moved_};
  checked.target_length = target_length(options_);
  checked.shared_nodes = static_cast<int>(joined_.boundary_nodes) + static_cast<int>(joined_.outline.size());
  for (const FaceReport& face : report_.faces) checked.is_meshed.push_back(face.status == FaceStatus::meshed);
  check_ = check_mesh(checked, std::move(folded), options_.threads, progress_, ranks_);
}

// What no repair made valid: inside parts first, then along B-rep edges.
void Assembler::straighten_last() {
  auto count = [this] {
    long invalid = static_cast<long>(invalid_quads_.size() + invalid_triangles_.size());
    ranks_.add_up({&invalid, 1});
    return invalid;
  };
  if (options_.order == 1 || count() == 0) return;
  const RepairResult inside =
      repair_elements(mesh_, is_valid, invalid_quads_, invalid_triangles_, curved_.first_inside);
  straightened_ += inside.straightened;
  take_over(inside);
  if (count() > 0) {
    const RepairResult last = straighten();
    if (ranks_.rank() == 0) straightened_ += last.straightened;
    off_edge_ = last.off_edge;
    take_over(last);
  }
  check();
}

// Sides on B-rep edges have neighbours on other ranks: all mend the same neighbourhood, each keeps what is its own.
RepairResult Assembler::straighten() {
  constexpr int rings = 12;  // farther than straighten_at_edges() reaches
  number();
  Neighbourhood about = gather_neighbourhood(share_, invalid_quads_, invalid_triangles_, rings, ranks_);
  RepairResult result = straighten_at_edges(about.mesh, is_valid, about.invalid_quads, about.invalid_triangles);
  put_nodes_back(about, share_);
  result.moved = rows_here(result.moved, about.node_number, share_.node_number);
  result.invalid_quads = rows_here(result.invalid_quads, about.quad_number, share_.quad_number);
  result.invalid_triangles = rows_here(result.invalid_triangles, about.triangle_number, share_.triangle_number);
  return result;
}

void Assembler::note_straightened() {
  report_.off_edge = off_edge_;
  if (off_edge_ > 0)
    report_.notes.push_back(fmt::format(
        "To keep elements valid sides were straightened along B-rep edges, up to {:.3g} mm off.", off_edge_));
  ranks_.add_up({&straightened_, 1});
  if (straightened_ > 0)
    report_.notes.push_back(fmt::format("{} curved elements were straightened to keep them valid.", straightened_));
}

MetricFigures Assembler::metric() const {
  std::vector<const RegionMesh*> meshes;
  for (const MeshPart& part : parts_) meshes.push_back(part.mesh);
  return measure_metric(meshes, options_.threads, progress_, ranks_);
}

MeshDistances Assembler::distances(double listed) const {
  return measure_distances(
      {model_, nodes_, mesh_, parts_, joined_.sizes, report_.target_length, options_.threads, listed}, progress_,
      ranks_);
}

}  // namespace paver
