// Which faces are mended, and which way is kept, follows from counts over all ranks.
#include "assemble/assembler.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "assemble/neighbourhood.h"
#include "mesh/flat_elements.h"
#include "quality/element_figures.h"
#include "quality/jacobian.h"

namespace paver {
namespace {

constexpr int most_splits = 3;        // rounds of splitting quads that stay invalid
constexpr int rings_of_mending = 12;  // farther than straighten_at_edges() reaches

bool has_any(const std::vector<long>& invalid) {
  return std::any_of(invalid.begin(), invalid.end(), [](long n) { return n > 0; });
}

long sum(const std::vector<long>& counts) { return std::accumulate(counts.begin(), counts.end(), 0L); }

}  // namespace

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
  begin_(Stage::paving);
  fail(paver_.pave());
  std::vector<long> closed(regions_.size(), 0);
  for (const Part& part : paver_.parts())
    if (part.paved) closed[part.region] += part.paved->counts.closed_by_triangulation;
  ranks_.add_up(closed);
  for (std::size_t r = 0; r < regions_.size(); ++r)
    report_.faces[regions_[r].face].closed_by_triangulation += closed[r];
  Invalid invalid = join_and_curve();
  int next = 1;
  for (int last : {1, further_attempts}) {
    for (; next <= last && has_any(invalid); ++next) invalid = pave_invalid(std::move(invalid), next);
    invalid = split_invalid(std::move(invalid));
    if (options_.order > 1) straighten_last(invalid);
    if (!has_any(invalid)) break;
  }
  note_invalid(invalid);
  report_.tasks = paver_.times();
}

void Assembler::fail(const std::vector<RegionFailure>& failures) {
  for (const RegionFailure& failure : failures) {
    FaceReport& face = report_.faces[regions_[failure.region].face];
    if (face.status == FaceStatus::failed) continue;
    face.status = FaceStatus::failed;
    face.stage = failure.stage;
    face.reason = failure.reason;
    face.where = failure.where;
  }
}

// Paves the faces with invalid elements in another way and keeps it where it leaves fewer.
Assembler::Invalid Assembler::pave_invalid(Invalid invalid, int attempt) {
  const std::vector<Part> before = paver_.parts();
  std::vector<char> is_kept(regions_.size(), 1);
  for (std::size_t r = 0; r < regions_.size(); ++r) is_kept[r] = invalid[regions_[r].face] > 0;
  for (const RegionFailure& failure : paver_.pave_again(is_kept, attempt)) {
    for (std::size_t r = 0; r < regions_.size(); ++r)
      if (regions_[r].face == regions_[failure.region].face) is_kept[r] = 0;
  }
  auto put_back = [&] {
    std::vector<Part> parts;
    for (const Part& part : paver_.parts())
      if (is_kept[part.region]) parts.push_back(part);
    for (const Part& part : before)
      if (!is_kept[part.region]) parts.push_back(part);
    std::stable_sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.region < b.region; });
    paver_.put(std::move(parts));
  };
  put_back();
  Invalid now = join_and_curve();
  bool is_reverted = false;
  for (std::size_t r = 0; r < regions_.size(); ++r) {
    const int face = regions_[r].face;
    if (!is_kept[r] || now[face] < invalid[face]) continue;
    is_kept[r] = 0;
    is_reverted = true;
  }
  if (!is_reverted) return now;
  put_back();
  return join_and_curve();
}

// Invalid quads become two triangles each, as long as that leaves fewer invalid elements.
Assembler::Invalid Assembler::split_invalid(Invalid invalid) {
  for (int round = 0; round < most_splits; ++round) {
    long quads = static_cast<long>(invalid_quads_.size());
    ranks_.add_up({&quads, 1});
    if (quads == 0) break;
    const std::vector<Part> before = paver_.parts();
    std::vector<Part> parts = before;
    std::map<int, std::shared_ptr<PavedRegion>> changed;
    for (int q : invalid_quads_) {
      auto [part, element] = joined_.quad_source[q];
      std::shared_ptr<PavedRegion>& copy = changed[part];
      if (!copy) copy = std::make_shared<PavedRegion>(*parts[part].paved);
      split_quad(copy->mesh, element);
    }
    for (auto& [part, copy] : changed) parts[part].paved = std::move(copy);
    paver_.put(std::move(parts));
    Invalid now = join_and_curve();
    if (sum(now) >= sum(invalid)) {
      paver_.put(before);
      return join_and_curve();
    }
    invalid = std::move(now);
  }
  return invalid;
}

Assembler::Invalid Assembler::join_and_curve() {
  begin_(Stage::join);
  join();
  begin_(Stage::curving);
  return curve();
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
    if (!region.laid) continue;
    for (int global : region.laid->global)
      if (global >= 0) use.nodes[global] = 1;
  }
  return use;
}

