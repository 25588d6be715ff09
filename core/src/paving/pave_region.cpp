// The paving loop: close small loops, choose a row, lay it, smooth it, close seams; until no void is left.
#include "paving/pave_region.h"

#include <algorithm>
#include <span>

#include "mesh/flat_elements.h"
#include "paving/cleanup.h"
#include "paving/cleanup_chords.h"
#include "paving/close_loop.h"
#include "paving/faults.h"
#include "paving/row.h"
#include "paving/seam.h"
#include "paving/smooth.h"
#include "regions/disc_grid.h"

namespace paver {
namespace {

class RegionPaver {
 public:
  RegionPaver(const Region& region, RegionMesh& mesh, const Progress& progress)
      : region_(region), front_(region, mesh), progress_(progress) {}

  PavingCounts run(double sharpest_tip) {
    if (auto crossing = front_.start(sharpest_tip)) {
      const Vec3 x = front_.mesh.x[front_.facets[crossing->facet].a];
      throw Error(ErrorCode::face_failed,
                  "its boundary, divided at this target length, crosses or touches itself; use a smaller size",
                  {"paving", region_.face, -1, x});
    }
    make_even();
    budget_ = most_elements();
    while (collect_open_loops()) {
      bool is_changed = false;
      for (int f : open_)
        if (front_.facets[f].is_alive && advance(f)) is_changed = true;
      bool is_over = static_cast<long>(front_.mesh.elements.size()) > budget_;
      if (!is_changed || is_over) close_smallest(is_over);
    }
    return front_.counts;
  }

  Front& front() { return front_; }

 private:
  // More than any sound run needs: paving ends even where it would go on for ever.
  long most_elements() const {
    double least = std::min(region_.h, region_.size.least());
    for (double h : front_.mesh.h) least = std::min(least, std::max(h, 0.02 * region_.h));
    return 1000 + 40 * static_cast<long>(front_.facets.size()) +
           static_cast<long>(std::min(8 * region_.area / (least * least), 1e12));
  }

  // Odd loops get their one triangle, then all loops are coloured.
  void make_even() {
    for (int f : front_.start_loops) {
      front_.collect_loop(f, loop_, 1 << 30);
      if (loop_.size() % 2 == 1) {
        const std::vector<int> loop = loop_;
        insert_triangle(front_, loop);
        // One of the loop's own facets is left, or the one just made; none where it was filled.
        auto left = std::find_if(loop.begin(), loop.end(), [&](int g) { return front_.facets[g].is_alive; });
        f = left != loop.end() ? *left : front_.newest_facet();
      }
      if (f >= 0 && front_.facets[f].is_alive) front_.colour_loop(f);
    }
  }

  // One facet of each loop, smallest loops first.
  bool collect_open_loops() {
    progress_.check();
    std::vector<std::pair<int, int>> found;
    seen_.assign(front_.facets.size(), false);
    for (std::size_t i = alive_from_; i < front_.facets.size(); ++i) {
      int f = static_cast<int>(i);
      if (!front_.facets[f].is_alive) {
        if (i == alive_from_) ++alive_from_;
        continue;
      }
      if (seen_[i]) continue;
      int size = 0, g = f;
      do {
        seen_[g] = true;
        ++size;
        g = front_.facets[g].next;
      } while (g != f);
      found.push_back({size, f});
    }
    std::stable_sort(found.begin(), found.end(), [](auto p, auto q) { return p.first < q.first; });
    open_.clear();
    for (auto [size, f] : found) open_.push_back(f);
    return !open_.empty();
  }

  // One step for f's loop; false when nothing could be done.
  bool advance(int f) {
    front_.collect_loop(f, loop_, 1 << 30);
    if (loop_.size() <= 8 && close_loop(front_, loop_)) return true;
    near_.clear();
    for (int g : loop_) near_.push_back(front_.facets[g].b);
    if (close_seams(front_, near_)) return true;
    bool is_changed = false;
    std::vector<Row> rows = find_rows(front_, loop_);
    for (const Row& row : rows) {
      if (is_changed && row.level > rows[0].level) break;
      if (!is_untouched(row)) continue;
      fresh_.clear();
      if (lay_row(front_, row, fresh_) == 0) continue;
      is_changed = true;
      settle();
    }
    return is_changed;
  }

  bool is_untouched(const Row& row) const {
    for (int g : row.facets)
      if (!front_.facets[g].is_alive) return false;
    if (!row.has_ends) return true;
    int first = row.facets.front(), last = row.facets.back();
    auto is_end = [&](int g) { return classify(front_, front_.facets[g].b, front_.angle_after(g)) == NodeState::end; };
    return is_end(front_.facets[first].prev) && is_end(last);
  }

