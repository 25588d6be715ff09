// Pieces by halving: along the longer side of the box about the elements' centres in the chart, so that each half gets
// its share of the fine elements.
#include "multilevel/level_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

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
  constexpr double far = std::numeric_limits<double>::infinity();
  Vec2 low{far, far}, high{-far, -far};
  for (const Centre* c = first; c != last; ++c) {
    low = {std::min(low.x, c->p.x), std::min(low.y, c->p.y)};
    high = {std::max(high.x, c->p.x), std::max(high.y, c->p.y)};
  }
  return high.x - low.x >= high.y - low.y;
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

// Elements to be paved that hang together by nodes.
void add_paved_pieces(LevelPlan& plan) {
  std::vector<char> waits = plan.is_paved;
  for (std::size_t first = 0; first < waits.size(); ++first) {
    if (!waits[first]) continue;
    std::vector<int>& piece = plan.pieces.emplace_back();
    piece.push_back(static_cast<int>(first));
    waits[first] = 0;
    for (std::size_t i = 0; i < piece.size(); ++i)
      for (int v : plan.mesh.elements[piece[i]].v) {
        if (v < 0) continue;
        for (int e : plan.mesh.star[v])
          if (waits[e]) waits[e] = 0, piece.push_back(e);
      }
    std::sort(piece.begin(), piece.end());
  }
}

class OutlineNumberer {
 public:
  explicit OutlineNumberer(LevelPlan& plan) : plan_(plan) {}

  void run() {
    plan_.outline_nodes = 0;
    plan_.outline_sides.clear();
    plan_.outline_of_node.assign(plan_.mesh.p.size(), -1);
    plan_.outline_of_edge.assign(plan_.net.edges.size(), -1);
    std::vector<int> piece_of(plan_.mesh.elements.size(), -1);
    for (std::size_t i = 0; i < plan_.pieces.size(); ++i)
      for (int e : plan_.pieces[i]) piece_of[e] = static_cast<int>(i);
    for (std::size_t e = 0; e < plan_.net.edges.size(); ++e) {
      const CoarseEdge& edge = plan_.net.edges[e];
      if (edge.element[1] >= 0 && piece_of[edge.element[0]] != piece_of[edge.element[1]]) add(e);
    }
  }

 private:
  int shared(int v) {
    if (plan_.mesh.global[v] >= 0) return plan_.mesh.global[v];
    int& number = plan_.outline_of_node[v];
    if (number < 0) number = plan_.outline_nodes++;
    return plan_.boundary_nodes + number;
  }

  void add(std::size_t e) {
    const CoarseEdge& edge = plan_.net.edges[e];
    const int from = shared(edge.a), to = shared(edge.b), n = plan_.counts[e];
    plan_.outline_of_edge[e] = plan_.outline_nodes;
    int last = from;
    for (int i = 1; i < n; ++i) {
      int next = plan_.boundary_nodes + plan_.outline_nodes++;
      plan_.outline_sides.push_back({last, next});
      last = next;
    }
    plan_.outline_sides.push_back({last, to});
  }

  LevelPlan& plan_;
};

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
  double all = 0;
  for (std::size_t e = 0; e < plan.mesh.elements.size(); ++e) {
    if (!plan.mesh.elements[e].is_alive() || (plan.is_paved[e] && elements > 0)) continue;
    const int i = static_cast<int>(e);
    centres.push_back({centre_of(plan.mesh, i), i, fine_elements(plan, i)});
    all += centres.back().fine;
  }
  const int pieces = elements > 0 ? std::max(1, static_cast<int>(std::lround(all / elements))) : 1;
  if (!centres.empty()) halve(centres.data(), centres.data() + centres.size(), pieces, plan.pieces);
  if (elements > 0) add_paved_pieces(plan);
}

void number_outlines(LevelPlan& plan) {
  plan.place_on_loop.assign(plan.mesh.p.size(), {-1, -1});
  for (std::size_t l = 0; l < plan.net.loop_node.size(); ++l)
    for (std::size_t i = 0; i < plan.net.loop_node[l].size(); ++i)
      plan.place_on_loop[plan.net.loop_node[l][i]] = {static_cast<int>(l), static_cast<int>(i)};
  OutlineNumberer(plan).run();
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
  plan.mesh.star.resize(plan.mesh.p.size());
  for (std::size_t e = 0; e < plan.mesh.elements.size(); ++e)
    for (int k = 0; plan.mesh.elements[e].is_alive() && k < plan.mesh.elements[e].corners(); ++k)
      plan.mesh.star[plan.mesh.elements[e].v[k]].add(static_cast<int>(e));
  number_outlines(plan);
  return plan;
}

}  // namespace paver
