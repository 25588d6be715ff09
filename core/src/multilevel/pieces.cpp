// Pieces by halving: along the longer side of the box about the elements' centres in the chart, so that each half gets
// its share of the fine elements.
#include "multilevel/pieces.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/box.h"

namespace paver {
namespace {

constexpr double paved_elements = 1500;          // fine ones: paving takes several times as long as division
constexpr int most_cuts = 2;                     // of what is paved together, each in two: large patches have levels
constexpr double shortest = 0.5, longest = 1.6;  // fine edges on a cut, in target lengths

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

std::vector<std::vector<int>> halved(const LevelPlan& plan, const std::vector<int>& elements, int pieces) {
  std::vector<Centre> centres;
  for (int e : elements) centres.push_back({centre_of(plan.mesh, e), e, fine_elements(plan, e)});
  std::vector<std::vector<int>> result;
  halve(centres.data(), centres.data() + centres.size(), pieces, result);
  return result;
}

/// Whether the elements hang together by edges and their outline does not touch itself.
bool is_region(const LevelPlan& plan, const std::vector<int>& part) {
  std::set<int> waits(part.begin(), part.end());
  std::vector<int> reached{part.front()};
  waits.erase(part.front());
  for (std::size_t i = 0; i < reached.size(); ++i)
    for (int edge : plan.net.of_element[reached[i]])
      for (int e : edge < 0 ? std::array<int, 2>{-1, -1} : plan.net.edges[edge].element)
        if (waits.erase(e) > 0) reached.push_back(e);
  const auto outline = outline_of(part, plan.mesh, plan.net);
  return waits.empty() && std::adjacent_find(outline.begin(), outline.end(), [](const auto& a, const auto& b) {
                            return a.first == b.first;
                          }) == outline.end();
}

bool is_in(const std::vector<int>& part, int element) { return std::binary_search(part.begin(), part.end(), element); }

/// What is paved together, in a few pieces where that is much: the one task of a blade's leading edge is else what all
/// ranks wait for.
class PavedCutter {
 public:
  PavedCutter(const Region& region, LevelPlan& plan)
      : plan_(plan), front_(region, mesh_), fine_(region, plan, front_) {}

  void cut(std::vector<int> group, int cuts) {
    if (cuts > 0 && fine_elements(plan_, group) > 2 * paved_elements) {
      std::vector<std::vector<int>> parts = halved(plan_, group, 2);
      if (parts.size() == 2 && is_region(plan_, parts[0]) && is_region(plan_, parts[1]) &&
          lay_cut(parts[0], parts[1])) {
        for (std::vector<int>& part : parts) cut(std::move(part), cuts - 1);
        return;
      }
    }
    plan_.pieces.push_back(std::move(group));
  }

 private:
  /// Quads alone need an even number of sides about them: one that is odd has an odd neighbour across the cut. False,
  /// and nothing done, where no good line of fine nodes can be laid along the cut.
  bool lay_cut(const std::vector<int>& part, const std::vector<int>& other) {
    int sides = 0, most_divided = -1;
    std::vector<int> edges;
    for (const auto& [node, at] : outline_of(part, plan_.mesh, plan_.net)) {
      sides += plan_.counts[at.edge];
      const auto& [a, b] = plan_.net.edges[at.edge].element;
      if (b < 0 || !is_in(other, is_in(part, a) ? b : a)) continue;
      edges.push_back(at.edge);
      if (most_divided < 0 || plan_.counts[at.edge] > plan_.counts[most_divided]) most_divided = at.edge;
    }
    if (edges.empty()) return false;
    const int more = sides % 2;
    plan_.counts[most_divided] += more;
    if (std::all_of(edges.begin(), edges.end(), [&](int e) { return has_even_row(e); })) return true;
    plan_.counts[most_divided] -= more;
    return false;
  }

  bool has_even_row(int e) {
    const CoarseEdge& edge = plan_.net.edges[e];
    if (fine_.is_pole(edge.a) || fine_.is_pole(edge.b)) return false;
    const Row row = fine_.row_of(e, edge.a);
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      const double length = norm(mesh_.between(row[i], row[i + 1])) / mesh_.h[row[i]];
      if (length < shortest || length > longest) return false;
      if (i > 0 && dot(mesh_.between(row[i - 1], row[i]), mesh_.between(row[i], row[i + 1])) <= 0) return false;
    }
    return true;
  }

  LevelPlan& plan_;
  RegionMesh mesh_;
  Front front_;
  FineMesh fine_;
};

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

double fine_elements(const LevelPlan& plan, const std::vector<int>& elements) {
  double sum = 0;
  for (int e : elements) sum += fine_elements(plan, e);
  return sum;
}

void cut_in_pieces(const Region& region, LevelPlan& plan, double elements) {
  plan.pieces.clear();
  std::vector<int> divided;
  std::set<int> paved;
  for (std::size_t e = 0; e < plan.mesh.elements.size(); ++e) {
    const int i = static_cast<int>(e);
    if (elements > 0 && plan.is_paved[e]) {
      paved.insert(i);
    } else if (plan.mesh.elements[e].is_alive()) {
      divided.push_back(i);
    }
  }
  const int pieces =
      elements > 0 ? std::max(1, static_cast<int>(std::lround(fine_elements(plan, divided) / elements))) : 1;
  if (!divided.empty()) plan.pieces = halved(plan, divided, pieces);
  if (paved.empty()) return;
  number_outlines(plan);  // none on the cuts yet
  PavedCutter cutter(region, plan);
  for (std::vector<int>& group : groups_by_nodes(plan.mesh, std::move(paved))) cutter.cut(std::move(group), most_cuts);
}

}  // namespace paver
