// Steps: the bad elements in order, new ones that are still bad behind them. For each: moves, then fillings of the
// element alone, with one neighbour, with two, of stars and the whole ring, without and with a node inside; then nodes
// on its sides; where nothing helps ever more elements about it together.
#include "repair/mend_region.h"

#include <algorithm>
#include <deque>
#include <optional>
#include <unordered_map>

#include "repair/edits/divide_inside.h"
#include "repair/edits/move_corners.h"
#include "repair/edits/patch.h"
#include "repair/edits/row_along.h"

namespace paver {
namespace {

constexpr int steps_per_element = 12, least_steps = 24;
constexpr std::size_t most_grown = 28;  // nodes about elements that are filled anew together
constexpr int most_growths = 1000;      // of a region, each a filling
constexpr double least_bend = 0.01;     // of the chord: below, a side counts as straight
constexpr double as_good = 1e-9;        // merits nearer than this are equal, the first is taken
constexpr double least_gain = 0.05;     // of value, of an element that is valid

struct CornersHash {
  std::size_t operator()(const Corners& v) const {
    std::size_t hash = 0;
    for (int node : v) hash = (hash ^ static_cast<std::size_t>(node)) * 0x9E3779B97F4A7C15U;
    return hash ^ hash >> 32U;
  }
};

/// The same element with its smallest corner first.
Corners rotated(Corners v) {
  const auto end = v.begin() + Element{v}.corners();
  std::rotate(v.begin(), std::min_element(v.begin(), end), end);
  return v;
}

class Mender {
 public:
  Mender(const ElementJudge& judge, ElementKinds kinds, RegionMesh& mesh)
      : region_(judge.region()), mesh_(mesh), judge_(judge), kinds_(kinds) {}

  Mended run(const std::vector<int>& bad) {
    std::deque<int> queue(bad.begin(), bad.end());
    std::vector<int> left;
    const long count = static_cast<long>(bad.size()), steps = least_steps + steps_per_element * count;
    std::size_t before = bad.size() + 1;
    for (long step = 0; step < steps && !queue.empty(); ++step) {
      if (step % (least_steps + count) == 0) {
        if (queue.size() + left.size() >= before) break;  // what comes is as bad as what goes
        before = queue.size() + left.size();
      }
      const int e = queue.front();
      queue.pop_front();
      if (!mesh_.elements[e].is_alive()) continue;
      const std::size_t made = mesh_.elements.size();
      if (!mend(e))
        left.push_back(e);
      else if (is_bad(e))
        queue.push_back(e);  // what helped others may help it yet
      for (std::size_t i = made; i < mesh_.elements.size(); ++i)
        if (is_bad(static_cast<int>(i))) queue.push_back(static_cast<int>(i));
    }
    left.insert(left.end(), queue.begin(), queue.end());
    for (int e : left)
      if (mesh_.elements[e].is_alive() && !is_bad(e)) raise_worst_about(judge_, free_corners(mesh_, e), mesh_);
    if (!in_rows_.empty()) even_out(judge_, free_nodes_near(mesh_, in_rows_), mesh_);
    for (int e : left) {
      if (!is_bad(e)) continue;
      mended_.left.push_back(e);
      if (kinds_.triangles) ask_for_side(e);
    }
    return mended_;
  }

 private:
  /// A change of connectivity: elements that go, and what comes.
  struct Candidate {
    ElementSet gone;
    Filling filling;
    std::vector<Vec2> nodes;  ///< places of new nodes, the next of the mesh
    double merit = -10;
  };

  /// A value, exact where it is above the floor it was asked for with.
  struct Known {
    double value = -2, floor = INFINITY;
  };

  bool is_bad(int e) const { return mesh_.elements[e].is_alive() && judge_.value(e) <= 0; }

  bool mend(int e) {
    known_.clear(), first_tried_ = mesh_.node_count();
    const double now = judge_.value(e);
    floor_ = now > value_of_cusp ? now + least_gain : std::max(now, 0.0);
    may_have_triangles_ = now <= 0 || !has_jacobian(mesh_, mesh_.elements[e], very_poor);
    const Vec3 where = middle(e);
    if (move_corners(judge_, e, fair, mesh_)) {
      note(ElementRepairKind::moved, where);
      return true;
    }
    Candidate best;
    try_sets(e, best);
    if (best.gone.empty() && !may_have_triangles_ && has_straight_corner(judge_, e)) {
      may_have_triangles_ = true;
      try_sets(e, best);
    }
    if (now <= 0 && best.filling.worst < fair) {
      if (divide_bend(judge_, e, kinds_, mesh_) > 0) {
        note(ElementRepairKind::divided, where);
        return true;
      }
      try_sides(e, best);
    }
    if (best.gone.empty() && now <= 0) grow(e, best);
    if (best.gone.empty()) return false;
    carry_out(best);
    note(best.nodes.empty() ? ElementRepairKind::refilled : ElementRepairKind::divided, where);
    return true;
  }

