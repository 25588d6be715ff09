// Steps: all regions, dearest first, of large ones the coarse mesh, which all ranks get; their pieces; regions of which
// a piece failed once more, whole. What a rank found out reaches the others by gather().
#include "parallel/pave_parts.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>

#include "base/tasks/gather.h"
#include "brep/kernel_guard.h"

namespace paver {
namespace {

constexpr double planned_cost = 0.25;   // of an element on levels, by one that is paved
constexpr double planning_share = 0.2;  // of the work on a region on levels

RegionFailure failure_of(int region, const Error& error) {
  return {region, error.where().stage, error.what(), error.where().point};
}

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
    FaceReport& face = report.faces[static_cast<std::size_t>(regions[static_cast<std::size_t>(failure.region)].face)];
    if (face.status == FaceStatus::failed) continue;
    face.status = FaceStatus::failed;
    face.stage = failure.stage;
    face.reason = failure.reason;
    face.where = failure.where;
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
  std::vector<int> all(regions_.size());
  std::iota(all.begin(), all.end(), 0);
  std::vector<std::shared_ptr<const PavedRegion>> paved(regions_.size());
  const std::vector<RegionFailure> failures = run(Stage::regions, all, costs_, [&](int i) {
    const Region& region = regions_[i];
    plans_[i] = plan_levels(region, options_.multilevel, boundary_nodes_, progress_, options_.elements);
    if (!plans_[i]) paved[i] = std::make_shared<PavedRegion>(pave_region(region, progress_, options_.elements));
    advance(plans_[i] ? planning_share * costs_[i] : costs_[i]);
    return paved[i] ? paved[i]->mesh.living_elements() : 0;
  });
  exchange_plans();
  replace(std::vector<char>(regions_.size(), 0));
  for (Part& part : parts_)
    if (part.piece < 0) part.paved = paved[part.region];
  return failures;
}

std::vector<RegionFailure> PartPaver::lay_pieces() {
  std::vector<int> pieces, region_of;
  std::vector<double> costs;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (parts_[i].piece < 0) continue;
    pieces.push_back(static_cast<int>(i));
    region_of.push_back(parts_[i].region);
    costs.push_back(parts_[i].cost);
  }
  return run(Stage::paving, region_of, costs, [&](int k) {
    Part& part = parts_[pieces[k]];
    const Region& region = regions_[part.region];
    const LevelPlan& plan = *plans_[part.region];
    part.place = std::make_shared<Region>(without_loops(region));
    part.paved = std::make_shared<PavedRegion>(
        lay_piece(region, *part.place, plan, static_cast<std::size_t>(part.piece), progress_, options_.elements));
    advance((1 - planning_share) * costs_[part.region] / static_cast<double>(plan.pieces.size()));
    return part.paved->mesh.living_elements();
  });
}

std::vector<RegionFailure> PartPaver::pave_whole(const std::vector<char>& is_wanted) {
  replace(is_wanted);
  std::vector<int> which, region_of;
  std::vector<double> costs;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const int region = parts_[i].region;
    if (!is_wanted[region]) continue;
    which.push_back(static_cast<int>(i));
    region_of.push_back(region);
    costs.push_back(costs_[region]);
  }
  return run(Stage::regions, region_of, costs, [&](int k) {
    const auto paved = std::make_shared<PavedRegion>(pave_region(regions_[region_of[k]], progress_, options_.elements));
    parts_[which[k]].paved = paved;
    return paved->mesh.living_elements();
  });
}

// Tasks give the number of elements they laid. Failures are the same on all ranks, by region.
std::vector<RegionFailure> PartPaver::run(Stage stage, const std::vector<int>& region_of,
                                          const std::vector<double>& costs, const std::function<long(int)>& task) {
  std::vector<long> elements(costs.size(), 0);
  std::vector<RegionFailure> mine;
  std::mutex mutex;
  const std::vector<DoneTask> done = run_tasks(
      options_.threads, costs, [&] { return ranks_.take(queue_); },
      [&](int k) {
        try {
          guard_kernel({stage_name(Stage::paving), regions_[region_of[k]].face, -1, {}},
                       [&] { elements[k] = task(k); });
        } catch (const Error& error) {
          if (error.code() == ErrorCode::cancelled) throw;
          std::lock_guard lock(mutex);
          mine.push_back(failure_of(region_of[k], error));
        }
      });
  ++queue_;
  for (const DoneTask& one : done) times_.push_back({stage, one.seconds, elements[one.task]});
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

// Regions marked 1 become one part each, the others stay; at first all are made.
void PartPaver::replace(const std::vector<char>& is_whole) {
  std::vector<Part> old = std::move(parts_);
  parts_.clear();
  auto next = old.begin();
  for (int r = 0; r < static_cast<int>(regions_.size()); ++r) {
    auto end = std::find_if(next, old.end(), [r](const Part& part) { return part.region != r; });
    if (next != end && !is_whole[r]) {
      parts_.insert(parts_.end(), next, end);
    } else if (is_whole[r] || !plans_[r]) {
      parts_.push_back({r, -1, costs_[r], nullptr, nullptr});
    } else {
      for (std::size_t i = 0; i < plans_[r]->pieces.size(); ++i) {
        double fine = 0;
        bool is_paved = false;
        for (int e : plans_[r]->pieces[i])
          fine += fine_elements(*plans_[r], e), is_paved |= plans_[r]->is_paved[e] != 0;
        parts_.push_back({r, static_cast<int>(i), (is_paved ? 1 : planned_cost) * fine, nullptr, nullptr});
      }
    }
    next = end;
  }
  number_outlines();
}

void PartPaver::number_outlines() {
  first_outline_.assign(1, 0);
  is_in_pieces_.assign(regions_.size(), 0);
  for (const Part& part : parts_) is_in_pieces_[part.region] |= part.piece >= 0;
  for (std::size_t r = 0; r < regions_.size(); ++r)
    first_outline_.push_back(first_outline_.back() + (is_in_pieces_[r] ? plans_[r]->outline_nodes : 0));
}

void PartPaver::put(std::vector<Part> parts) {
  parts_ = std::move(parts);
  number_outlines();
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
