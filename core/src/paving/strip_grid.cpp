// In: region. Out: its mesh.
// Rows laid from either long side of a narrow strip do not see the nodes of the other one, and may join it shifted.
// Steps: the loop's four corners; sides and their counts; width; nodes between the sides (Coons) in the chart.
#include "paving/strip_grid.h"

#include <algorithm>
#include <cmath>

#include "base/search/nearest_turn.h"

namespace paver {
namespace {

constexpr double least_corner = M_PI / 4, largest_corner = 3 * M_PI / 4;
constexpr double least_straight = 5 * M_PI / 6;  // up to as much beyond pi a side runs on
constexpr double narrow = 0.7;                   // of the target length
constexpr double widest = 1.4;                   // target lengths per element round a tube
constexpr double least_jacobian = 0.3;

/// Nothing where an element is not positive in the chart, or has a lesser scaled Jacobian.
std::optional<RegionMesh> sound(RegionMesh mesh, double least = least_jacobian) {
  const bool is_sound = std::all_of(mesh.elements.begin(), mesh.elements.end(), [&](const Element& quad) {
    return is_positive(mesh, quad) && has_jacobian(mesh, quad, least);
  });
  if (!is_sound) return std::nullopt;
  return mesh;
}

class Strip {
 public:
  explicit Strip(const Region& region) : region_(region), loop_(region.loops[0]) {}

  /// False where the loop has no four sides, or those opposite each other differ.
  bool find_sides() {
    std::vector<std::size_t> corners;
    for (std::size_t i = 0; i < loop_.size(); ++i) {
      const double angle = loop_[i].angle;
      if (angle >= least_corner && angle <= largest_corner)
        corners.push_back(i);
      else if (!(std::fabs(angle - M_PI) <= M_PI - least_straight))
        return false;
    }
    if (corners.size() != 4) return false;
    const auto count = [&](std::size_t k) {
      return static_cast<int>((corners[(k + 1) % 4] + loop_.size() - corners[k]) % loop_.size());
    };
    columns_ = count(0), rows_ = count(1);
    if (count(2) != columns_ || count(3) != rows_) return false;
    first_ = corners[0];
    if (rows_ > columns_) first_ = corners[1], std::swap(rows_, columns_);
    return true;
  }

  /// Or a tube, cut open along its periodic edge, that has nodes enough round it.
  bool is_narrow() const {
    if (is_along_columns()) return has_room(0, columns_, rows_);
    if (is_along_rows()) return has_room(columns_, rows_, columns_);
    double most = 0;
    for (int i = 0; i <= columns_; ++i) {
      const LoopNode &one = low(i), &other = high(i);
      most = std::max(most, norm(other.x - one.x) / std::min(one.h, other.h));
    }
    return most < narrow;
  }

  bool is_prism() const {
    FacingSides columns, rows;
    for (int i = 0; i <= columns_; ++i) columns.push_back({&low(i), &high(i)});
    for (int j = 0; j <= rows_; ++j) rows.push_back({&left(j), &right(j)});
    return are_sides_of_prism(region_, columns) || are_sides_of_prism(region_, rows);
  }

  /// Cut open along its periodic edge.
  bool is_tube() const { return is_along_columns() || is_along_rows(); }

  std::optional<RegionMesh> lay(double turn_weight, double least = least_jacobian) {
    std::vector<int> node(static_cast<std::size_t>(columns_ + 1) * static_cast<std::size_t>(rows_ + 1));
    auto number = [&](int i, int j) -> int& { return node[j * (columns_ + 1) + i]; };
    mesh_.turn_weight = turn_weight;
    mesh_.reserve(node.size());
    for (int j = 0; j <= rows_; ++j)
      for (int i = 0; i <= columns_; ++i) {
        const LoopNode* known = on_loop(i, j);
        number(i, j) = known ? add_node(region_, *known, mesh_) : add_node(region_, inside(i, j), mesh_);
      }
    for (int j = 0; j < rows_; ++j)
      for (int i = 0; i < columns_; ++i)
        mesh_.add_element({number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)});
    return sound(std::move(mesh_), least);
  }

  std::size_t elements() const { return static_cast<std::size_t>(rows_) * static_cast<std::size_t>(columns_); }

 private:
  bool is_along_columns() const {
    return is_along_edge(columns_, [&](int i) { return std::pair(&low(i), &high(i)); });
  }
  bool is_along_rows() const {
    return is_along_edge(rows_, [&](int j) { return std::pair(&left(j), &right(j)); });
  }

  /// Whether two sides of `count` intervals are the same ones.
  static bool is_along_edge(int count, auto&& pair_at) {
    for (int i = 0; i <= count; ++i)
      if (const auto [one, other] = pair_at(i); one->global < 0 || one->global != other->global) return false;
    return true;
  }

