// Clean-up by energy: work lists of irregular nodes; elementary changes first,
// then cavities filled anew, then pairs of triangles walked together. Each is
// tried and taken back unless it lowers the energy and leaves sound,
// well-shaped elements. Then smoothing of all nodes, and a search for the best
// places about the worst elements.
#include "paving/cleanup/clean_up.h"

#include <algorithm>
#include <unordered_set>

#include "paving/cleanup/cavity.h"
#include "paving/cleanup/mesh_edit.h"
#include "paving/cleanup/moves.h"
#include "paving/cleanup/triangle_pairs.h"
#include "paving/faults.h"
#include "paving/smoothing/raise_worst.h"
#include "paving/smoothing/sweeper.h"

namespace paver {
namespace {

constexpr double least_gain = 0.1;         // of energy, by which a change of connectivity is worth a trial
constexpr double least_after_gain = 0.45;  // scaled Jacobian

// Cavities about a node grow this far, once in a run to the wide limit: again, they cost much and find little.
constexpr int most_rings = 4, most_wide_rings = 8, most_elements = 250;
constexpr double most_excess = 14;  // energy and spread together that a fill may lack as it is laid
constexpr double any_spread = 1e9;
constexpr int most_hexagons = 24;  // divisions tried for one pair of triangles
constexpr int sweeps = 8, sweeps_again = 6;
constexpr std::size_t most_growth = 40;  // elements made, by those there are; on all models at hand up to 5
// Even lengths may cost energy: a change as dear as this is tried where a likely share of the spread about it would pay
// for it, and where it brings the number of elements nearer to what the area wants.
constexpr double dearest = 2.5, dearest_turn = 0.5, likely_share = 0.25, least_fall = 0.1, least_fit = 0.05;
constexpr double even_jacobian = 0.6;  // least scaled Jacobian such a change may leave
constexpr double uneven = 0.25;        // spread about a regular node from which on it is looked at
// A triangle goes whatever it costs in energy, and for elements half as long or nearly twice.
constexpr Demand triangle_demand{.gain = -100, .jacobian = 0.3, .shortest = 0.4, .longest = 1.9};
// Where triangles are not wanted at all, in this order.
constexpr Demand all_quad_demands[] = {{-100, 0.2, 0.2, 0}, {-1e6, 0.05, 0.05, 0}, {-1e9, 1e-3, 1e-3, 0}};
constexpr int most_partners = 8;  // other triangles tried for one
// An element this poor may go at the cost of some energy when the worst about it rises.
constexpr double poor_jacobian = 0.6, most_energy = 4;
constexpr double sharp_jacobian = 0.2;  // an element at a sharper corner of the boundary is as good as it can be
constexpr Demand mending_demand{-100, 0.45, 0.4, 0.1};

class CleanUp {
 public:
  CleanUp(Front& front, const Progress& progress, int first_node)
      : region_(front.region),
        mesh_(front.mesh),
        progress_(progress),
        edit_(front),
        moves_(edit_),
        cavity_(edit_),
        pairs_(mesh_),
        first_node_(first_node),
        most_made_(1000 + most_growth * front.mesh.elements.size()) {}

  void run() {
    push_all();
    work([&](int node) { return improve(node); });
    push_all();
    work([&](int node) { return improve(node) || refill(node); });
    for (int round = 0; round < 2; ++round) {
      join_triangles(triangle_demand, 0);
      work([&](int node) { return improve(node) || refill(node); });
    }
    edit_.forget_measures();
  }

  /// After smoothing, by the lengths there are now.
  void run_again() {
    tried_.clear();
    is_stuck_.assign(is_stuck_.size(), 0);
    push_all();
    work([&](int node) { return improve(node) || refill(node); });
    edit_.forget_measures();
  }

  /// Quads for triangles, as good as they come but at any price.
  void join_all_triangles() {
    edit_.forget_measures();
    for (const Demand& demand : all_quad_demands)
      for (int nearer = 0; nearer < most_partners; ++nearer) join_triangles(demand, nearer);
    work([&](int node) { return improve(node) || refill(node); });
  }

