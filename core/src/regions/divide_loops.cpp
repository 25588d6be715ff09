// In: model, layouts, interval counts. Out: nodes, regions, faces that failed.
// Steps, round by round: divide; of each region the facets that cross; where their curves keep apart the edge that
// bulges more is to have twice as many intervals; where they do not the face fails, and what it asked for is forgotten.
// Likewise where chords turn a loop round.
// Of elements with curved sides then those whose sides run over each other, twice as many once or twice.
#include "regions/divide_loops.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "regions/build_regions.h"
#include "regions/bulging_facets.h"
#include "regions/crossing_facets.h"
#include "regions/curves_apart.h"

namespace paver {
namespace {

constexpr int most_doublings = 6;         // of one edge: beyond, elements would be slivers a thousand times as long
constexpr int most_crowded = 2;           // of one edge where only curved sides run over each other
constexpr int most_intervals = 100000;    // of an edge that is divided further
constexpr int most_rounds = 24;           // doublings of several edges one after another
constexpr std::size_t most_pairs = 1000;  // of one region and round

/// Two facets of one region that cross.
struct Crossing {
  int edge = -1;  ///< to be divided further where the curves keep apart
  int other = -1;
  Meeting::Kind kind = Meeting::Kind::apart;
  Vec3 where;
  bool is_crowded = false;  ///< of curved sides only: fewer doublings, and no face fails for it
};

/// What the facets of one region are pieces of.
class FacetCurves {
 public:
  FacetCurves(const Model& model, const EdgeNodes& nodes, const Region& region)
      : nodes_(nodes), region_(region), numbers_(number_loop_nodes(region)) {
    for (const Coedge& coedge : coedges_of(model.faces[region.face].loops)) coedges_[coedge.edge].push_back(&coedge);
  }

  Crossing judge(const std::array<LoopFacet, 2>& pair) const {
    const PlaneCurve one = curve(pair[0]), other = curve(pair[1]);
    const bool is_first = one.bulge(0, 1) >= other.bulge(0, 1);
    Crossing result;
    result.edge = edge(pair[is_first ? 0 : 1]);
    result.other = edge(pair[is_first ? 1 : 0]);
    const Meeting meeting = find_meeting(one, other, shared_ends(pair));
    result.kind = meeting.kind;
    const bool is_apart = meeting.kind == Meeting::Kind::apart;
    result.where = region_.point(is_apart ? nearest_point(one.start, one.end, other.start, other.end) : meeting.at);
    if (result.edge < 0) {  // nothing that could be divided
      std::swap(result.edge, result.other);
      result.kind = Meeting::Kind::meet;
    }
    return result;
  }

  Vec2 middle(LoopFacet f) const { return curve(f).point(0.5); }

 private:
  bool is_in_ring(LoopFacet f) const { return f.loop >= static_cast<int>(region_.loops.size()); }
  const std::vector<LoopNode>& nodes_of(LoopFacet f) const {
    const std::size_t loops = region_.loops.size(), loop = static_cast<std::size_t>(f.loop);
    return is_in_ring(f) ? region_.fans[loop - loops].ring : region_.loops[loop];
  }
  const LoopNode& node(LoopFacet f, int end) const {
    const auto& nodes = nodes_of(f);
    return nodes[(static_cast<std::size_t>(f.place) + static_cast<std::size_t>(end)) % nodes.size()];
  }
  int edge(LoopFacet f) const { return is_in_ring(f) ? -1 : node(f, 0).edge; }

  std::vector<SharedEnd> shared_ends(const std::array<LoopFacet, 2>& pair) const {
    std::vector<SharedEnd> shared;
    if (is_in_ring(pair[0]) || is_in_ring(pair[1])) return shared;
    auto number = [&](LoopFacet f, int end) {
      const std::vector<int>& loop = numbers_.of_loop[f.loop];
      return loop[(static_cast<std::size_t>(f.place) + static_cast<std::size_t>(end)) % loop.size()];
    };
    for (int i : {0, 1})
      for (int j : {0, 1})
        if (number(pair[0], i) == number(pair[1], j))
          shared.push_back({static_cast<double>(i), static_cast<double>(j)});
    return shared;
  }

