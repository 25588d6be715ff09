// Edits of a finished mesh that can be taken back, and the energy that says
// whether they were worth it.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_set>
#include <vector>

#include "paving/front/front.h"

namespace paver {

/// One change of connectivity: elements to remove, elements to make. Corners
/// equal to `RegionMesh::node_count()` and above stand for the nodes to add, in
/// the order of `fresh`.
struct Change {
  std::vector<int> gone;
  std::vector<Corners> made;
  std::vector<Vec2> fresh;  ///< chart places of new nodes
  int moved = -1;           ///< a free node that takes a new place, or -1
  Vec2 place;
  void clear() { gone.clear(), made.clear(), fresh.clear(), moved = -1; }
};

/// What the elements about an edit must reach.
struct Demand {
  double gain = 0;         ///< change of energy: lengths may become worse by as much as
                           ///< it is worth
  double jacobian = 0.45;  ///< least scaled Jacobian
  double shortest = 0.55;  ///< least edge length by the target length
  double rise = 0;         ///< by how much the worst scaled Jacobian must rise, or 0
  double fall = 0;         ///< by how much energy and spread together must fall
  double longest = 1.6;    ///< largest edge length by the target length
};

/// Journal over the mesh of a front that has no void left. The energy of a node
/// is the square of its number of elements less the ideal number: 4 inside, by
/// the angle on the border; every triangle costs `triangle_energy`.
class MeshEdit {
 public:
  static constexpr double triangle_energy = 3;
  static constexpr double fine_spread_price = 4.2, skew_price = 3.5;
  /// Energy that one unit of spread is worth: the sum of ((r - 1/r) / 2)^2 over the sides of elements, r their length
  /// by the target length; a side far off counts no more than one at the border of hope: narrow strips stay regular.
  /// On coarse meshes (Region::evenness) it is worth more.
  const double spread_price;

  explicit MeshEdit(Front& front);

  RegionMesh& mesh() { return front_.mesh; }
  /// Node energy with `more` further elements.
  double energy(int node, int more = 0) const { return energy_of(mesh_.star[node].size() + more, aims_[node]); }
  /// What `more` further elements would add to the node's energy.
  double step(int node, int more) const { return energy(node, more) - energy(node); }
  /// Energy of a new node with that many elements.
  static double energy_of_new(int size) { return energy_of(size, {}); }
  bool is_irregular(int node) const { return mesh_.star[node].size() > 0 && energy(node) >= 1; }
  /// What the change would add to the energy.
  double energy_gain(const Change& change);
  /// Spread of the elements about those given, as they are: more a change of them cannot win.
  double spread_about(std::span<const int> elements);
  /// Spread of one side by its length over the target length: twice as long is as bad as half as long.
  static double spread(double ratio) {
    double off = 0.5 * (ratio - 1 / ratio);
    return std::min(off * off, hopeless);
  }
  /// Whether the side between two nodes is one of the boundary, which no edit changes.
  bool is_border(int a, int b) const {
    return mesh_.is_fixed[a] && mesh_.is_fixed[b] && border_.contains(side_key(a, b));
  }
  double spread_of(int e) { return measured(e, mesh_.elements[e]).spread; }
  /// Area of an element in squares of its target length.
  double area(int e) { return measured(e, mesh_.elements[e]).area; }
  /// To be called where nodes were moved by others.
  void forget_measures() { measures_ = std::vector<Measure>(); }
  /// Carries the change out. False, and nothing done, when an element would
  /// have a node twice, an edge more than two elements, a free node fewer than
  /// three, or two nodes on the same boundary node would meet.
  bool apply(const Change& change);
  /// Moves free nodes about the edits, then tells whether all elements there
  /// are positive in the chart and shape and lengths are as demanded or, where
  /// that is less, no worse than before.
  bool settle(const Demand& demand);

  std::size_t mark() const { return journal_.size(); }
  void roll_back(std::size_t mark);
  /// Keeps all edits; the journal starts anew.
  void commit();
  /// Nodes of all elements made or removed since the last commit.
  const std::vector<int>& touched() const { return touched_; }

 private:
  enum class Kind : char { made, gone, node, move, place };
  struct Entry {
    Kind kind;
    int id;
    Element element;
    NodePlace place;
  };
  struct Aim {
    float ideal = 4;       // number of elements
    int least = 3;         // that no corner is nearly straight
    bool is_kept = false;  // laid as it is to stay, as are the elements about it
  };
  static double energy_of(int size, Aim aim) {
    if (size == 0) return 0;
    double off = size - aim.ideal;
    return off * off + (size < aim.least ? degenerate_energy * (aim.least - size) : 0);
  }
  static constexpr double degenerate_energy = 8;
  static constexpr double hopeless = 0.3;  // spread of a side that counts no more however far off it is
  struct Measure {
    float jacobian = 2, shortest = 1, longest = 1, spread = 0;  // lengths by the target length
    float skew = 0;                                             // sum of 1 - scaled Jacobian
    float area = 0;
    void add(const Measure& m) {
      jacobian = std::min(jacobian, m.jacobian);
      shortest = std::min(shortest, m.shortest), longest = std::max(longest, m.longest);
      spread += m.spread, skew += m.skew;
    }
  };
  static std::uint64_t side_key(int a, int b) {
    return static_cast<std::uint64_t>(std::min(a, b)) << 32 | static_cast<std::uint32_t>(std::max(a, b));
  }
  void find_border();
  double target_between(int node, std::size_t count) const;
  bool has_shared_edges(int node) const;
  void move(int node, Vec2 p, bool is_first);
  void touch(int node);
  void forget_touched();
  void smooth_touched(bool is_first);
  void collect_near();
  void measure(const Element& e, Measure& worst) const;
  void measure_lengths(const Element& e, Measure& worst) const;
  bool is_promising(const Demand& demand, const Measure& before) const;
  const Measure& measured(int id, const Element& e);
  Measure measure_before();

  Front& front_;
  RegionMesh& mesh_;
  std::vector<Aim> aims_;                     // of all nodes and more
  std::unordered_set<std::uint64_t> border_;  // sides
  std::vector<Entry> journal_;
  std::vector<int> touched_, near_, list_;
  std::vector<MetricVec> sum_;  // of the steps its elements wish, per entry of touched_
  std::vector<int> delta_;
  std::vector<int> slot_;          // per node: its entry of touched_, or -1
  std::vector<Measure> measures_;  // per element, as at the last commit; Jacobian 2: to be measured
  std::vector<int> stamp_;
  int run_ = 0;
  mutable std::vector<int> after_, before_;
  int old_elements_ = 0;  // number of elements at the last commit
};

}  // namespace paver
