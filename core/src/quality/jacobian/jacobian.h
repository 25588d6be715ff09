// Proof that curved elements do not fold, and their area.
#pragma once

#include <array>
#include <vector>

#include "paver/result.h"

namespace paver {

enum class ElementShape { quad, triangle };
enum class Validity { valid, invalid, undecided };

/// What is known of det(u, v) = (x_u x x_v) . n over one element, n its unit vector area.
struct JacobianBound {
  Validity validity = Validity::invalid;
  double ratio = 0;  ///< lower bound of det over its mean; 0 or less where not valid. 1: a parallelogram
};

/// The Jacobian determinant of Lagrange elements of one shape and order in Bernstein form, whose coefficients bound it:
/// degree 2p - 1 in each direction for quads, 2p - 2 for triangles. Doubtful elements are split until the sign is
/// certain, eight times at most. Source: [Johnen13], with the determinant taken against the element's own normal.
/// Const after construction and safe to use from many threads; no function allocates.
class JacobianForm {
 public:
  static constexpr int max_order = 4;
  static constexpr int max_nodes = (max_order + 1) * (max_order + 1);
  static constexpr int max_coefficients = 4 * max_order * max_order;

  /// Order 1 to 4. Gives the tables; use jacobian_form() to share them.
  JacobianForm(ElementShape shape, int order);

  int node_count() const { return nodes_; }

  /// `x`: node_count() nodes in Gmsh's order, mm. Proven positive or not; stops at the first certain sign.
  bool is_valid(const Vec3* x) const { return bound(x, 0).validity == Validity::valid; }

  /// The same with a lower bound, which is worked out more closely where it is below `enough`.
  JacobianBound bound(const Vec3* x, double enough = poor_ratio) const;

  static constexpr int lanes = 4;
  struct alignas(lanes * sizeof(double)) Lanes {  ///< one number of each of several elements
    double of[lanes];
  };
  struct LaneFigures {
    Lanes sj, area;
    Lanes low;  ///< least coefficient of det over its mean; where it is poor_ratio or more: the bound
  };
  /// Scaled Jacobian, area and lowest coefficient of several elements at once, bit for bit those of one alone.
  /// `x`: three per node: x, y, z.
  void measure_lanes(const Lanes* x, LaneFigures& figures) const;
  /// Of these the lowest coefficient alone: an element is valid where it is above flat_ratio.
  void bound_lanes(const Lanes* x, Lanes& low) const;

  static constexpr double poor_ratio = 0.5;   ///< lower bounds below it are worked out more closely
  static constexpr double flat_ratio = 1e-9;  ///< det over its mean; below, rounding may hide a fold

  /// Area of the curved element by Gauss quadrature with p + 2 points per direction, in units of x squared.
  double area(const Vec3* x) const;

 private:
  using Coefficients = std::array<double, max_coefficients>;
  struct Weight {  ///< control point `out` receives weight * (node `in` - node 0)
    int out, in;
    double weight;
  };
  struct Difference {  ///< a control point of x_u or x_v: order * (to - from)
    int from, to;
  };
  struct Product {  ///< coefficient `out` of det receives weight * (x_u[u] x x_v[v]) . n
    int out, u, v;
    double weight;
  };
  struct Pair {  ///< the mean of x_u x x_v receives weight * (control point a x control point b)
    int a, b;
    double weight;
  };
  struct Split;

  template <int width>
  void measure_wide(const Lanes* x, int lane, LaneFigures& figures) const;
  template <int width>
  void bound_wide(const Lanes* x, int lane, Lanes& least) const;
  void measure_lanes_avx2(const Lanes* x, LaneFigures& figures) const;
  void bound_lanes_avx2(const Lanes* x, Lanes& low) const;
  void build_control();
  void build_products();
  void build_mean();
  void build_children();
  void build_quadrature();
  bool coefficients(const Vec3* x, Coefficients& c) const;
  void apply(const std::vector<double>& columns, const Coefficients& c, Coefficients& result) const;
  void split(const Coefficients& c, int level, Split& state) const;

  ElementShape shape_;
  int order_, nodes_, degree_, count_;  ///< degree and number of the coefficients of det
  std::vector<double> node_weights_;    ///< nodes_ x nodes_: control points from nodes
  std::vector<Weight> to_control_;      ///< the same without zeros and without node 0, by control point
  std::vector<Difference> du_, dv_;
  std::vector<Product> products_;
  std::vector<Pair> mean_;
  std::vector<int> corners_;                     ///< coefficients that are values of det at corners
  std::vector<double> samples_;                  ///< count_ columns of count_: det on the lattice from its coefficients
  std::array<std::vector<double>, 4> children_;  ///< the same: coefficients on a quarter
  std::vector<double> quadrature_;               ///< per point: weight, then d/du and d/dv per node
};

/// The shared tables for a shape and order 1 to 4, built at first use.
const JacobianForm& jacobian_form(ElementShape shape, int order);

/// Whether the Jacobian of one element of a mesh is proven positive.
bool is_valid(const SurfaceMesh& mesh, bool is_quad, int element);

}  // namespace paver
