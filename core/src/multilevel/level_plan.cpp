// Outlines follow from the pieces: only these travel.
#include "multilevel/level_plan.h"

#include "base/packing.h"

namespace paver {
namespace {

/// Every field but those that number_outlines() fills in; stars follow from the elements.
template <class A>
void fields(A& archive, Is<LevelPlan> auto& plan) {
  auto& mesh = plan.mesh;
  archive(mesh.p, mesh.x, mesh.xp, mesh.xq, mesh.drift, mesh.turn_weight, mesh.turn, mesh.h, mesh.is_fixed, mesh.global,
          mesh.elements);
  archive(plan.net.edges, plan.net.of_element, plan.net.loop_node);
  archive(plan.at, plan.counts, plan.is_paved, plan.closed_by_triangulation, plan.multilevel, plan.boundary_nodes,
          plan.pieces);
}

}  // namespace

void number_outlines(LevelPlan& plan) {
  plan.place_on_loop.assign(plan.mesh.p.size(), {-1, -1});
  for (std::size_t l = 0; l < plan.net.loop_node.size(); ++l)
    for (std::size_t i = 0; i < plan.net.loop_node[l].size(); ++i)
      plan.place_on_loop[plan.net.loop_node[l][i]] = {static_cast<int>(l), static_cast<int>(i)};
  plan.outline_nodes = 0;
  plan.outline_sides.clear();
  plan.outline_of_node.assign(plan.mesh.p.size(), -1);
  plan.outline_of_edge.assign(plan.net.edges.size(), -1);
  std::vector<int> piece_of(plan.mesh.elements.size(), -1);
  for (std::size_t i = 0; i < plan.pieces.size(); ++i)
    for (int e : plan.pieces[i]) piece_of[e] = static_cast<int>(i);
  auto shared = [&](int v) {
    if (plan.mesh.global[v] >= 0) return plan.mesh.global[v];
    int& number = plan.outline_of_node[v];
    if (number < 0) number = plan.outline_nodes++;
    return plan.boundary_nodes + number;
  };
  for (std::size_t e = 0; e < plan.net.edges.size(); ++e) {
    const CoarseEdge& edge = plan.net.edges[e];
    if (edge.element[1] < 0 || piece_of[edge.element[0]] == piece_of[edge.element[1]]) continue;
    int last = shared(edge.a);
    const int to = shared(edge.b);
    plan.outline_of_edge[e] = plan.outline_nodes;
    for (int i = 1; i < plan.counts[e]; ++i) {
      const int next = plan.boundary_nodes + plan.outline_nodes++;
      plan.outline_sides.push_back({last, next});
      last = next;
    }
    plan.outline_sides.push_back({last, to});
  }
}

std::string pack(const LevelPlan& plan) {
  Packer packer;
  fields(packer, plan);
  return packer.take();
}

LevelPlan unpack_plan(std::string_view bytes) {
  LevelPlan plan;
  Unpacker unpacker(bytes);
  fields(unpacker, plan);
  plan.mesh.find_stars();
  number_outlines(plan);
  return plan;
}

}  // namespace paver