  PlaneCurve curve(LoopFacet f) const {
    constexpr double moved = 1e-3;  // of the chord: more than nodes are moved to open slits
    const LoopNode &a = node(f, 0), &b = node(f, 1);
    PlaneCurve result{a.p, b.p, nullptr};
    if (edge(f) < 0) return result;
    const EdgeDivision& division = nodes_.edges[a.edge];
    const auto uses = coedges_.find(a.edge);
    if (uses == coedges_.end()) return result;
    for (const Coedge* use : uses->second) {
      const Coedge& coedge = *use;
      for (int k = 0; k < division.intervals(); ++k) {
        const int from = coedge.is_reversed ? k + 1 : k, to = coedge.is_reversed ? k : k + 1;
        if (division.node[from] != a.global || division.node[to] != b.global) continue;
        const double s = division.t[2 * static_cast<std::size_t>(from)],
                     t = division.t[2 * static_cast<std::size_t>(to)];
        const Chart& chart = *region_.chart;
        if (norm(chart.to_chart(coedge.pcurve->uv(s)) - a.p) > moved * norm(b.p - a.p)) continue;  // the other side's
        result.at = [&chart, &image = *coedge.pcurve, s, t](double share) {
          return chart.to_chart(image.uv(s + share * (t - s)));
        };
        return result;
      }
    }
    return result;
  }

  const EdgeNodes& nodes_;
  const Region& region_;
  const LoopNodes numbers_;
  std::map<int, std::vector<const Coedge*>> coedges_;  // by edge
};

/// Whether the side between two nodes that follow each other on a loop leaves its chord in space.
bool is_bulging(const EdgeNodes& nodes, const LoopNode& a, const LoopNode& b) {
  constexpr double straight = 0.004;  // of the chord
  if (a.edge < 0) return false;
  const EdgeDivision& division = nodes.edges[a.edge];
  const int n = division.intervals();
  // Inner nodes of an edge are numbered in a row.
  const int first = n > 1 ? division.node[1] : -1;
  auto place = [&](int global) { return n > 1 && global >= first && global < first + n - 1 ? global - first + 1 : -1; };
  const int i = place(a.global), j = place(b.global);
  int k = 0;
  if (i >= 0 && j >= 0)
    k = std::min(i, j);
  else if (i >= 0 || j >= 0)
    k = std::max(i, j) == 1 ? 0 : n - 1;
  if (n == 2) k = division.node[0] == (i >= 0 ? b.global : a.global) ? 0 : 1;
  const Vec3* x = &division.x[2 * static_cast<std::size_t>(k)];
  return norm(x[1] - 0.5 * (x[0] + x[2])) > straight * norm(x[2] - x[0]);
}

/// One for each edge that is to be divided as its curved sides would run over others.
std::vector<Crossing> find_crowded(const Model& model, const EdgeNodes& nodes, const Region& region) {
  std::optional<FacetCurves> curves;  // where there is a bulge
  std::vector<CurvedFacet> facets;
  std::vector<int> edges;
  for (std::size_t l = 0; l < region.loops.size(); ++l)
    for (std::size_t i = 0, n = region.loops[l].size(); i < n; ++i) {
      const LoopNode &a = region.loops[l][i], &b = region.loops[l][(i + 1) % n];
      facets.push_back({a.p, 0.5 * (a.p + b.p), b.p, a.global, b.global});
      edges.push_back(a.edge);
      if (!is_bulging(nodes, a, b)) continue;
      if (!curves) curves.emplace(model, nodes, region);
      facets.back().middle = curves->middle({static_cast<int>(l), static_cast<int>(i)});
    }
  std::vector<Crossing> result;
  if (!curves) return result;
  for (const int f : crowded_facets(facets)) {
    const auto is_known = [&](const Crossing& known) { return known.edge == edges[f]; };
    if (edges[f] >= 0 && std::ranges::none_of(result, is_known))
      result.push_back({edges[f], -1, Meeting::Kind::apart, {}, true});
  }
  return result;
}

/// Of a region whose loop, as its chords have it, runs the wrong way round though none cross, as that of a lens between
/// an arc and a flatter side in two pieces: the edge of the facet that takes most of it away. Nothing where its curves
/// run so themselves.
std::optional<Crossing> find_turned(const Model& model, const EdgeNodes& nodes, const Region& region) {
  if (region.goes_round || region.loops.size() != 1) return std::nullopt;
  const std::vector<LoopNode>& loop = region.loops[0];
  double area = 0;  // twice it, as are those below
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) area += cross(loop[i].p - loop[0].p, loop[i + 1].p - loop[0].p);
  if (area > 0) return std::nullopt;
  const FacetCurves curves(model, nodes, region);
  std::optional<Crossing> result;
  double most = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const LoopNode &a = loop[i], &b = loop[(i + 1) % loop.size()];
    const double taken = cross(curves.middle({0, static_cast<int>(i)}) - a.p, b.p - a.p);
    area += taken;
    if (a.edge >= 0 && taken > most) most = taken, result = {a.edge, a.edge, Meeting::Kind::apart, a.x};
  }
  if (area <= 0) result.reset();
  return result;
}

