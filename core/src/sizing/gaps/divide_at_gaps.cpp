// In: model, target length. Out: the model with edges divided.
// Steps, face by face: points along its edges; per vertex the nearest edge before it that one of the vertex's own runs
// along; the place opposite the vertex; of places that are near each other the one of the narrowest gap. Faces of
// divided edges once more: the next line beside may be as near.
#include "sizing/gaps/divide_at_gaps.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "base/boxes/box_tree.h"
#include "base/segment.h"
#include "sizing/merging/merge_limits.h"

namespace paver {
namespace {

constexpr double near = 0.2;          // target lengths: in wider gaps nodes need not face each other
constexpr double slender = 5;         // times as long as wide are gaps at least ...
constexpr double shortest = 0.3;      // ... and target lengths: so are pieces of edges
constexpr double along = 0.95;        // cosine between two edges that run along each other
constexpr double opposite = 0.9;      // cosine between the way across and that into the face
constexpr double widening = 1.5;      // of the width, as far from its end as the gap is long at least
constexpr double beside_sides = 0.2;  // radians, between the way across and the edges at the vertex
constexpr int most_rounds = 3;
constexpr int samples = 16;  // of an edge that is not straight
constexpr double straight = 1 - 1e-9;

/// An edge as its face walks it.
struct Bank {
  int edge = -1;
  bool is_reversed = false;
  const ParameterCurve* image = nullptr;
  int before = -1, after = -1;  // in the loop
  std::vector<double> t;        // rising, as the points
  std::vector<Vec3> points;
};

struct Foot {
  double distance = INFINITY, t = 0;
  double before = 0, behind = 0;  // mm, of the edge
};

struct Place {
  int edge = -1;
  double t = 0, before = 0, behind = 0, distance = 0, apart = 0;  // apart: mm, from others
};

class FaceGaps {
 public:
  FaceGaps(const ModelEdits& edits, const MergeLimits& limits, int face)
      : edits_(edits), limits_(limits), face_(edits.face(face)) {
    for (const Loop& loop : face_.loops) add(loop);
    std::vector<Box> boxes;
    for (std::size_t b = 0; b < banks_.size(); ++b)
      for (std::size_t i = 0; i + 1 < banks_[b].points.size(); ++i) {
        bank_of_.push_back(static_cast<int>(b));
        boxes.emplace_back().add(banks_[b].points[i]);
        boxes.back().add(banks_[b].points[i + 1]);
      }
    tree_ = BoxTree(std::move(boxes));
  }

  std::vector<Place> places() const {
    std::vector<Place> found;
    for (std::size_t b = 0; b < banks_.size(); ++b)
      for (const bool is_start : {true, false})
        if (const std::optional<Place> place = opposite_end(static_cast<int>(b), is_start)) found.push_back(*place);
    return found;
  }

 private:
  void add(const Loop& loop) {
    const auto first = static_cast<int>(banks_.size()), count = static_cast<int>(loop.coedges.size());
    for (int i = 0; i < count; ++i) {
      const Coedge& coedge = loop.coedges[i];
      const Edge& edge = edits_.edge(coedge.edge);
      Bank bank{coedge.edge,
                coedge.is_reversed,
                coedge.pcurve.get(),
                first + (i + count - 1) % count,
                first + (i + 1) % count,
                {},
                {}};
      if (edge.curve && coedge.pcurve && !edge.is_periodic) {
        const bool is_straight = norm(edits_.point(edge.end) - edits_.point(edge.start)) > straight * edge.length;
        for (int k = 0, n = is_straight ? 1 : samples; k <= n; ++k) {
          bank.t.push_back(edge.parameter(static_cast<double>(k) / n));
          bank.points.push_back(edge.curve->point(bank.t.back()));
        }
      }
      banks_.push_back(std::move(bank));
    }
  }

  /// Opposite the end of a bank, on the nearest other one that it runs along.
  std::optional<Place> opposite_end(int b, bool is_start) const {
    const Bank& bank = banks_[b];
    if (bank.points.empty()) return std::nullopt;
    const int next = is_start ? bank.before : bank.after;
    if (banks_[next].points.empty()) return std::nullopt;
    const double h = limits_.length(bank.edge), length = edits_.edge(bank.edge).length;
    if (length < shortest * h) return std::nullopt;
    const Vec3 x = end_of(bank, is_start);
    std::set<int> others;
    Box about;
    about.add(x);
    tree_.each_meeting(about.grown(near * h), [&](int i) { others.insert(bank_of_[i]); });
    std::optional<Place> best;
    for (const int o : others) {
      const Bank& other = banks_[o];
      if (other.edge == bank.edge || other.edge == banks_[next].edge) continue;
      const Foot foot = foot_on(other, x);
      if (foot.distance >= near * h || (best && foot.distance >= best->distance)) continue;
      const double least = std::max(slender * foot.distance, shortest * h);
      if (length < least || foot.before < shortest * h || foot.behind < shortest * h) continue;
      if (!is_gap(b, is_start, other, foot, least)) continue;
      best = Place{other.edge, foot.t, foot.before, foot.behind, foot.distance, shortest * h};
    }
    return best;
  }

  Vec3 end_of(const Bank& bank, bool is_start) const {
    return is_start != bank.is_reversed ? bank.points.front() : bank.points.back();
  }

  /// As the bank leaves its end, of length one.
  Vec3 way_from(const Bank& bank, bool is_start) const {
    return direction_out(edits_.edge(bank.edge), is_start == bank.is_reversed);
  }

