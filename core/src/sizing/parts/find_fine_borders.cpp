// In: faces with their edges, intervals. Out: pieces of borders, with the lengths of intervals there.
// Steps, face by face: edges that hang together by vertices; pieces of them all; the mean interval of each border; from
// each piece to other borders the least of distance times gradation less a share of the interval there.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "base/union_find.h"
#include "sizing/parts/find_places.h"

namespace paver {
namespace {

constexpr int pieces_of_edge = 16;
// Of an interval: a hole in the middle of a plate as wide as one is not near its border.
constexpr double share_of_interval = 0.25;

class BordersOfFace {
 public:
  using Interval = std::function<double(const Edge&, double t)>;

  BordersOfFace(const Model& model, const Face& face) {
    for (const Coedge& coedge : coedges_of(face.loops)) {
      const Edge& edge = edge_of(model, coedge);
      if (edge.curve && !edge.is_degenerate && !edge.is_periodic) edges_.push_back(&edge);
    }
    UnionFind hanging_together(edges_.size());
    std::map<int, int> edge_at;  // per vertex the first one
    for (int i = 0; i < static_cast<int>(edges_.size()); ++i)
      for (int vertex : {edges_[i]->start, edges_[i]->end})
        hanging_together.merge(i, edge_at.try_emplace(vertex, i).first->second);
    for (int i = 0; i < static_cast<int>(edges_.size()); ++i) border_.push_back(hanging_together.find(i));
  }

  void find(const Interval& interval, double gradation, std::vector<SizeSource>& sources) const {
    if (std::ranges::all_of(border_, [](int border) { return border == 0; })) return;
    std::vector<SizeSource> pieces, reached;
    for (std::size_t i = 0; i < edges_.size(); ++i) add_pieces(*edges_[i], border_[i], interval, pieces);
    for (const SizeSource& piece : pieces)
      reached.push_back({piece.a, piece.b, -share_of_interval * piece.value, piece.group});
    take_mean_lengths(pieces);
    const NearestSegment others(std::move(reached), gradation);
    std::vector<char> is_fine(edges_.size(), 0);  // per border
    for (const SizeSource& piece : pieces)
      if (others.least_of_others(piece.a, -piece.value, piece.group) < -piece.value) is_fine[piece.group] = 1;
    std::ranges::copy_if(pieces, std::back_inserter(sources), [&](const auto& piece) { return is_fine[piece.group]; });
  }

 private:
  static void add_pieces(const Edge& edge, int border, const Interval& interval, std::vector<SizeSource>& pieces) {
    double t = edge.t0, h = interval(edge, t);
    for (int i = 1; i <= pieces_of_edge; ++i) {
      const double next = edge.parameter(static_cast<double>(i) / pieces_of_edge), next_h = interval(edge, next);
      pieces.push_back({edge.curve->point(t), edge.curve->point(next), 0.5 * (h + next_h), border});
      t = next, h = next_h;
    }
  }

  // Of each border: its long edges need not be divided for the sake of its own short ones.
  void take_mean_lengths(std::vector<SizeSource>& pieces) const {
    std::vector<double> length(edges_.size(), 0), intervals(edges_.size(), 0);
    for (const SizeSource& piece : pieces) {
      const double step = norm(piece.b - piece.a);
      length[piece.group] += step, intervals[piece.group] += step / piece.value;
    }
    for (SizeSource& piece : pieces)
      if (intervals[piece.group] > 0) piece.value = length[piece.group] / intervals[piece.group];
  }

  std::vector<const Edge*> edges_;
  std::vector<int> border_;  // per edge: the first edge that it hangs together with
};

}  // namespace

std::vector<SizeSource> find_fine_borders(const Model& model, const BordersOfFace::Interval& interval,
                                          double gradation) {
  std::vector<SizeSource> sources;
  for (const Face& face : model.faces)
    if (face.is_meshed() && face.loops.size() > 1) BordersOfFace(model, face).find(interval, gradation, sources);
  return sources;
}

}  // namespace paver