/// One for each edge that is to be divided, or the one whose curves do not keep apart.
std::vector<Crossing> find_crossings(const Model& model, const EdgeNodes& nodes, const Region& region, bool is_curved) {
  std::vector<Crossing> result;
  if (region.fill) return result;
  const auto pairs = crossing_facets(region, most_pairs);
  if (pairs.empty()) {
    if (const auto turned = find_turned(model, nodes, region)) return {*turned};
    return is_curved ? find_crowded(model, nodes, region) : result;
  }
  const FacetCurves curves(model, nodes, region);
  for (const auto& pair : pairs) {
    const Crossing crossing = curves.judge(pair);
    if (crossing.kind != Meeting::Kind::apart) return {crossing};
    auto is_known = [&](const Crossing& known) { return known.edge == crossing.edge; };
    if (std::none_of(result.begin(), result.end(), is_known)) result.push_back(crossing);
  }
  return result;
}

class LoopDivider {
 public:
  LoopDivider(const Model& model, const SizeField& size, const std::vector<FaceLayout>& layouts,
              const EdgeCounts& counts, bool is_curved, SharedTasks& tasks)
      : model_(model),
        size_(size),
        layouts_(layouts),
        counts_(counts),
        is_curved_(is_curved),
        tasks_(tasks),
        is_together_(counts.count.size(), 0) {
    for (const std::vector<int>& set : counts.together)
      for (int e : set) is_together_[e] = 1;
  }

  DividedLoops run() {
    for (int round = 0;; ++round) {
      divide();
      if (round == most_rounds || !part_crossings(round + 1 == most_rounds)) return std::move(result_);
    }
  }

 private:
  void divide() {
    EdgeCounts counts = counts_;
    times_ = doublings();
    for (std::size_t e = 0; e < counts.count.size(); ++e) counts.count[e] = count(static_cast<int>(e), times_[e]);
    result_.nodes = divide_edges(model_, size_, counts, tasks_);
    result_.regions = build_regions(model_, size_, layouts_, result_.nodes);
    std::erase_if(result_.regions, [&](const Region& region) { return has_failed_.contains(region.face); });
  }

  // Per edge: what faces that did not fail ask for, of it or of one that is divided together with it.
  std::vector<int> doublings() const {
    std::vector<int> times(counts_.count.size(), 0);
    for (const auto& [place, asked] : asked_)
      if (!has_failed_.contains(place.first)) times[place.second] = std::max(times[place.second], asked);
    for (const std::vector<int>& set : counts_.together) {
      const int most = times[*std::ranges::max_element(set, {}, [&](int e) { return times[e]; })];
      for (int e : set) times[e] = most;
    }
    return times;
  }

