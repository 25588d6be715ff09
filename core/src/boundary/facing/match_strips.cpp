#include "boundary/facing/match_strips.h"

#include <algorithm>

#include "boundary/facing/raised_counts.h"

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
  auto at = [&](double share) { return edge.curve->point(edge.parameter(share)); };
  for (int i = 0; i < n; i += step)
    most = std::max(most, norm(at((i + 0.5) / n) - 0.5 * (at(static_cast<double>(i) / n) + at((i + 1.0) / n))));
  return most;
}

using Side = std::vector<int>;

double most_bulge(const Model& model, const Side& side, const std::vector<EdgeCount>& counts) {
  double most = 0;
  for (int e : side) most = std::max(most, bulge(model.edges[e], counts[e].count));
  return most;
}

/// Whether a count was raised.
bool match(const Model& model, const OppositeSides& pair, std::vector<EdgeCount>& counts) {
  const long first = sum_of_counts(pair.first, counts), second = sum_of_counts(pair.second, counts);
  if (first == second) return false;
  auto is_divided = [&](int e) { return counts[e].count > 0; };
  if (!std::ranges::all_of(pair.first, is_divided) || !std::ranges::all_of(pair.second, is_divided)) return false;
  const double width = 2 * model.faces[pair.face].area / (length_of(model, pair.first) + length_of(model, pair.second));
  if (std::max(most_bulge(model, pair.first, counts), most_bulge(model, pair.second, counts)) <= largest_bulge * width)
    return false;
  const Side& fewer = first < second ? pair.first : pair.second;
  take_counts(fewer, raised_counts(model, fewer, counts, std::max(first, second)), counts);
  return true;
}

}  // namespace

void match_bent_strips(const Model& model, const std::vector<OppositeSides>& pairs, std::vector<EdgeCount>& counts) {
  bool is_changed = true;
  for (int round = 0; is_changed && round < most_rounds; ++round) {
    is_changed = false;
    for (const OppositeSides& pair : pairs)
      if (pair.partner >= 0) is_changed = match(model, pair, counts) || is_changed;
  }
}

}  // namespace paver
