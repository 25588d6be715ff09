// Plans a row: node states, wedges and tucks by length, and the wished places of its nodes.
#include "paving/rows/row_plan.h"

#include <algorithm>

namespace paver {
namespace {

constexpr double deg = M_PI / 180;
// Turn along a row and lengths over target lengths from which on it gets a quad more or one less [Blacker91].
constexpr double wedge_turn = 70 * deg, wedge_ratio = 1.25, wedge_ratio_first = 1.35;
constexpr double tuck_turn = 70 * deg, tuck_ratio = 0.8, tuck_turn_small = 52 * deg, tuck_ratio_small = 0.3;
// Without much turn, by the facets that are too many or too few; a wedge and a tuck change two.
constexpr double wedge_ratio_long = 1.12, wedge_excess = 1.5, tuck_lack = 2;
constexpr double tuck_least_ratio = 0.6;  // finer rows are so by their boundary: no tuck brings them near the target
constexpr double graded_turn = 20 * deg;  // lengths that grow inwards ask for tucks along straight rows, too

// A row's height: mostly the target length, so that lengths are pulled back to it, and some of the facets' own.
constexpr double target_share = 0.65, least_mean = 0.6, largest_mean = 1.4;  // the mean: of the target length
constexpr double diagonal = 1.414;                                           // of a square
constexpr double least_sine = 0.7;  // of half the angle at a node: its new edge is no longer than the height by this
constexpr double narrow = 0.4;  // facets shorter than this part of the row's height: directions over a wider stretch

/// Height of the row at a node: the length of its two facets, pulled towards the target length.
double row_height(const Front& front, int f) {
  double target = front.mesh.h[front.facets[f].b];
  double mean = 0.5 * (front.length(f) + front.length(front.facets[f].next));
  return target_share * target + (1 - target_share) * std::clamp(mean, least_mean * target, largest_mean * target);
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
        wish(0.5, d / std::max(least_sine, std::sin(0.5 * a)));
      }
      break;
    case NodeState::corner: {
      double s = std::max(least_sine, std::sin(a / 3));
      wish(2.0 / 3, d / s);
      wish(0.5, diagonal * d);
      wish(1.0 / 3, d / s);
      break;
    }
    case NodeState::reversal:
      for (int i = 1; i <= 5; ++i) wish(1 - 0.125 * (i + 1), i % 2 ? d : diagonal * d);
  }
}

/// Walks along the row adding up turn and length ratio since the last change; changes the state of the node that
/// turns most where both pass their limits, or where the row became longer by one and a half facets or shorter by two.
class RowAdjuster {
 public:
  RowAdjuster(const Front& front, const Row& row, std::vector<NodePlan>& plans)
      : front_(front), row_(row), plans_(plans) {}

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
        change(most_, NodeState::corner);
      } else if (!is_first && ((turn_ < -tuck_turn && ratio < tuck_ratio) ||
                               (turn_ < -tuck_turn_small && ratio < tuck_ratio_small) ||
                               (turn_ < 0 && ratio > tuck_least_ratio && ratio < tuck_ratio && excess < -tuck_lack) ||
                               (is_graded_ && turn_ < graded_turn && ratio < tuck_ratio && excess < -tuck_lack))) {
        change(least_, NodeState::end);
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

  void change(int i, NodeState state) {
    if (i < 0) return;
    plans_[i].state = state;
    place(front_, row_.facets[i], plans_[i]);
    reset();
  }

  const Front& front_;
  const Row& row_;
  std::vector<NodePlan>& plans_;
  double turn_ = 0, ratio_sum_ = 0;
  int count_ = 0, most_ = -1, least_ = -1;
  const bool is_graded_ = front_.region.size.is_graded();
};

}  // namespace

std::vector<NodePlan> plan_row(const Front& front, const Row& row) {
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
