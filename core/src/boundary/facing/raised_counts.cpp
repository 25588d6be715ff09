#include "boundary/facing/raised_counts.h"

#include <algorithm>

namespace paver {

long sum_of_counts(const std::vector<int>& edges, const std::vector<EdgeCount>& counts) {
  long total = 0;
  for (int e : edges) total += counts[e].count;
  return total;
}

std::vector<int> raised_counts(const Model& model, const std::vector<int>& edges, const std::vector<EdgeCount>& counts,
                               long total) {
  std::vector<int> result;
  for (int e : edges) result.push_back(counts[e].count);
  if (std::count(result.begin(), result.end(), 0) > 0) return {};
  const auto interval = [&](std::size_t i) { return model.edges[edges[i]].length / result[i]; };
  for (long sum = sum_of_counts(edges, counts); sum < total; ++sum) {
    std::size_t longest = 0;
    for (std::size_t i = 1; i < result.size(); ++i)
      if (interval(i) > interval(longest)) longest = i;
    ++result[longest];
  }
  return result;
}

void take_counts(const std::vector<int>& edges, const std::vector<int>& number, std::vector<EdgeCount>& counts) {
  for (std::size_t k = 0; k < edges.size(); ++k) {
    EdgeCount& taken = counts[edges[k]];
    if (number[k] <= taken.count) continue;
    taken.count = taken.minimum = number[k];
    taken.wish = std::max(taken.wish, static_cast<double>(number[k]));
  }
}

}  // namespace paver
