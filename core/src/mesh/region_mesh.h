// Nodes and elements of one region while it is paved, smoothed and cleaned up.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <vector>

#include "mesh/metric_vec.h"

namespace paver {

/// Up to four corner nodes, counter-clockwise in the chart. A triangle's last one is -1.
using Corners = std::array<int, 4>;

struct Element {
  Corners v{-1, -1, -1, -1};
  bool is_alive() const { return v[0] >= 0; }
  int corners() const { return v[3] < 0 ? 3 : 4; }
  /// None of one that is gone.
  std::span<const int> nodes() const { return {v.data(), static_cast<std::size_t>(is_alive() ? corners() : 0)}; }
  int corner_of(int node) const {
    for (int i = 0; i < 4; ++i)
      if (v[i] == node) return i;
    return -1;
  }
  int after(int node) const {
    const int k = corner_of(node) + 1;
    return v[k < corners() ? k : 0];
  }
  int before(int node) const {
    const int k = corner_of(node);
    return v[(k > 0 ? k : corners()) - 1];
  }
};

/// Elements about one node, unordered; in place as long as they are few, which is nearly always.
class Star {
 public:
  Star() = default;
  Star(const Star& from)
      : size_(from.size_),
        near_(from.near_),
        far_(from.far_ ? std::make_unique<std::vector<int>>(*from.far_) : nullptr) {}
  Star(Star&&) noexcept = default;
  Star& operator=(const Star& from) {
    if (this != &from) *this = Star(from);
    return *this;
  }
  Star& operator=(Star&&) noexcept = default;
  ~Star() = default;
  int size() const { return size_; }
  const int* begin() const { return size_ <= few ? near_.data() : far_->data(); }
  const int* end() const { return begin() + size_; }
  void add(int e) {
    if (size_ == few) far_ = std::make_unique<std::vector<int>>(near_.begin(), near_.end());
    if (size_ >= few)
      far_->push_back(e);
    else
      near_[size_] = e;
    ++size_;
  }
  void remove(int e) {
    int* first = size_ <= few ? near_.data() : far_->data();
    int* at = std::find(first, first + size_, e);
    if (at == first + size_) return;
    *at = first[--size_];
    if (size_ < few) return;
    far_->pop_back();
    if (size_ == few) {
      std::copy(far_->begin(), far_->end(), near_.begin());
      far_.reset();
    }
  }

 private:
  static constexpr int few = 5;  // 32 bytes: two stars a cache line
  int size_ = 0;
  std::array<int, few> near_{};
  std::unique_ptr<std::vector<int>> far_;
};

/// Where one node is, with the derivatives there.
struct NodePlace {
  Vec2 p;
  Vec3 x, xp, xq;
  Vec3 n{}, np{}, nq{};  ///< the surface's normal and its derivatives; zero where turns do not count
  float drift = 0;
};

/// A node's normal, by which lengths count turns.
struct NodeTurn {
  Vec3 n, np, nq;
};

/// Struct of arrays, one entry per node; elements are edited only through the members below.
struct RegionMesh {
  std::vector<Vec2> p;         ///< chart coordinates
  std::vector<Vec3> x;         ///< position, mm
  std::vector<Vec3> xp, xq;    ///< derivatives of the position by the chart coordinates
  std::vector<float> drift;    ///< how far the node slid since x was last evaluated, by the scale there
  double turn_weight = 0;      ///< what a radian counts, in target lengths: 1 / turn limit, or 0
  std::vector<NodeTurn> turn;  ///< empty where turns do not count
  std::vector<double> h;       ///< target length, mm
  std::vector<char> is_fixed;  ///< boundary nodes and hard points never move
  std::vector<int> global;     ///< boundary stage's node, or -1
  std::vector<Star> star;
  std::vector<Element> elements;

  bool has_turns() const { return turn_weight > 0; }
  NodePlace place(int node) const;
  void put(int node, const NodePlace& at);

