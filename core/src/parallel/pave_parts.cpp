// Steps: all regions, dearest first, of large ones the coarse mesh, which all ranks get; their pieces; regions of which
// a piece failed once more, whole. What a rank found out reaches the others by gather().
#include "parallel/pave_parts.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>

#include "base/tasks/gather.h"
#include "brep/kernel_guard.h"
#include "multilevel/pieces.h"

namespace paver {
namespace {

constexpr double planned_cost = 0.25;   // of an element on levels, by one that is paved
constexpr double planning_share = 0.2;  // of the work on a region on levels

}  // namespace

template <class A>
void fields(A& archive, Is<RegionFailure> auto& failure) {
  auto& [region, stage, reason, where] = failure;
  archive(region, stage, reason, where);
}

std::vector<RegionFailure> gather_failures(const std::vector<RegionFailure>& mine, Ranks& ranks) {
  std::vector<RegionFailure> all = gather_all(mine, ranks);
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.region < b.region; });
  return all;
}

void report_failures(const std::vector<RegionFailure>& failures, const std::vector<Region>& regions,
                     RunReport& report) {
  for (const RegionFailure& failure : failures) {
    FaceReport& face = report.faces[regions[failure.region].face];
    if (face.status != FaceStatus::failed) face.fail(failure.stage, failure.reason, failure.where);
  }
}

PartPaver::PartPaver(const std::vector<Region>& regions, std::vector<double> costs, int boundary_nodes,
                     const Options& options, Progress& progress, Ranks& ranks, int first_queue)
    : regions_(regions),
      costs_(std::move(costs)),
      boundary_nodes_(boundary_nodes),
      options_(options),
      progress_(progress),
      ranks_(ranks),
      queue_(first_queue),
      plans_(regions.size()) {}

std::vector<RegionFailure> PartPaver::pave() {
  progress_.begin(Stage::paving, std::lround(std::accumulate(costs_.begin(), costs_.end(), 1.0)));
  std::vector<RegionFailure> failures = pave_regions();
  std::vector<char> is_whole(regions_.size(), 0);
  for (const RegionFailure& failure : lay_pieces()) is_whole[failure.region] = 1;
  if (std::count(is_whole.begin(), is_whole.end(), 1) == 0) return failures;
  for (const RegionFailure& failure : pave_whole(is_whole)) failures.push_back(failure);
  return failures;
}

// Small regions are paved while others make the coarse meshes of large ones.
std::vector<RegionFailure> PartPaver::pave_regions() {
  for (std::size_t r = 0; r < regions_.size(); ++r) parts_.push_back(whole(static_cast<int>(r)));
  auto all = [](const Part&) { return true; };
  const std::vector<RegionFailure> failures = run(Stage::regions, all, [&](Part& part) {
    const Region& region = regions_[part.region];
    std::optional<LevelPlan>& plan = plans_[part.region];
    plan = plan_levels(region, options_.multilevel, boundary_nodes_, progress_, options_.elements);
    if (!plan) part.paved = std::make_shared<PavedRegion>(pave_region(region, progress_, options_.elements));
    advance(plan ? planning_share * part.cost : part.cost);
  });
  exchange_plans();
  std::vector<Part> parts;
  for (Part& part : parts_)
    if (plans_[part.region])
      add_pieces(part.region, parts);
    else
      parts.push_back(std::move(part));
  put(std::move(parts));
  return failures;
}

std::vector<RegionFailure> PartPaver::lay_pieces() {
  auto is_piece = [](const Part& part) { return part.piece >= 0; };
  return run(Stage::paving, is_piece, [&](Part& part) {
    const Region& region = regions_[part.region];
    const LevelPlan& plan = *plans_[part.region];
    part.place = std::make_shared<Region>(without_loops(region));
    part.paved = std::make_shared<PavedRegion>(
        lay_piece(region, *part.place, plan, static_cast<std::size_t>(part.piece), progress_, options_.elements));
    advance((1 - planning_share) * costs_[part.region] / static_cast<double>(plan.pieces.size()));
  });
}

