// In: model, limits. Out: the model with composite edges.
// Steps: vertices at which two edges of the same faces end and run on, the shortest first; chains of what is joined
// there; for each one edge whose curve and images are those of its pieces, one after the other.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/cells.h"
#include "sizing/merging/merge_steps.h"

namespace paver {
namespace {

constexpr double straight = 5 * M_PI / 180;
// Short edges may be so much longer where they run on, and straight on: pieces of a curve that a file has in many.
constexpr double smooth_reach = 3, straight_reach = 7;

/// Where the pieces of a chain begin, in the chain's parameter: mm along it.
struct Pieces {
  std::vector<double> begin;                     // one more than pieces
  std::vector<std::pair<double, double>> range;  // of the piece's own parameter, in the chain's direction

  /// The piece at s, its parameter there, and what that grows by s.
  std::size_t find(double s, double& t, double& pace) const {
    const std::size_t i = cell_of(begin, s);
    pace = (range[i].second - range[i].first) / (begin[i + 1] - begin[i]);
    t = range[i].first + pace * (s - begin[i]);
    return i;
  }
};

class ChainCurve : public Curve {
 public:
  ChainCurve(std::shared_ptr<const Pieces> pieces, std::vector<std::shared_ptr<const Curve>> curves)
      : pieces_(std::move(pieces)), curves_(std::move(curves)) {}
  Vec3 point(double s) const override {
    double t, pace;
    return curves_[pieces_->find(s, t, pace)]->point(t);
  }
  CurveSlope slope(double s) const override {
    double t, pace;
    const CurveSlope at = curves_[pieces_->find(s, t, pace)]->slope(t);
    return {at.x, pace * at.t};
  }
  CurveJet jet(double s) const override {
    double t, pace;
    const CurveJet at = curves_[pieces_->find(s, t, pace)]->jet(t);
    return {{at.x, pace * at.t}, pace * pace * at.tt};
  }

 private:
  std::shared_ptr<const Pieces> pieces_;
  std::vector<std::shared_ptr<const Curve>> curves_;
};

class ChainJoiner {
 public:
  ChainJoiner(ModelEdits& edits, const MergeLimits& limits) : edits_(edits), limits_(limits) {}

  void run(std::vector<Merge>& merges) {
    find_chains();
    for (Side& chain : chains_)
      if (chain.size() > 1) make(chain, merges);
  }

 private:
  struct Joint {
    int vertex = -1;
    double shorter = 0, angle = 0;
  };

  void find_chains() {
    const auto count = edits_.model().edges.size();
    chains_.resize(count);
    lengths_.resize(count);
    chain_of_.resize(count);
    place_.resize(count);
    std::iota(chain_of_.begin(), chain_of_.end(), 0);
    for (std::size_t e = 0; e < count; ++e)
      chains_[e] = {{static_cast<int>(e), false}}, lengths_[e] = edits_.edge(static_cast<int>(e)).length;
    std::vector<Joint> joints;
    for (std::size_t v = 0; v < edits_.model().vertices.size(); ++v) {
      Joint joint{static_cast<int>(v)};
      if (is_joint(joint)) joints.push_back(joint);
    }
    std::ranges::stable_sort(joints, {}, &Joint::shorter);
    for (const Joint& joint : joints) join(joint);
  }

  bool is_joint(Joint& joint) const {
    const std::vector<int>& edges = edits_.edges_at(joint.vertex);
    if (edges.size() != 2 || edges[0] == edges[1] || edits_.is_fixed(joint.vertex)) return false;
    const Edge &a = edits_.edge(edges[0]), &b = edits_.edge(edges[1]);
    if (a.faces != b.faces || limits_.is_protected(edges[0]) || limits_.is_protected(edges[1])) return false;
    if (a.is_periodic || b.is_periodic) return false;
    joint.shorter = std::min(a.length, b.length);
    joint.angle = bend_between(a, b, joint.vertex);
    if (joint.shorter > reach(joint) * limits_.short_edge(a.length < b.length ? edges[0] : edges[1])) return false;
    const bool is_within_pieces =
        joint.angle <= straight && std::max(a.length, b.length) <= straight_reach * limits_.short_edge(edges[0]);
    if (!is_within_pieces && limits_.holds(joint.vertex, {}, joint.shorter)) return false;
    return joint.angle <= smooth_angle * M_PI / 180 && runs_on(edges[0], edges[1], joint.vertex);
  }

  static double reach(const Joint& joint) { return joint.angle > straight ? smooth_reach : straight_reach; }

  // In all their loops the two follow one another, and their images do.
  bool runs_on(int a, int b, int vertex) const {
    int found = 0;
    for (std::size_t use = 0; use < edits_.edge(a).faces.size(); ++use) {
      const int f = edits_.edge(a).faces[use];
      if (use > 0 && f == edits_.edge(a).faces[use - 1]) return false;
      const Face& face = edits_.face(f);
      for (const Loop& loop : face.loops)
        for (std::size_t i = 0, n = loop.coedges.size(); i < n; ++i) {
          const Coedge &one = loop.coedges[i], &two = loop.coedges[(i + 1) % n];
          const bool meet = ((one.edge == a && two.edge == b) || (one.edge == b && two.edge == a)) &&
                            edits_.end_of({one.edge, one.is_reversed}) == vertex && n > 2;
          found += meet && one.pcurve && two.pcurve && !one.is_slit && !two.is_slit && is_continuous(face, one, two);
        }
    }
    return found == static_cast<int>(edits_.edge(a).faces.size());
  }

