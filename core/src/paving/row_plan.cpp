// Plans a row: node states, wedges and tucks by length, and the wished places of its nodes.
#include "paving/row_plan.h"

#include <algorithm>

namespace paver {
namespace {

constexpr double deg = M_PI / 180;
constexpr double wedge_turn = 70 * deg, wedge_ratio = 1.25, wedge_ratio_first = 1.35;
constexpr double wedge_ratio_long = 1.12, wedge_excess = 1.5;  // of facets; a wedge takes two
constexpr double tuck_turn = 70 * deg, tuck_ratio = 0.8, tuck_turn_small = 52 * deg, tuck_ratio_small = 0.3;
constexpr double tuck_lack = 2;           // of facets, as many as a tuck takes
constexpr double tuck_least_ratio = 0.6;  // finer rows are so by their boundary: no tuck brings them near the target

constexpr double narrow = 0.4;  // facets shorter than this part of the row's height: directions over a wider stretch

/// Height of the row at a node: the length of its two facets, pulled towards the target length.
double row_height(const Front& front, int f) {
  double target = front.mesh.h[front.facets[f].b];
  double mean = 0.5 * (front.length(f) + front.length(front.facets[f].next));
  return 0.65 * target + 0.35 * std::clamp(mean, 0.6 * target, 1.4 * target);
}

void place(const Front& front, int f, NodePlan& plan) {
  double d = row_height(front, f), a = plan.angle;
  plan.count = 0;
  auto wish = [&](double share, double length) { plan.wish[plan.count++] = make_wish(front, f, share * a, length); };
  switch (plan.state) {
    case NodeState::end:
      break;
    case NodeState::side:
      if (std::max(front.length(f), front.length(front.facets[f].next)) < narrow * d) {
        plan.wish[plan.count++] = make_wide_wish(front, f, d);
      } else {
        wish(0.5, d / std::max(0.7, std::sin(0.5 * a)));
      }
      break;
    case NodeState::corner: {
      double s = std::max(0.7, std::sin(a / 3));
      wish(2.0 / 3, d / s);
      wish(0.5, 1.414 * d);
      wish(1.0 / 3, d / s);
      break;
    }
    case NodeState::reversal:
      for (int i = 1; i <= 5; ++i) wish(1 - 0.125 * (i + 1), i % 2 ? d : 1.414 * d);
  }
}

/// Walks along the row adding up turn and length ratio since the last change; changes the state of the node that
/// turns most where both pass their limits, or where the row became longer by one and a half facets or shorter by two.
class RowAdjuster {
 public:
  RowAdjuster(Front& front, const Row& row, std::vector<NodePlan>& plans) : front_(front), row_(row), plans_(plans) {}

  void run() {
    int n = static_cast<int>(plans_.size()), last = row_.has_ends ? n - 1 : n;
    for (int i = 0; i < last; ++i) {
      if (plans_[i].state != NodeState::side) {
        reset();
        continue;
      }
      add(i);
      double ratio = ratio_sum_ / count_, excess = ratio_sum_ - count_;
      bool is_first = row_.level == 0;
      bool turns = turn_ > wedge_turn && ratio > (is_first ? wedge_ratio_first : wedge_ratio);
      bool is_long = !is_first && ratio > wedge_ratio_long && excess > wedge_excess && turn_ > 0;
      if (turns || is_long) {
        change(most_, NodeState::corner, front_.counts.wedges);
      } else if (!is_first && ((turn_ < -tuck_turn && ratio < tuck_ratio) ||
                               (turn_ < -tuck_turn_small && ratio < tuck_ratio_small) ||
                               (turn_ < 0 && ratio > tuck_least_ratio && ratio < tuck_ratio && excess < -tuck_lack))) {
        change(least_, NodeState::end, front_.counts.tucks);
      }
    }
  }

 private:
  void reset() { turn_ = ratio_sum_ = 0, count_ = 0, most_ = least_ = -1; }

  void add(int i) {
    const NodePlan& plan = plans_[i];
    int f = row_.facets[i], node = front_.facets[f].b;
    double turn = plan.angle - M_PI, target = front_.mesh.h[node];
    double base = 0.5 * (front_.length(f) + front_.length(front_.facets[f].next));
    turn_ += turn;
    ratio_sum_ += (base + plan.wish[0].length * turn) / target;
    ++count_;
    if (most_ < 0 || plan.angle > plans_[most_].angle) most_ = i;
    if (!front_.mesh.is_fixed[node] && (least_ < 0 || plan.angle < plans_[least_].angle)) least_ = i;
  }

  void change(int i, NodeState state, long& counter) {
    if (i < 0) return;
    plans_[i].state = state;
    place(front_, row_.facets[i], plans_[i]);
    ++counter;
    reset();
  }

  Front& front_;
  const Row& row_;
  std::vector<NodePlan>& plans_;
  double turn_ = 0, ratio_sum_ = 0;
  int count_ = 0, most_ = -1, least_ = -1;
};

}  // namespace

std::vector<NodePlan> plan_row(Front& front, const Row& row) {
  std::vector<NodePlan> plans(row.facets.size());
  for (std::size_t i = 0; i < plans.size(); ++i) {
    int f = row.facets[i];
    plans[i].angle = front.chord_angle_after(f);
    plans[i].state = classify(front, front.facets[f].b, front.angle_after(f));
    place(front, f, plans[i]);
  }
  RowAdjuster(front, row, plans).run();
  return plans;
}

}  // namespace paver
