#include "boundary/facing/match_strips.h"

#include <algorithm>
#include <utility>

namespace paver {
namespace {

constexpr double largest_bulge = 0.5;  // of the width
constexpr int most_rounds = 8;         // through strips that share sides

/// Largest distance from the chords of `n` intervals that are equal in the parameter to the curve at their middles; of
/// many intervals at some.
double bulge(const Edge& edge, int n) {
  constexpr int most_samples = 64;
  const int step = (n + most_samples - 1) / most_samples;
  double most = 0;
  auto at = [&](double share) { return edge.curve->point((1 - share) * edge.t0 + share * edge.t1); };
  for (int i = 0; i < n; i += step)
    most = std::max(most, norm(at((i + 0.5) / n) - 0.5 * (at(static_cast<double>(i) / n) + at((i + 1.0) / n))));
  return most;
}

class Strip {
 public:
  Strip(const Model& model, const OppositeSides& pair, std::vector<EdgeCount>& counts)
      : model_(model), counts_(counts), fewer_(&pair.first), more_(&pair.second) {
    if (sum(*fewer_) > sum(*more_)) std::swap(fewer_, more_);
    width_ = 2 * model.faces[static_cast<std::size_t>(pair.face)].area / (length(*fewer_) + length(*more_));
  }

  /// Whether a count was raised.
  bool match() {
    const long wanted = sum(*more_);
    if (sum(*fewer_) == wanted || !is_divided(*fewer_) || !is_divided(*more_)) return false;
    if (std::max(most_bulge(*fewer_), most_bulge(*more_)) <= largest_bulge * width_) return false;
    while (sum(*fewer_) < wanted) raise(*std::ranges::max_element(*fewer_, {}, [&](int e) { return interval(e); }));
    return true;
  }

 private:
  using Side = std::vector<int>;

  const Edge& edge(int e) const { return model_.edges[static_cast<std::size_t>(e)]; }
  EdgeCount& count(int e) const { return counts_[static_cast<std::size_t>(e)]; }
  double interval(int e) const { return edge(e).length / count(e).count; }
  bool is_divided(const Side& side) const {
    return std::ranges::all_of(side, [&](int e) { return count(e).count > 0; });
  }
  long sum(const Side& side) const {
    long total = 0;
    for (int e : side) total += count(e).count;
    return total;
  }
  double length(const Side& side) const {
    double total = 0;
    for (int e : side) total += edge(e).length;
    return total;
  }
  double most_bulge(const Side& side) const {
    double most = 0;
    for (int e : side) most = std::max(most, bulge(edge(e), count(e).count));
    return most;
  }
  void raise(int e) {
    EdgeCount& raised = count(e);
    raised.minimum = std::max(raised.minimum, ++raised.count);
    raised.wish = std::max(raised.wish, static_cast<double>(raised.count));
  }

  const Model& model_;
  std::vector<EdgeCount>& counts_;
  const Side *fewer_, *more_;
  double width_ = 0;
};

}  // namespace

void match_bent_strips(const Model& model, const std::vector<OppositeSides>& pairs, std::vector<EdgeCount>& counts) {
  bool is_changed = true;
  for (int round = 0; is_changed && round < most_rounds; ++round) {
    is_changed = false;
    for (const OppositeSides& pair : pairs)
      if (pair.partner >= 0) is_changed = Strip(model, pair, counts).match() || is_changed;
  }
}

}  // namespace paver