  Foot foot_on(const Bank& bank, Vec3 x) const {
    Foot foot;
    double upto = 0, total = 0;
    for (std::size_t i = 0; i + 1 < bank.points.size(); ++i) {
      const Vec3 a = bank.points[i], b = bank.points[i + 1];
      const double share = nearest_share(x, a, b), here = norm(x - a - share * (b - a));
      if (here < foot.distance)
        foot.distance = here, foot.t = (1 - share) * bank.t[i] + share * bank.t[i + 1],
        upto = total + share * norm(b - a);
      total += norm(b - a);
    }
    if (!(total > 0)) return {};
    const Curve& curve = *edits_.edge(bank.edge).curve;
    for (int step = 0; step < 4 && bank.points.size() > 2; ++step) {
      const auto [at, slope] = curve.slope(foot.t);
      foot.t = std::clamp(foot.t + dot(x - at, slope) / dot(slope, slope), bank.t.front(), bank.t.back());
    }
    const double scale = edits_.edge(bank.edge).length / total;
    foot.distance = norm(x - curve.point(foot.t));
    foot.before = scale * upto, foot.behind = scale * (total - upto);
    return foot;
  }

  /// Whether what lies between the end of a bank and the foot is a gap of the face that goes on for `least` mm.
  bool is_gap(int b, bool is_start, const Bank& other, const Foot& foot, double least) const {
    const Bank& bank = banks_[b];
    const Vec3 x = end_of(bank, is_start), way = way_from(bank, is_start);
    const auto [at, slope] = edits_.edge(other.edge).curve->slope(foot.t);
    const Vec3 across = unit(at - x), tangent = unit(slope);
    const double cosine = dot(way, tangent);
    if (!(foot.distance > 0) || std::fabs(cosine) < along || (cosine > 0 ? foot.behind : foot.before) < least)
      return false;
    if (-dot(across, unit(inward(other, foot.t))) < opposite || !lies_in_face(b, is_start, across)) return false;
    const Edge& edge = edits_.edge(bank.edge);
    const double share = std::min(1.0, least / edge.length);
    const Vec3 farther = edge.curve->point(edge.parameter(is_start != bank.is_reversed ? share : 1 - share));
    return foot_on(other, farther).distance < widening * foot.distance;
  }

  /// Left of the bank at a parameter.
  Vec3 inward(const Bank& bank, double t) const {
    const auto [at, xu, xv] = face_.surface->slope(bank.image->uv(t));
    return (bank.is_reversed ? -1 : 1) * cross(cross(xu, xv), edits_.edge(bank.edge).curve->slope(t).t);
  }

  /// Whether a way from the end of a bank leads between that and the next one.
  bool lies_in_face(int b, bool is_start, Vec3 way) const {
    const Bank &bank = banks_[b], &next = banks_[is_start ? bank.before : bank.after];
    const Bank &after = is_start ? bank : next, &before = is_start ? next : bank;
    const Edge& edge = edits_.edge(after.edge);
    const auto [at, xu, xv] = face_.surface->slope(after.image->uv(after.is_reversed ? edge.t1 : edge.t0));
    const Vec3 normal = unit(cross(xu, xv)), first = way_from(after, true), last = way_from(before, false);
    const auto angle_to = [&](Vec3 v) {
      const double angle = std::atan2(dot(cross(first, v), normal), dot(first, v));
      return angle > 0 ? angle : angle + 2 * M_PI;
    };
    return angle_to(way) > beside_sides && angle_to(way) < angle_to(last) - beside_sides;
  }

  const ModelEdits& edits_;
  const MergeLimits& limits_;
  const Face& face_;
  std::vector<Bank> banks_;
  std::vector<int> bank_of_;  // per box
  BoxTree tree_;
};

bool may_have_gaps(const Face& face) { return face.is_meshed() && face.surface && !face.loops.empty(); }

class GapDivider {
 public:
  GapDivider(Model& model, const Options& options) : edits_(model), limits_(edits_, options, lasting_) {}

  void run() {
    std::set<int> open;
    for (std::size_t f = 0; f < edits_.model().faces.size(); ++f) open.insert(static_cast<int>(f));
    for (int round = 0; round < most_rounds && !open.empty(); ++round) {
      std::vector<Place> places;
      for (const int f : open)
        if (may_have_gaps(edits_.face(f)))
          std::ranges::move(FaceGaps(edits_, limits_, f).places(), std::back_inserter(places));
      open = divide(std::move(places));
    }
  }

 private:
  /// Narrowest gaps first; gives the faces of what was divided.
  std::set<int> divide(std::vector<Place> places) {
    std::ranges::stable_sort(places, {}, &Place::distance);
    std::map<int, std::vector<Place>> of_edges;
    for (const Place& place : places) {
      std::vector<Place>& taken = of_edges[place.edge];
      auto is_near = [&](const Place& other) { return std::fabs(other.before - place.before) < place.apart; };
      if (!limits_.has_own_length(place.edge) && std::ranges::none_of(taken, is_near)) taken.push_back(place);
    }
    std::set<int> faces;
    for (auto& [edge, taken] : of_edges) {
      if (taken.empty()) continue;
      faces.insert(edits_.edge(edge).faces.begin(), edits_.edge(edge).faces.end());
      // From its end on, as the edge keeps what lies before a place.
      std::ranges::sort(taken, std::ranges::greater(), &Place::t);
      for (const Place& place : taken) {
        const double length = edits_.edge(edge).length;
        const int behind = edits_.split(edge, place.t);
        edits_.edge(edge).length = place.before;
        edits_.edge(behind).length = length - place.before;
      }
    }
    return faces;
  }

  ModelEdits edits_;
  std::vector<int> lasting_;
  MergeLimits limits_;
};

}  // namespace

void divide_at_gaps(Model& model, const Options& options) { GapDivider(model, options).run(); }

}  // namespace paver
