// In: loops. Out: elements, and the loops without the gaps.
// Steps: the node that faces each node, if any; runs of these; a quad from each pair to the next.
//
//      b2 --- b1 --- b0       One loop runs a0, a1, a2, another, or the same one farther on, b2, b1, b0.
//       |  q  |  q  |         Of two loops one is left, that goes on from a0 to b0 and from b2 to a2; one loop becomes
//      a2 --- a1 --- a0       two.
//
#include "paving/closing/gap_rows.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/boxes/box_tree.h"
#include "base/predicates.h"

namespace paver {
namespace {

using Loops = std::vector<std::vector<int>>;

constexpr double narrow = 0.35;         // of the shorter facet of a node: what is wider is left to rows
constexpr double across = 0.95;         // sine between the way across and the facets
constexpr double most_widening = 1.5;   // from one pair to the next: tips are none
constexpr double detour = 0.25;         // of the distance: from its middle to that of the way
constexpr std::size_t fewest_left = 4;  // nodes of a loop

class Gaps {
 public:
  Gaps(const Region& region, const RegionMesh& mesh, const Loops& loops)
      : region_(region), mesh_(mesh), partner_(mesh.p.size(), -1), next_(partner_), prev_(partner_) {
    std::vector<Box> boxes;
    for (const std::vector<int>& loop : loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const int node = loop[i], after = loop[(i + 1) % loop.size()];
        // Where a node lies in two sectors of the region it has no one neighbour: no gap is laid there.
        is_twice_ |= next_[node] >= 0;
        next_[node] = after, prev_[after] = node;
        nodes_.push_back(node);
        boxes.emplace_back().add(mesh.x[node]);
      }
    if (is_twice_) return;
    const BoxTree tree(std::move(boxes));
    std::vector<int> facing(mesh.p.size(), -1);
    for (const int node : nodes_) facing[node] = faced_by(node, tree);
    for (const int node : nodes_)
      if (facing[node] >= 0 && facing[facing[node]] == node) partner_[node] = facing[node];
  }

  /// The nodes of each run on one of its sides, in the order of the loop.
  Loops runs() const {
    Loops runs;
    std::vector<char> is_used(partner_.size(), 0);
    for (const int node : nodes_) {
      if (partner_[node] < 0 || is_used[node] != 0 || leads_on(prev_[node], node)) continue;
      std::vector<int> run{node};
      while (leads_on(run.back(), next_[run.back()])) run.push_back(next_[run.back()]);
      for (const int n : run) is_used[n] = is_used[partner_[n]] = 1;
      if (run.size() > 1) runs.push_back(std::move(run));
    }
    return runs;
  }

  int partner(int node) const { return partner_[node]; }

 private:
  double distance(int a, int b) const { return norm(mesh_.x[a] - mesh_.x[b]); }

  /// The nearest node before it, on the side of the region, or -1.
  int faced_by(int node, const BoxTree& tree) const {
    const double reach = narrow * std::min(distance(node, next_[node]), distance(node, prev_[node]));
    Box about;
    about.add(mesh_.x[node]);
    int best = -1;
    double least = reach;
    tree.each_meeting(about.grown(reach), [&](int i) {
      const int other = nodes_[i];
      if (other == node || other == next_[node] || other == prev_[node]) return;
      const double away = distance(node, other);
      if (away < least || (away == least && other < best)) least = away, best = other;
    });
    return best >= 0 && is_before(node, best) ? best : -1;
  }

  /// Whether the way to another node leads into the region, across one facet at least.
  bool is_before(int node, int other) const {
    const Vec3 way = unit(mesh_.x[other] - mesh_.x[node]);
    bool is_across = false;
    for (const auto& [a, b] : {std::pair(node, next_[node]), std::pair(prev_[node], node)}) {
      const bool is_square = norm(cross(way, unit(mesh_.x[b] - mesh_.x[a]))) > across;
      is_across |= is_square && orientation(mesh_.p[a], mesh_.p[b], mesh_.p[other]) > 0;
    }
    return is_across && is_short(node, other);
  }

  /// Whether the way within the surface is no detour, as round a cone that is cut open.
  bool is_short(int a, int b) const {
    const Vec3 middle = region_.place(0.5 * (mesh_.p[a] + mesh_.p[b])).x;
    return norm(middle - 0.5 * (mesh_.x[a] + mesh_.x[b])) < detour * distance(a, b);
  }

