// Steps, round by round, of the parts that changed: bad elements are mended; then sides that parts may not both have,
// and sides on B-rep edges, get a node, in the same order on all ranks.
#include "repair/repair_parts.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <tuple>
#include <utility>

#include "base/tasks/gather.h"
#include "base/tasks/tasks.h"
#include "repair/divide_sides.h"
#include "repair/find_bad.h"
#include "repair/mend_mesh.h"
#include "repair/other_ways.h"
#include "repair/shared_sides.h"

namespace paver {
namespace {

constexpr int most_rounds = 4;  // what divided sides of one face leave of another
// Bad elements, by those of the round before and where these are few: with more, divided sides do not help.
constexpr std::size_t most_increase = 2, few = 8;

/// As ranks exchange it: of a face, or of an edge where one is divided.
struct RepairedPlace {
  ElementRepairKind kind;
  int entity;
  Vec3 where;
};

/// What was found out about one part in a round.
struct PartFindings {
  std::vector<MendedPlace> places;
  std::vector<SideToDivide> sides;
  std::vector<InnerSide> inner;
  std::size_t bad = 0;  ///< elements left as they are
};

class PartRepairer {
 public:
  PartRepairer(const Model& model, const std::vector<Region>& regions, const Options& options, EdgeNodes& nodes,
               PartPaver& paver, const Progress& progress, Ranks& ranks)
      : model_(model),
        regions_(regions),
        options_(options),
        kinds_(kinds_of(options.elements)),
        nodes_(nodes),
        paver_(paver),
        progress_(progress),
        ranks_(ranks),
        parts_(paver.parts()),
        is_due_(parts_.size(), 1),
        findings_(parts_.size()) {}

  std::vector<ElementRepair> run() {
    for (; round_ < most_rounds && is_any_due(); ++round_) {
      mend();
      if (kinds_.triangles) divide_shared();
      divide_edges();
    }
    paver_.put(std::move(parts_));
    return all_places();
  }

 private:
  bool is_any_due() {
    long due = std::count(is_due_.begin(), is_due_.end(), 1);
    ranks_.add_up({&due, 1});
    return due > 0;
  }

  const Region& region_of(std::size_t part) const { return regions_[parts_[part].region]; }

  void mend() {
    std::vector<double> costs;
    for (std::size_t i = 0; i < parts_.size(); ++i) costs.push_back(is_due_[i] ? parts_[i].cost : 0);
    run_tasks(options_.threads, costs, [&](int i) {
      progress_.check();
      const auto part = static_cast<std::size_t>(i);
      findings_[part].places.clear();
      findings_[part].sides.clear();
      if (is_due_[part] && parts_[part].paved) mend(part);
    });
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      is_due_[i] = 0;
      for (const MendedPlace& place : findings_[i].places)
        places_.push_back({place.kind, region_of(i).face, place.where});
    }
  }

  void mend(std::size_t i) {
    PartFindings& found = findings_[i];
    const BoundarySides sides(region_of(i), nodes_);
    const Region& place = paver_.place_of(parts_[i]);
    std::vector<int> bad = find_bad({place, parts_[i].paved->mesh, sides, options_.order});
    const bool has_twins = !twin_sides(parts_[i].paved->mesh).empty();
    const Face& face = model_.faces[region_of(i).face];
    const OtherWays ways{region_of(i), face, sides, options_, progress_};
    const bool is_first = round_ == 0 && parts_[i].piece < 0;
    if (!bad.empty() || has_twins || (is_first && ways.can_help(parts_[i].paved->mesh))) {
      auto copy = std::make_shared<PavedRegion>(*parts_[i].paved);
      Mended mended = mend_mesh({place, copy->mesh, sides, options_.order}, kinds_, std::move(bad), copy->mesh);
      if (is_first) ways.improve(mended, *copy);
      if (!mended.places.empty()) parts_[i].paved = std::move(copy);
      found.places = std::move(mended.places);
      const bool is_hopeless = round_ > 0 && mended.left.size() > most_increase * std::max(found.bad, few);
      found.bad = mended.left.size();
      if (!is_hopeless) found.sides = std::move(mended.sides);
    }
    const RegionMesh& mesh = parts_[i].paved->mesh;
    if (!kinds_.triangles) return;
    found.inner = inner_sides(mesh, static_cast<int>(i), static_cast<int>(nodes_.nodes.size()));
    std::ranges::move(sides_beside_nodes({place, mesh, sides, options_.order}), std::back_inserter(found.sides));
  }

