// Paves a region; where rows tangle once more with lengths that grow half as fast; where no triangle is wanted in
// several ways, until one leaves none and no fault.
#include "paving/pave_region.h"

#include <algorithm>

#include "mesh/split_quads.h"
#include "paving/cleanup/chords.h"
#include "paving/cleanup/clean_up.h"
#include "paving/disc_grid.h"
#include "paving/dome_grid.h"
#include "paving/faults.h"
#include "paving/fill_void.h"
#include "paving/lay_fill.h"
#include "paving/small_holes.h"
#include "paving/strip_grid.h"

namespace paver {

namespace {

constexpr double tangled = 0.2;  // scaled Jacobian below which a region is paved in a second way

/// One way of paving: the other rule for rows takes other ways, and so does a slightly other size.
struct Attempt {
  double size = 1;
  double misfit_weight = 1;
  bool is_coarse = false;  ///< elements are to be divided
};
constexpr Attempt all_quad_attempts[] = {{1, 1}, {1, 0}, {0.95, 1}, {1.05, 1}, {0.9, 1}, {0.8, 1}, {0.5, 1}, {0.25, 1}};
constexpr double sharpest_corner = 6 * M_PI / 180;     // sharper corners take a triangle, unless none is wanted
constexpr double gap_widths[] = {0.8, 1.2, 1.6, 1.0};  // of the target length: about small holes
constexpr long elements_per_pair = 10000;              // of triangles: paving leaves as many
constexpr std::size_t few_elements = 100;              // on larger regions a second way is as often worse as better
constexpr double least_coarse = 0.7;  // of a coarse mesh's sides: squares, in the mean, by target lengths
constexpr double few_flat = 0.01;     // of the elements: not worth four times as many

Region scaled(const Region& region, double size) {
  Region finer = region;
  finer.size = region.size.scaled(size);
  finer.h *= size;
  for (auto& loop : finer.loops)
    for (LoopNode& node : loop) node.h *= size;
  return finer;
}

/// Whether the target length differs along the boundary, or from there to the inside.
bool grows(const Region& region) {
  constexpr double least_growth = 1.5;
  double low = region.h, high = region.h;
  for (const auto& loop : region.loops)
    for (const LoopNode& node : loop) low = std::min(low, node.h), high = std::max(high, node.h);
  return high > least_growth * low;
}

/// How much rows ran into each other.
struct Tangle {
  long off_surface = 0;  ///< elements
  double worst = 1;      ///< scaled Jacobian, where the boundary leaves it free

