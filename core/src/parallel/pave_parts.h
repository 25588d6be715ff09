// Which rank paves what: regions and their pieces from queues that all ranks share.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/tasks/tasks.h"
#include "multilevel/multilevel.h"
#include "paver/options.h"
#include "paver/ranks.h"
#include "paver/result.h"
#include "paving/pave_region.h"
#include "regions/region.h"

namespace paver {

/// A region or one of its pieces. Every rank knows all parts, and has the meshes of its own.
struct Part {
  int region = -1;
  int piece = -1;  ///< -1: the whole region
  double cost = 0;
  std::shared_ptr<const Region> place;       ///< of a piece here: its copy of the region
  std::shared_ptr<const PavedRegion> paved;  ///< null: failed, or on another rank
};

/// Why a region has no mesh.
struct RegionFailure {
  int region = -1;
  std::string stage, reason;
  std::optional<Vec3> where;
};

/// Collective: those of all ranks, by region.
std::vector<RegionFailure> gather_failures(const std::vector<RegionFailure>& mine, Ranks& ranks);

/// Their faces failed; of several the first counts.
void report_failures(const std::vector<RegionFailure>& failures, const std::vector<Region>& regions, RunReport& report);

/// References are kept. Every member is collective.
class PartPaver {
 public:
  /// `boundary_nodes`: number of nodes of the boundary stage. Queues of the ranks from `first_queue` on are free.
  PartPaver(const std::vector<Region>& regions, std::vector<double> costs, int boundary_nodes, const Options& options,
            Progress& progress, Ranks& ranks, int first_queue = 0);

  /// Paves all regions, large ones in pieces. Failures are the same on all ranks, by region.
  std::vector<RegionFailure> pave();

  /// In the order of the regions and their pieces.
  const std::vector<Part>& parts() const { return parts_; }
  /// Other meshes for the same parts, or parts as they were.
  void put(std::vector<Part> parts);
  /// The boundary stage has `more` nodes than before.
  void add_boundary_nodes(int more);
  /// Outline nodes of a region's pieces start at this number.
  int outline_of(int region) const { return first_outline_[region]; }
  int outline_nodes() const { return first_outline_.back(); }
  /// Sides on the outlines, as shared nodes of the whole model (see shared_node).
  std::vector<std::array<int, 2>> outline_sides(int region) const;
  /// The first queue that is still free.
  int next_queue() const { return queue_; }
  /// Tasks done here so far.
  const std::vector<TaskTime>& times() const { return times_; }
  const Region& place_of(const Part& part) const { return part.place ? *part.place : regions_[part.region]; }

 private:
  std::vector<RegionFailure> run(Stage stage, const std::function<bool(const Part&)>& is_due,
                                 const std::function<void(Part&)>& pave);
  std::vector<RegionFailure> pave_regions();
  std::vector<RegionFailure> lay_pieces();
  std::vector<RegionFailure> pave_whole(const std::vector<char>& is_wanted);
  void exchange_plans();
  void advance(double cost);
  Part whole(int region) const { return {region, -1, costs_[region], nullptr, nullptr}; }
  void add_pieces(int region, std::vector<Part>& parts) const;

  const std::vector<Region>& regions_;
  const std::vector<double> costs_;
  const int boundary_nodes_;
  const Options& options_;
  Progress& progress_;
  Ranks& ranks_;
  std::vector<Part> parts_;
  std::vector<TaskTime> times_;
  int queue_ = 0;
  int added_ = 0;                                // nodes of the boundary stage
  std::vector<std::optional<LevelPlan>> plans_;  // per region
  std::vector<char> is_in_pieces_;               // per region
  std::vector<int> first_outline_;               // per region, and the number of all
};

}  // namespace paver
