// Pieces by halving: along the longer side of the box about the elements' centres in the chart, so that each half gets
// its share of the fine elements.
#include "multilevel/level_plan.h"

#include <algorithm>
#include <cmath>

#include "base/box.h"
#include "base/packing.h"

namespace paver {
namespace {

struct Centre {
  Vec2 p;
  int element;
  double fine;
};

Vec2 centre_of(const RegionMesh& mesh, int e) {
  Vec2 sum{0, 0};
  const Element& element = mesh.elements[e];
  for (int k = 0; k < element.corners(); ++k) sum = sum + mesh.p[element.v[k]];
  return (1.0 / element.corners()) * sum;
}

bool is_wide(const Centre* first, const Centre* last) {
  Box box;
  for (const Centre* c = first; c != last; ++c) box.add(c->p);
  return box.high.x - box.low.x >= box.high.y - box.low.y;
}

void halve(Centre* first, Centre* last, int pieces, std::vector<std::vector<int>>& result) {
  if (pieces < 2 || last - first < 2) {
    std::vector<int>& piece = result.emplace_back();
    for (const Centre* c = first; c != last; ++c) piece.push_back(c->element);
    std::sort(piece.begin(), piece.end());
    return;
  }
  const bool by_x = is_wide(first, last);
  std::sort(first, last, [&](const Centre& a, const Centre& b) {
    const double at = by_x ? a.p.x : a.p.y, other = by_x ? b.p.x : b.p.y;
    return at != other ? at < other : a.element < b.element;
  });
  const int first_pieces = pieces / 2;
  double all = 0, sum = 0;
  for (const Centre* c = first; c != last; ++c) all += c->fine;
  Centre* middle = first;
  while (middle + 1 != last && sum + 0.5 * middle->fine < all * first_pieces / pieces) sum += (middle++)->fine;
  if (middle == first) ++middle;
  halve(first, middle, first_pieces, result);
  halve(middle, last, pieces - first_pieces, result);
}

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

std::vector<std::vector<int>> groups_by_nodes(const RegionMesh& mesh, std::set<int> waits) {
  std::vector<std::vector<int>> groups;
  while (!waits.empty()) {
    std::vector<int>& group = groups.emplace_back(1, *waits.begin());
    waits.erase(waits.begin());
    for (std::size_t i = 0; i < group.size(); ++i)
      for (int v : mesh.elements[group[i]].v) {
        if (v < 0) continue;
        for (int e : mesh.star[v])
          if (waits.erase(e) > 0) group.push_back(e);
      }
    std::sort(group.begin(), group.end());
  }
  return groups;
}

double fine_elements(const LevelPlan& plan, int element) {
  const auto& edges = plan.net.of_element[element];
  const double m = 0.5 * plan.counts[edges[0]], n = 0.5 * plan.counts[edges[1]];
  if (plan.mesh.elements[element].corners() == 3) {
    const double mean = (2 * m + 2 * n + plan.counts[edges[2]]) / 3;
    constexpr double of_quad = 0.75;  // three quads of half the side
    return of_quad * mean * mean;
  }
  return (m + 0.5 * plan.counts[edges[2]]) * (n + 0.5 * plan.counts[edges[3]]);
}

void cut_in_pieces(LevelPlan& plan, double elements) {
  plan.pieces.clear();
  std::vector<Centre> centres;
  std::set<int> paved;
  double all = 0;
  for (std::size_t e = 0; e < plan.mesh.elements.size(); ++e) {
    const int i = static_cast<int>(e);
    const bool is_paved = elements > 0 && plan.is_paved[e];
    if (is_paved) paved.insert(i);
    if (is_paved || !plan.mesh.elements[e].is_alive()) continue;
    centres.push_back({centre_of(plan.mesh, i), i, fine_elements(plan, i)});
    all += centres.back().fine;
  }
  const int pieces = elements > 0 ? std::max(1, static_cast<int>(std::lround(all / elements))) : 1;
  if (!centres.empty()) halve(centres.data(), centres.data() + centres.size(), pieces, plan.pieces);
  for (std::vector<int>& piece : groups_by_nodes(plan.mesh, std::move(paved))) plan.pieces.push_back(std::move(piece));
}

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
