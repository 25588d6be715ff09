// Which faces are mended, and which way is kept, follows from counts over all ranks.
#include "assemble/assembler.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "assemble/neighbourhood.h"
#include "base/bytes.h"
#include "paving/inner_sides.h"
#include "quality/element_figures.h"
#include "quality/jacobian.h"
#include "repair/mend_region.h"

namespace paver {
namespace {

constexpr int most_rounds = 4;        // of mending: what divided sides of one face leave of another
constexpr int rings_of_mending = 12;  // farther than straighten_at_edges() reaches

bool has_any_edge(const Region& region, const std::set<int>& edges) {
  for (const auto& loop : region.loops)
    for (const LoopNode& node : loop)
      if (edges.contains(node.edge)) return true;
  return false;
}

}  // namespace

Assembler::Assembler(const Model& model, EdgeNodes& nodes, const std::vector<Region>& regions, PartPaver& paver,
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
  Faults faults = join_and_curve();
  for (int round = 0; round < most_rounds && mend_parts(); ++round) faults = join_and_curve();
  faults = divide_shared(faults);
  straighten_last(faults);
  report_.tasks = paver_.times();
}

bool Assembler::drop_faulty() {
  if (report_.quality.inverted + report_.quality.undecided > 0) {
    find_invalid();
    check();
  }
  check_areas(model_, report_.faces, *check_);
  const MeshFaults faults = check_->faults;
  for (int f : faults.faces()) {
    FaceReport& face = report_.faces[static_cast<std::size_t>(f)];
    face.status = FaceStatus::failed;
    face.stage = stage_name(Stage::quality);
    face.reason = faults.reason(f);
    face.where = faults.where(f);
    face.worst_sj = 1;
  }
  if (faults.empty()) return false;
  Faults left = join_and_curve();
  straighten_last(left);
  return true;
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

// Bad elements are mended where they are, part by part; sides on B-rep edges of those that are left are divided on all
// faces. False when there is nothing to mend, or nothing could be done.
bool Assembler::mend_parts() {
  std::vector<PartElement> bad = check_->turned;
  for (int q : invalid_quads_) bad.push_back({joined_.quad_source[q][0], joined_.quad_source[q][1]});
  for (int t : invalid_triangles_) bad.push_back({joined_.triangle_source[t][0], joined_.triangle_source[t][1]});
  std::sort(bad.begin(), bad.end());
  bad.erase(std::unique(bad.begin(), bad.end()), bad.end());
  std::erase_if(bad, [&](const PartElement& one) { return hopeless_.contains(one); });
  std::vector<Part> parts = paver_.parts();
  std::vector<SideToDivide> sides;
  long changes = 0;
  for (auto first = bad.begin(); first != bad.end();) {
    const int part = first->part;
    const auto last = std::find_if(first, bad.end(), [&](const PartElement& one) { return one.part != part; });
    std::vector<int> elements;
    std::transform(first, last, std::back_inserter(elements), [](const PartElement& one) { return one.element; });
    first = last;
    auto copy = std::make_shared<PavedRegion>(*parts[part].paved);
    const Mended mended = mend_region(regions_[parts[part].region], nodes_, options_.order, options_.elements,
                                      std::move(elements), copy->mesh);
    sides.insert(sides.end(), mended.sides.begin(), mended.sides.end());
    for (int e : mended.left) hopeless_.insert({part, e});
    repairs_[0] += mended.moved, repairs_[1] += mended.refilled, repairs_[2] += mended.divided;
    if (!mended.has_changed()) continue;
    ++changes;
    parts[part].paved = std::move(copy);
  }
  if (options_.elements != Elements::all_quad)
    for (const Part& part : parts)
      if (part.paved)
        std::ranges::move(sides_beside_nodes(regions_[part.region], nodes_, part.paved->mesh),
                          std::back_inserter(sides));
  paver_.put(std::move(parts));
  changes += divide_sides(sides);
  ranks_.add_up({&changes, 1});
  return changes > 0;
}

// Those that any rank asks for, on all; the number of them.
long Assembler::divide_sides(const std::vector<SideToDivide>& sides) {
  std::vector<SideToDivide> all;
  for (const std::string& bytes : ranks_.gather(bytes_of(sides)))
    for (const SideToDivide& side : from_bytes<SideToDivide>(bytes)) all.push_back(side);
  const std::vector<DividedSide> divided = divide_intervals(model_, std::move(all), nodes_);
  if (ranks_.rank() == 0) repairs_[3] += static_cast<long>(divided.size());
  if (divided.empty()) return 0;
  paver_.add_boundary_nodes(static_cast<int>(divided.size()));
  std::set<int> edges;
  for (const DividedSide& side : divided) edges.insert(nodes_.node_edge[static_cast<std::size_t>(side.node)]);
  std::vector<Part> parts = paver_.parts();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Part& part = parts[i];
    const Region& region = regions_[part.region];
    if (!part.paved || !has_any_edge(region, edges)) continue;
    std::erase_if(hopeless_, [&](const PartElement& one) { return one.part == static_cast<int>(i); });
    auto copy = std::make_shared<PavedRegion>(*part.paved);
    divide_boundary_sides(region, nodes_, divided, options_.order, kinds_of(options_.elements), copy->mesh);
    part.paved = std::move(copy);
  }
  paver_.put(std::move(parts));
  return static_cast<long>(divided.size());
}

// Several faces have sides between the same two nodes of their boundaries: those inside a face get a node.
Assembler::Faults Assembler::divide_shared(const Faults& faults) {
  if (options_.elements == Elements::all_quad || check_->faults.sides().empty()) return faults;
  const std::vector<Part> before = paver_.parts();
  std::vector<Part> parts = before;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto sides = faulty_sides(i);
    if (sides.empty()) continue;
    auto copy = std::make_shared<PavedRegion>(*parts[i].paved);
    divide_inner_sides(regions_[parts[i].region], sides, copy->mesh);
    parts[i].paved = std::move(copy);
  }
  std::vector<char> is_kept(regions_.size(), 0);
  for (std::size_t r = 0; r < regions_.size(); ++r)
    for (const FaultySide& side : check_->faults.sides()) is_kept[r] |= side.face == regions_[r].face;
  paver_.put(std::move(parts));
  return keep_better(before, std::move(is_kept), faults);
}

