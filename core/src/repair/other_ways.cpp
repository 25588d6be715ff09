#include "repair/other_ways.h"

#include <algorithm>
#include <optional>

#include "check/area_slack.h"
#include "mesh/split_quads.h"
#include "paver/error.h"
#include "paving/dome_grid.h"
#include "paving/strip_grid.h"
#include "quality/metrics.h"
#include "repair/edits/fill_region.h"
#include "repair/find_bad.h"
#include "repair/mend_mesh.h"
#include "repair/shared_sides.h"

namespace paver {
namespace {

constexpr long few_elements = 100;   // of a region, looked at as a whole
constexpr double good = 0.35;        // from there on it is better than triangles
constexpr double least_share = 0.5;  // of the elements that paving takes

bool has_few_elements(const RegionMesh& mesh) { return mesh.living_elements() <= few_elements; }

/// Triangles count half.
double quads_in(const RegionMesh& mesh) {
  return static_cast<double>(mesh.living_elements()) - 0.5 * static_cast<double>(mesh.triangle_count());
}

}  // namespace

bool OtherWays::can_help(const RegionMesh& mesh) const {
  return has_few_elements(mesh) && (is_coarse_and_mixed(mesh) || has_long_side(mesh) || !can_be_whole(mesh));
}

void OtherWays::improve(Mended& mended, PavedRegion& paved) const {
  const Vec3 where = paved.mesh.x[mended.left.empty() ? 0 : paved.mesh.elements[mended.left[0]].v[0]];
  const bool is_whole = mended.left.empty() && is_sound(paved.mesh);
  bool is_changed = !is_whole && make_whole(mended, paved);
  is_changed = make_regular(mended, paved) || is_changed;
  if (is_changed) mended.places.push_back({ElementRepairKind::paved_again, where});
}

bool OtherWays::is_sound(const RegionMesh& mesh) const {
  return twin_sides(mesh).empty() && !has_long_side(mesh) && can_be_whole(mesh);
}

/// The front of a rod, a few elements about, may close along it. Of few elements.
bool OtherWays::has_long_side(const RegionMesh& mesh) const {
  if (!has_few_elements(mesh)) return false;
  const double longest = far_too_long * region_.h;
  return std::any_of(mesh.elements.begin(), mesh.elements.end(), [&](const Element& e) {
    for (int k = 0; e.is_alive() && k < e.corners(); ++k)
      if (norm(mesh.x[e.v[(k + 1) % e.corners()]] - mesh.x[e.v[k]]) > longest) return true;
    return false;
  });
}

/// As far as can be told from its elements, where these are few: a front may close across a body instead of around it
/// where lengths are about the body's own.
bool OtherWays::can_be_whole(const RegionMesh& mesh) const {
  if (!(region_.own_area > 0) || face_.surface->kind() == SurfaceKind::plane || !has_few_elements(mesh)) return true;
  const ElementJudge judge(region_, mesh, sides_, options_.order);
  ElementArea sum;
  for (const Element& e : mesh.elements) {
    if (!e.is_alive()) continue;
    const ElementArea one = judge.area(e.v);
    sum.area += one.area, sum.slack += one.slack;
  }
  return can_be_area(sum.area, face_, region_.own_area, sum.slack);
}

bool OtherWays::is_coarse_and_mixed(const RegionMesh& mesh) const {
  return options_.elements == Elements::quad_dominant && has_few_elements(mesh) && mesh.triangle_count() > 0;
}

bool OtherWays::make_whole(Mended& mended, PavedRegion& paved) const {
  auto lay = [&](DomeRows rows) { return take_rows(lay_dome(region_, options_.elements, rows), mended, paved); };
  return lay(DomeRows::even) || lay(DomeRows::in_chart) || lay(DomeRows::many) ||
         take_rows(lay_tube(region_), mended, paved) || pave_without_turns(mended, paved) ||
         pave_by_other_rule(region_, mended, paved) || lay(DomeRows::most);
}

bool OtherWays::take_rows(std::optional<RegionMesh> rows, Mended& mended, PavedRegion& paved) const {
  if (rows && options_.elements == Elements::all_triangle) split_all_quads(*rows);
  return rows && take(region_, {std::move(*rows), {}}, mended, paved);
}

// It may be that no element fits lengths that count turns.
bool OtherWays::pave_without_turns(Mended& mended, PavedRegion& paved) const {
  if (!paved.mesh.has_turns()) return false;
  Region plain = region_;
  plain.size.count_no_turns();
  auto pave = [&] { return pave_region(plain, progress_, options_.elements); };
  return take_paved(plain, pave, mended, paved) || pave_by_other_rule(plain, mended, paved);
}

bool OtherWays::pave_by_other_rule(const Region& region, Mended& mended, PavedRegion& paved) const {
  auto pave = [&] { return pave_region_once(region, progress_, options_.elements, RowRule::no_fit); };
  return take_paved(region, pave, mended, paved);
}

template <class Pave>
bool OtherWays::take_paved(const Region& region, Pave pave, Mended& mended, PavedRegion& paved) const {
  try {
    return take(region, pave(), mended, paved);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::face_failed) throw;
    return false;
  }
}

bool OtherWays::take(const Region& region, PavedRegion second, Mended& mended, PavedRegion& paved) const {
  const ElementJudge judge(region, second.mesh, sides_, options_.order);
  Mended again = mend_mesh(judge, kinds_of(options_.elements), find_bad(judge), second.mesh);
  if (!again.left.empty() || !is_sound(second.mesh)) return false;
  mended = std::move(again), paved = std::move(second);
  return true;
}

bool OtherWays::make_regular(Mended& mended, PavedRegion& paved) const {
  if (!is_coarse_and_mixed(paved.mesh)) return false;
  std::optional<RegionMesh> grid = lay_four_sided(region_, few_elements);
  if (grid && static_cast<double>(grid->elements.size()) < least_share * quads_in(paved.mesh)) grid.reset();
  return take_grid(std::move(grid), mended, paved) || take_grid(lay_tube(region_), mended, paved) ||
         take_grid(fill_with_row(region_, sides_, options_.order), mended, paved);
}

bool OtherWays::take_grid(std::optional<RegionMesh> grid, Mended& mended, PavedRegion& paved) const {
  if (!grid) return false;
  const double value = ElementJudge(region_, *grid, sides_, options_.order).worst_value();
  const double before = ElementJudge(region_, paved.mesh, sides_, options_.order).worst_value();
  if (value < fair || value <= std::min(before, good)) return false;
  if (!is_sound(*grid)) return false;
  mended = {}, paved = {std::move(*grid), {}};
  return true;
}

}  // namespace paver