  // After a row: smooth its nodes and those it stands on, then close what became sharp.
  void settle() {
    RegionMesh& mesh = front_.mesh;
    near_ = fresh_;
    std::size_t count = near_.size();
    for (std::size_t i = 0; i < count; ++i)
      for (int e : mesh.star[near_[i]])
        for (int v : mesh.elements[e].v)
          if (v >= 0 && !mesh.is_fixed[v]) near_.push_back(v);
    std::sort(near_.begin(), near_.end());
    near_.erase(std::unique(near_.begin(), near_.end()), near_.end());
    smooth_nodes(front_, near_, 2);
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

  // Nothing moves any more: the smallest loop (or all, when far too many elements were made) is closed as it is.
  void close_smallest(bool all) {
    for (int f : open_) {
      if (!front_.facets[f].is_alive) continue;
      close_by_triangulation(front_, f);
      if (!all) return;
    }
  }

  const Region& region_;
  Front front_;
  const Progress& progress_;
  std::vector<int> open_, loop_, fresh_, near_;
  std::vector<bool> seen_;
  std::size_t alive_from_ = 0;
  long budget_ = 0;
};

}  // namespace

std::optional<std::array<int, 2>> find_crossing(const Region& region) {
  if (region.laid) return std::nullopt;
  RegionMesh mesh;
  Front front(region, mesh);
  auto crossing = front.start();
  if (!crossing) return std::nullopt;
  std::vector<int> edge_of_facet;
  for (const auto& loop : region.loops)
    for (const LoopNode& node : loop) edge_of_facet.push_back(node.edge);
  auto edge = [&](int f) { return f >= 0 && f < static_cast<int>(edge_of_facet.size()) ? edge_of_facet[f] : -1; };
  return std::array<int, 2>{edge(crossing->facet), edge(crossing->other)};
}

namespace {

/// One way of paving: smaller elements resolve what turned out too coarse, the other rule for rows takes other ways.
struct Attempt {
  double size;
  double misfit_weight;
};
constexpr Attempt attempts[] = {{1, 1}, {1, 0}, {0.5, 1}, {0.25, 1}};
// Where no triangle is wanted: a slightly other size already takes other ways.
constexpr Attempt all_quad_attempts[] = {{1, 1}, {1, 0}, {0.95, 1}, {1.05, 1}, {0.9, 1}, {0.8, 1}, {0.5, 1}, {0.25, 1}};
constexpr double sharpest_tip = 6 * M_PI / 180;  // sharper corners take a triangle, unless none is wanted
constexpr double few_flat = 0.01;                // of the elements: not worth four times as many

Region scaled(const Region& region, double size) {
  Region finer = region;
  finer.size = region.size.scaled(size);
  finer.h *= size;
  for (auto& loop : finer.loops)
    for (LoopNode& node : loop) node.h *= size;
  return finer;
}

PavedRegion pave_once(const Region& region, const Attempt& attempt, const Progress& progress, Elements elements) {
  PavedRegion paved;
  RegionPaver paver(region, paved.mesh, progress);
  paver.front().misfit_weight = attempt.misfit_weight;
  paved.counts = paver.run(elements == Elements::all_quad ? 0 : sharpest_tip);
  clean_up(paver.front(), progress, elements == Elements::all_quad);
  remove_chords(paver.front());
  return paved;
}

}  // namespace

const int further_attempts = static_cast<int>(std::size(attempts)) - 1;

namespace {

PavedRegion pave_in_way(const Region& region, const Attempt& way, const Progress& progress, Elements elements) {
  return pave_once(way.size == 1 ? region : scaled(region, way.size), way, progress, elements);
}

/// Pairs of triangles that clean-up could not join; an odd one is what the region's boundary asks for.
long pairs_left(const RegionMesh& mesh) {
  return std::count_if(mesh.elements.begin(), mesh.elements.end(),
                       [](const Element& e) { return e.is_alive() && e.corners() == 3; }) /
         2;
}

PavedRegion finish(PavedRegion paved, Elements elements) {
  mend_flat_elements(paved.mesh, elements != Elements::all_quad);
  if (elements == Elements::all_triangle) split_all_quads(paved.mesh);
  return paved;
}

}  // namespace

PavedRegion pave_region_again(const Region& region, int attempt, const Progress& progress, Elements elements) {
  return finish(pave_in_way(region, attempts[attempt], progress, elements), elements);
}

PavedRegion pave_region(const Region& region, const Progress& progress, Elements elements) {
  auto as_laid = [&](RegionMesh mesh) {
    if (elements == Elements::all_triangle) split_all_quads(mesh);
    return PavedRegion{std::move(mesh), {}};
  };
  if (region.laid) return as_laid(*region.laid);
  if (auto disc = lay_disc(region, progress)) return as_laid(std::move(*disc));
  PavedRegion best;
  Faults fewest{1, 0};
  long pairs = 0;
  const bool all_quad = elements == Elements::all_quad;
  for (const Attempt& way : all_quad ? std::span<const Attempt>(all_quad_attempts) : attempts) {
    bool is_good_enough =
        fewest.off_surface + pairs == 0 && fewest.flat <= few_flat * static_cast<double>(best.mesh.elements.size());
    bool is_first = best.mesh.elements.empty();
    if (!is_first && (fewest.sum() + pairs == 0 || (way.size != 1 && is_good_enough))) break;
    PavedRegion paved = pave_in_way(region, way, progress, elements);
    Faults faults = count_faults(paved.mesh);
    long left = all_quad ? pairs_left(paved.mesh) : 0;
    if (!is_first && faults.sum() + left >= fewest.sum() + pairs) continue;
    best = std::move(paved), fewest = faults, pairs = left;
  }
  return finish(std::move(best), elements);
}

}  // namespace paver
