// Interval assignment. Chords start near their wishes; what a side then lacks is brought from where there is too much,
// along the cheapest path of chords, each of which takes one more or one less; at a price a chord may take one more at
// one end and one less at the other.
// In: sides with their facets, chords with wishes. Out: counts per edge.
#include "multilevel/coarse/edge_counts.h"

#include <algorithm>
#include <cmath>

namespace paver {
namespace {

constexpr double break_price = 2;  // of the squared change along a chord; a count off its wish by one costs 1 each end
constexpr double least_cost = 0.01, tie = 1e-3;
constexpr double golden = 0.6180339887498949;
constexpr double clear = 0.25;  // of one: distance to a whole number that is rounded
constexpr int most_paths = 20;  // per side and per chord end

double spread_out(int i) {
  double x = golden * (i + 1);
  return x - std::floor(x);
}

// Near whole numbers to those; between, now up and now down, so that neither side is preferred.
int rounded(double wish, double share) {
  double whole = std::floor(wish), rest = wish - whole;
  double up = std::clamp((rest - clear) / (1 - 2 * clear), 0.0, 1.0);
  return static_cast<int>(whole) + (share < up ? 1 : 0);
}

struct Counts {
  double wish = 1;
  int end[2] = {1, 1};
  double cost() const {
    double a = end[0] - wish, b = end[1] - wish, change = end[0] - end[1];
    return a * a + b * b + break_price * change * change;
  }
};

/// A chord of a path: `by[k]` is added to its count at end k.
struct Move {
  int chord = -1;
  int by[2] = {0, 0};
};

class Assignment {
 public:
  Assignment(const CoarseRegion& coarse, const CoarseNet& net, const std::vector<Chord>& chords)
      : coarse_(coarse), net_(net), chords_(chords), counts_(chords.size()), lacks_(coarse.side_intervals) {}

  bool run(const std::vector<double>& wishes) {
    for (std::size_t c = 0; c < chords_.size(); ++c) start(static_cast<int>(c), wishes);
    long left = most_paths * static_cast<long>(lacks_.size() + 2 * chords_.size());
    for (std::size_t s = 0; s < lacks_.size(); ++s)
      while (lacks_[s] != 0)
        if (--left < 0 || !(bring_to(static_cast<int>(s)) || change_one_end(static_cast<int>(s)))) return false;
    for (std::size_t c = 0; c < chords_.size(); ++c)  // a path may have taken a chord twice
      if (!is_possible(static_cast<int>(c), counts_[c])) return false;
    return true;
  }

  std::vector<int> edge_counts() const {
    std::vector<int> result(net_.edges.size(), 1);
    for (std::size_t c = 0; c < chords_.size(); ++c) {
      const std::vector<int>& edges = chords_[c].edges;
      for (std::size_t i = 0; i < edges.size(); ++i)
        result[edges[i]] = counts_[c].end[i < (edges.size() + 1) / 2 ? 0 : 1];
    }
    return result;
  }

 private:
  void start(int c, const std::vector<double>& wishes) {
    const Chord& chord = chords_[c];
    double sum = 0;
    int ends = 0;
    for (int k : {0, 1}) {
      if (chord.side[k] < 0) continue;
      const CoarseEdge& edge = net_.edges[k == 0 ? chord.edges.front() : chord.edges.back()];
      sum += coarse_.fine_facets(static_cast<std::size_t>(edge.loop), static_cast<std::size_t>(edge.facet));
      ++ends;
    }
    if (ends == 0) {
      for (int e : chord.edges) sum += wishes[e];
      ends = static_cast<int>(chord.edges.size());
    }
    Counts& counts = counts_[c];
    counts.wish = std::max(1.0, sum / ends);
    counts.end[0] = counts.end[1] = rounded(counts.wish, spread_out(c));
    for (int s : chord.side)
      if (s >= 0) lacks_[s] -= counts.end[0];
  }

  // Once the path to a state is gone.
  Counts counts_at(int chord, int state) const {
    Counts counts = counts_[chord];
    for (int at = state; before_[at] >= 0; at = before_[at])
      for (int k : {0, 1})
        if (via_[at].chord == chord) counts.end[k] += via_[at].by[k];
    return counts;
  }

