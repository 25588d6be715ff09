#include "repair/other_ways.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "check/area_slack.h"
#include "mesh/split_quads.h"
#include "paver/error.h"
#include "paving/dome_grid.h"
#include "paving/strip_grid.h"
#include "quality/metrics.h"
#include "repair/edits/move_corners.h"
#include "repair/edits/row_along.h"
#include "repair/find_bad.h"
#include "repair/mend_mesh.h"
#include "repair/shared_sides.h"

namespace paver {
namespace {

constexpr long few_elements = 100;      // of a region, looked at as a whole
constexpr double good = 0.35;           // from there on it is better than triangles
constexpr double least_share = 0.5;     // of the elements that paving takes
constexpr double coarse = 0.02;         // of its area: a region that lacks more is worth another way
constexpr double coarse_chords = 0.15;  // the same at order 1: eight chords around a ball take as much
constexpr double poor = 0.1;            // worth less, another way is none unless there was worse
constexpr double much_less = 0.5;       // of what the first way lacks: then another one is taken
constexpr long most_more = 3;           // times the elements, at most
constexpr long most_finer = 1600;       // elements of a face, where only smaller ones make it whole
constexpr double most_long = 1.5;       // target lengths: of a side
constexpr double most_for_fewer = 1.5;  // times the elements, for fewer triangles

bool has_few_elements(const RegionMesh& mesh) { return mesh.living_elements() <= few_elements; }

double longest_side(const RegionMesh& mesh) {
  double longest = 0;
  for (const Element& e : mesh.elements)
    for (int k = 0; e.is_alive() && k < e.corners(); ++k)
      longest = std::max(longest, norm(mesh.x[e.v[(k + 1) % e.corners()]] - mesh.x[e.v[k]]));
  return longest;
}

double mean_facet(const Region& region) {
  double sum = 0, count = 0;
  for (const auto& loop : region.loops)
    for (std::size_t i = 0; i < loop.size(); ++i, ++count) sum += norm(loop[(i + 1) % loop.size()].x - loop[i].x);
  return sum / count;
}

/// Triangles count half.
double quads_in(const RegionMesh& mesh) {
  return static_cast<double>(mesh.living_elements()) - 0.5 * static_cast<double>(mesh.triangle_count());
}

double worst_jacobian(const RegionMesh& mesh) {
  double worst = 1;
  for (const Element& e : mesh.elements)
    if (e.is_alive()) worst = std::min(worst, scaled_jacobian(mesh, e));
  return worst;
}

RegionMesh mesh_of_loop(const Region& region) {
  RegionMesh mesh;
  mesh.turn_weight = region.size.turn_weight();
  for (const LoopNode& node : region.loops[0]) add_node(region, node, mesh);
  return mesh;
}

/// The whole mesh of a region with few nodes about it, by some of the other ways.
class Remesher {
 public:
  Remesher(const OtherWays& of, Mended& mended, PavedRegion& paved)
      : of_(of), region_(of.region), order_(of.options.order), mended_(mended), paved_(paved) {}

  bool make_whole() {
    auto lay = [&](DomeRows rows) { return take_rows(lay_dome(region_, of_.options.elements, rows)); };
    return lay(DomeRows::even) || lay(DomeRows::in_chart) || lay(DomeRows::many) || take_rows(lay_tube(region_)) ||
           pave_without_turns() || pave_by_other_rule(region_) || lay(DomeRows::most) || pave_finer();
  }

  /// The same where the elements are valid, but too coarse for the shape.
  bool make_finer() {
    aim_ = Aim::finer;
    return make_whole();
  }

  bool make_regular() {
    if (!of_.is_coarse_and_mixed(paved_.mesh)) return false;
    std::optional<RegionMesh> grid = lay_four_sided(region_, few_elements);
    if (grid && static_cast<double>(grid->elements.size()) < least_share * quads_in(paved_.mesh)) grid.reset();
    const bool is_regular = take_grid(std::move(grid)) || take_grid(lay_tube(region_)) || take_grid(fill_with_row());
    return pave_with_fewer_triangles() || is_regular;
  }

 private:
  bool take_rows(std::optional<RegionMesh> rows) {
    if (rows && of_.options.elements == Elements::all_triangle) split_all_quads(*rows);
    return rows && take(region_, {std::move(*rows), {}});
  }

  // It may be that no element fits lengths that count turns.
  bool pave_without_turns() {
    if (!paved_.mesh.has_turns()) return false;
    Region plain = region_;
    plain.size.count_no_turns();
    return take_paved(plain, [&] { return pave_region(plain, of_.progress, of_.options.elements); }) ||
           pave_by_other_rule(plain);
  }

  bool pave_by_other_rule(const Region& region) {
    return take_paved(region,
                      [&] { return pave_region_once(region, of_.progress, of_.options.elements, RowRule::no_fit); });
  }

  Region with_length(double h) const {
    Region other = region_;
    other.h = h;
    other.size.count_no_turns();
    other.size = other.size.at_most(h);
    for (auto& loop : other.loops)
      for (LoopNode& node : loop) node.h = std::min(node.h, h);
    return other;
  }