  // Only on the rank that has the part.
  template <class Change>
  void change(std::size_t part, Change change) {
    auto copy = std::make_shared<PavedRegion>(*parts_[part].paved);
    change(copy->mesh);
    parts_[part].paved = std::move(copy);
    is_due_[part] = 1;
  }

  // Of all parts on all ranks.
  template <class Side>
  std::vector<Side> all_of(std::vector<Side> PartFindings::*sides) const {
    std::vector<Side> mine;
    for (const PartFindings& found : findings_) std::ranges::copy(found.*sides, std::back_inserter(mine));
    return gather_all(mine, ranks_);
  }

  void divide_shared() {
    std::map<std::size_t, std::vector<InnerSide>> of_part;
    for (const InnerSide& side : sides_to_part(all_of(&PartFindings::inner), regions_, nodes_))
      if (parts_[side.part].paved) of_part[static_cast<std::size_t>(side.part)].push_back(side);
    for (const auto& [part, sides] : of_part)
      change(part, [&, i = part, &inner = sides](RegionMesh& mesh) {
        for (Vec3 x : divide_inner_sides(paver_.place_of(parts_[i]), inner, mesh))
          places_.push_back({ElementRepairKind::divided, region_of(i).face, x});
      });
  }

  void divide_edges() {
    const std::vector<DividedSide> divided = divide_intervals(model_, all_of(&PartFindings::sides), nodes_);
    if (divided.empty()) return;
    paver_.put(std::move(parts_));
    paver_.add_boundary_nodes(static_cast<int>(divided.size()));
    parts_ = paver_.parts();
    std::set<int> ends;
    for (const DividedSide& side : divided) {
      ends.insert(side.a);
      const auto node = static_cast<std::size_t>(side.node);
      if (ranks_.rank() == 0)
        places_.push_back({ElementRepairKind::divided_edge, nodes_.node_edge[node], nodes_.nodes[node]});
    }
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      auto is_end = [&](int node) { return ends.contains(node); };
      if (!parts_[i].paved || std::ranges::none_of(parts_[i].paved->mesh.global, is_end)) continue;
      const BoundarySides sides(region_of(i), nodes_);
      change(i, [&](RegionMesh& mesh) {
        divide_boundary_sides({paver_.place_of(parts_[i]), mesh, sides, options_.order}, nodes_, divided, kinds_, mesh);
      });
    }
  }

  std::vector<ElementRepair> all_places() {
    std::vector<RepairedPlace> all = gather_all(places_, ranks_);
    auto key = [](const RepairedPlace& p) { return std::tie(p.kind, p.entity, p.where.x, p.where.y, p.where.z); };
    std::ranges::sort(all, {}, key);
    std::vector<ElementRepair> repairs;
    for (const auto& [kind, entity, where] : all) {
      const auto i = static_cast<std::size_t>(entity);
      repairs.push_back(
          {kind, kind == ElementRepairKind::divided_edge ? model_.edges[i].name : model_.faces[i].name, where});
    }
    return repairs;
  }

  const Model& model_;
  const std::vector<Region>& regions_;
  const Options& options_;
  const ElementKinds kinds_;
  EdgeNodes& nodes_;
  PartPaver& paver_;
  const Progress& progress_;
  Ranks& ranks_;
  int round_ = 0;
  std::vector<Part> parts_;
  std::vector<char> is_due_;            // per part: to be looked at
  std::vector<PartFindings> findings_;  // per part
  std::vector<RepairedPlace> places_;
};

}  // namespace

const char* element_repair_name(ElementRepairKind kind) {
  static constexpr const char* names[] = {"moved", "refilled", "divided", "paved again", "divided edge"};
  static_assert(std::size(names) == static_cast<std::size_t>(ElementRepairKind::divided_edge) + 1);
  return names[static_cast<std::size_t>(kind)];
}

std::vector<ElementRepair> repair_parts(const Model& model, const std::vector<Region>& regions, const Options& options,
                                        EdgeNodes& nodes, PartPaver& paver, const Progress& progress, Ranks& ranks) {
  return PartRepairer(model, regions, options, nodes, paver, progress, ranks).run();
}

}  // namespace paver
