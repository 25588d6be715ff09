// Steps: coarse meshes of large regions, given to all ranks; all parts, dearest first; regions of which a piece failed
// once more, whole. What a rank found out reaches the others by gather().
#include "parallel/pave_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <nlohmann/json.hpp>
#include <numeric>

#include "brep/kernel_guard.h"

namespace paver {
namespace {

constexpr double planned_cost = 0.25;  // of an element on levels, by one that is paved

RegionFailure failure_of(int region, const Error& error) {
  return {region, error.where().stage, error.what(), error.where().point};
}

std::string to_text(const std::vector<RegionFailure>& failures) {
  auto list = nlohmann::json::array();
  for (const RegionFailure& f : failures) {
    auto where = nlohmann::json::array();
    if (f.where) where = {f.where->x, f.where->y, f.where->z};
    list.push_back({f.region, f.stage, f.reason, where});
  }
  return list.dump();
}

void add_from_text(std::string_view text, std::vector<RegionFailure>& failures) {
  for (const auto& f : nlohmann::json::parse(text)) {
    RegionFailure failure{f[0], f[1], f[2], std::nullopt};
    if (!f[3].empty()) failure.where = Vec3{f[3][0], f[3][1], f[3][2]};
    failures.push_back(failure);
  }
}

}  // namespace

PartPaver::PartPaver(const std::vector<Region>& regions, std::vector<double> costs, int boundary_nodes,
                     const Options& options, Progress& progress, Ranks& ranks)
    : regions_(regions),
      costs_(std::move(costs)),
      boundary_nodes_(boundary_nodes),
      options_(options),
      progress_(progress),
      ranks_(ranks),
      plans_(regions.size()) {}

std::vector<RegionFailure> PartPaver::pave() {
  plan();
  replace(std::vector<char>(regions_.size(), 0));
  std::vector<int> all(parts_.size());
  std::iota(all.begin(), all.end(), 0);
  progress_.begin(Stage::paving, static_cast<long>(parts_.size()));
  std::vector<RegionFailure> failures;
  std::vector<char> is_whole = run_parts(all, failures, [this](const Part& part) { return pave_part(part); });
  if (std::count(is_whole.begin(), is_whole.end(), 1) == 0) return failures;
  replace(is_whole);
  std::vector<int> again;
  for (std::size_t i = 0; i < parts_.size(); ++i)
    if (is_whole[parts_[i].region]) again.push_back(static_cast<int>(i));
  run_parts(again, failures, [this](const Part& part) { return pave_part(part); });
  return failures;
}

std::vector<RegionFailure> PartPaver::pave_again(const std::vector<char>& is_wanted, int attempt) {
  replace(is_wanted);
  std::vector<int> again;
  for (std::size_t i = 0; i < parts_.size(); ++i)
    if (is_wanted[parts_[i].region]) again.push_back(static_cast<int>(i));
  std::vector<RegionFailure> failures;
  run_parts(again, failures, [&](const Part& part) {
    return pave_region_again(regions_[part.region], attempt, progress_, options_.elements);
  });
  return failures;
}

// Regions without levels cost nothing here.
void PartPaver::plan() {
  const std::vector<DoneTask> done = run_tasks(
      options_.threads, costs_, [&] { return ranks_.take(queue_); },
      [&](int i) {
        plans_[i] = plan_levels(regions_[i], options_.multilevel, boundary_nodes_, progress_, options_.elements);
      });
  ++queue_;
  note_times(Stage::regions, done);
  exchange_plans(done);
}

void PartPaver::note_times(Stage stage, const std::vector<DoneTask>& done) {
  for (const DoneTask& task : done) times_.push_back({stage, task.seconds});
}

void PartPaver::exchange_plans(const std::vector<DoneTask>& done) {
  if (ranks_.count() == 1) return;
  std::string mine;
  for (const DoneTask& task : done) {
    const int i = task.task;
    if (!plans_[i]) continue;
    const std::string plan = pack(*plans_[i]);
    for (std::size_t number : {static_cast<std::size_t>(i), plan.size()})
      mine.append(reinterpret_cast<const char*>(&number), sizeof number);
    mine += plan;
  }
  const std::vector<std::string> all = ranks_.gather(mine);
  for (int rank = 0; rank < ranks_.count(); ++rank) {
    if (rank == ranks_.rank()) continue;
    for (std::string_view rest = all[rank]; !rest.empty();) {
      std::size_t head[2];
      std::copy_n(rest.data(), sizeof head, reinterpret_cast<char*>(head));
      plans_[head[0]] = unpack_plan(rest.substr(sizeof head, head[1]));
      rest.remove_prefix(sizeof head + head[1]);
    }
  }
}

PavedRegion PartPaver::pave_part(const Part& part) {
  const Region& region = regions_[part.region];
  if (part.piece < 0) return pave_region(region, progress_, options_.elements);
  return lay_piece(region, *part.place, *plans_[part.region], static_cast<std::size_t>(part.piece), progress_,
                   options_.elements);
}

// Gives, per region, whether one of its pieces failed: on all ranks the same.
std::vector<char> PartPaver::run_parts(const std::vector<int>& which, std::vector<RegionFailure>& failures,
                                       const std::function<PavedRegion(const Part&)>& pave) {
  std::vector<double> cost;
  for (int i : which) cost.push_back(parts_[i].cost);
  std::vector<long> has_failed(regions_.size(), 0);
  std::vector<RegionFailure> mine;
  std::mutex mutex;
  auto note = [&](const Part& part, const Error& error) {
    std::lock_guard lock(mutex);
    if (part.piece >= 0)
      has_failed[part.region] = 1;
    else
      mine.push_back(failure_of(part.region, error));
  };
  const std::vector<DoneTask> done = run_tasks(
      options_.threads, cost, [&] { return ranks_.take(queue_); },
      [&](int k) {
        Part& part = parts_[which[k]];
        if (part.piece >= 0) part.place = std::make_shared<Region>(without_loops(regions_[part.region]));
        try {
          guard_kernel({stage_name(Stage::paving), regions_[part.region].face, -1, {}},
                       [&] { part.paved = std::make_shared<PavedRegion>(pave(part)); });
        } catch (const Error& error) {
          if (error.code() == ErrorCode::cancelled) throw;
          note(part, error);
        }
        progress_.advance();
      });
  ++queue_;
  note_times(Stage::paving, done);
  ranks_.add_up(has_failed);
  std::vector<RegionFailure> all;
  for (const std::string& text : ranks_.gather(to_text(mine))) add_from_text(text, all);
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.region < b.region; });
  failures.insert(failures.end(), all.begin(), all.end());
  std::vector<char> is_whole;
  for (long n : has_failed) is_whole.push_back(n > 0);
  return is_whole;
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

std::vector<std::array<int, 2>> PartPaver::outline_sides(int region) const {
  if (!is_in_pieces_[region]) return {};
  std::vector<std::array<int, 2>> sides = plans_[region]->outline_sides;
  for (auto& side : sides)
    for (int& node : side)
      if (node >= boundary_nodes_) node += first_outline_[region];
  return sides;
}

}  // namespace paver
