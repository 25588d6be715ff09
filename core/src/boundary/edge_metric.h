// Length of one edge measured in target lengths: the table behind interval counts and node positions.
#pragma once

#include <span>
#include <vector>

#include "sizing/size_field.h"
#include "topology/model.h"

namespace paver {

/// Table along one non-degenerate edge: parameter t, arc length s (mm), turn of the tangent (radians), target length h
/// and the integral of ds/h, called weight. h is the least of the global h, of lengths given for parts of the model,
/// and of the edge's own turn limit, smoothed along the edge by the gradation: an edge that runs straight along a
/// fillet keeps the global h. Where the tangent jumps (a kink inside the edge), or turns within a stretch that is small
/// against h, a node is placed. Keeps a reference to the edge's curve.
class EdgeMetric {
 public:
  /// `sides`: the edge on faces whose turns count.
  EdgeMetric(const Edge& edge, const SizeField& size, std::span<const TurningSide> sides = {});

  double length() const { return rows_.back().s; }
  double weight() const { return rows_.back().weight; }
  double turn() const { return rows_.back().turn; }
  /// turn() less the turns of the kinks.
  double smooth_turn() const;
  int kink_count() const { return static_cast<int>(kinks_.size()); }
  /// Arc lengths of the n + 1 nodes of `n` intervals: equal in weight between kinks, a node on each kink (on the
  /// sharpest n - 1 of them where there are more) that is not all but on another node.
  std::vector<double> node_lengths(int n) const;
  /// Arc length where the weight reaches `weight`, 0 to weight().
  double length_at_weight(double weight) const;
  /// Curve parameter at arc length `s`; exact to about 1e-9 of the length.
  double parameter_at_length(double s) const;
  double size_at_length(double s) const;
  /// Whether none of `n` intervals turns more than it may; the turn of a kink on a node counts for none.
  bool turns_within(int n) const;
  /// The same of intervals between nodes at these arc lengths.
  bool turns_within(const std::vector<double>& lengths) const;
  const TurnLimit& turn_limit() const { return limit_; }

 private:
  struct Row {
    double t = 0, s = 0, turn = 0, h = 0, weight = 0;
    double pace = 0;   // dt/ds
    double given = 0;  // target length without any turn
    bool is_in_small_bend = false;
  };
  struct Panel {
    double a = 0, b = 0;
    Vec3 direction_a, direction_b;
    double length = 0;
  };
  struct Kink {
    std::size_t row = 0;  // first row behind it; the row before has the same t and s
    double turn = 0;
  };

  void tabulate();
  Vec3 direction_at(double t) const;
  void add_panel(const Panel& panel, double tolerance, int depth);
  void add_rows(const Panel& half, bool may_hold_kink);
  void drop_kinks_at_ends();
  void refine_rows(const Edge& edge, const SizeField& size);
  void refine_between(const Row& a, const Row& b, const Edge& edge, const SizeField& size,
                      std::vector<Row>& fine) const;
  void make_kinks_of_small_bends(const Edge& edge, const SizeField& size);
  void make_kink(int first, int last, double width);
  Row row_at_turn(double turn, std::size_t first) const;
  void set_sizes(const Edge& edge, const SizeField& size);
  void count_turns(const ParameterCurve& pcurve, const FaceSize& face);
  void weigh();
  double length_at_bend(double s, double by_curvature) const;
  double quadrature(double a, double b) const;
  std::vector<Kink> kinks_with_nodes(int n) const;
  std::vector<int> share_intervals(const std::vector<Row>& ends, int n) const;
  enum class KinkSide { before, behind };
  double turn_at_length(double s, KinkSide side) const;
  static double first_guess(const Row& a, const Row& b, double share);
  static double share_between(const Row& a, const Row& b, double s);
  using Column = double Row::*;
  std::size_t row_before(double value, Column column) const;

  const Curve* curve_;
  double t0_, t1_;
  const TurnLimit limit_;
  double top_speed_ = 0;
  std::vector<Row> rows_;  // at least two
  std::vector<Kink> kinks_;
};

}  // namespace paver