  bool is_continuous(const Face& face, const Coedge& one, const Coedge& two) const {
    constexpr double apart = 0.25;  // of the period
    const Edge &a = edits_.edge(one.edge), &b = edits_.edge(two.edge);
    const Vec2 gap = two.pcurve->uv(start_parameter(b, two)) - one.pcurve->uv(end_parameter(a, one));
    const Vec2 period = face.surface->period();
    return !(period.x > 0 && std::abs(gap.x) > apart * period.x) &&
           !(period.y > 0 && std::abs(gap.y) > apart * period.y);
  }

  void join(const Joint& joint) {
    const std::vector<int>& edges = edits_.edges_at(joint.vertex);
    const int a = chain_of_[edges[0]], b = chain_of_[edges[1]];
    if (a == b) return;  // one vertex of a closed chain stays
    const double shorter = std::min(lengths_[a], lengths_[b]), limit = limits_.short_edge(edges[0]);
    if (shorter > reach(joint) * limit || shorter * joint.angle > limit * smooth_angle * M_PI / 180) return;
    Side &one = chains_[a], &two = chains_[b];
    if (edits_.start_of(one.front()) == joint.vertex && one.front().edge == edges[0]) one = reversed(one);
    if (edits_.end_of(two.back()) == joint.vertex && two.back().edge == edges[1]) two = reversed(two);
    for (const SideEdge& piece : two) chain_of_[piece.edge] = a;
    one.insert(one.end(), two.begin(), two.end());
    two.clear();
    lengths_[a] += lengths_[b];
  }

  void make(Side& chain, std::vector<Merge>& merges) {
    const SideEdge named =
        *std::ranges::max_element(chain, {}, [&](const SideEdge& piece) { return edits_.edge(piece.edge).length; });
    if (named.is_reversed) chain = reversed(chain);
    const int kept = named.edge;
    auto pieces = std::make_shared<Pieces>();
    std::vector<std::shared_ptr<const Curve>> curves;
    Edge whole = edits_.edge(kept);
    whole.start = edits_.start_of(chain.front()), whole.end = edits_.end_of(chain.back());
    whole.origins.clear();
    pieces->begin.push_back(0);
    for (const SideEdge& piece : chain) {
      const Edge& edge = edits_.edge(piece.edge);
      pieces->range.push_back(piece.is_reversed ? std::pair{edge.t1, edge.t0} : std::pair{edge.t0, edge.t1});
      pieces->begin.push_back(pieces->begin.back() + edge.length);
      curves.push_back(edge.curve);
      whole.origins.insert(whole.origins.end(), edge.origins.begin(), edge.origins.end());
      if (piece.edge != kept)
        merges.push_back(
            {MergeKind::edge, edge.name, whole.name, edge.length, edge.curve->point(0.5 * (edge.t0 + edge.t1))});
    }
    std::sort(whole.origins.begin(), whole.origins.end());
    whole.t0 = 0, whole.t1 = whole.length = pieces->begin.back();
    whole.curve = std::make_shared<ChainCurve>(pieces, curves);
    put_into_loops(chain, kept, whole, pieces);
  }

  void put_into_loops(const Side& chain, int kept, const Edge& whole, const std::shared_ptr<const Pieces>& pieces) {
    const int name = chain_of_[kept];
    for (std::size_t i = 0; i < chain.size(); ++i) place_[chain[i].edge] = static_cast<int>(i);
    struct Use {
      Loop* loop;
      Coedge coedge;
    };
    std::vector<Use> uses;
    for (int f : whole.faces)
      for (Loop& loop : edits_.face(f).loops) {
        std::vector<std::shared_ptr<const ParameterCurve>> images(chain.size());
        Coedge coedge;
        for (const Coedge& use : loop.coedges) {
          if (chain_of_[use.edge] != name) continue;
          const auto i = static_cast<std::size_t>(place_[use.edge]);
          images[i] = use.pcurve;
          coedge.is_reversed = use.is_reversed != chain[i].is_reversed;
        }
        if (!images.front()) continue;
        coedge.edge = kept;
        coedge.pcurve = image_by([pieces, images = std::move(images)](double s) {
          double t, pace;
          return images[pieces->find(s, t, pace)]->uv(t);
        });
        uses.push_back({&loop, coedge});
      }
    for (const Use& use : uses)
      for (Coedge& coedge : use.loop->coedges)
        if (coedge.edge == kept) coedge = use.coedge;
    std::vector<int> others;
    for (const SideEdge& piece : chain)
      if (piece.edge != kept) others.push_back(piece.edge);
    edits_.take_out(others);
    edits_.set(kept, whole);
  }

  ModelEdits& edits_;
  const MergeLimits& limits_;
  std::vector<Side> chains_;  // of the edge that they are known by
  std::vector<double> lengths_;
  std::vector<int> chain_of_;
  std::vector<int> place_;  // of an edge in its chain
};

}  // namespace

void join_chains(ModelEdits& edits, const MergeLimits& limits, std::vector<Merge>& merges) {
  ChainJoiner(edits, limits).run(merges);
}

}  // namespace paver