  // An odd count stays odd, but where sides of several edges and of one would no longer have as many.
  int count(int edge, int times) const {
    int result = counts_.count[edge];
    for (int i = 0; i < times; ++i) result = 2 * result + (is_together_[edge] != 0 ? 0 : result % 2);
    return result;
  }

  // Whether there were any.
  bool part_crossings(bool is_last) {
    constexpr double node_cost = 1;  // microseconds
    std::vector<double> costs;
    for (const Region& region : result_.regions) {
      double nodes = 0;
      for (const auto& loop : region.loops) nodes += static_cast<double>(loop.size());
      costs.push_back(region.fill ? 0 : node_cost * nodes);
    }
    const auto found = tasks_.run<std::vector<Crossing>>(Stage::boundary, costs, [&](int i) {
      return find_crossings(model_, result_.nodes, result_.regions[i], is_curved_);
    });
    std::map<std::pair<int, int>, int> asked = asked_;
    for (std::size_t i = 0; i < found.size(); ++i) {
      const int face = result_.regions[i].face;
      for (const Crossing& crossing : found[i]) {
        if (crossing.kind == Meeting::Kind::meet) {
          fail(face, crossing, "cross or touch; repair the face in the CAD model");
          continue;
        }
        const int times = times_[crossing.edge] + 1;
        if (crossing.is_crowded) {
          if (times <= most_crowded) asked[{face, crossing.edge}] = times;
          continue;
        }
        if (crossing.kind == Meeting::Kind::near || is_last || times > most_doublings ||
            count(crossing.edge, times) > most_intervals) {
          fail(face, crossing,
               "come too near to each other for this target length; use a smaller size there or remove the narrow gap");
        } else {
          asked[{face, crossing.edge}] = times;
        }
      }
    }
    const bool is_asked = asked != asked_ || result_.failures.size() > has_failed_.size();
    asked_ = std::move(asked);
    for (const CrossingFace& failure : result_.failures) has_failed_.insert(failure.face);
    return is_asked;
  }

  void fail(int face, const Crossing& crossing, const char* what) {
    for (const CrossingFace& known : result_.failures)
      if (known.face == face) return;
    result_.failures.push_back({face, fmt::format("{} {}", names(face, crossing), what), crossing.where});
  }

  std::string names(int face, const Crossing& crossing) const {
    if (crossing.edge < 0) return "its own cuts";
    const std::string one = name(face, crossing.edge);
    if (crossing.other < 0) return fmt::format("its {} and its periodic edge", one);
    if (crossing.other == crossing.edge) return fmt::format("two pieces of its {}", one);
    return fmt::format("its {} and its {}", one, name(face, crossing.other));
  }

  /// Edges that connecting added have a name that no user knows.
  std::string name(int face, int e) const {
    const Edge& edge = model_.edges[e];
    const auto other =
        std::ranges::find_if(edge.faces, [&](int f) { return model_.faces[f].name != model_.faces[face].name; });
    if (!edge.origins.empty() || other == edge.faces.end()) return "edge " + edge.name;
    return "line with " + model_.faces[*other].name;
  }

  const Model& model_;
  const SizeField& size_;
  const std::vector<FaceLayout>& layouts_;
  const EdgeCounts& counts_;
  const bool is_curved_;
  SharedTasks& tasks_;
  std::vector<char> is_together_;  // per edge: one of EdgeCounts::together
  DividedLoops result_;
  std::map<std::pair<int, int>, int> asked_;  // by face and edge: doublings
  std::vector<int> times_;                    // per edge: those that it has
  std::set<int> has_failed_;
};

}  // namespace

DividedLoops divide_loops(const Model& model, const SizeField& size, const std::vector<FaceLayout>& layouts,
                          const EdgeCounts& counts, bool is_curved, SharedTasks& tasks) {
  return LoopDivider(model, size, layouts, counts, is_curved, tasks).run();
}

}  // namespace paver