  /// By area alone.
  double elements_at(double h) const { return (region_.own_area > 0 ? region_.own_area : of_.face.area) / (h * h); }

  // Rows of elements as long as the facets may find no room, as between a hole in a tube and a cut along it.
  bool pave_finer() {
    constexpr double shares[] = {0.5, 0.25};  // of the facets' mean length
    if (region_.loops.empty() || !has_few_elements(paved_.mesh)) return false;
    const double mean = mean_facet(region_);
    const long most = aim_ == Aim::finer ? most_more * paved_.mesh.living_elements() : most_finer;
    return std::ranges::any_of(shares, [&](double share) {
      const double h = share * std::min(mean, region_.h);
      if (elements_at(h) > static_cast<double>(most)) return false;  // facets far shorter than the face
      const Region finer = with_length(h);
      return take_paved(finer, [&] { return pave_region(finer, of_.progress, of_.options.elements); });
    });
  }

  // Lengths far above those of the facets leave gaps that only triangles close.
  bool pave_with_fewer_triangles() {
    constexpr double shares[] = {1.4, 1};  // of the facets' mean length
    if (region_.loops.empty()) return false;
    aim_ = Aim::fewer_triangles;
    bool is_better = pave_once_more(region_, Elements::all_quad);
    const double mean = mean_facet(region_), most = most_for_fewer * static_cast<double>(paved_.mesh.living_elements());
    for (double share : shares) {
      const double h = share * mean;
      if (h >= region_.h || elements_at(h) > most) continue;
      for (Elements elements : {Elements::quad_dominant, Elements::all_quad})
        is_better = pave_once_more(with_length(h), elements) || is_better;
    }
    return is_better;
  }

  // One triangle is what an odd border asks for.
  bool pave_once_more(const Region& region, Elements elements) {
    return paved_.mesh.triangle_count() > 1 &&
           take_paved(region, [&] { return pave_region_once(region, of_.progress, elements); });
  }

  template <class Pave>
  bool take_paved(const Region& region, Pave pave) {
    try {
      return take(region, pave());
    } catch (const Error& error) {
      if (error.code() != ErrorCode::face_failed) throw;
      return false;
    }
  }

  bool take(const Region& region, PavedRegion second) {
    if (aim_ == Aim::fewer_triangles && !has_fewer_triangles(second.mesh)) return false;
    const ElementJudge judge(region, second.mesh, of_.sides, order_);
    Mended again = mend_mesh(judge, kinds_of(of_.options.elements), find_bad(judge), second.mesh);
    if (!again.left.empty() || !of_.is_sound(second.mesh)) return false;
    if (aim_ == Aim::finer && !is_finer(second.mesh)) return false;
    if (aim_ == Aim::fewer_triangles && !is_as_good(second.mesh)) return false;
    mended_ = std::move(again), paved_ = std::move(second);
    return true;
  }

  /// Follows the shape better without many more elements, more triangles, longer sides or poor elements.
  bool is_finer(const RegionMesh& mesh) const {
    const RegionMesh& before = paved_.mesh;
    const long count = mesh.living_elements(), count_before = before.living_elements();
    return of_.lacking(mesh) <= much_less * of_.lacking(before) && count <= most_more * count_before &&
           mesh.triangle_count() * count_before <= before.triangle_count() * count &&
           longest_side(mesh) <= std::max(longest_side(before), most_long * region_.h) &&
           worst_value(mesh) >= std::min(poor, worst_value(before));
  }

  /// And not many more elements.
  bool has_fewer_triangles(const RegionMesh& mesh) const {
    const RegionMesh& before = paved_.mesh;
    return mesh.triangle_count() < before.triangle_count() &&
           static_cast<double>(mesh.living_elements()) <=
               most_for_fewer * static_cast<double>(before.living_elements());
  }

  bool is_as_good(const RegionMesh& mesh) const {
    return has_fewer_triangles(mesh) && worst_value(mesh) >= std::min(worst_value(paved_.mesh), good) &&
           worst_jacobian(mesh) >= std::min(worst_jacobian(paved_.mesh), good) &&
           !(of_.is_too_coarse(mesh) && of_.lacking(mesh) > of_.lacking(paved_.mesh));
  }

  bool take_grid(std::optional<RegionMesh> grid) {
    if (!grid) return false;
    const double value = worst_value(*grid), before = worst_value(paved_.mesh);
    if (value < fair || value <= std::min(before, good) || !of_.is_sound(*grid)) return false;
    if (of_.is_too_coarse(*grid) && of_.lacking(*grid) > of_.lacking(paved_.mesh)) return false;
    mended_ = {}, paved_ = {std::move(*grid), {}};
    return true;
  }

  double worst_value(const RegionMesh& mesh) const {
    return ElementJudge(region_, mesh, of_.sides, order_).worst_value();
  }

