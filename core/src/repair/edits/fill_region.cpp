#include "repair/edits/fill_region.h"

#include <algorithm>
#include <numeric>

#include "repair/edits/move_corners.h"
#include "repair/edits/row_along.h"

namespace paver {
namespace {

constexpr ElementKinds quads_only{true, false};

RegionMesh mesh_of_loop(const Region& region) {
  RegionMesh mesh;
  mesh.turn_weight = region.size.turn_weight();
  for (const LoopNode& node : region.loops[0]) add_node(region, node, mesh);
  return mesh;
}

/// With a row along the chain and its rest filled.
std::optional<RegionMesh> filled(const Region& region, const BoundarySides& sides, int order, std::span<const int> loop,
                                 SmoothChain chain) {
  RegionMesh mesh = mesh_of_loop(region);
  const ElementJudge judge(region, mesh, sides, order);
  std::vector<int> made;
  for (Vec2 p : places_of_row(mesh, loop, chain)) {
    const NodePlace place = region.place(p);
    made.push_back(mesh.add_node(place, region.target(p)));
  }
  const BorderRow row = row_along(loop, chain, made);
  const Filling rest = fill_outline(
      row.rest, quads_only, [&](const Corners& v, double floor) { return judge.value(v, floor); },
      [](int, int) { return false; });
  if (!(rest.worst > 0)) return std::nullopt;
  for (const std::vector<Corners>* elements : {&row.quads, &rest.elements})
    for (const Corners& corners : *elements) mesh.add_element(corners);
  raise_worst_about(judge, made, mesh);
  even_out(judge, made, mesh);
  return mesh;
}

}  // namespace

std::optional<RegionMesh> fill_with_row(const Region& region, const BoundarySides& sides, int order) {
  if (region.loops.size() != 1 || !region.fans.empty() || region.loops[0].size() > most_outline + 2)
    return std::nullopt;
  std::vector<int> loop(region.loops[0].size());
  std::iota(loop.begin(), loop.end(), 0);
  const RegionMesh border = mesh_of_loop(region);
  std::optional<RegionMesh> best;
  double most = 0;
  for (const SmoothChain& chain : smooth_chains({region, border, sides, order}, loop)) {
    if (!leaves_filling(loop, chain)) continue;
    std::optional<RegionMesh> mesh = filled(region, sides, order, loop, chain);
    const double worst = mesh ? ElementJudge(region, *mesh, sides, order).worst_value() : 0;
    if (worst > most) most = worst, best = std::move(mesh);
  }
  return best;
}

}  // namespace paver