  /// The element alone, with one neighbour, with two, the stars of its corners, its ring.
  void try_sets(int e, Candidate& best) {
    ElementSet about = neighbours_of(mesh_, e);
    try_set({e}, best);
    for (int f : about) try_set({e, f}, best);
    for (std::size_t i = 0; i < about.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) try_set({e, about[i], about[j]}, best);
      for (int g : neighbours_of(mesh_, about[i]))
        if (g != e) try_set({e, about[i], g}, best);
    }
    for (int v : mesh_.elements[e].nodes()) try_set({mesh_.star[v].begin(), mesh_.star[v].end()}, best);
    about.push_back(e);
    try_set(about, best);
    try_set(ring_about(mesh_, e), best);
  }

  /// Fillings of places that overlap ask for the same elements again and again.
  double value_of(const Corners& v, double floor) {
    floor = std::max(floor, floor_);
    if (*std::max_element(v.begin(), v.end()) >= first_tried_) return judge_.value(v, floor);
    Known& known = known_.try_emplace(rotated(v)).first->second;
    if (known.value > known.floor || known.floor <= floor) return known.value;
    return (known = {judge_.value(v, floor), floor}).value;
  }

  void note(ElementRepairKind kind, Vec3 where) { mended_.places.push_back({kind, where}); }

  Vec3 middle(int e) const {
    Vec3 sum;
    const Element& element = mesh_.elements[e];
    for (int v : element.nodes()) sum += (1.0 / element.corners()) * mesh_.x[v];
    return sum;
  }

  void try_set(const ElementSet& set, Candidate& best) {
    const PatchOutline outline = outline_of(mesh_, set, most_outline);
    if (outline.loop.empty()) return;
    std::vector<int> fixed;
    for (int v : outline.inside)
      if (mesh_.is_fixed[v]) fixed.push_back(v);
    if (fixed.size() > 1) return;
    if (fixed.size() == 1) {
      consider({set, fill_about(fixed[0], outline.loop, kinds_, value_), {}}, best);
      return;
    }
    consider({set, fill(outline.loop, set), {}}, best);
    if (best.filling.worst >= fair || outline.loop.size() < 4) return;
    Vec2 p;
    double h = 0;
    for (int v : outline.loop) {
      p = p + (1.0 / static_cast<double>(outline.loop.size())) * mesh_.p[v];
      h += mesh_.h[v] / static_cast<double>(outline.loop.size());
    }
    const int node = add_node(p, h);
    consider({set, fill_about(node, outline.loop, kinds_, value_), {p}}, best);
    mesh_.drop_last_node();
    if (kinds_.quads && best.filling.worst < fair)
      for (const SmoothChain& chain : smooth_chains(judge_, outline.loop)) try_row(set, outline.loop, chain, best);
  }

  /// Along a smooth part of the border, where two sides of a quad would leave no angle between them.
  void try_row(const ElementSet& set, const std::vector<int>& outline, SmoothChain chain, Candidate& best) {
    if (!leaves_filling(outline, chain)) return;
    const std::vector<Vec2> places = places_of_row(mesh_, outline, chain);
    std::vector<int> made;
    for (Vec2 p : places) made.push_back(add_node(p, mesh_.h[outline[chain.first]]));
    const BorderRow row = row_along(outline, chain, made);
    double worst = 1;
    for (const Corners& quad : row.quads)
      if (worst > floor_) worst = std::min(worst, value_of(quad, floor_));
    if (worst > floor_) {
      Filling filling = fill(row.rest, set);
      filling.worst = std::min(filling.worst, worst);
      filling.elements.insert(filling.elements.end(), row.quads.begin(), row.quads.end());
      consider({set, std::move(filling), places}, best);
    }
    for (std::size_t i = 0; i < made.size(); ++i) mesh_.drop_last_node();
  }

  /// For the place of some elements.
  Filling fill(const std::vector<int>& outline, const ElementSet& set, std::size_t most_nodes = most_outline) {
    return fill_outline(
        outline, kinds_, value_, [&](int a, int b) { return is_side_outside(mesh_, set, a, b); }, most_nodes);
  }

