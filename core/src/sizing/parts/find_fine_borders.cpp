// In: faces with their edges, intervals. Out: pieces of borders, with the lengths of intervals there.
// Steps, face by face: edges that hang together by vertices; pieces of them all; the mean interval of each border; from
// each piece to other borders the least of distance times gradation less a share of the interval there.
#include <algorithm>
#include <cmath>
#include <map>

#include "base/union_find.h"
#include "sizing/parts/find_places.h"

namespace paver {
namespace {

constexpr int pieces_of_edge = 16;
constexpr double undivided = 0.99;  // of an edge's length
// Of an interval. An edge that is not divided at all is not for less: a hole in the middle of a plate as wide as one
// interval keeps its ring.
constexpr double share_of_interval = 0.4, share_of_whole_edge = 0.25;

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
    std::map<int, std::size_t> border_at;  // per first edge
    for (int i = 0; i < static_cast<int>(edges_.size()); ++i)
      border_.push_back(border_at.try_emplace(hanging_together.find(i), border_at.size()).first->second);
    borders_.resize(border_at.size());
  }

  void find(const Interval& interval, double gradation, std::vector<SizeSource>& sources) {
    if (borders_.size() < 2) return;
    auto reached = borders_, plain = borders_;
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const std::size_t b = border_[i], first = borders_[b].size();
      add_pieces(*edges_[i], interval, borders_[b]);
      for (std::size_t k = first; k < borders_[b].size(); ++k) {
        const auto& [start, end, length] = borders_[b][k];
        const bool is_divided = length < undivided * edges_[i]->length;
        reached[b].push_back({start, end, -(is_divided ? share_of_interval : share_of_whole_edge) * length});
        plain[b].push_back({start, end});
      }
    }
    const NearestSegment nearest_reached(reached, gradation), nearest(plain, 1);
    for (std::size_t b = 0; b < borders_.size(); ++b) {
      take_mean_length(borders_[b]);
      const double most = -borders_[b].front().value;
      const bool is_fine = std::ranges::any_of(
          borders_[b], [&](const auto& piece) { return nearest_reached.least_of_others(piece.a, most, b) < most; });
      if (!is_fine) continue;
      start_where_rings_end(borders_[b], b, nearest);
      sources.insert(sources.end(), borders_[b].begin(), borders_[b].end());
    }
  }

 private:
  static void add_pieces(const Edge& edge, const Interval& interval, std::vector<SizeSource>& pieces) {
    double t = edge.t0, h = interval(edge, t);
    for (int i = 1; i <= pieces_of_edge; ++i) {
      const double next = edge.parameter(static_cast<double>(i) / pieces_of_edge), next_h = interval(edge, next);
      pieces.push_back({edge.curve->point(t), edge.curve->point(next), 0.5 * (h + next_h)});
      t = next, h = next_h;
    }
  }

  // Long edges of a border need not be divided for the sake of its own short ones.
  static void take_mean_length(std::vector<SizeSource>& border) {
    double length = 0, intervals = 0;
    for (const SizeSource& piece : border) {
      const double step = norm(piece.b - piece.a);
      length += step, intervals += step / piece.value;
    }
    for (SizeSource& piece : border)
      if (intervals > 0) piece.value = length / intervals;
  }

  std::vector<const Edge*> edges_;
  std::vector<std::size_t> border_;  // per edge: edges that hang together are one
  std::vector<std::vector<SizeSource>> borders_;
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
