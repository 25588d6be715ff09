// The paving loop: close small loops, choose a row, lay it, smooth it, close seams; until no void is left.
#include "paving/fill_void.h"

#include <algorithm>

#include "paving/closing/close_loop.h"
#include "paving/rows/row.h"
#include "paving/rows/seam.h"
#include "paving/smoothing/smooth_nodes.h"

namespace paver {
namespace {

class VoidFiller {
 public:
  VoidFiller(Front& front, const Progress& progress) : region_(front.region), front_(front), progress_(progress) {}

  void run() {
    make_even();
    budget_ = static_cast<long>(front_.mesh.elements.size()) + most_elements();
    while (collect_open_loops()) {
      bool is_changed = false;
      for (int f : open_)
        if (front_.facets[f].is_alive && advance(f)) is_changed = true;
      check_budget();
      if (!is_changed) close_smallest();
    }
  }

 private:
  // More than any sound run adds: rows before short facets, and the area in the least squares that curvature, or a
  // length given for a part of the face, asks for. On all models at hand paving adds a quarter of it at most.
  long most_elements() const {
    constexpr double shortest = 0.02;  // of the target length: what gradation is taken to reach at most
    constexpr double of_area = 8, most_by_area = 1e12;
    constexpr long at_least = 10000, per_facet = 100;
    double least = std::min(region_.h, region_.size.least());
    if (region_.size.is_graded())
      for (double h : front_.mesh.h) least = std::min(least, std::max(h, shortest * region_.h));
    return at_least + per_facet * static_cast<long>(front_.facets.size()) +
           static_cast<long>(std::min(of_area * region_.area / (least * least), most_by_area));
  }

  void check_budget() const {
    if (static_cast<long>(front_.mesh.elements.size()) <= budget_) return;
    const Vec3 x = front_.mesh.x[front_.facets[open_.back()].a];
    throw Error(ErrorCode::face_failed,
                "paving makes many times the elements that its area asks for and would not end; repair the face in the "
                "CAD model or use another size",
                {"paving", region_.face, -1, x});
  }

  // Odd loops get their one triangle, then all loops are coloured. A triangle may join its loop with another that has
  // nodes in common with it, so a loop is known by its first facet that is left.
  void make_even() {
    std::vector<char> is_done(front_.facets.size(), 0);
    for (std::size_t first = 0; first < is_done.size(); ++first) {
      int f = static_cast<int>(first);
      if (is_done[first] || !front_.facets[f].is_alive) continue;
      front_.collect_loop(f, loop_);
      if (loop_.size() % 2 == 1) {
        const std::vector<int> loop = loop_;
        insert_triangle(front_, loop);
        // One of the loop's own facets is left, or the one just made; none where it was filled.
        auto left = std::find_if(loop.begin(), loop.end(), [&](int g) { return front_.facets[g].is_alive; });
        f = left != loop.end() ? *left : front_.newest_facet();
        if (f < 0 || !front_.facets[f].is_alive) continue;
        front_.collect_loop(f, loop_);
      }
      for (int g : loop_)
        if (static_cast<std::size_t>(g) < is_done.size()) is_done[g] = 1;
      front_.colour_loop(f);
    }
  }

  // One facet of each loop, smallest loops first.
  bool collect_open_loops() {
    progress_.check();
    // Only facets alive at the last call and those made since: most of the array is dead before long.
    for (int n = static_cast<int>(front_.facets.size()); known_ < n; ++known_) alive_.push_back(known_);
    std::erase_if(alive_, [&](int f) { return !front_.facets[f].is_alive; });
    seen_.resize(front_.facets.size(), 0);
    ++call_;
    std::vector<std::pair<int, int>> found;
    for (int f : alive_) {
      if (seen_[f] == call_) continue;
      int size = 0;
      front_.each_of_loop(f, [&](int g) { seen_[g] = call_, ++size; });
      found.push_back({size, f});
    }
    std::stable_sort(found.begin(), found.end(), [](auto p, auto q) { return p.first < q.first; });
    open_.clear();
    for (auto [size, f] : found) open_.push_back(f);
    return !open_.empty();
  }

  // One step for f's loop; false when nothing could be done.
  bool advance(int f) {
    front_.collect_loop(f, loop_);
    if (loop_.size() <= 8 && close_loop(front_, loop_)) return true;
    near_.clear(), angles_.clear();
    for (int g : loop_) {
      angles_.push_back(front_.angle_after(g));
      if (wants_seam(front_, g, angles_.back())) near_.push_back(front_.facets[g].b);
    }
    if (close_seams(front_, near_)) return true;
    bool is_changed = false;
    std::vector<Row> rows = find_rows(front_, loop_, angles_);
    for (Row& row : rows) {
      if (is_changed && !row.is_low) continue;
      if (!keep_living(row)) continue;
      fresh_.clear();
      if (lay_row(front_, row, fresh_) == 0) continue;
      is_changed = true;
      settle();
    }
    return is_changed;
  }

  // Rows laid before in the pass may have used up the facets at the row's ends. What is left is a row when it still
  // runs from end to end.
  bool keep_living(Row& row) const {
    auto is_dead = [&](int g) { return !front_.facets[g].is_alive; };
    std::vector<int>& all = row.facets;
    if (!row.has_ends) return std::none_of(all.begin(), all.end(), is_dead);
    all.erase(all.begin(), std::find_if_not(all.begin(), all.end(), is_dead));
    while (!all.empty() && is_dead(all.back())) all.pop_back();
    if (all.empty() || std::any_of(all.begin(), all.end(), is_dead)) return false;
    auto is_end = [&](int g) { return classify(front_, front_.facets[g].b, front_.angle_after(g)) == NodeState::end; };
    return is_end(front_.facets[all.front()].prev) && is_end(all.back());
  }

  // After a row: smooth its nodes and those it stands on, then close what became sharp.
  void settle() {
    RegionMesh& mesh = front_.mesh;
    near_ = fresh_;
    std::size_t count = near_.size();
    for (std::size_t i = 0; i < count; ++i)
      for (int e : mesh.star[near_[i]])
        for (int v : mesh.elements[e].nodes())
          if (!mesh.is_fixed[v]) near_.push_back(v);
    std::sort(near_.begin(), near_.end());
    near_.erase(std::unique(near_.begin(), near_.end()), near_.end());
    smooth_nodes(front_, near_);
    near_.clear();
    for (int node : fresh_) {
      near_.push_back(node);
      int out = front_.facet_from(node);
      if (out < 0) continue;
      near_.push_back(front_.facets[out].b);
      near_.push_back(front_.facets[front_.facets[out].prev].a);
    }
    std::sort(near_.begin(), near_.end());
    near_.erase(std::unique(near_.begin(), near_.end()), near_.end());
    close_seams(front_, near_);
  }

  // Nothing moves any more: the smallest loop is closed as it is.
  void close_smallest() {
    auto alive = std::find_if(open_.begin(), open_.end(), [&](int f) { return front_.facets[f].is_alive; });
    if (alive != open_.end()) close_by_triangulation(front_, *alive);
  }

  const Region& region_;
  Front& front_;
  const Progress& progress_;
  std::vector<int> open_, loop_, fresh_, near_;
  std::vector<double> angles_;  // of the void at the ends of loop_
  std::vector<int> alive_;      // facets, ascending
  std::vector<int> seen_;       // per facet: the call of collect_open_loops() that came by last
  int known_ = 0, call_ = 0;
  long budget_ = 0;
};

}  // namespace

void fill_void(Front& front, const Progress& progress) { VoidFiller(front, progress).run(); }

}  // namespace paver
