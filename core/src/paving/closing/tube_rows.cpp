// In: loops of a region, two sides of one of which are the same edge. Out: quads between these sides.
// Rows of the front would lose columns there, for the normals' table has lines too far apart to see the turn round a
// slim tube, and would close across it. Steps: the cut; stretches along it that have nothing but the cut beside them;
// columns, by a rim at an end or the turn; a row per interval of the cut.
#include "paving/closing/tube_rows.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace paver {
namespace {

constexpr double slim = 4;         // target lengths round it: the table has ten lines then
constexpr double off_line = 1e-6;  // of a cut's length: nodes of a rim lie so far from a line across
constexpr std::size_t fewest_rows = 2;

/// Of the region's loop `loop`: facets from `first` on run along the cut, and back from `second` on.
struct Cut {
  std::size_t loop = 0, first = 0, second = 0, count = 0;
};

/// Rows between two nodes of a cut.
struct Stretch {
  std::size_t first = 0, last = 0, columns = 0;
};

class TubeRows {
 public:
  TubeRows(const Region& region, RegionMesh& mesh, std::vector<std::vector<int>> loops)
      : region_(region), mesh_(mesh), loops_(std::move(loops)) {}

  std::vector<std::vector<int>> run() {
    const std::optional<Cut> cut = find_cut();
    if (cut && is_slim(*cut))
      if (const std::vector<Stretch> stretches = find_stretches(*cut); !stretches.empty()) lay(*cut, stretches);
    return std::move(loops_);
  }

 private:
  int at(std::size_t loop, std::size_t i) const { return loops_[loop][i % loops_[loop].size()]; }
  int near(const Cut& cut, std::size_t k) const { return at(cut.loop, cut.first + k); }
  int far(const Cut& cut, std::size_t k) const { return at(cut.loop, cut.second + cut.count - k); }

  /// The longest run of facets that come back elsewhere in the loop.
  std::optional<Cut> find_cut() const {
    for (std::size_t l = 0; l < loops_.size(); ++l) {
      const std::size_t n = loops_[l].size();
      std::map<std::pair<int, int>, std::size_t> facet_at;  // by nodes of the whole model
      auto global = [&](std::size_t i) { return mesh_.global[at(l, i)]; };
      for (std::size_t i = 0; i < n; ++i)
        if (global(i) >= 0 && global(i + 1) >= 0) facet_at[{global(i), global(i + 1)}] = i;
      auto back = [&](std::size_t i) -> std::optional<std::size_t> {
        const auto found = facet_at.find({global(i + 1), global(i)});
        return found != facet_at.end() ? std::optional(found->second) : std::nullopt;
      };
      Cut longest{l, 0, 0, 0};
      for (std::size_t i = 0; i < n; ++i) {
        if (!back(i) || back(i + n - 1) == (*back(i) + 1) % n) continue;
        std::size_t count = 1;
        while (count < n && back(i + count) == (*back(i) + n - count) % n) ++count;
        if (count > longest.count) longest = {l, i, (*back(i) + n + 1 - count) % n, count};
      }
      if (longest.count >= fewest_rows) return longest;
    }
    return std::nullopt;
  }

  /// Its two sides lie apart in the chart, across the way along it, and the way round is short.
  bool is_slim(const Cut& cut) {
    along_ = mesh_.p[near(cut, cut.count)] - mesh_.p[near(cut, 0)];
    length_ = norm(along_);
    if (!(length_ > 0)) return false;
    along_ = (1 / length_) * along_;
    origin_ = mesh_.p[near(cut, 0)];
    for (std::size_t k = 0; k <= cut.count; ++k) {
      const Vec2 across = mesh_.p[far(cut, k)] - mesh_.p[near(cut, k)];
      width_ = std::max(width_, norm(across));
      if (std::fabs(dot(across, along_)) > off_line * length_) return false;
      if (k > 0 && !(place(near(cut, k)) > place(near(cut, k - 1)))) return false;
    }
    return cross(along_, mesh_.p[far(cut, 0)] - mesh_.p[near(cut, 0)]) > 0 && width_ < slim * region_.h;
  }

  double place(int node) const { return place(mesh_.p[node]); }
  double place(Vec2 p) const { return dot(p - origin_, along_); }

  /// Where nothing but the cut lies beside it.
  std::vector<Stretch> find_stretches(const Cut& cut) const {
    const std::vector<double> others = places_of_others(cut);
    std::vector<Stretch> stretches;
    for (std::size_t i = 1; i < others.size(); ++i) {
      const std::size_t low = others[i - 1] <= off_line * length_ ? rim(cut, false) : 0,
                        high = others[i] >= (1 - off_line) * length_ ? rim(cut, true) : 0,
                        columns = low > 0    ? low
                                  : high > 0 ? high
                                             : columns_by_turn(region_);
      const double room = width_ / static_cast<double>(columns);
      Stretch stretch{cut.count, 0, columns};
      for (std::size_t k = 0; k <= cut.count; ++k) {
        const double here = place(near(cut, k));
        if (here < others[i - 1] + room && (k > 0 || low == 0)) continue;
        if (here > others[i] - room && (k < cut.count || high != columns)) continue;
        stretch.first = std::min(stretch.first, k), stretch.last = k;
      }
      if (stretch.last >= stretch.first + fewest_rows) stretches.push_back(stretch);
    }
    return stretches;
  }