  /// Neighbours join it one by one, nearest first, as long as there is one loop about all and no fixed node inside.
  void grow(int e, Candidate& best) {
    ElementSet set{e};
    for (std::size_t from = 0; from < set.size(); ++from)
      for (int next : neighbours_of(mesh_, set[from])) {
        if (std::find(set.begin(), set.end(), next) != set.end()) continue;
        set.push_back(next);
        const PatchOutline outline = outline_of(mesh_, set, most_grown);
        const bool is_simple = !outline.loop.empty() && std::none_of(outline.inside.begin(), outline.inside.end(),
                                                                     [&](int v) { return mesh_.is_fixed[v]; });
        if (!is_simple) {
          set.pop_back();
          continue;
        }
        if (set.size() < 3) continue;
        if (growths_++ >= most_growths) return;
        consider({set, fill(outline.loop, set, most_grown), {}}, best);
        if (!best.gone.empty()) return;
      }
  }

  int add_node(Vec2 p, double h) { return mesh_.add_node(region_.place(p), h); }

  /// A node on one side inside, both elements there filled anew.
  void try_sides(int e, Candidate& best) {
    const Element element = mesh_.elements[e];
    for (int k = 0, n = element.corners(); k < n; ++k) {
      const int a = element.v[k], b = element.v[(k + 1) % n], other = mesh_.across(a, b);
      if (other < 0 || is_too_short(mesh_, a, b)) continue;
      const int node = add_node_between(region_, a, b, mesh_);
      auto filled = [&](int at) { return fill(with_node_between(mesh_.elements[at], a, b, node), {e, other}); };
      Filling here = filled(e), there = filled(other);
      if (here.worst > 0 && there.worst > 0) {
        here.worst = std::min(here.worst, there.worst);
        here.triangles += there.triangles;
        here.elements.insert(here.elements.end(), there.elements.begin(), there.elements.end());
        consider({{e, other}, std::move(here), {mesh_.p[node]}}, best);
      }
      mesh_.drop_last_node();
    }
  }

  void consider(Candidate candidate, Candidate& best) const {
    if (candidate.filling.worst <= floor_) return;
    const auto triangles = std::count_if(candidate.gone.begin(), candidate.gone.end(),
                                         [&](int e) { return mesh_.elements[e].corners() == 3; });
    const int more = candidate.filling.triangles - static_cast<int>(triangles);
    if (more > 0 && !may_have_triangles_) return;
    candidate.merit = merit(candidate.filling.worst, more);
    if (candidate.merit > best.merit + as_good) best = std::move(candidate);
  }

  void carry_out(const Candidate& best) {
    double h = 0;
    int count = 0;
    for (int e : best.gone)
      for (int v : mesh_.elements[e].nodes()) h += mesh_.h[v], ++count;
    std::vector<int> nodes;
    for (Vec2 p : best.nodes) nodes.push_back(add_node(p, h / count));
    for (int e : best.gone) mesh_.remove_element(e);
    for (const Corners& corners : best.filling.elements) mesh_.add_element(corners);
    if (nodes.size() < 2) return;
    raise_worst_about(judge_, nodes, mesh_);
    in_rows_.insert(in_rows_.end(), nodes.begin(), nodes.end());
  }

  /// Of its sides on B-rep edges the one that leaves its chord farthest, or the longest where none bends.
  void ask_for_side(int e) {
    const Element& element = mesh_.elements[e];
    SideToDivide asked;
    double most = -1;
    for (int k = 0, n = element.corners(); k < n; ++k) {
      const int v = element.v[k], w = element.v[(k + 1) % n], a = mesh_.global[v], b = mesh_.global[w];
      const BoundarySide* side = judge_.sides().find(a, b);
      if (!side || is_too_short(mesh_, v, w)) continue;
      const double length = norm(mesh_.x[w] - mesh_.x[v]);
      const double sagitta = norm(side->middle - 0.5 * (mesh_.x[v] + mesh_.x[w]));
      const double weight = sagitta > least_bend * length ? 1 + sagitta / mesh_.h[v] : length / (length + mesh_.h[v]);
      if (weight > most) most = weight, asked = {side->edge, a, b};
    }
    if (asked.edge >= 0) mended_.sides.push_back(asked);
  }

  const Region& region_;
  RegionMesh& mesh_;
  const ElementJudge& judge_;
  const ElementKinds kinds_;
  const ElementValue value_ = [this](const Corners& v, double floor) { return value_of(v, floor); };
  double floor_ = 0;                                       // value that what comes must exceed
  bool may_have_triangles_ = true;                         // more of them than what goes
  std::unordered_map<Corners, Known, CornersHash> known_;  // of elements between nodes that stay where they are
  int first_tried_ = 0;                                    // nodes from here on are for trying
  int growths_ = 0;
  std::vector<int> in_rows_;  // new nodes
  Mended mended_;
};

}  // namespace

Mended mend_region(const ElementJudge& judge, ElementKinds kinds, std::vector<int> bad, RegionMesh& mesh) {
  std::sort(bad.begin(), bad.end());
  return Mender(judge, kinds, mesh).run(bad);
}

}  // namespace paver
