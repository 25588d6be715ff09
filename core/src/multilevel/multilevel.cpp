// In: region. Out: its plan, and the mesh of each of its pieces.
// Steps: coarser region, its mesh, lengths made even; counts along its chords; coarse nodes on the boundary go to the
// fine nodes that the counts give them, the others to where lengths suit the counts; pieces. Then for each piece:
// division, patches, smoothing.
#include "multilevel/multilevel.h"

#include <algorithm>
#include <cmath>

#include "mesh/split_quads.h"
#include "multilevel/coarse/coarse_net.h"
#include "multilevel/coarse/edge_counts.h"
#include "multilevel/coarse/even_out.h"
#include "multilevel/fine_mesh.h"
#include "multilevel/patches.h"
#include "multilevel/pieces.h"
#include "paving/disc_grid.h"
#include "paving/faults.h"
#include "paving/smoothing/raise_worst.h"
#include "paving/smoothing/sweeper.h"

namespace paver {
namespace {

constexpr int least_ratio = 2, moderate_ratio = 6, large_ratio = 12;
constexpr double fewest_coarse = 1000;  // elements that the coarse mesh should have: large elements vary more in length
constexpr double many_coarse = 2000;    // the same for ratios above the moderate one
constexpr double most_coarse = 10000;   // from here on ratios are larger still: one task makes the coarse mesh
constexpr double fewest_coarser = 800;  // and for the mesh under a coarse one, whose lengths are evened out afterwards
constexpr double evenness = 2.1;        // of coarse meshes: their irregular nodes are few among the fine ones
constexpr int even_sweeps = 4, count_sweeps = 12, fine_sweeps = 1;
constexpr double mean_slack = 0.05;               // of the mean length of fine edges, by their target
constexpr double piece_elements = 4096;           // fine ones: enough pieces for many ranks, few nodes between them
constexpr double poor = 0.2, most_poor = 0.0005;  // scaled Jacobian where the boundary leaves it free; of a piece
constexpr int whole = -1;                         // for boundary_nodes: one piece

/// Ratio of the target lengths for which the coarse mesh is not too small; 0: none.
int ratio_for(const Region& region, int multilevel) {
  const double elements = region.area / (region.h * region.h);
  auto fitting = [&](double fewest) { return static_cast<int>(std::sqrt(elements / fewest)); };
  const bool is_coarse = region.evenness > 1;
  const int most = multilevel == automatic_levels ? moderate_ratio : multilevel;
  int ratio = std::min(most, fitting(is_coarse ? fewest_coarser : fewest_coarse));
  if (multilevel == automatic_levels && !is_coarse)
    ratio = std::max({ratio, std::min(large_ratio, fitting(many_coarse)), fitting(most_coarse)});
  return ratio >= least_ratio ? ratio : 0;
}

/// Whether short facets of loops ask for more elements than the area does, as many small holes do: what they ask for is
/// too small to be divided.
bool is_crowded(const Region& coarse) {
  if (coarse.size.is_graded()) return false;
  double more = 0;
  for (const auto& loop : coarse.loops)
    for (std::size_t i = 0; i < loop.size(); ++i)
      more += std::max(0.0, 1 - norm(loop[(i + 1) % loop.size()].x - loop[i].x) / coarse.h);
  return more > coarse.area / (coarse.h * coarse.h);
}

/// From a coarse mesh to a plan.
class Planner {
 public:
  Planner(const Region& region, CoarseRegion coarse, const Progress& progress)
      : region_(region), coarse_(std::move(coarse)), progress_(progress) {}

  std::optional<LevelPlan> run(PavedRegion paved) {
    RegionMesh& mesh = paved.mesh;
    even_out(coarse_.region, mesh, {}, even_sweeps, progress_);
    std::optional<CoarseNet> net = build_net(coarse_, mesh);
    if (!net) return std::nullopt;
    const std::vector<double> wanted = lengths(mesh, *net);
    auto counts = choose_edge_counts(coarse_, *net, find_chords(coarse_, mesh, *net), wanted);
    if (!counts || !fits(*net, wanted, *counts)) return std::nullopt;
    move_boundary(mesh, *net, *counts);
    even_out(coarse_.region, mesh, wishes(mesh, *net, *counts), count_sweeps, progress_);
    LevelPlan plan;
    const std::vector<double> laid = lengths(mesh, *net);
    plan.is_paved = choose_paved(mesh, *net, *counts, laid);
    if (plan.is_paved.empty()) return std::nullopt;
    for (std::size_t e = 0; e < counts->size(); ++e)
      if (is_within_paved(net->edges[e], plan.is_paved))
        (*counts)[e] = std::max(1, static_cast<int>(std::lround(laid[e])));
    plan.mesh = std::move(mesh);
    plan.net = std::move(*net);
    plan.at = std::move(coarse_.at);
    plan.counts = std::move(*counts);
    plan.closed_by_triangulation = paved.closed_by_triangulation;
    return plan;
  }

