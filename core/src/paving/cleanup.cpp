// Clean-up by energy: work lists of irregular nodes, elementary changes one or two at a time, each tried and taken back
// unless it lowers the energy and leaves sound, well-shaped elements; then smoothing of all nodes.
#include "paving/cleanup.h"

#include <algorithm>
#include <unordered_set>

#include "paving/cleanup_cavity.h"
#include "paving/cleanup_edit.h"
#include "paving/cleanup_moves.h"
#include "paving/cleanup_optimise.h"
#include "paving/cleanup_smooth.h"
#include "paving/cleanup_triangles.h"
#include "paving/smooth.h"

namespace paver {
namespace {

const int depth = 1;
const double max1 = 2;

const int rings = 4;
const int most_elements = 60;
const int order = 5431;

const Demand triangle_demand{-100, 0.3, 0.4};

class CleanUp {
 public:
  CleanUp(Front& front, const Progress& progress)
      : front_(front), progress_(progress), edit_(front), moves_(edit_), second_(edit_), cavity_(edit_), pairs_(edit_) {}

  void run() {
    RegionMesh& mesh = front_.mesh;
    for (int o = order; o > 0; o /= 10) {
      int d = o % 10;
      if (d == 4) { join_triangles(); continue; }
      if (d != 5) for (int i = 0; i < mesh.node_count(); ++i) push(i);
      work([&](int node) { return d == 1 ? improve(node) : d == 2 ? improve_twice(node) : improve(node) || refill(node); });
    }
  }

 private:
  void push(int node) {
    if (waits_.size() <= static_cast<std::size_t>(node)) waits_.resize(node + 64, 0);
    if (waits_[node] || !(edit_.is_irregular(node) || is_at_triangle(node))) return;
    waits_[node] = 1;
    list_.push_back(node);
  }

  bool is_at_triangle(int node) const {
    for (int e : front_.mesh.star[node])
      if (front_.mesh.elements[e].corners() == 3) return true;
    return false;
  }

  template <class Improve>
  void work(Improve improve) {
    std::size_t most = 20 * front_.mesh.p.size() + 100;
    for (std::size_t i = 0; i < list_.size() && i < most; ++i) {
      if (i % 256 == 0) progress_.check();
      int node = list_[i];
      waits_[node] = 0;
      if (front_.mesh.star[node].size() == 0) continue;
      if (improve(node)) push(node);
    }
    list_.clear();
  }

  // Commits when the edits are good.
  bool take(const Demand& demand) {
    if (!edit_.settle(demand)) return false;
    std::vector<int> nodes = edit_.touched();
    edit_.commit();
    for (int v : nodes) push(v);
    return true;
  }

  bool improve(int node) {
    found_.clear();
    std::size_t used = 0;
    moves_.each(node, [&](const Change& change) {
      double gain = edit_.energy_gain(change);
      if (gain > -0.1) return false;
      if (pool_.size() <= used) pool_.emplace_back();
      pool_[used] = change;
      found_.push_back({gain, static_cast<int>(used++)});
      return false;
    });
    std::stable_sort(found_.begin(), found_.end(), [](auto p, auto q) { return p.first < q.first; });
    for (auto [gain, i] : found_) {
      if (edit_.apply(pool_[i]) && take({gain})) return true;
      edit_.roll_back(0);
    }
    return false;
  }

  bool improve_twice(int node) {
    if (improve(node)) return true;
    bool is_done = false;
    int tries = 0;
    moves_.each(node, [&](const Change& change) {
      double gain = edit_.energy_gain(change);
      if (gain > max1 || !edit_.apply(change)) return false;
      std::vector<int> nodes = edit_.touched();
      std::size_t mark = edit_.mark();
      for (int v : nodes) {
        if (!edit_.is_irregular(v)) continue;
        second_.each(v, [&](const Change& next) {
          double both = gain + edit_.energy_gain(next);
          if (both > -0.1) return false;
          ++tries;
          if (edit_.apply(next) && take({both})) return is_done = true;
          edit_.roll_back(mark);
          return false;
        });
        if (is_done) return true;
      }
      edit_.roll_back(0);
      return tries > 12;
    });
    return is_done;
  }

  void join_triangles() {
    for (int e = 0; e < static_cast<int>(front_.mesh.elements.size()); ++e) {
      const Element& element = front_.mesh.elements[e];
      if (!element.is_alive() || element.corners() != 3 || !pairs_.find(e, fill_) || !edit_.apply(fill_)) continue;
      std::size_t mark = edit_.mark();
      if (take(triangle_demand)) continue;
      edit_.roll_back(mark);
      if (!divide_hexagon(mark)) edit_.roll_back(0);
    }
  }

  // Where all nodes about joined triangles are fixed, the quads need a node or two between.
  bool divide_hexagon(std::size_t mark) {
    bool is_done = false;
    int tries = 0;
    const std::vector<int> nodes = edit_.touched();
    for (int v : nodes) {
      if (is_done || tries > 24) break;
      second_.each(v, [&](const Change& next) {
        if (next.fresh.empty() || next.gone.size() != 2) return false;
        if (++tries > 24 || (edit_.apply(next) && take(triangle_demand))) return is_done = tries <= 24;
        edit_.roll_back(mark);
        return false;
      });
    }
    return is_done;
  }

  bool refill(int node) {
    cavity_.start(node);
    for (int ring = 0; ring < rings && cavity_.grow(most_elements); ++ring) {
      if (!cavity_.find_fill(1, fill_) || !tried_.insert(cavity_.outline_key()).second) continue;
      double gain = edit_.energy_gain(fill_);
      if (edit_.apply(fill_) && take({gain})) return true;
      edit_.roll_back(0);
    }
    return false;
  }

  Front& front_;
  const Progress& progress_;
  MeshEdit edit_;
  Moves moves_, second_;
  Cavity cavity_;
  TrianglePairs pairs_;
  Change fill_;
  std::vector<Change> pool_;
  std::vector<std::pair<double, int>> found_;
  std::vector<int> list_;
  std::unordered_set<std::size_t> tried_;  // outlines whose fill was not good
  std::vector<char> waits_;
};

}  // namespace

void clean_up(Front& front, const Progress& progress) {
  CleanUp(front, progress).run();
  Sweeper sweeper(front);
  for (int k = 0; k < 6; ++k) sweeper.sweep(1);
  raise_worst(front, 0.7, 4);
  std::vector<int> nodes;
  for (int i = 0; i < front.mesh.node_count(); ++i) nodes.push_back(i);
  for (int k = 0; k < 0; ++k) {
    progress.check();
    smooth_nodes(front, nodes, 1);
  }
}

}  // namespace paver
