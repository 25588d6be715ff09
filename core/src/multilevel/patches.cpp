// Elements whose divisions would be poor are marked, with some about them; then, in: marked elements, out: fine
// elements in their place. Steps: parts connected by nodes; their outlines as loops of fine nodes; a region of its own
// for each, with the fan about a pole that lies in it.
#include "multilevel/patches.h"

#include <algorithm>

#include "multilevel/pieces.h"

namespace paver {
namespace {

// Mean length of the fine edges along a coarse one, by their target length.
constexpr double shortest = 0.72, longest = 1.4;
constexpr double bent = 0.7071;     // cosine between the normals at the ends of a coarse edge, 45 degrees
constexpr int rings = 2;            // of coarse elements about the marked ones
constexpr double most_paved = 0.5;  // of the area

bool is_far_off(int e, const CoarseNet& net, const std::vector<int>& counts, const std::vector<double>& lengths) {
  if (net.edges[e].loop >= 0) return false;
  double length = lengths[e] / counts[e];
  return length < shortest || length > longest;
}

std::vector<char> marks(const RegionMesh& mesh, const CoarseNet& net, const std::vector<int>& counts,
                        const std::vector<double>& lengths) {
  std::vector<char> is_marked(mesh.elements.size(), 0);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const Element& element = mesh.elements[e];
    if (!element.is_alive()) continue;
    const auto& around = net.of_element[e];
    for (int k = 0, n = element.corners(); k < n; ++k) {
      bool is_unequal = n == 4 && k < 2 && counts[around[k]] != counts[around[k + 2]];
      is_marked[e] |= is_unequal || is_far_off(around[k], net, counts, lengths);
    }
  }
  return is_marked;
}

// Elements beside a bent edge cannot follow the surface, and what is divided from them lies on it askew.
void mark_bent(const RegionMesh& mesh, const CoarseNet& net, std::vector<char>& is_marked) {
  for (const CoarseEdge& edge : net.edges)
    if (dot(unit(mesh.normal(edge.a)), unit(mesh.normal(edge.b))) < bent)
      for (int e : edge.element)
        if (e >= 0) is_marked[e] = 1;
}

// Paving needs some room.
void grow(const RegionMesh& mesh, std::vector<char>& is_marked) {
  const std::vector<char> before = is_marked;
  for (std::size_t e = 0; e < before.size(); ++e) {
    if (!before[e]) continue;
    for (int v : mesh.elements[e].nodes())
      for (int other : mesh.star[v]) is_marked[other] = 1;
  }
}

// Marks elements that would leave an outline of the marked ones touching itself.
void settle_marks(const RegionMesh& mesh, const CoarseNet& net, std::vector<char>& is_marked) {
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    std::vector<int> part;
    for (std::size_t e = 0; e < is_marked.size(); ++e)
      if (is_marked[e]) part.push_back(static_cast<int>(e));
    const auto outline = outline_of(part, mesh, net);
    for (const auto& [node, edge] : outline) {
      if (outline.count(node) < 2) continue;
      for (int e : mesh.star[node])
        if (!is_marked[e]) is_marked[e] = has_changed = true;
    }
  }
}

bool is_too_much(const std::vector<char>& is_marked, const RegionMesh& mesh) {
  long marked = std::count_if(is_marked.begin(), is_marked.end(), [](char mark) { return mark != 0; });
  return static_cast<double>(marked) > most_paved * static_cast<double>(mesh.living_elements());
}

class PatchPaver {
 public:
  PatchPaver(FineMesh& fine, const std::function<RegionMesh(const Region&)>& pave)
      : fine_(fine), front_(fine.front), mesh_(fine.mesh), pave_region_(pave) {}

  void pave(const std::vector<int>& part) {
    Region region = task_of(front_.region);
    region.area = 0;
    for (int e : part) region.area += area_of(e);
    add_loops(part, region);
    for (int e : part) add_fan(e, region);
    take_over(pave_region_(region), !region.fans.empty());
  }

