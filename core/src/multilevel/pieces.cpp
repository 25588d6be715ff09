// Pieces by halving: along the longer side of the box about the elements' centres in the chart, so that each half gets
// its share of the fine elements.
#include "multilevel/pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/box.h"

namespace paver {
namespace {

constexpr double paved_elements = 1500;          // fine ones: paving takes several times as long as division
constexpr int few_cuts = 2;                      // of what is paved together, each in two: large patches have levels
constexpr double most_elements = 10000;          // fine ones: what has more is cut further
constexpr double shortest = 0.5, longest = 1.6;  // fine edges on a cut, in target lengths

struct Centre {
  Vec2 p;
  int element;
  double fine;
};

Vec2 centre_of(const RegionMesh& mesh, int e) {
  Vec2 sum{0, 0};
  const Element& element = mesh.elements[e];
  for (int v : element.nodes()) sum = sum + mesh.p[v];
  return (1.0 / element.corners()) * sum;
}

bool is_wide(const Centre* first, const Centre* last) {
  Box box;
  for (const Centre* c = first; c != last; ++c) box.add(c->p);
  return box.high.x - box.low.x >= box.high.y - box.low.y;
}

/// The first of what lies beyond `share` of the fine elements. Neither side is empty.
Centre* divide(Centre* first, Centre* last, bool by_x, double share) {
  std::sort(first, last, [&](const Centre& a, const Centre& b) {
    const double at = by_x ? a.p.x : a.p.y, other = by_x ? b.p.x : b.p.y;
    return at != other ? at < other : a.element < b.element;
  });
  double all = 0, sum = 0;
  for (const Centre* c = first; c != last; ++c) all += c->fine;
  Centre* middle = first;
  while (middle + 1 != last && sum + 0.5 * middle->fine < all * share) sum += (middle++)->fine;
  return middle == first ? middle + 1 : middle;
}

std::vector<int> elements_of(const Centre* first, const Centre* last) {
  std::vector<int> elements;
  for (const Centre* c = first; c != last; ++c) elements.push_back(c->element);
  std::sort(elements.begin(), elements.end());
  return elements;
}

void halve(Centre* first, Centre* last, int pieces, std::vector<std::vector<int>>& result) {
  if (pieces < 2 || last - first < 2) {
    result.push_back(elements_of(first, last));
    return;
  }
  const int first_pieces = pieces / 2;
  Centre* middle = divide(first, last, is_wide(first, last), static_cast<double>(first_pieces) / pieces);
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

std::vector<Centre> centres_of(const LevelPlan& plan, const std::vector<int>& elements) {
  std::vector<Centre> centres;
  for (int e : elements) centres.push_back({centre_of(plan.mesh, e), e, fine_elements(plan, e)});
  return centres;
}

std::vector<std::vector<int>> halved(const LevelPlan& plan, const std::vector<int>& elements, int pieces) {
  std::vector<Centre> centres = centres_of(plan, elements);
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
    const double fine = fine_elements(plan_, group);
    if (group.size() > 1 && (fine > most_elements || (cuts > 0 && fine > 2 * paved_elements)))
      if (auto parts = cut_in_two(group)) {
        for (std::vector<int>& part : *parts) cut(std::move(part), cuts - 1);
        return;
      }
    plan_.pieces.push_back(std::move(group));
  }

 private:
  using Two = std::array<std::vector<int>, 2>;

  // In the middle of the longer side or of the shorter one, else beside it.
  std::optional<Two> cut_in_two(const std::vector<int>& group) {
    std::vector<Centre> centres = centres_of(plan_, group);
    Centre *first = centres.data(), *last = first + centres.size();
    const bool is_by_x = is_wide(first, last);
    for (double share : {0.5, 0.4, 0.6, 0.3, 0.7})
      for (bool by_x : {is_by_x, !is_by_x}) {
        const Centre* middle = divide(first, last, by_x, share);
        Two parts{elements_of(first, middle), elements_of(middle, last)};
        if (is_region(plan_, parts[0]) && is_region(plan_, parts[1]) && lay_cut(parts[0], parts[1])) return parts;
      }
    return std::nullopt;
  }

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
      for (int v : mesh.elements[group[i]].nodes())
        for (int e : mesh.star[v])
          if (waits.erase(e) > 0) group.push_back(e);
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
  for (std::vector<int>& group : groups_by_nodes(plan.mesh, std::move(paved))) cutter.cut(std::move(group), few_cuts);
}

}  // namespace paver