  /// After smoothing: elements that stayed poor.
  void mend() {
    edit_.forget_measures();
    int left = 50 + static_cast<int>(mesh_.elements.size()) / 100;
    for (int e = 0, n = static_cast<int>(mesh_.elements.size()); e < n && left > 0; ++e) {
      const Element element = mesh_.elements[e];
      if (!element.is_alive() || has_jacobian(mesh_, element, poor_jacobian)) continue;
      if (!has_jacobian(mesh_, element, sharp_jacobian) && free_jacobian(region_, mesh_, element) >= poor_jacobian)
        continue;
      progress_.check();
      --left;
      for (int i = 0; i < element.corners() && mesh_.elements[e].is_alive(); ++i) mend_once(element.v[i]);
    }
  }

 private:
  // Not again where nothing has changed since: neighbours that are poor, too, have the node as well.
  void mend_once(int node) {
    if (mended_at_.size() <= static_cast<std::size_t>(node)) mended_at_.resize(mesh_.p.size(), -1);
    if (mended_at_[node] != taken_ && !mend_about(node)) mended_at_[node] = taken_;
  }

  bool mend_about(int node) {
    bool is_done = false;
    auto is_cheap = [](double gain, std::span<const int>, int) { return gain <= most_energy; };
    moves_.each(node, is_cheap, [&](const Change& change, double) {
      if (!edit_.apply(change)) return false;
      if (take(mending_demand)) return is_done = true;
      edit_.roll_back(0);
      return false;
    });
    return is_done || mend_cavity(node);
  }

  bool mend_cavity(int node) {
    cavity_.start(node);
    for (int ring = 0; ring < most_rings && cavity_.grow(most_elements); ++ring) {
      if (!cavity_.find_fill(-most_energy) || !cavity_.make_fill(fill_, any_spread) || !edit_.apply(fill_)) continue;
      if (take(mending_demand)) return true;
      edit_.roll_back(0);
    }
    return false;
  }

  void push(int node) {
    if (waits_.size() <= static_cast<std::size_t>(node))
      waits_.resize(node + 64, 0), is_stuck_.resize(node + 64, 0), was_wide_.resize(node + 64, 0);
    if (waits_[node] || !(edit_.is_irregular(node) || is_at_triangle(node) || is_uneven(node))) return;
    waits_[node] = 1;
    list_.push_back(node);
  }

  bool is_uneven(int node) {
    double spread = 0;
    for (int e : mesh_.star[node]) spread += edit_.spread_of(e);
    return spread > uneven;
  }

  void push_all() {
    for (int i = 0; i < mesh_.node_count(); ++i)
      if (i >= first_node_ || is_beside_new(i)) push(i);
  }

  bool is_beside_new(int node) const {
    for (int e : mesh_.star[node])
      for (int v : mesh_.elements[e].v)
        if (v >= first_node_) return true;
    return false;
  }

  bool is_at_triangle(int node) const {
    for (int e : mesh_.star[node])
      if (mesh_.elements[e].corners() == 3) return true;
    return false;
  }

  template <class Improve>
  void work(Improve improve_node) {
    const std::size_t most = 20 * mesh_.p.size() + 100;
    for (std::size_t i = 0; i < list_.size(); ++i) {
      if (i % 256 == 0) progress_.check();
      int node = list_[i];
      waits_[node] = 0;
      if (i < most && mesh_.elements.size() < most_made_ && mesh_.star[node].size() > 0 && improve_node(node))
        push(node);
    }
    list_.clear();
  }

  // Keeps the edits and takes up their nodes, if the elements are as demanded.
  bool take(const Demand& demand) {
    if (!edit_.settle(demand)) return false;
    const std::vector<int> nodes = edit_.touched();
    edit_.commit();
    ++taken_;
    for (int v : nodes) {
      push(v);
      is_stuck_[v] = 0;
    }
    return true;
  }

  // The elementary change about the node that lowers the energy most.
  bool improve(int node) {
    if (is_stuck_[node]) return false;
    found_.clear();
    std::size_t used = 0;
    auto is_worth = [&](double gain, std::span<const int> gone, int made) {
      return gain <= -least_gain || may_even_lengths(gain, gone, made);
    };
    moves_.each(node, is_worth, [&](const Change& change, double gain) {
      if (pool_.size() <= used) pool_.emplace_back();
      pool_[used] = change;
      found_.push_back({gain, static_cast<int>(used++)});
      return false;
    });
    std::stable_sort(found_.begin(), found_.end(), [](auto p, auto q) { return p.first < q.first; });
    for (auto [gain, i] : found_) {
      if (edit_.apply(pool_[i]) &&
          take({.gain = gain, .jacobian = gain > 0 ? even_jacobian : least_after_gain, .fall = least_fall}))
        return true;
      edit_.roll_back(0);
    }
    is_stuck_[node] = 1;
    return false;
  }