  std::vector<int> take_about_poles() { return std::move(about_poles_); }

 private:
  double area_of(int e) const {
    const auto& v = mesh_.elements[e].v;
    const Vec3 a = mesh_.x[v[0]], b = mesh_.x[v[1]], c = mesh_.x[v[2]], d = v[3] < 0 ? c : mesh_.x[v[3]];
    return 0.5 * norm(cross(c - a, d - b));
  }

  void add_loops(const std::vector<int>& part, Region& region) {
    std::multimap<int, OutlineEdge> outline = outline_of(part, mesh_, fine_.net);
    while (!outline.empty()) {
      std::vector<LoopNode>& loop = region.loops.emplace_back();
      int node = outline.begin()->first;
      for (auto next = outline.begin(); next != outline.end(); next = outline.find(node)) {
        add_edge(next->second, loop);
        node = next->second.to;
        outline.erase(next);
      }
    }
  }

  void add_edge(const OutlineEdge& at, std::vector<LoopNode>& loop) {
    for (int v : {at.from, at.to}) fine_.corner_node(v);
    const CoarseEdge& edge = fine_.net.edges[at.edge];
    const Row row = fine_.row_of(at.edge, at.from);
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      LoopNode node{row[i], -1, front_.mesh.p[row[i]], front_.mesh.x[row[i]], front_.mesh.h[row[i]], -1};
      if (edge.loop >= 0) {
        const LoopNode& known = fine_.loop_node(edge, static_cast<int>(i));
        node.edge = known.edge;
        if (i > 0) node.angle = known.angle;
      }
      loop.push_back(node);
    }
  }

  void add_fan(int e, Region& region) {
    const int pole = fine_.pole_of(e);
    if (pole < 0) return;
    for (const Fan& fan : front_.region.fans) {
      if (fan.centre.global != mesh_.global[pole]) continue;
      const int node = fine_.corner_node(pole);
      for (const Fan& known : region.fans)
        if (known.centre.global == node) return;
      region.fans.push_back(fan);
      region.fans.back().centre.global = node;
    }
  }

  void take_over(const RegionMesh& part, bool has_pole) {
    Row number(part.p.size(), -1);
    for (int v = 0; v < part.node_count(); ++v) {
      if (part.star[v].size() == 0) continue;
      number[v] = part.global[v] >= 0 ? part.global[v] : front_.add_placed_node(part.place(v));
      if (has_pole && part.global[v] < 0) about_poles_.push_back(number[v]);
    }
    for (const Element& element : part.elements) {
      if (!element.is_alive()) continue;
      Corners v{-1, -1, -1, -1};
      for (int k = 0; k < element.corners(); ++k) v[k] = number[element.v[k]];
      front_.mesh.add_element(v);
    }
  }

  FineMesh& fine_;
  Front& front_;
  const RegionMesh& mesh_;
  const std::function<RegionMesh(const Region&)>& pave_region_;
  std::vector<int> about_poles_;
};

}  // namespace

std::vector<char> choose_paved(const RegionMesh& mesh, const CoarseNet& net, const std::vector<int>& counts,
                               const std::vector<double>& lengths) {
  std::vector<char> is_marked = marks(mesh, net, counts, lengths);
  for (int ring = 0; ring < rings; ++ring) {
    if (ring == 1) mark_bent(mesh, net, is_marked);  // one ring is room enough about these
    grow(mesh, is_marked);
  }
  settle_marks(mesh, net, is_marked);
  if (is_too_much(is_marked, mesh)) is_marked.clear();
  return is_marked;
}

std::vector<int> pave_patches(FineMesh& fine, const std::vector<int>& marked,
                              const std::function<RegionMesh(const Region&)>& pave) {
  PatchPaver paver(fine, pave);
  for (const std::vector<int>& part : groups_by_nodes(fine.mesh, {marked.begin(), marked.end()})) paver.pave(part);
  return paver.take_about_poles();
}

}  // namespace paver