 private:
  double ratio() const { return coarse_.region.h / region_.h; }

  /// Whether edges would be about their target length on average, or between it and the length of those on the
  /// boundary, which are given: most counts inside follow from these.
  static bool fits(const CoarseNet& net, const std::vector<double>& lengths, const std::vector<int>& counts) {
    double length = 0, given_length = 0, count = 0, given_count = 0;
    for (std::size_t e = 0; e < lengths.size(); ++e) {
      const bool is_given = net.edges[e].loop >= 0;
      length += lengths[e], count += counts[e];
      if (is_given) given_length += lengths[e], given_count += counts[e];
    }
    const double mean = length / count, given = given_count > 0 ? given_length / given_count : 1;
    return mean > std::min(given, 1 - mean_slack) && mean < std::max(given, 1 + mean_slack);
  }

  // Of coarse edges, in fine target lengths.
  std::vector<double> lengths(const RegionMesh& mesh, const CoarseNet& net) const {
    std::vector<double> result;
    for (const CoarseEdge& edge : net.edges) {
      const double h = 0.5 * (mesh.h[edge.a] + mesh.h[edge.b]) / ratio();
      result.push_back(norm(mesh.step(mesh.point(edge.a), mesh.point(edge.b), h)) / h);
    }
    return result;
  }

  // Lengths that suit the counts, in coarse target lengths.
  std::vector<std::array<float, 4>> wishes(const RegionMesh& mesh, const CoarseNet& net,
                                           const std::vector<int>& counts) const {
    std::vector<std::array<float, 4>> result(mesh.elements.size(), {1, 1, 1, 1});
    for (std::size_t e = 0; e < result.size(); ++e)
      for (int k = 0; mesh.elements[e].is_alive() && k < mesh.elements[e].corners(); ++k)
        result[e][k] = static_cast<float>(counts[net.of_element[e][k]] / ratio());
    return result;
  }

  static bool is_within_paved(const CoarseEdge& edge, const std::vector<char>& is_paved) {
    return edge.loop < 0 && is_paved[edge.element[0]] && is_paved[edge.element[1]];
  }

  void move_boundary(RegionMesh& mesh, const CoarseNet& net, const std::vector<int>& counts) {
    std::vector<std::vector<int>> facets(coarse_.at.size());
    for (std::size_t l = 0; l < facets.size(); ++l) facets[l].resize(coarse_.side[l].size());
    for (std::size_t e = 0; e < net.edges.size(); ++e)
      if (net.edges[e].loop >= 0) facets[net.edges[e].loop][net.edges[e].facet] = counts[e];
    for (std::size_t l = 0; l < facets.size(); ++l)
      for (std::size_t i = 0; i < facets[l].size(); ++i) {
        int next = coarse_.at[l][i] + facets[l][i];
        coarse_.at[l][i + 1] = next;
        put(mesh, net.loop_node[l][(i + 1) % facets[l].size()], l, next);
      }
  }

  void put(RegionMesh& mesh, int node, std::size_t l, int i) const {
    const LoopNode& at = region_.loops[l][static_cast<std::size_t>(i) % region_.loops[l].size()];
    NodePlace place = region_.place(at.p);
    place.x = at.x;
    mesh.put(node, place);
    mesh.global[node] = at.global;
  }

