// Curving by closest points in the charts: of the middles of chords, of the blends of sides.
#include "curving/place_nodes.h"

#include <array>

#include "base/tasks/tasks.h"
#include "curving/edge_bulges.h"
#include "curving/near_surface.h"

namespace paver {
namespace {

EdgeBulges bulges_about(const MeshPart& part, const PartSides& sides, const SurfaceMesh& mesh) {
  EdgeBulges bulges;
  for (std::size_t k = 0; k < sides.border.size(); ++k) {
    const auto [v, w] = sides.border[k];
    const int middle = sides.border_node[k];
    if (mesh.node_edge[middle] < 0) continue;
    bulges.add(part.mesh->global[v], mesh.nodes[(*part.node_of)[v]], part.mesh->global[w],
               mesh.nodes[(*part.node_of)[w]], mesh.nodes[middle]);
  }
  return bulges;
}

/// Per side inside the part: its middle's place in the chart.
std::vector<Vec2> place_sides(const MeshPart& part, const PartSides& sides, SurfaceMesh& mesh) {
  const std::vector<int>& node_of = *part.node_of;
  const EdgeBulges bulges = bulges_about(part, sides, mesh);
  std::vector<Vec2> places;
  int next = sides.first_own;
  for (auto [v, w] : sides.inside) {
    Vec2& place = places.emplace_back(guess_middle(*part.region, *part.mesh, v, w, {}));
    const SideEnd a = side_end(*part.mesh, v, mesh.nodes[node_of[v]]);
    const SideEnd b = side_end(*part.mesh, w, mesh.nodes[node_of[w]]);
    mesh.nodes[next++] = side_middle(*part.region, a, b, bulges.beside(a, b), place);
  }
  return places;
}

// Where a cut has a place of its own it counts, so that all parts and ranks find the same, to the last bit; else the
// part's.
void place_cuts(const PartSides& sides, const CurvingTask& task, const MeshPart& part, SurfaceMesh& mesh,
                std::vector<char>& is_placed) {
  for (std::size_t k = 0; k < sides.border.size(); ++k) {
    const int number = sides.border_cut[k];
    if (number < 0 || is_placed[number]) continue;
    is_placed[number] = 1;
    const CutSide& cut = task.cuts.sides()[number];
    auto [v, w] = sides.border[k];
    if (shared_node(part.mesh->global[v], part.outline, task.edges.nodes.size()) != cut.a) std::swap(v, w);
    const Region& region = cut.region ? *cut.region : *part.region;
    auto end_of = [&](int node, Vec2 place) {
      SideEnd end = side_end(*part.mesh, node, mesh.nodes[(*part.node_of)[node]]);
      end.h = region.h;
      if (!cut.region) return end;
      const SurfaceSlope slope = region.slope(place);
      end.p = place, end.normal = cross(slope.u, slope.v);
      return end;
    };
    const SideEnd a = end_of(v, cut.pa), b = end_of(w, cut.pb);
    Vec2 middle = half_way(region, a.p, b.p);
    mesh.nodes[sides.border_node[k]] = side_middle(region, a, b, {}, middle);
  }
}

/// Places the centres of a part's quads, of which `quad` is the first, with what is known of its sides.
void place_centres(const MeshPart& part, const PartSides& sides, const std::vector<Vec2>& places, std::size_t quad,
                   SurfaceMesh& mesh) {
  auto middle_place = [&](int side) {
    if (side >= 0) return places[side];
    auto [v, w] = sides.border[-1 - side];
    auto position = [&](int node) { return mesh.nodes[(*part.node_of)[node]]; };
    const Vec3 middle = mesh.nodes[sides.border_node[-1 - side]];
    return guess_middle(*part.region, *part.mesh, v, w, middle - 0.5 * (position(v) + position(w)));
  };
  const std::vector<Element>& elements = part.mesh->elements;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    if (!elements[e].is_alive() || elements[e].corners() != 4) continue;
    const Vec3 blend = blended_centre(mesh, static_cast<int>(quad));
    const int* v = &mesh.quads[9 * quad++];
    const double across = norm(mesh.nodes[v[2]] - mesh.nodes[v[0]]);
    const auto& of = sides.of_element[e];
    Vec2 place = guess_centre(*part.region, *part.mesh, elements[e].v,
                              {middle_place(of[0]), middle_place(of[1]), middle_place(of[2]), middle_place(of[3])});
    mesh.nodes[v[8]] = nearest_point(*part.region, place, blend, across);
  }
}

}  // namespace

CurvedMesh curve_elements(SurfaceMesh linear, const CurvingTask& task, const Progress& progress) {
  const std::vector<MeshPart>& parts = task.parts;
  OrderTwoMesh raised = number_order_2(std::move(linear), task);
  SurfaceMesh& mesh = raised.mesh;
  std::vector<char> is_placed(task.cuts.sides().size(), 0);
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (parts[i].mesh) place_cuts(raised.sides[i], task, parts[i], mesh, is_placed);
  const std::vector<PartRows> first = part_rows(task.sizes);
  run_tasks(task.threads, part_costs(task.sizes), [&](int i) {
    progress.check();
    if (!parts[i].mesh) return;
    const std::vector<Vec2> places = place_sides(parts[i], raised.sides[i], mesh);
    place_centres(parts[i], raised.sides[i], places, first[i].quad, mesh);
  });
  CurvedMesh result{std::move(mesh), std::move(raised.own_nodes), {}, raised.first_inside};
  for (std::size_t c = 0; c < raised.cut_node.size(); ++c)
    if (raised.cut_node[c] >= 0) result.cuts.push_back(static_cast<int>(c));
  return result;
}

}  // namespace paver