std::vector<RegionFailure> PartPaver::pave_whole(const std::vector<char>& is_wanted) {
  std::vector<Part> parts;
  for (Part& part : parts_)
    if (!is_wanted[part.region])
      parts.push_back(std::move(part));
    else if (part.piece == 0)
      parts.push_back(whole(part.region));
  put(std::move(parts));
  auto is_due = [&](const Part& part) { return is_wanted[part.region] != 0; };
  return run(Stage::regions, is_due, [&](Part& part) {
    part.paved = std::make_shared<PavedRegion>(pave_region(regions_[part.region], progress_, options_.elements));
  });
}

// Failures are the same on all ranks, by region.
std::vector<RegionFailure> PartPaver::run(Stage stage, const std::function<bool(const Part&)>& is_due,
                                          const std::function<void(Part&)>& pave) {
  std::vector<Part*> due;
  std::vector<double> costs;
  for (Part& part : parts_)
    if (is_due(part)) due.push_back(&part), costs.push_back(part.cost);
  std::vector<RegionFailure> mine;
  std::mutex mutex;
  const std::vector<DoneTask> done = run_tasks(
      options_.threads, costs, [&] { return ranks_.take(queue_); },
      [&](int k) {
        try {
          guard_kernel({stage_name(Stage::paving), regions_[due[k]->region].face, -1, {}}, [&] { pave(*due[k]); });
        } catch (const Error& error) {
          if (error.code() == ErrorCode::cancelled) throw;
          std::lock_guard lock(mutex);
          mine.push_back({due[k]->region, error.where().stage, error.what(), error.where().point});
        }
      });
  ++queue_;
  for (const auto& [task, seconds] : done)
    times_.push_back({stage, seconds, due[task]->paved ? due[task]->paved->mesh.living_elements() : 0});
  return gather_failures(mine, ranks_);
}

void PartPaver::advance(double cost) { progress_.advance(std::max(1L, std::lround(cost))); }

// Each rank has the plans that it made.
void PartPaver::exchange_plans() {
  if (ranks_.count() == 1) return;
  std::vector<std::pair<int, std::string>> mine;  // region and plan
  for (std::size_t i = 0; i < plans_.size(); ++i)
    if (plans_[i]) mine.emplace_back(static_cast<int>(i), pack(*plans_[i]));
  for (const auto& [region, plan] : gather_all(mine, ranks_))
    if (!plans_[region]) plans_[region] = unpack_plan(plan);
}

void PartPaver::add_pieces(int region, std::vector<Part>& parts) const {
  const LevelPlan& plan = *plans_[region];
  for (std::size_t i = 0; i < plan.pieces.size(); ++i) {
    const bool is_paved = plan.is_paved[plan.pieces[i].front()] != 0;
    const double cost = (is_paved ? 1 : planned_cost) * fine_elements(plan, plan.pieces[i]);
    parts.push_back({region, static_cast<int>(i), cost, nullptr, nullptr});
  }
}

void PartPaver::put(std::vector<Part> parts) {
  parts_ = std::move(parts);
  first_outline_.assign(1, 0);
  is_in_pieces_.assign(regions_.size(), 0);
  for (const Part& part : parts_) is_in_pieces_[part.region] |= part.piece >= 0;
  for (std::size_t r = 0; r < regions_.size(); ++r)
    first_outline_.push_back(first_outline_.back() + (is_in_pieces_[r] ? plans_[r]->outline_nodes : 0));
}

// Outline nodes are numbered behind those of the boundary stage.
void PartPaver::add_boundary_nodes(int more) {
  for (Part& part : parts_) {
    if (part.piece < 0 || !part.paved) continue;
    auto copy = std::make_shared<PavedRegion>(*part.paved);
    for (int& global : copy->mesh.global)
      if (global >= boundary_nodes_ + added_) global += more;
    part.paved = std::move(copy);
  }
  added_ += more;
}

std::vector<std::array<int, 2>> PartPaver::outline_sides(int region) const {
  if (!is_in_pieces_[region]) return {};
  std::vector<std::array<int, 2>> sides = plans_[region]->outline_sides;
  for (auto& side : sides)
    for (int& node : side)
      if (node >= boundary_nodes_) node += first_outline_[region] + added_;
  return sides;
}

}  // namespace paver
