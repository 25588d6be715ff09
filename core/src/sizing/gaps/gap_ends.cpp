// In: banks of a face, limits. Out: places.
// Steps: per end of a bank the nearest bank before it that it runs along; the place opposite that end.
#include <algorithm>
#include <cmath>
#include <optional>

#include "sizing/gaps/gap_places.h"

namespace paver {
namespace {

constexpr double near = 0.2;          // target lengths: in wider gaps nodes need not face each other
constexpr double nearest = 0.05;      // the same: chords would cross unless they do, however the gap widens
constexpr double shortest = 0.3;      // the same: gaps, and pieces of edges, but where they are nearest
constexpr double along = 0.95;        // cosine between two edges that run along each other
constexpr double beside_sides = 0.2;  // radians, between the way across and the edges at the vertex

class GapEnds {
 public:
  GapEnds(const FaceBanks& faced, const MergeLimits& limits) : faced_(faced), limits_(limits) {}

  /// Opposite the end of a bank, on the nearest other one that it runs along.
  std::optional<GapPlace> opposite_end(int b, bool is_start) const {
    const Bank& bank = faced_[b];
    if (bank.points.empty()) return std::nullopt;
    const int next = is_start ? bank.before : bank.after;
    if (faced_[next].points.empty()) return std::nullopt;
    const double h = limits_.length(bank.edge), length = faced_.edge(bank).length;
    const Vec3 x = end_of(bank, is_start);
    Box about;
    about.add(x);
    std::optional<GapPlace> best;
    for (const int o : faced_.meeting(about.grown(std::min(near * h, length / gap_slenderness)))) {
      const Bank& other = faced_[o];
      if (other.edge == bank.edge || other.edge == faced_[next].edge) continue;
      const BankFoot foot = faced_.foot_on(other, x);
      if (foot.distance >= near * h || (best && foot.distance >= best->distance)) continue;
      // Where both meet, a cusp, elements as long as the length fit into its point best.
      const bool is_nearest = foot.distance < nearest * h && !faced_.meet(bank, other);
      const double piece = (is_nearest ? nearest : shortest) * h;
      const double least = std::max(gap_slenderness * foot.distance, piece);
      if (length < least || foot.before < piece || foot.behind < piece) continue;
      if (!is_gap(b, is_start, other, foot, least)) continue;
      best = GapPlace{other.edge, foot.t, foot.before, foot.behind, foot.distance, piece};
    }
    return best;
  }

 private:
  Vec3 end_of(const Bank& bank, bool is_start) const {
    return is_start != bank.is_reversed ? bank.points.front() : bank.points.back();
  }

  /// As the bank leaves its end, of length one.
  Vec3 way_from(const Bank& bank, bool is_start) const {
    return direction_out(faced_.edge(bank), is_start == bank.is_reversed);
  }

  /// Whether what lies between the end of a bank and the foot is a gap of the face that goes on for `least` mm.
  bool is_gap(int b, bool is_start, const Bank& other, const BankFoot& foot, double least) const {
    const Bank& bank = faced_[b];
    const Vec3 x = end_of(bank, is_start), way = way_from(bank, is_start);
    const auto [at, slope] = faced_.edge(other).curve->slope(foot.t);
    const Vec3 across = unit(at - x), tangent = unit(slope);
    const double cosine = dot(way, tangent);
    if (!(foot.distance > 0) || std::fabs(cosine) < along || (cosine > 0 ? foot.behind : foot.before) < least)
      return false;
    if (-dot(across, unit(faced_.inward(other, foot.t))) < straight_across || !lies_in_face(b, is_start, across))
      return false;
    if (foot.distance < nearest * limits_.length(bank.edge)) return true;
    const Edge& edge = faced_.edge(bank);
    const double share = std::min(1.0, least / edge.length);
    const Vec3 farther = edge.curve->point(edge.parameter(is_start != bank.is_reversed ? share : 1 - share));
    return faced_.foot_on(other, farther).distance < most_widening * foot.distance;
  }

  /// Whether a way from the end of a bank leads between that and the next one.
  bool lies_in_face(int b, bool is_start, Vec3 way) const {
    const Bank &bank = faced_[b], &next = faced_[is_start ? bank.before : bank.after];
    const Bank &after = is_start ? bank : next, &before = is_start ? next : bank;
    const Edge& edge = faced_.edge(after);
    const auto [at, xu, xv] = faced_.surface().slope(after.image->uv(after.is_reversed ? edge.t1 : edge.t0));
    const Vec3 normal = unit(cross(xu, xv)), first = way_from(after, true), last = way_from(before, false);
    const auto angle_to = [&](Vec3 v) {
      const double angle = std::atan2(dot(cross(first, v), normal), dot(first, v));
      return angle > 0 ? angle : angle + 2 * M_PI;
    };
    return angle_to(way) > beside_sides && angle_to(way) < angle_to(last) - beside_sides;
  }

  const FaceBanks& faced_;
  const MergeLimits& limits_;
};

}  // namespace

void find_gap_ends(const FaceBanks& banks, const MergeLimits& limits, std::vector<GapPlace>& found) {
  const GapEnds ends(banks, limits);
  for (int b = 0; b < banks.size(); ++b)
    for (const bool is_start : {true, false})
      if (const std::optional<GapPlace> place = ends.opposite_end(b, is_start)) found.push_back(*place);
}

}  // namespace paver