  /// Of a tube, by its area where that is known: along it from node `first` of the loop on, `round` elements about.
  bool has_room(int first, int along, int round) const {
    double length = 0;
    for (int i = first; i < first + along; ++i) length += norm(at(i + 1).x - at(i).x);
    return region_.own_area <= widest * region_.h * round * length;
  }

  /// Counted from the first corner.
  const LoopNode& at(int i) const { return loop_[(first_ + static_cast<std::size_t>(i)) % loop_.size()]; }
  const LoopNode& low(int i) const { return at(i); }
  const LoopNode& right(int j) const { return at(columns_ + j); }
  const LoopNode& high(int i) const { return at(2 * columns_ + rows_ - i); }
  const LoopNode& left(int j) const { return at(2 * (columns_ + rows_) - j); }

  const LoopNode* on_loop(int i, int j) const {
    if (j == 0) return &low(i);
    if (i == columns_) return &right(j);
    if (j == rows_) return &high(i);
    return i == 0 ? &left(j) : nullptr;
  }

  Vec2 inside(int i, int j) const {
    const double s = static_cast<double>(i) / columns_, t = static_cast<double>(j) / rows_;
    const Vec2 corners =
        (1 - t) * ((1 - s) * low(0).p + s * low(columns_).p) + t * ((1 - s) * high(0).p + s * high(columns_).p);
    return (1 - t) * low(i).p + t * high(i).p + (1 - s) * left(j).p + s * right(j).p - corners;
  }

  const Region& region_;
  const std::vector<LoopNode>& loop_;
  std::size_t first_ = 0;  // corner where the first long side begins
  int columns_ = 0, rows_ = 0;
  RegionMesh mesh_;
};

/// One row of quads between two loops of equally many nodes.
class Ring {
 public:
  explicit Ring(const Region& region) : one_(region.loops[0]), two_(region.loops[1]) {
    mesh_.turn_weight = region.size.turn_weight();
    for (const std::vector<LoopNode>* loop : {&one_, &two_})
      for (const LoopNode& node : *loop) add_node(region, node, mesh_);
    first_ = nearest_turn(one_.size(), [&](auto i, auto j) { return two_[j].x - one_[i].x; });
  }

  /// Nor does the surface turn by more than one element may.
  bool is_narrow(const Region& region) const {
    constexpr double most_turn = 1.6;  // of the limit
    for (std::size_t i = 0; i < one_.size(); ++i) {
      const LoopNode &a = one_[i], &b = two_[facing(i)];
      if (norm(b.x - a.x) >= narrow * std::min(region.target(a.p), region.target(b.p))) return false;
      const auto between = [&](double share) { return region.chart->between(a.p, b.p, share); };
      if (turn_along(region, between) > most_turn * region.turn_limit) return false;
    }
    return true;
  }

  std::optional<RegionMesh> lay() {
    const std::size_t n = one_.size();
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t next = (i + 1) % n;
      mesh_.add_element({static_cast<int>(i), static_cast<int>(next), static_cast<int>(n + facing(next)),
                         static_cast<int>(n + facing(i))});
    }
    return sound(std::move(mesh_));
  }

 private:
  std::size_t facing(std::size_t i) const { return (first_ + two_.size() - i) % two_.size(); }

  const std::vector<LoopNode>&one_, &two_;
  std::size_t first_ = 0;  // of two_: faces the first of one_
  RegionMesh mesh_;
};

std::optional<RegionMesh> lay_ring(const Region& region) {
  constexpr std::size_t most_nodes = 4096;  // turning tries all
  const std::size_t nodes = region.loops[0].size();
  if (nodes != region.loops[1].size() || nodes > most_nodes) return std::nullopt;
  Ring ring(region);
  return ring.is_narrow(region) ? ring.lay() : std::nullopt;
}

}  // namespace

std::optional<RegionMesh> lay_strip(const Region& region) {
  if (!region.fans.empty()) return std::nullopt;
  if (region.loops.size() == 2) return lay_ring(region);
  if (region.loops.size() != 1) return std::nullopt;
  Strip strip(region);
  if (!strip.find_sides() || !(strip.is_narrow() || strip.is_prism())) return std::nullopt;
  if (auto grid = strip.lay(region.size.turn_weight())) return grid;
  return strip.is_tube() || strip.is_prism() ? strip.lay(0) : std::nullopt;
}

std::optional<RegionMesh> lay_four_sided(const Region& region, std::size_t most_elements) {
  if (!region.fans.empty() || region.loops.size() != 1) return std::nullopt;
  Strip strip(region);
  if (!strip.find_sides() || strip.elements() > most_elements) return std::nullopt;
  return strip.lay(0, 0);
}

}  // namespace paver