  /// Of quads only: a row along a smooth part of the loop and the best filling of what it leaves; of all such parts
  /// that with the best worst element. Nothing where the region has more than one loop, a fan, more nodes than are
  /// filled anew, or no such part.
  std::optional<RegionMesh> fill_with_row() const {
    if (region_.loops.size() != 1 || !region_.fans.empty() || region_.loops[0].size() > most_outline + 2)
      return std::nullopt;
    std::vector<int> loop(region_.loops[0].size());
    std::iota(loop.begin(), loop.end(), 0);
    const RegionMesh border = mesh_of_loop(region_);
    std::optional<RegionMesh> best;
    double most = 0;
    for (const SmoothChain& chain : smooth_chains({region_, border, of_.sides, order_}, loop)) {
      if (!leaves_filling(loop, chain)) continue;
      std::optional<RegionMesh> mesh = filled(loop, chain);
      const double worst = mesh ? worst_value(*mesh) : 0;
      if (worst > most) most = worst, best = std::move(mesh);
    }
    return best;
  }

  /// With a row along the chain and its rest filled.
  std::optional<RegionMesh> filled(std::span<const int> loop, SmoothChain chain) const {
    RegionMesh mesh = mesh_of_loop(region_);
    const ElementJudge judge(region_, mesh, of_.sides, order_);
    std::vector<int> made;
    for (Vec2 p : places_of_row(mesh, loop, chain)) made.push_back(mesh.add_node(region_.place(p), region_.target(p)));
    const BorderRow row = row_along(loop, chain, made);
    const Filling rest = fill_outline(row.rest, {true, false}, judge);
    if (!(rest.worst > 0)) return std::nullopt;
    for (const std::vector<Corners>* elements : {&row.quads, &rest.elements})
      for (const Corners& corners : *elements) mesh.add_element(corners);
    raise_worst_about(judge, made, mesh);
    even_out(judge, made, mesh);
    return mesh;
  }

  enum class Aim { whole, finer, fewer_triangles };

  const OtherWays& of_;
  const Region& region_;
  const int order_;
  Mended& mended_;
  PavedRegion& paved_;
  Aim aim_ = Aim::whole;
};

}  // namespace

bool OtherWays::can_help(const RegionMesh& mesh) const {
  return has_few_elements(mesh) &&
         (is_coarse_and_mixed(mesh) || has_long_side(mesh) || !can_be_whole(mesh) || is_too_coarse(mesh));
}

void OtherWays::improve(Mended& mended, PavedRegion& paved) const {
  const Vec3 where = paved.mesh.x[mended.left.empty() ? 0 : paved.mesh.elements[mended.left[0]].v[0]];
  Remesher remesher(*this, mended, paved);
  const bool is_whole = mended.left.empty() && is_sound(paved.mesh);
  bool is_changed = !is_whole && remesher.make_whole();
  if ((is_whole || is_changed) && has_few_elements(paved.mesh) && is_too_coarse(paved.mesh))
    is_changed = remesher.make_finer() || is_changed;
  is_changed = remesher.make_regular() || is_changed;
  if (is_changed) mended.places.push_back({ElementRepairKind::paved_again, where});
}

bool OtherWays::is_sound(const RegionMesh& mesh) const {
  return twin_sides(mesh).empty() && !has_long_side(mesh) && can_be_whole(mesh);
}

/// The front of a rod, a few elements about, may close along it. Of few elements.
bool OtherWays::has_long_side(const RegionMesh& mesh) const {
  return has_few_elements(mesh) && longest_side(mesh) > far_too_long * region.h;
}

bool OtherWays::has_known_area() const { return region.own_area > 0 && face.surface->kind() != SurfaceKind::plane; }

ElementArea OtherWays::area_of(const RegionMesh& mesh) const {
  const ElementJudge judge(region, mesh, sides, options.order);
  ElementArea sum;
  for (const Element& e : mesh.elements) {
    if (!e.is_alive()) continue;
    const ElementArea one = judge.area(e.v);
    sum.area += one.area, sum.slack += one.slack;
  }
  return sum;
}

/// As far as can be told from its elements, where these are few: a front may close across a body instead of around it
/// where lengths are about the body's own.
bool OtherWays::can_be_whole(const RegionMesh& mesh) const {
  if (!has_known_area() || !has_few_elements(mesh)) return true;
  const ElementArea sum = area_of(mesh);
  return can_be_area(sum.area, face, region.own_area, sum.slack);
}

double OtherWays::lacking(const RegionMesh& mesh) const {
  return has_known_area() ? std::max(0.0, 1 - area_of(mesh).area / region.own_area) : 0;
}

bool OtherWays::is_too_coarse(const RegionMesh& mesh) const {
  return lacking(mesh) > (options.order > 1 ? coarse : coarse_chords);
}

bool OtherWays::is_coarse_and_mixed(const RegionMesh& mesh) const {
  return options.elements == Elements::quad_dominant && has_few_elements(mesh) && mesh.triangle_count() > 0;
}

}  // namespace paver