  /// Makes room for so many nodes and as many elements.
  void reserve(std::size_t count);
  int node_count() const { return static_cast<int>(p.size()); }
  /// Without those that are taken out.
  long living_elements() const;
  long triangle_count() const;
  /// Takes back the node added last; no element may use it.
  void drop_last_node();
  int add_node(const NodePlace& at, double target);
  /// On a surface whose turns do not count.
  int add_node(Vec2 chart, Vec3 position, Vec3 tangent_p, Vec3 tangent_q, double target) {
    return add_node(NodePlace{chart, position, tangent_p, tangent_q}, target);
  }
  /// The new element's number.
  int add_element(const Corners& corners);
  void remove_element(int e);
  /// Takes back its removal.
  void restore_element(int e, const Corners& corners);
  /// Makes the stars anew from the elements.
  void find_stars();
  void replace_node(int e, int from, int to);
  /// The element on the other side of a side from a to b, which has it from b to a; -1 where there is none.
  int across(int a, int b) const {
    for (int e : star[a])
      if (elements[e].before(a) == b) return e;
    return -1;
  }
  /// Whether an element has a side between two nodes.
  bool has_side(int a, int b) const { return across(a, b) >= 0 || across(b, a) >= 0; }
  /// Scale of the mesh at a node: its target length or, where that is shorter, its shortest side.
  double scale_at(int node) const;
  Vec3 normal(int node) const { return unit(cross(xp[node], xq[node])); }

  /// From one node to another as lengths count it.
  MetricVec between(int a, int b) const { return step(point(a), point(b), 0.5 * (h[a] + h[b])); }
  /// The same from a node to a place.
  MetricVec between(int a, const NodePlace& b) const { return step(point(a), {b.x, b.n}, h[a]); }
  /// From one point with its normal to another, where the target length is `target`.
  MetricVec step(const MetricVec& from, const MetricVec& to, double target) const {
    MetricVec way{to.x - from.x, {}};
    if (has_turns() && !(from.n == Vec3{}) && !(to.n == Vec3{})) way.n = (turn_weight * target) * (to.n - from.n);
    return way;
  }
  double length(int a, int b) const { return norm(between(a, b)); }
  /// By the mean target length of both.
  double relative_length(int a, int b) const { return length(a, b) / (0.5 * (h[a] + h[b])); }
  /// Point and normal of a node.
  MetricVec point(int node) const { return {x[node], has_turns() ? turn[node].n : Vec3{}}; }
  MetricVec tangent_p(int node) const {
    return {xp[node], has_turns() ? (turn_weight * h[node]) * turn[node].np : Vec3{}};
  }
  MetricVec tangent_q(int node) const {
    return {xq[node], has_turns() ? (turn_weight * h[node]) * turn[node].nq : Vec3{}};
  }
  /// Tangent vector of a chart displacement.
  MetricVec push(int node, Vec2 by) const { return by.x * tangent_p(node) + by.y * tangent_q(node); }
  /// Chart displacement whose image is the tangent vector v at `node`.
  Vec2 pull_back(int node, const MetricVec& v) const;
  /// Plane of the tangents at `node`, counter-clockwise as the chart.
  MetricFrame frame(int node) const { return {tangent_p(node), tangent_q(node)}; }
};

/// Whether an element does not face away from the surface, as far as it has two fixed corners: a chart that bends
/// straight lines has room between a chord of the boundary and its curve, where there is no surface.
bool faces_surface(const RegionMesh& mesh, const Element& e);

/// Whether all corners turn left in the chart.
bool turns_left(const RegionMesh& mesh, const Element& e);

/// Whether it turns left and faces the surface.
bool is_positive(const RegionMesh& mesh, const Element& e);
/// Of a mesh from which no element was removed.
bool are_all_positive(const RegionMesh& mesh);

/// Whether two corners are one node, or one node of the boundary stage.
bool has_node_twice(const RegionMesh& mesh, const Element& e);

/// Whether the scaled Jacobian is at least `bound`, positive; takes no root.
bool has_jacobian(const RegionMesh& mesh, const Element& e, double bound);

/// Smallest corner value (e1 x e2).n / (|e1||e2|), n the element's own area vector; triangles times 2/sqrt 3. Without
/// the corners whose bits are set in `left_out`.
double scaled_jacobian(const RegionMesh& mesh, const Element& e, unsigned left_out = 0);
/// The same of an element that need not be in the mesh; -1 where it is not positive.
double positive_jacobian(const RegionMesh& mesh, const Corners& corners);
/// Smallest of the elements about a node; 2 where there are none.
double worst_about(const RegionMesh& mesh, int node);

}  // namespace paver