  const Region& region_;
  CoarseRegion coarse_;
  const Progress& progress_;
};

/// The mesh of a whole region on levels; nothing where it is better paved directly.
std::optional<PavedRegion> pave_on_levels(const Region& region, int multilevel, const Progress& progress,
                                          Elements elements) {
  try {
    if (auto plan = plan_levels(region, multilevel, whole, progress, elements))
      return lay_piece(region, region, *plan, 0, progress, elements);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::face_failed) throw;
  }
  return std::nullopt;
}

/// The mesh of a coarse region, itself on levels where it is large. A coarse mesh is paved in one way only: where it is
/// poor the fine one will be paved.
PavedRegion pave_coarse(const Region& region, int multilevel, const Progress& progress, Elements elements) {
  if (auto paved = pave_on_levels(region, multilevel, progress, elements)) return std::move(*paved);
  if (auto disc = lay_disc(region, progress)) return {std::move(*disc), {}};
  return pave_coarse_region(region, progress, elements);
}

std::optional<LevelPlan> plan_level(const Region& region, int multilevel, int ratio, const Progress& progress,
                                    Elements elements) {
  std::optional<CoarseRegion> coarse = coarsen(region, ratio);
  if (!coarse || is_crowded(coarse->region)) return std::nullopt;
  coarse->region.evenness = evenness;
  try {
    PavedRegion paved = pave_coarse(coarse->region, multilevel, progress, elements);
    return Planner(region, std::move(*coarse), progress).run(std::move(paved));
  } catch (const Error& error) {
    if (error.code() != ErrorCode::face_failed) throw;
    return std::nullopt;
  }
}

/// More than repair should be left.
bool has_many_poor(const Region& region, const RegionMesh& mesh) {
  const auto count = std::count_if(mesh.elements.begin(), mesh.elements.end(), [&](const Element& e) {
    return e.is_alive() && !has_jacobian(mesh, e, poor) && free_jacobian(region, mesh, e) < poor;
  });
  return static_cast<double>(count) > most_poor * static_cast<double>(mesh.living_elements());
}

void smooth(Front& front, const std::vector<int>& rests, const Progress& progress) {
  for (int v : rests) front.mesh.is_fixed[v] = 1;
  sweep_nodes(front, fine_sweeps, progress);
  for (int v : rests) front.mesh.is_fixed[v] = 0;
  raise_worst(front, 2);
}

}  // namespace

std::optional<LevelPlan> plan_levels(const Region& region, int multilevel, int boundary_nodes, const Progress& progress,
                                     Elements elements) {
  const int first = region.fill || multilevel == 0 ? 0 : ratio_for(region, multilevel);
  if (first == 0) return std::nullopt;
  const Elements quads = elements == Elements::all_triangle ? Elements::quad_dominant : elements;
  for (int ratio : {first, first / 2}) {
    if (ratio < least_ratio) break;
    std::optional<LevelPlan> plan = plan_level(region, multilevel, ratio, progress, quads);
    if (!plan) continue;
    plan->multilevel = multilevel;
    plan->boundary_nodes = boundary_nodes;
    cut_in_pieces(region, *plan, boundary_nodes == whole ? 0 : piece_elements);
    number_outlines(*plan);
    return plan;
  }
  return std::nullopt;
}

PavedRegion lay_piece(const Region& region, const Region& part, const LevelPlan& plan, std::size_t i,
                      const Progress& progress, Elements elements) {
  const Elements quads = elements == Elements::all_triangle ? Elements::quad_dominant : elements;
  PavedRegion result;
  if (i == 0) result.closed_by_triangulation = plan.closed_by_triangulation;
  Front front(part, result.mesh);
  FineMesh fine(region, plan, front);
  std::vector<int> marked;
  for (int e : plan.pieces[i]) {
    if (e % 64 == 0) progress.check();
    if (plan.is_paved[e] || !fine.lay(e)) marked.push_back(e);
  }
  const std::vector<int> rests = pave_patches(fine, marked, [&](const Region& patch) {
    auto paved = pave_on_levels(patch, plan.multilevel, progress, quads);
    if (!paved) paved = pave_region(patch, progress, quads);
    result.closed_by_triangulation += paved->closed_by_triangulation;
    return std::move(paved->mesh);
  });
  if (marked.size() < plan.pieces[i].size()) smooth(front, rests, progress);
  front.end_slides();
  if (count_faults(result.mesh).off_surface > 0 || has_many_poor(region, result.mesh))
    throw Error(ErrorCode::face_failed, "a piece of the coarse mesh cannot be divided",
                {"paving", region.face, -1, {}});
  if (elements == Elements::all_triangle) split_all_quads(result.mesh);
  return result;
}

}  // namespace paver