  /// Whether there is a quad from a pair to the next one.
  bool leads_on(int node, int after) const {
    const int one = partner_[node], two = partner_[after];
    if (one < 0 || two < 0 || next_[two] != one || next_[node] != after || after == one) return false;
    const double here = distance(node, one), there = distance(after, two);
    if (std::max(here, there) > most_widening * std::min(here, there)) return false;
    const int corners[] = {node, after, two, one};
    for (int k = 0; k < 4; ++k)
      if (orientation(mesh_.p[corners[k]], mesh_.p[corners[(k + 1) % 4]], mesh_.p[corners[(k + 2) % 4]]) <= 0)
        return false;
    return true;
  }

  const Region& region_;
  const RegionMesh& mesh_;
  std::vector<int> nodes_, partner_, next_, prev_;  // the latter per node of the mesh, -1: none
  bool is_twice_ = false;
};

struct Position {
  std::size_t loop = 0, index = 0;
};

Position find(const Loops& loops, int node) {
  for (std::size_t l = 0; l < loops.size(); ++l)
    if (const auto at = std::ranges::find(loops[l], node); at != loops[l].end())
      return {l, static_cast<std::size_t>(at - loops[l].begin())};
  return {loops.size(), 0};
}

/// The loops without the gap at a run; nothing where one of two would be odd and may not.
std::optional<Loops> without_gap(Loops loops, const std::vector<int>& run, const Gaps& gaps, bool may_be_odd) {
  const int first = run.front(), last = run.back();
  const Position a = find(loops, first), b = find(loops, gaps.partner(last));
  if (a.loop == loops.size() || b.loop == loops.size()) return std::nullopt;
  // From the end of the run on, to its start.
  auto rest = [&](const Position& at, std::size_t skip) {
    std::vector<int> nodes = loops[at.loop];
    std::rotate(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(at.index), nodes.end());
    nodes.erase(nodes.begin() + 1, nodes.begin() + static_cast<std::ptrdiff_t>(skip));
    std::rotate(nodes.begin(), nodes.begin() + 1, nodes.end());
    return nodes;
  };
  const std::size_t quads = run.size() - 1;
  Loops left;
  if (a.loop != b.loop) {
    std::vector<int> whole = rest(a, quads), other = rest(b, quads);
    if (whole.size() + other.size() < fewest_left) return std::nullopt;
    whole.insert(whole.end(), other.begin(), other.end());
    left.push_back(std::move(whole));
  } else {
    // One loop: a0 .. aN, one part, bN .. b0, the other one.
    std::vector<int> nodes = loops[a.loop];
    std::rotate(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(a.index), nodes.end());
    const auto bank = std::ranges::find(nodes, gaps.partner(last));
    if (nodes.end() - bank <= static_cast<std::ptrdiff_t>(quads)) return std::nullopt;
    std::vector<int> ahead(nodes.begin() + static_cast<std::ptrdiff_t>(quads), bank + 1),
        behind(bank + static_cast<std::ptrdiff_t>(quads), nodes.end());
    behind.push_back(first);
    for (std::vector<int>* part : {&ahead, &behind}) {
      if (part->size() % 2 != 0 && !may_be_odd) return std::nullopt;
      if (part->size() >= fewest_left)
        left.push_back(std::move(*part));
      else if (part->size() > 2)
        return std::nullopt;
    }
  }
  for (std::size_t l = 0; l < loops.size(); ++l)
    if (l != a.loop && l != b.loop) left.push_back(std::move(loops[l]));
  return left;
}

}  // namespace

std::vector<std::vector<int>> lay_gap_rows(const Region& region, RegionMesh& mesh, Loops loops, bool may_be_odd) {
  const Gaps gaps(region, mesh, loops);
  for (const std::vector<int>& run : gaps.runs()) {
    std::optional<Loops> left = without_gap(loops, run, gaps, may_be_odd);
    if (!left || left->empty()) continue;
    loops = std::move(*left);
    for (std::size_t i = 0; i + 1 < run.size(); ++i)
      mesh.add_element({run[i], run[i + 1], gaps.partner(run[i + 1]), gaps.partner(run[i])});
  }
  return loops;
}

}  // namespace paver
