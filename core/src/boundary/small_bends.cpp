// Windows as long as a small bend begin at every row; where one turns enough, the one that turns most begins in it.
#include "boundary/small_bends.h"

#include <algorithm>
#include <cmath>

namespace paver {
namespace {

constexpr double most = 170 * M_PI / 180;  // what turns more folds back: its sides would lie on each other
constexpr double most_about = 0.5;         // of its turn, beside a bend: else it is a part of a longer one

class Windows {
 public:
  Windows(const std::vector<TurnedTo>& rows, const std::vector<double>& width) : rows_(rows), width_(width) {}

  int count() const { return static_cast<int>(rows_.size()); }
  SmallBend from(int i) const { return {i, last_within(rows_[i].s + width_[i])}; }
  double turn(SmallBend bend) const { return rows_[bend.last].turn - rows_[bend.first].turn; }
  /// It and all between it and an end of the curve.
  bool is_at_end(SmallBend bend) const {
    const double reach = width_[bend.first];
    return rows_[bend.last].s <= rows_.front().s + reach || rows_[bend.first].s >= rows_.back().s - reach;
  }
  bool begins_in(int i, SmallBend bend) const { return i < count() && rows_[i].s <= rows_[bend.last].s; }

  SmallBend strongest_in(SmallBend first) const {
    SmallBend best = first;
    for (int i = first.first + 1; begins_in(i, first); ++i)
      if (const SmallBend other = from(i); turn(other) > turn(best)) best = other;
    while (rows_[best.first + 1].turn == rows_[best.first].turn) ++best.first;
    return best;
  }
  // Beside it: a window's width to either side.
  double turn_about(SmallBend bend) const {
    const double reach = width_[bend.first];
    const int before = std::max(last_within(rows_[bend.first].s - reach), 0),
              after = std::min(last_within(rows_[bend.last].s + reach) + 1, count() - 1);
    return turn({before, after}) - turn(bend);
  }

 private:
  int last_within(double s) const {
    const auto after = std::ranges::upper_bound(rows_, s, {}, &TurnedTo::s);
    return static_cast<int>(after - rows_.begin()) - 1;
  }

  const std::vector<TurnedTo>& rows_;
  const std::vector<double>& width_;
};

}  // namespace

std::vector<SmallBend> find_small_bends(const std::vector<TurnedTo>& rows, const std::vector<double>& width,
                                        double least) {
  const Windows windows(rows, width);
  std::vector<SmallBend> found;
  for (int i = 0; i + 1 < windows.count(); ++i) {
    const SmallBend first = windows.from(i);
    if (windows.turn(first) <= least) continue;
    const SmallBend bend = windows.strongest_in(first);
    const bool folds = windows.turn(bend) > most && !windows.is_at_end(bend);
    if (!folds && windows.turn_about(bend) > most_about * windows.turn(bend)) continue;
    if (!folds) found.push_back(bend);
    i = bend.last;
  }
  return found;
}

}  // namespace paver