  bool may_even_lengths(double gain, std::span<const int> gone, int made) {
    bool is_count_kept = static_cast<int>(gone.size()) == made;
    if (gain > (is_count_kept ? dearest_turn : dearest)) return false;
    if (!is_count_kept && count_gain(gone, made) > -least_fit) return false;
    return gain + least_fall <= likely_share * edit_.spread_price * edit_.spread_about(gone);
  }

  // How much nearer the change brings the number of elements to the area in target lengths; below 0: nearer.
  double count_gain(std::span<const int> gone, int made) {
    double area = 0;
    for (int e : gone) area += edit_.area(e);
    return std::fabs(std::log(made / area)) - std::fabs(std::log(static_cast<double>(gone.size()) / area));
  }

  bool refill(int node) {
    const int rings = was_wide_[node] ? most_rings : most_wide_rings;
    was_wide_[node] = 1;
    cavity_.start(node);
    for (int ring = 0; ring < rings && cavity_.grow(most_elements); ++ring) {
      const std::size_t outline = cavity_.outline_key();
      if (tried_.contains(outline)) continue;
      const std::optional<double> gain = cavity_.find_fill(1);
      if (!gain) continue;
      tried_.insert(outline);
      if (!cavity_.make_fill(fill_, (most_excess - *gain) / edit_.spread_price)) continue;
      if (edit_.apply(fill_) && take({.gain = *gain})) return true;
      edit_.roll_back(0);
    }
    return false;
  }

  void join_triangles(const Demand& demand, int nearer) {
    for (int e = 0; e < static_cast<int>(mesh_.elements.size()); ++e) {
      const Element& element = mesh_.elements[e];
      if (!element.is_alive() || element.corners() != 3 || !pairs_.find(e, fill_, nearer)) continue;
      if (!edit_.apply(fill_)) {
        edit_.roll_back(0);
        continue;
      }
      progress_.check();
      std::size_t mark = edit_.mark();
      if (take(demand)) continue;
      edit_.roll_back(mark);
      if (!divide_hexagon(mark, demand)) edit_.roll_back(0);
    }
  }

  // Where all nodes about joined triangles are fixed, the quads need a node or
  // two between.
  bool divide_hexagon(std::size_t mark, const Demand& demand) {
    bool is_done = false;
    int tries = 0;
    const std::vector<int> nodes = edit_.touched();
    for (int v : nodes) {
      if (is_done || tries >= most_hexagons) break;
      auto is_pair = [](double, std::span<const int> gone, int made) { return gone.size() == 2 && made > 2; };
      moves_.each(v, is_pair, [&](const Change& next, double) {
        if (++tries > most_hexagons) return true;
        if (edit_.apply(next) && take(demand)) return is_done = true;
        edit_.roll_back(mark);
        return false;
      });
    }
    return is_done;
  }

  const Region& region_;
  RegionMesh& mesh_;
  const Progress& progress_;
  MeshEdit edit_;
  Moves moves_;
  Cavity cavity_;
  TrianglePairs pairs_;
  Change fill_;
  std::vector<Change> pool_;
  std::vector<std::pair<double, int>> found_;
  std::vector<int> list_;
  std::vector<char> waits_;      // per node: on the list
  std::vector<char> was_wide_;   // per node: cavities about it have grown to the wide limit
  std::vector<char> is_stuck_;   // per node: no elementary change helped since the last edit there
  std::vector<long> mended_at_;  // per node: how often something was taken when mending it failed
  long taken_ = 0;
  const int first_node_;
  const std::size_t most_made_;            // elements, those replaced among them
  std::unordered_set<std::size_t> tried_;  // outlines whose fill was taken or was not good
};

}  // namespace

void clean_up(Front& front, const Progress& progress, bool all_quad, int first_node) {
  front.end_void();
  if (first_node == 0) front.order_nodes();  // else those done have their order
  CleanUp clean(front, progress, first_node);
  clean.run();
  if (all_quad) clean.join_all_triangles();
  sweep_nodes(front, sweeps, progress);
  clean.run_again();
  sweep_nodes(front, sweeps_again, progress);
  raise_worst(front, 3);
  clean.mend();
  raise_worst(front, 2);
}

}  // namespace paver