  // What the change costs; infinite where it is not possible.
  double cost(const Move& move, const Counts& now) const {
    Counts then = now;
    for (int k : {0, 1}) then.end[k] += move.by[k];
    if (!is_possible(move.chord, then)) return INFINITY;
    return std::max(least_cost, then.cost() - now.cost()) + tie * spread_out(move.chord);
  }

  bool is_possible(int chord, const Counts& counts) const {
    bool is_whole = chords_[chord].edges.size() < 2;
    return counts.end[0] >= 1 && counts.end[1] >= 1 && !(is_whole && counts.end[0] != counts.end[1]);
  }

  void apply(const Move& move) {
    for (int k : {0, 1}) {
      counts_[move.chord].end[k] += move.by[k];
      int side = chords_[move.chord].side[k];
      if (side >= 0) lacks_[side] -= move.by[k];
    }
  }

  // State 2 s: side s wants one more; 2 s + 1: one less.
  static int state(int side, int by) { return 2 * side + (by > 0 ? 0 : 1); }

  // Cheapest path of changes that gives `side` what it lacks at the cost of nothing else.
  bool bring_to(int side) {
    const std::size_t states = 2 * lacks_.size();
    cost_.assign(states, INFINITY);
    via_.assign(states, {});
    before_.assign(states, -1);
    best_ = INFINITY;
    best_path_.clear();
    const int goal = lacks_[side] > 0 ? 1 : -1;
    cost_[state(side, goal)] = 0;
    for (std::size_t round = 0; round < states && relax(side); ++round) {
    }
    for (const Move& move : best_path_) apply(move);
    return best_ < INFINITY;
  }

  bool relax(int source) {
    bool has_changed = false;
    for (std::size_t c = 0; c < chords_.size(); ++c)
      for (int k : {0, 1}) {
        int from = chords_[c].side[k], to = chords_[c].side[1 - k];
        if (from < 0) continue;
        for (int by : {1, -1}) {
          if (cost_[state(from, by)] == INFINITY) continue;
          for (int other : {by, -by}) {
            Move move{static_cast<int>(c), {by, by}};
            move.by[1 - k] = other;
            has_changed |= reach(state(from, by), move, to, other, source);
          }
        }
      }
    return has_changed;
  }

  // Side `to` gets `by`: the path ends there, or `to` must get rid of it again.
  bool reach(int from, const Move& move, int to, int by, int source) {
    double reached = cost_[from] + cost(move, counts_at(move.chord, from));
    if (!(reached < best_)) return false;
    int lack = to < 0 ? by : to == source ? lacks_[to] - by : lacks_[to];
    if (to < 0 || lack * by > 0) {
      best_ = reached;
      best_path_.assign(1, move);
      for (int k = from; before_[k] >= 0; k = before_[k]) best_path_.push_back(via_[k]);
      return true;
    }
    int at = state(to, -by);
    if (!(reached < cost_[at])) return false;
    for (int k = from; k >= 0; k = before_[k])
      if (k == at) return false;  // no cycles
    cost_[at] = reached, via_[at] = move, before_[at] = from;
    return true;
  }

  // The region is odd: one quad will be, too.
  bool change_one_end(int side) {
    Move best;
    double least = INFINITY;
    for (std::size_t c = 0; c < chords_.size(); ++c)
      for (int k : {0, 1}) {
        if (chords_[c].side[k] != side) continue;
        Move move{static_cast<int>(c), {0, 0}};
        move.by[k] = lacks_[side] > 0 ? 1 : -1;
        const double price = cost(move, counts_[c]);
        if (price < least) least = price, best = move;
      }
    if (least == INFINITY) return false;
    apply(best);
    return true;
  }

  const CoarseRegion& coarse_;
  const CoarseNet& net_;
  const std::vector<Chord>& chords_;
  std::vector<Counts> counts_;
  std::vector<int> lacks_;
  std::vector<double> cost_;  // per state, of the cheapest path so far
  std::vector<Move> via_;
  std::vector<int> before_;
  double best_ = 0;
  std::vector<Move> best_path_;
};

}  // namespace

std::optional<std::vector<int>> choose_edge_counts(const CoarseRegion& coarse, const CoarseNet& net,
                                                   const std::vector<Chord>& chords,
                                                   const std::vector<double>& wishes) {
  Assignment assignment(coarse, net, chords);
  if (!assignment.run(wishes)) return std::nullopt;
  return assignment.edge_counts();
}

}  // namespace paver
