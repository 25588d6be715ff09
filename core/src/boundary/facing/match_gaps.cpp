// In: loops, sizes, counts. Out: larger counts on loops about gaps.
// Steps, face by face: width by area and length of the border; counts wanted; nodes there, equally far apart on each
// edge; the turn of one loop against the other that brings them nearest; the quads between them.
#include "boundary/facing/match_gaps.h"

#include <algorithm>
#include <cmath>

#include "base/nearest_turn.h"
#include "boundary/facing/raised_counts.h"
#include "quality/metrics.h"

namespace paver {
namespace {

constexpr double narrow = 0.7;             // target lengths
constexpr double most_more = 2.5;          // times the intervals that a loop has
constexpr double most_more_of_both = 1.4;  // of those wanted
constexpr double least_jacobian = 0.4;     // of the quads between equally spaced nodes
constexpr long most_nodes = 256;

class GapBetween {
 public:
  GapBetween(const Model& model, const std::vector<Loop>& loops, std::vector<EdgeCount>& counts)
      : model_(model), counts_(counts) {
    const long first = sum(loops[0]), second = sum(loops[1]);
    fewer_ = &loops[first < second ? 0 : 1], more_ = &loops[first < second ? 1 : 0];
    least_ = std::min(first, second);
    wanted_ = 2 * ((std::max(first, second) + 1) / 2);
  }

  double length() const {
    double total = 0;
    for (const Loop* loop : {fewer_, more_})
      for (const Coedge& coedge : loop->coedges) total += edge(coedge).length;
    return total;
  }

  void match() {
    // Two smooth rims are tied in any case.
    if (fewer_->coedges.size() == 1 && more_->coedges.size() == 1) return;
    const auto edges = static_cast<long>(fewer_->coedges.size());
    const long equal = edges * ((wanted_ + edges - 1) / edges);
    if (equal % 2 == 0 && static_cast<double>(equal) <= most_more_of_both * static_cast<double>(wanted_))
      wanted_ = equal;
    if (wanted_ > most_nodes || static_cast<double>(wanted_) > most_more * static_cast<double>(least_)) return;
    const std::vector<int> fewer = edges_of(*fewer_), more = edges_of(*more_);
    const std::vector<int> of_fewer = raised_counts(model_, fewer, counts_, wanted_),
                           of_more = raised_counts(model_, more, counts_, wanted_);
    if (of_fewer.empty() || of_more.empty()) return;
    if (quality(nodes(*fewer_, of_fewer), nodes(*more_, of_more)) < least_jacobian) return;
    take_counts(fewer, of_fewer, counts_);
    take_counts(more, of_more, counts_);
  }

 private:
  const Edge& edge(const Coedge& coedge) const { return edge_of(model_, coedge); }

  long sum(const Loop& loop) const { return sum_of_counts(edges_of(loop), counts_); }

  std::vector<Vec3> nodes(const Loop& loop, const std::vector<int>& number) const {
    std::vector<Vec3> result;
    for (std::size_t k = 0; k < number.size(); ++k) {
      const Coedge& coedge = loop.coedges[k];
      const Edge& here = edge(coedge);
      for (int i = 0; i < number[k]; ++i) {
        const double share = static_cast<double>(coedge.is_reversed ? number[k] - i : i) / number[k];
        result.push_back(here.curve->point(here.parameter(share)));
      }
    }
    return result;
  }

  /// Worst scaled Jacobian of the quads between two loops, which run opposite ways.
  static double quality(const std::vector<Vec3>& one, const std::vector<Vec3>& two) {
    const std::size_t n = one.size();
    const std::size_t turn = nearest_turn(n, [&](auto i, auto j) { return two[j] - one[i]; });
    double worst = 1;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t next = (i + 1) % n;
      worst = std::min(worst, scaled_jacobian(one[i], one[next], two[(turn + n - next) % n], two[(turn + n - i) % n]));
    }
    return worst;
  }

  const Model& model_;
  std::vector<EdgeCount>& counts_;
  const Loop *fewer_, *more_;
  long least_ = 0, wanted_ = 0;
};

}  // namespace

void match_gaps(const Model& model, const SizeField& size, const std::vector<std::vector<Loop>>& loops,
                std::vector<EdgeCount>& counts) {
  for (std::size_t f = 0; f < loops.size(); ++f) {
    // Elsewhere neighbours lose more than the gap wins: 38 triangles more on a model of 5000 elements.
    if (loops[f].size() != 2 || size.face_h[f] >= size.h) continue;
    GapBetween gap(model, loops[f], counts);
    if (model.faces[f].area < 0.5 * gap.length() * narrow * size.face_h[f]) gap.match();
  }
}

}  // namespace paver