void Assembler::join() {
  while (true) {
    std::vector<JoinPart> parts;
    for (const Part& part : paver_.parts()) {
      const int face = regions_[part.region].face;
      const bool is_here = part.paved && report_.faces[face].status == FaceStatus::meshed;
      parts.push_back({face, is_here ? &part.paved->mesh : nullptr, paver_.outline_of(part.region)});
    }
    std::vector<RegionFailure> failures;
    try {
      joined_ = join_regions(model_, nodes_, boundary_use(), parts, paver_.outline_nodes());
    } catch (const Error& error) {
      if (error.code() != ErrorCode::face_failed) throw;
      auto is_of = [&](const Region& region) { return region.face == error.where().face; };
      const auto region = std::find_if(regions_.begin(), regions_.end(), is_of);
      failures.push_back(
          {static_cast<int>(region - regions_.begin()), stage_name(Stage::join), error.what(), error.where().point});
    }
    failures = gather_failures(failures, ranks_);
    if (failures.empty()) break;
    fail(failures);
  }
  parts_.clear();
  for (std::size_t i = 0; i < paver_.parts().size(); ++i) {
    const Part& part = paver_.parts()[i];
    const bool is_here = !joined_.node_of[i].empty();
    parts_.push_back({&paver_.place_of(part), is_here ? &part.paved->mesh : nullptr, &joined_.node_of[i],
                      paver_.outline_of(part.region)});
  }
}

// Raises the order; gives the number of elements per face whose Jacobian is not proven positive.
Assembler::Invalid Assembler::curve() {
  straightened_ = 0;
  if (options_.order == 1) {
    mesh_ = std::move(joined_.mesh);
    invalid_quads_ = find_invalid(mesh_, true);
    invalid_triangles_.clear();
    return count_invalid();
  }
  std::vector<CutSide> outlines;
  for (std::size_t r = 0; r < regions_.size(); ++r)
    for (auto [a, b] : paver_.outline_sides(static_cast<int>(r)))
      outlines.push_back({regions_[r].face, std::min(a, b), std::max(a, b), nullptr, {}, {}});
  cuts_.emplace(regions_, std::move(outlines));
  curved_ = curve_elements(joined_, nodes_, model_, *cuts_, parts_, options_.threads, progress_);
  mesh_ = std::move(curved_.mesh);
  RepairResult repaired =
      repair_elements(mesh_, is_valid, find_invalid(mesh_, true), find_invalid(mesh_, false), curved_.first_inside);
  straightened_ = repaired.recentred + repaired.straightened;
  invalid_quads_ = repaired.invalid_quads;
  invalid_triangles_ = repaired.invalid_triangles;
  return count_invalid();
}

Assembler::Invalid Assembler::count_invalid() {
  Invalid invalid(model_.faces.size(), 0);
  for (int q : invalid_quads_) ++invalid[mesh_.quad_face[q]];
  for (int t : invalid_triangles_) ++invalid[mesh_.triangle_face[t]];
  ranks_.add_up(invalid);
  return invalid;
}

void Assembler::straighten_last(Invalid& invalid) {
  if (!has_any(invalid)) return;
  const RepairResult last = straighten();
  if (last.recentred + last.straightened == 0) return;
  if (ranks_.rank() == 0) straightened_ += last.recentred + last.straightened;
  report_.notes.push_back(fmt::format(
      "To keep elements valid sides were straightened along B-rep edges, up to {:.3g} mm off.", last.off_edge));
  invalid_quads_ = last.invalid_quads;
  invalid_triangles_ = last.invalid_triangles;
  invalid = count_invalid();
}

// Sides on B-rep edges have neighbours on other ranks: all mend the same neighbourhood, each keeps what is its own.
RepairResult Assembler::straighten() {
  if (ranks_.count() == 1) return straighten_at_edges(mesh_, is_valid, invalid_quads_, invalid_triangles_);
  number();
  Neighbourhood about = gather_neighbourhood(share_, invalid_quads_, invalid_triangles_, rings_of_mending, ranks_);
  RepairResult result = straighten_at_edges(about.mesh, is_valid, about.invalid_quads, about.invalid_triangles);
  put_nodes_back(about, share_);
  result.invalid_quads = rows_here(result.invalid_quads, about.quad_number, share_.quad_number);
  result.invalid_triangles = rows_here(result.invalid_triangles, about.triangle_number, share_.triangle_number);
  return result;
}

void Assembler::note_invalid(const Invalid& invalid) {
  ranks_.add_up({&straightened_, 1});
  if (straightened_ > 0)
    report_.notes.push_back(fmt::format("{} curved elements were straightened to keep them valid.", straightened_));
  std::map<std::string, long> count;
  for (std::size_t face = 0; face < invalid.size(); ++face)
    if (invalid[face] > 0) count[model_.faces[face].name] += invalid[face];
  for (const auto& [face, n] : count)
    report_.notes.push_back(fmt::format(
        "{} has {} elements that could not be made valid; use a smaller size or max-turn.", face, n));
}

double Assembler::chord_error() const { return paver::chord_error(mesh_, model_, parts_, options_.threads); }

}  // namespace paver