  Tangle(const Region& region, const RegionMesh& mesh) : off_surface(count_faults(mesh).off_surface) {
    for (const Element& e : mesh.elements)
      if (e.is_alive() && !has_jacobian(mesh, e, worst)) worst = std::min(worst, free_jacobian(region, mesh, e));
  }
  bool is_bad() const { return off_surface > 0 || worst < tangled; }
  bool is_less_than(const Tangle& other) const {
    return off_surface != other.off_surface ? off_surface < other.off_surface : worst > other.worst;
  }
};

/// Pairs of triangles that clean-up could not join; an odd one is what the region's boundary asks for.
long pairs_left(const RegionMesh& mesh) { return mesh.triangle_count() / 2; }

/// Whether elements are far smaller than the target length, as about many small holes: lengths that loops ask for are
/// too short to be divided.
bool is_too_fine(const Region& region, const RegionMesh& mesh) {
  double sum = 0;
  long sides = 0;
  for (const Element& e : mesh.elements)
    for (int k = 0; e.is_alive() && k < e.corners(); ++k, ++sides) {
      const int a = e.v[k], b = e.v[(k + 1) % e.corners()];
      const double h = region.target(mesh.p[a]), length = norm(mesh.step(mesh.point(a), mesh.point(b), h)) / h;
      sum += length * length;
    }
  return sum < least_coarse * static_cast<double>(sides);
}

/// Paves the void of a started front; nodes before `first_node` belong to a mesh that is done. Gives how often it was
/// closed by triangulation.
long pave_front(Front& front, const Attempt& attempt, const Progress& progress, Elements elements, int first_node = 0) {
  front.misfit_weight = attempt.misfit_weight;
  fill_void(front, progress);
  if (attempt.is_coarse && is_too_fine(front.region, front.mesh))
    throw Error(ErrorCode::face_failed, "its loops ask for shorter lengths than a coarse mesh has",
                {"paving", front.region.face, -1, {}});
  clean_up(front, progress, elements == Elements::all_quad, first_node);
  remove_chords(front);
  return front.closed_by_triangulation;
}

/// Where what is laid at acute corners in advance crosses the loops, none is.
PavedRegion pave_whole(const Region& region, const Attempt& attempt, const Progress& progress, Elements elements) {
  const double sharpest = elements == Elements::all_quad ? 0 : sharpest_corner;
  Vec3 crossing;
  for (const bool has_corners : {true, false}) {
    PavedRegion paved;
    Front front(region, paved.mesh);
    const auto facet = front.start(has_corners ? std::optional(sharpest) : std::nullopt);
    if (!facet) {
      paved.closed_by_triangulation = pave_front(front, attempt, progress, elements);
      return paved;
    }
    crossing = front.mesh.x[front.facets[*facet].a];
  }
  throw Error(
      ErrorCode::face_failed,
      "its loops cross, touch or run the wrong way round; repair the face in the CAD model or use a smaller size",
      {"paving", region.face, -1, crossing});
}

/// The region without its small holes, then these cut into it, in a void of another width about those with triangles
/// beside; all at once where that leaves fewer triangles.
PavedRegion pave_and_cut(const Region& region, const std::vector<std::size_t>& holes, const Attempt& attempt,
                         const Progress& progress, Elements elements) {
  const Region rest = without_holes(region, holes);
  auto disc = region.evenness > 1 ? std::nullopt : lay_disc(rest, progress);  // paving is more even
  PavedRegion paved = disc ? PavedRegion{std::move(*disc), {}} : pave_whole(rest, attempt, progress, elements);
  const long pairs = pairs_left(paved.mesh);
  const HoleLoops loops = add_holes(region, paved.mesh, holes);
  std::optional<PavedRegion> best;
  long fewest = 0;
  std::vector<char> is_wanted(holes.size(), true);
  for (double width : gap_widths) {
    PavedRegion cut = best ? *best : paved;
    Front front(region, cut.mesh);
    front.closed_by_triangulation = cut.closed_by_triangulation;
    if (!cut_about(front, loops, is_wanted, width)) continue;
    cut.closed_by_triangulation = pave_front(front, attempt, progress, elements, cut.mesh.node_count());
    const long more = pairs_left(cut.mesh) - pairs;
    if (!best || more < fewest) best = std::move(cut), fewest = more;
    if (fewest <= 0) return std::move(*best);
    is_wanted = are_at_triangles(region, best->mesh, loops);
    if (std::ranges::find(is_wanted, true) == is_wanted.end()) break;
  }
  if (best && fewest * elements_per_pair <= best->mesh.living_elements()) return std::move(*best);
  PavedRegion whole = pave_whole(region, attempt, progress, elements);
  return best && fewest + pairs <= pairs_left(whole.mesh) ? std::move(*best) : std::move(whole);
}

PavedRegion pave_once(const Region& region, const Attempt& attempt, const Progress& progress, Elements elements) {
  if (attempt.size != 1) return pave_once(scaled(region, attempt.size), {1, attempt.misfit_weight}, progress, elements);
  const std::vector<std::size_t> holes = small_holes(region);
  return holes.empty() ? pave_whole(region, attempt, progress, elements)
                       : pave_and_cut(region, holes, attempt, progress, elements);
}

PavedRegion pave_without_triangles(const Region& region, const Progress& progress) {
  PavedRegion best;
  Faults fewest;
  long pairs = 0;
  for (const Attempt& way : all_quad_attempts) {
    const bool is_first = best.mesh.elements.empty();
    const bool is_good_enough =
        fewest.off_surface + pairs == 0 && fewest.flat <= few_flat * static_cast<double>(best.mesh.elements.size());
    if (!is_first && (fewest.sum() + pairs == 0 || (way.size != 1 && is_good_enough))) break;
    PavedRegion paved = pave_once(region, way, progress, Elements::all_quad);
    const Faults faults = count_faults(paved.mesh);
    const long left = pairs_left(paved.mesh);
    if (!is_first && faults.sum() + left >= fewest.sum() + pairs) continue;
    best = std::move(paved), fewest = faults, pairs = left;
  }
  return best;
}

PavedRegion finish(PavedRegion paved, Elements elements) {
  if (elements == Elements::all_triangle) split_all_quads(paved.mesh);
  return paved;
}

}  // namespace

PavedRegion pave_region_once(const Region& region, const Progress& progress, Elements elements, RowRule rule) {
  return finish(pave_once(region, {1, rule == RowRule::fit ? 1.0 : 0.0}, progress, elements), elements);
}

PavedRegion pave_coarse_region(const Region& region, const Progress& progress, Elements elements) {
  return finish(pave_once(region, {.is_coarse = true}, progress, elements), elements);
}

PavedRegion pave_region(const Region& region, const Progress& progress, Elements elements) {
  auto laid = lay_fill(region);
  if (!laid) laid = lay_disc(region, progress);
  if (!laid) laid = lay_strip(region);
  if (!laid) laid = lay_prism(region);
  if (!laid && is_slim_tube(region)) laid = lay_tube(region);
  if (laid) return finish({std::move(*laid), {}}, elements);
  if (elements == Elements::all_quad) return pave_without_triangles(region, progress);
  PavedRegion best = pave_region_once(region, progress, elements);
  Tangle least(region, best.mesh);
  auto try_way = [&](const Region& other, const Attempt& way) {
    if (!least.is_bad() || best.mesh.elements.size() > few_elements) return;
    PavedRegion paved = finish(pave_once(other, way, progress, elements), elements);
    const Tangle tangle(region, paved.mesh);
    if (tangle.is_less_than(least)) best = std::move(paved), least = tangle;
  };
  if (least.off_surface == 0) try_way(region, {1, 0});
  if (grows(region)) {
    Region slower = region;  // rows that converge cannot give up nodes as fast
    slower.gradation *= 0.5;
    try_way(slower, {});
  }
  return best;
}

}  // namespace paver
