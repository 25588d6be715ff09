// Edges by sorting the elements' sides; chords by walking across quads.
#include "multilevel/coarse/coarse_net.h"

#include <algorithm>
#include <compare>

namespace paver {
namespace {

struct ElementSide {
  int low, high, element, corner;
  auto operator<=>(const ElementSide&) const = default;
};

std::vector<ElementSide> sorted_sides(const RegionMesh& mesh) {
  std::vector<ElementSide> sides;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const Element& element = mesh.elements[e];
    if (!element.is_alive()) continue;
    for (int k = 0, n = element.corners(); k < n; ++k) {
      auto [low, high] = std::minmax(element.v[k], element.v[(k + 1) % n]);
      sides.push_back({low, high, static_cast<int>(e), k});
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

bool mark_boundary(CoarseNet& net) {
  std::map<std::pair<int, int>, int> single;
  for (std::size_t e = 0; e < net.edges.size(); ++e) {
    const CoarseEdge& edge = net.edges[e];
    if (edge.element[1] < 0) single[{edge.a, edge.b}] = static_cast<int>(e);
  }
  for (std::size_t l = 0; l < net.loop_node.size(); ++l) {
    const std::vector<int>& nodes = net.loop_node[l];
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      auto found = single.find({nodes[i], nodes[(i + 1) % nodes.size()]});
      if (found == single.end()) return false;
      net.edges[found->second].loop = static_cast<int>(l);
      net.edges[found->second].facet = static_cast<int>(i);
      single.erase(found);
    }
  }
  return single.empty();
}

class ChordWalker {
 public:
  ChordWalker(const CoarseRegion& coarse, const RegionMesh& mesh, const CoarseNet& net)
      : coarse_(coarse), mesh_(mesh), net_(net), is_done_(net.edges.size(), 0) {}

  std::vector<Chord> run() {
    for (std::size_t e = 0; e < net_.edges.size(); ++e) {
      const CoarseEdge& edge = net_.edges[e];
      if (edge.loop >= 0) walk(static_cast<int>(e), -1, side_of(edge));
    }
    for (std::size_t e = 0; e < net_.edges.size(); ++e)
      for (int element : net_.edges[e].element)
        if (element >= 0 && mesh_.elements[element].corners() == 3) walk(static_cast<int>(e), element, -1);
    for (std::size_t e = 0; e < net_.edges.size(); ++e) walk(static_cast<int>(e), net_.edges[e].element[0], -1);
    return std::move(chords_);
  }

 private:
  int side_of(const CoarseEdge& edge) const { return edge.loop < 0 ? -1 : coarse_.side[edge.loop][edge.facet]; }

  void walk(int edge, int from, int start_side) {
    if (is_done_[edge]) return;
    Chord chord;
    chord.side[0] = start_side;
    while (!is_done_[edge]) {
      is_done_[edge] = 1;
      chord.edges.push_back(edge);
      const auto& elements = net_.edges[edge].element;
      int next = elements[0] == from ? elements[1] : elements[0];
      if (next < 0) chord.side[1] = side_of(net_.edges[edge]);
      if (next < 0 || mesh_.elements[next].corners() == 3) break;
      const auto& around = net_.of_element[next];
      int k = static_cast<int>(std::find(around.begin(), around.end(), edge) - around.begin());
      from = next;
      edge = around[(k + 2) % 4];
    }
    chords_.push_back(std::move(chord));
  }

  const CoarseRegion& coarse_;
  const RegionMesh& mesh_;
  const CoarseNet& net_;
  std::vector<char> is_done_;
  std::vector<Chord> chords_;
};

}  // namespace

std::optional<CoarseNet> build_net(const CoarseRegion& coarse, const RegionMesh& mesh) {
  CoarseNet net;
  net.of_element.assign(mesh.elements.size(), {-1, -1, -1, -1});
  net.loop_node = find_loop_nodes(coarse.region, mesh);
  const std::vector<ElementSide> sides = sorted_sides(mesh);
  for (std::size_t i = 0; i < sides.size();) {
    const Element& element = mesh.elements[sides[i].element];
    CoarseEdge edge;
    edge.a = element.v[sides[i].corner];
    edge.b = edge.a == sides[i].low ? sides[i].high : sides[i].low;
    int uses = 0;
    for (const std::size_t first = i;
         i < sides.size() && sides[i].low == sides[first].low && sides[i].high == sides[first].high; ++i, ++uses) {
      if (uses == 2) return std::nullopt;
      edge.element[uses] = sides[i].element;
      net.of_element[sides[i].element][sides[i].corner] = static_cast<int>(net.edges.size());
    }
    net.edges.push_back(edge);
  }
  if (!mark_boundary(net)) return std::nullopt;
  return net;
}

std::vector<Chord> find_chords(const CoarseRegion& coarse, const RegionMesh& mesh, const CoarseNet& net) {
  return ChordWalker(coarse, mesh, net).run();
}

std::multimap<int, OutlineEdge> outline_of(const std::vector<int>& part, const RegionMesh& mesh, const CoarseNet& net) {
  std::multimap<int, OutlineEdge> outline;
  for (int e : part) {
    const Element& element = mesh.elements[e];
    for (int k = 0, n = element.corners(); k < n; ++k) {
      const CoarseEdge& edge = net.edges[net.of_element[e][k]];
      const int across = edge.element[0] == e ? edge.element[1] : edge.element[0];
      if (across >= 0 && std::binary_search(part.begin(), part.end(), across)) continue;
      outline.insert({element.v[k], {net.of_element[e][k], element.v[k], element.v[(k + 1) % n]}});
    }
  }
  return outline;
}

}  // namespace paver