// Of the part on this rank, by its own nodes: in the same order whichever rank found them.
std::vector<std::pair<int, int>> Assembler::faulty_sides(std::size_t part) const {
  std::vector<std::pair<int, int>> sides;
  const int face = regions_[paver_.parts()[part].region].face;
  const std::vector<int>& node_of = joined_.node_of[part];
  auto own = [&](long number) {
    for (std::size_t i = 0; i < node_of.size(); ++i)
      if (node_of[i] >= 0 && number_of(node_of[i]) == number) return static_cast<int>(i);
    return -1;
  };
  for (const FaultySide& side : check_->faults.sides()) {
    if (side.face != face || node_of.empty()) continue;
    const int a = own(side.low), b = own(side.high);
    if (a >= 0 && b >= 0) sides.push_back(std::minmax({a, b}));
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

// Of the regions that are marked, and were changed, those of faces that have fewer faults stay changed.
Assembler::Faults Assembler::keep_better(const std::vector<Part>& before, std::vector<char> is_kept,
                                         const Faults& faults) {
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
  Faults now = join_and_curve();
  bool is_reverted = false;
  for (std::size_t r = 0; r < regions_.size(); ++r) {
    const int face = regions_[r].face;
    if (!is_kept[r] || now[face] < faults[face]) continue;
    is_kept[r] = 0;
    is_reverted = true;
  }
  if (!is_reverted) return now;
  put_back();
  return join_and_curve();
}

Assembler::Faults Assembler::join_and_curve() {
  begin_(Stage::join);
  join();
  begin_(Stage::curving);
  curve();
  return check();
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
  for (std::size_t e = 0; e < nodes_.edges.size(); ++e) {
    if (model_.edges[e].is_wire()) use.edges[e] = 1;
    if (use.edges[e])
      for (int node : nodes_.edges[e].node) use.nodes[node] = 1;
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
  curved_ = curve_elements(joined_, nodes_, model_, *cuts_, parts_, options_.threads, progress_);
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

// A fold may bring other faults along; what becomes of a face is decided by its folds as long as it has any.
Assembler::Faults Assembler::check() {
  begin_(Stage::quality);
  MeshFaults folded;
  auto add = [&](bool is_quad, int element) {
    const int* v = is_quad ? &mesh_.quads[static_cast<std::size_t>(mesh_.nodes_per_quad() * element)]
                           : &mesh_.triangles[static_cast<std::size_t>(mesh_.nodes_per_triangle() * element)];
    folded.add((is_quad ? mesh_.quad_face : mesh_.triangle_face)[static_cast<std::size_t>(element)], FaultKind::folded,
               0.5 * (mesh_.nodes[v[0]] + mesh_.nodes[v[2]]));
  };
  for (int quad : invalid_quads_) add(true, quad);
  for (int triangle : invalid_triangles_) add(false, triangle);
  static const std::vector<long> as_here;
  const bool is_alone = ranks_.count() == 1;
  if (!is_alone) number();
  CheckedMesh checked{model_, nodes_, mesh_, parts_, joined_.sizes, is_alone ? as_here : share_.node_number, moved_};
  checked.target_length = target_length(options_);
  checked.shared_nodes = static_cast<int>(joined_.boundary_nodes) + static_cast<int>(joined_.outline.size());
  for (const FaceReport& face : report_.faces) checked.is_meshed.push_back(face.status == FaceStatus::meshed);
  check_ = check_mesh(checked, std::move(folded), options_.threads, progress_, ranks_);
  Faults faults;
  for (int face = 0; face < static_cast<int>(model_.faces.size()); ++face) {
    const long folds = check_->faults.count(face, FaultKind::folded);
    faults.push_back(folds > 0 ? folds : check_->faults.count(face));
  }
  return faults;
}

// What no repair made valid: inside parts first, then along B-rep edges.
void Assembler::straighten_last(Faults& faults) {
  auto count = [this] {
    long invalid = static_cast<long>(invalid_quads_.size() + invalid_triangles_.size());
    ranks_.add_up({&invalid, 1});
    return invalid;
  };
  if (options_.order == 1 || count() == 0) return;
  const RepairResult inside =
      repair_elements(mesh_, is_valid, invalid_quads_, invalid_triangles_, curved_.first_inside);
  straightened_ += inside.recentred + inside.straightened;
  take_over(inside);
  if (count() > 0) {
    const RepairResult last = straighten();
    if (ranks_.rank() == 0) straightened_ += last.recentred + last.straightened;
    off_edge_ = last.off_edge;
    take_over(last);
  }
  faults = check();
}

// Sides on B-rep edges have neighbours on other ranks: all mend the same neighbourhood, each keeps what is its own.
RepairResult Assembler::straighten() {
  if (ranks_.count() == 1) return straighten_at_edges(mesh_, is_valid, invalid_quads_, invalid_triangles_);
  number();
  Neighbourhood about = gather_neighbourhood(share_, invalid_quads_, invalid_triangles_, rings_of_mending, ranks_);
  RepairResult result = straighten_at_edges(about.mesh, is_valid, about.invalid_quads, about.invalid_triangles);
  put_nodes_back(about, share_);
  result.moved = rows_here(result.moved, about.node_number, share_.node_number);
  result.invalid_quads = rows_here(result.invalid_quads, about.quad_number, share_.quad_number);
  result.invalid_triangles = rows_here(result.invalid_triangles, about.triangle_number, share_.triangle_number);
  return result;
}

void Assembler::note_mending() {
  ranks_.add_up(repairs_);
  if (std::any_of(repairs_.begin(), repairs_.end(), [](long count) { return count > 0; }))
    report_.notes.push_back(
        fmt::format("Repaired, where elements folded or missed the surface: {} by moving nodes, {} by other elements, "
                    "{} nodes added inside faces, {} on B-rep edges.",
                    repairs_[0], repairs_[1], repairs_[2], repairs_[3]));
  if (off_edge_ > 0)
    report_.notes.push_back(fmt::format(
        "To keep elements valid sides were straightened along B-rep edges, up to {:.3g} mm off.", off_edge_));
  ranks_.add_up({&straightened_, 1});
  if (straightened_ > 0)
    report_.notes.push_back(fmt::format("{} curved elements were straightened to keep them valid.", straightened_));
}

double Assembler::chord_error() const { return paver::chord_error(mesh_, model_, parts_, options_.threads); }

}  // namespace paver
