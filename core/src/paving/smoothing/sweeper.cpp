// Smoothing sweeps: one pass over the elements gathers the wishes, one over the
// nodes moves them, one over the elements finds those that became bad, whose
// nodes go back until nothing is bad. With all nodes back the mesh is as
// before, so a sweep always ends and never leaves an element inverted or a poor
// one poorer.
#include "paving/smoothing/sweeper.h"

#include <algorithm>

#include "paving/smoothing/fit.h"

namespace paver {
namespace {

// With momentum a dozen sweeps even out lengths as thirty over-relaxed ones or sixty plain ones do.
constexpr double over_relaxation = 1.3, momentum = 0.7;
constexpr double still = 0.004;  // step by the scale of the mesh below which a node rests
constexpr double good_jacobian = 0.7;

class Sweeper {
 public:
  explicit Sweeper(Front& front) : front_(front), mesh_(front.mesh) {
    const std::size_t node_count = mesh_.p.size(), element_count = mesh_.elements.size();
    sum_.resize(node_count), last_.resize(node_count), scale_.resize(node_count), moved_as_.assign(node_count, -1),
        seen_node_.assign(node_count, 0);
    sj_.resize(element_count), old_sj_.resize(element_count), seen_.assign(element_count, 0);
    for (std::size_t e = 0; e < element_count; ++e)
      if (mesh_.elements[e].is_alive()) sj_[e] = capped_jacobian(mesh_.elements[e]);
    for (int i = 0; i < mesh_.node_count(); ++i) add_node(i);
    nodes_.swap(next_);
    for (int i : nodes_) scale_[i] = static_cast<float>(mesh_.scale_at(i));
  }

  /// False when nothing moved far any more.
  bool sweep() {
    ++run_;
    collect_elements();
    gather_wishes();
    move_nodes();
    take_back_bad();
    collect_nodes();
    nodes_.swap(next_);
    return !nodes_.empty();
  }

 private:
  void add_node(int node) {
    if (mesh_.is_fixed[node] || mesh_.star[node].size() == 0) return;
    next_.push_back(node);
  }

  float capped_jacobian(const Element& e) const {
    double sj = has_jacobian(mesh_, e, good_jacobian) ? good_jacobian : scaled_jacobian(mesh_, e);
    return static_cast<float>(std::min(good_jacobian, sj));
  }

  void collect_elements() {
    elements_.clear();
    for (int node : nodes_)
      for (int e : mesh_.star[node]) {
        if (seen_[e] == run_) continue;
        seen_[e] = run_;
        elements_.push_back(e);
      }
  }

  void gather_wishes() {
    for (int node : nodes_) sum_[node] = {};
    for (int e : elements_) {
      const Element& element = mesh_.elements[e];
      MetricVec steps[4];
      if (!fit_evenly(mesh_, element, steps)) continue;
      for (int i = 0; i < element.corners(); ++i) sum_[element.v[i]] += steps[i];
    }
  }

  void move_nodes() {
    old_.resize(nodes_.size());
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      int i = nodes_[k];
      const Vec2 wished = mesh_.pull_back(i, sum_[i]);
      const Vec2 step = (over_relaxation / mesh_.star[i].size()) * wished + momentum * last_[i];
      last_[i] = step;
      if (!(norm(mesh_.push(i, step)) > still * scale_[i])) continue;
      old_[k] = mesh_.p[i], sum_[i] = mesh_.point(i);
      front_.slide(i, mesh_.p[i] + step, scale_[i]);
      moved_as_[i] = static_cast<int>(k);
    }
  }

  bool check(int e) {
    if (!is_positive(mesh_, mesh_.elements[e])) return false;
    sj_[e] = capped_jacobian(mesh_.elements[e]);
    return sj_[e] >= static_cast<float>(good_jacobian) || sj_[e] >= old_sj_[e];
  }

  void take_back_bad() {
    stack_.clear();
    auto collect = [&](int e) {
      for (int v : mesh_.elements[e].nodes())
        if (moved_as_[v] >= 0) stack_.push_back(v);
    };
    for (int e : elements_) {
      old_sj_[e] = sj_[e];
      if (!check(e)) collect(e);
    }
    while (!stack_.empty()) {
      int node = stack_.back();
      stack_.pop_back();
      if (moved_as_[node] < 0) continue;
      const Vec2 old = old_[moved_as_[node]];
      moved_as_[node] = -1;
      // Derivatives stay those of where it was evaluated last: to be evaluated at its next move.
      mesh_.p[node] = old, mesh_.x[node] = sum_[node].x, mesh_.drift[node] = 1, last_[node] = {};
      if (mesh_.has_turns()) mesh_.turn[node].n = sum_[node].n;
      for (int e : mesh_.star[node])
        if (!check(e)) collect(e);
    }
  }

  // Nodes of all elements in which something moved.
  void collect_nodes() {
    next_.clear();
    for (int e : elements_) {
      const auto& v = mesh_.elements[e].v;
      auto has_moved = [&](int node) { return node >= 0 && moved_as_[node] >= 0; };
      if (std::none_of(v.begin(), v.end(), has_moved)) continue;
      for (int node : v) {
        if (node < 0 || seen_node_[node] == run_) continue;
        seen_node_[node] = run_;
        add_node(node);
      }
    }
    for (int node : nodes_) moved_as_[node] = -1;
  }

  Front& front_;
  RegionMesh& mesh_;
  std::vector<int> nodes_, elements_, next_;  // nodes to look at and the elements about them
  std::vector<MetricVec> sum_;                // per node: of its elements' wishes, then where it was
  std::vector<Vec2> last_;                    // per node: its last step in the chart
  std::vector<float> scale_;                  // per node: of the mesh there at the start
  std::vector<Vec2> old_;                     // per entry of nodes_: where it was in the chart
  std::vector<int> moved_as_;                 // per node: its entry of nodes_ when it moved in this sweep, or -1
  std::vector<int> seen_, seen_node_;         // per element, per node: the sweep that listed it last
  std::vector<float> old_sj_, sj_;            // per element, at most good_jacobian
  std::vector<int> stack_;
  int run_ = 0;
};

}  // namespace

void sweep_nodes(Front& front, int sweeps, const Progress& progress) {
  Sweeper sweeper(front);
  for (int i = 0; i < sweeps; ++i) {
    progress.check();
    if (!sweeper.sweep()) break;
  }
}

}  // namespace paver