  /// All nodes but the cut's, and its ends, rising.
  std::vector<double> places_of_others(const Cut& cut) const {
    std::vector<double> others{0, length_};
    for (std::size_t l = 0; l < loops_.size(); ++l)
      for (std::size_t i = 0, n = loops_[l].size(); i < n; ++i) {
        const bool is_of_cut = (i + n - cut.first) % n <= cut.count || (i + n - cut.second) % n <= cut.count;
        if (l != cut.loop || !is_of_cut) others.push_back(place(at(l, i)));
      }
    for (const Fan& fan : region_.fans)
      for (const LoopNode& node : fan.ring) others.push_back(place(node.p));
    std::ranges::sort(others);
    return others;
  }

  /// Intervals of the rim at an end of the cut, if it runs straight across; else 0.
  std::size_t rim(const Cut& cut, bool at_end) const {
    const std::vector<int> nodes = rim_nodes(cut, at_end);
    auto is_across = [&](int node) { return std::fabs(place(node) - (at_end ? length_ : 0)) <= off_line * length_; };
    return std::ranges::all_of(nodes, is_across) ? nodes.size() - 1 : 0;
  }

  std::vector<int> rim_nodes(const Cut& cut, bool at_end) const {
    return at_end ? chain(cut.loop, cut.first + cut.count, cut.second)
                  : chain(cut.loop, cut.second + cut.count, cut.first);
  }

  void lay(const Cut& cut, const std::vector<Stretch>& stretches) {
    std::vector<std::vector<int>> rests;
    // What is left lies between two lines from one side of the cut to the other: `low` comes, `high` goes.
    auto add_rest = [&](std::size_t from, std::size_t to, std::vector<int> low, const std::vector<int>& high) {
      if (from == to) return;
      for (std::size_t k = from + 1; k < to; ++k) low.push_back(near(cut, k));
      low.insert(low.end(), high.begin(), high.end());
      for (std::size_t k = to - 1; k > from; --k) low.push_back(far(cut, k));
      rests.push_back(std::move(low));
    };
    std::vector<int> low = rim_nodes(cut, false);
    std::size_t from = 0;
    for (const auto& [first, last, columns] : stretches) {
      std::vector<int> row = row_at(cut, first, columns);
      add_rest(from, first, low, row);
      for (std::size_t k = first + 1; k <= last; ++k) {
        std::vector<int> next = row_at(cut, k, columns);
        for (std::size_t j = 0; j < columns; ++j) mesh_.add_element({row[j], next[j], next[j + 1], row[j + 1]});
        row = std::move(next);
      }
      low.assign(row.rbegin(), row.rend()), from = last;
    }
    add_rest(from, cut.count, low, rim_nodes(cut, true));
    loops_.erase(loops_.begin() + static_cast<std::ptrdiff_t>(cut.loop));
    loops_.insert(loops_.end(), rests.begin(), rests.end());
  }

  /// The loop's nodes from one to another.
  std::vector<int> chain(std::size_t loop, std::size_t from, std::size_t to) const {
    const std::size_t n = loops_[loop].size(), count = (to + 2 * n - from) % n;
    std::vector<int> nodes;
    for (std::size_t i = 0; i <= count; ++i) nodes.push_back(at(loop, from + i));
    return nodes;
  }

  /// From one side of the cut to the other; at its ends the rim, if it has as many.
  std::vector<int> row_at(const Cut& cut, std::size_t k, std::size_t columns) {
    if (const bool at_end = k == cut.count; (k == 0 || at_end) && rim(cut, at_end) == columns) {
      std::vector<int> nodes = rim_nodes(cut, at_end);
      if (!at_end) std::ranges::reverse(nodes);
      return nodes;
    }
    std::vector<int> nodes{near(cut, k)};
    for (std::size_t j = 1; j < columns; ++j) {
      const double share = static_cast<double>(j) / static_cast<double>(columns);
      const Vec2 p = (1 - share) * mesh_.p[near(cut, k)] + share * mesh_.p[far(cut, k)];
      nodes.push_back(add_node(region_, p, mesh_));
    }
    nodes.push_back(far(cut, k));
    return nodes;
  }

  const Region& region_;
  RegionMesh& mesh_;
  std::vector<std::vector<int>> loops_;
  Vec2 origin_, along_;  // in the chart
  double length_ = 0, width_ = 0;
};

}  // namespace

std::size_t columns_by_turn(const Region& region) {
  constexpr double full = 2 * M_PI, slack = 1e-3;
  const auto least = static_cast<std::size_t>(std::ceil(full / region.turn_limit - slack));
  return std::max<std::size_t>(least + least % 2, 4);
}

std::vector<std::vector<int>> lay_tube_rows(const Region& region, RegionMesh& mesh,
                                            std::vector<std::vector<int>> loops) {
  return TubeRows(region, mesh, std::move(loops)).run();
}

}  // namespace paver
