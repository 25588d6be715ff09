#include "sizing/merging/side_match.h"

#include <algorithm>
#include <cmath>

#include "base/cells.h"

namespace paver {
namespace {

constexpr int steps = 24;       // per edge, where distances are taken
constexpr int match_rows = 64;  // per edge

double parameter(const Edge& edge, bool is_reversed, double share) {
  return is_reversed ? edge.t1 + share * (edge.t0 - edge.t1) : edge.t0 + share * (edge.t1 - edge.t0);
}

double one_way(const ModelEdits& edits, const Side& from, const Side& to) {
  const SideCurve a(edits, from), b(edits, to);
  double most = 0;
  for (std::size_t i = 0; i < from.size(); ++i)
    for (int k = 0; k <= steps; ++k) {
      const double within = static_cast<double>(k) / steps, share = (1 - within) * a.begin(i) + within * a.begin(i + 1);
      const Vec3 x = a.point(a.at(share));
      most = std::max(most, norm(x - b.point(b.nearest(x, 0, 1))));
    }
  return most;
}

}  // namespace

SideCurve::SideCurve(const ModelEdits& edits, const Side& side) : edits_(edits), side_(side) {
  begins_.push_back(0);
  for (const SideEdge& edge : side) begins_.push_back(length_ += edits.edge(edge.edge).length);
  for (double& begin : begins_) begin = length_ > 0 ? begin / length_ : 0;
  begins_.back() = 1;
}

SidePlace SideCurve::at(double share) const {
  const std::size_t i = cell_of(begins_, share);
  const double step = begins_[i + 1] - begins_[i], within = step > 0 ? (share - begins_[i]) / step : 0;
  return {i, parameter(edits_.edge(side_[i].edge), side_[i].is_reversed, std::clamp(within, 0.0, 1.0)), share};
}

Vec3 SideCurve::point(const SidePlace& place) const { return edits_.edge(side_[place.at].edge).curve->point(place.t); }

SidePlace SideCurve::nearest(Vec3 x, double from, double to) const {
  const auto distance = [&](double share) { return norm(point(at(share)) - x); };
  const int count = steps * static_cast<int>(side_.size());
  double best = from, least = distance(from);
  const double step = (to - from) / count;
  for (int i = 1; i <= count; ++i)
    if (const double here = distance(from + i * step); here < least) least = here, best = from + i * step;
  // Golden section between the neighbours of the nearest sample.
  constexpr double golden = 0.6180339887498949;
  double lo = std::max(from, best - step), hi = std::min(to, best + step);
  for (int i = 0; i < 30; ++i) {
    const double a = hi - golden * (hi - lo), b = lo + golden * (hi - lo);
    (distance(a) < distance(b) ? hi : lo) = distance(a) < distance(b) ? b : a;
  }
  const double middle = 0.5 * (lo + hi);
  return at(distance(middle) < least ? middle : best);
}

double distance_between(const ModelEdits& edits, const Side& one, const Side& two) {
  return std::max(one_way(edits, one, two), one_way(edits, two, one));
}

double tilt_between(const ModelEdits& edits, const Side& one, const Side& two) {
  const auto area_about = [&](const Side& side) {
    constexpr int chords = 32;
    const SideCurve curve(edits, side);
    const Vec3 start = curve.point(curve.at(0));
    Vec3 area, last;
    for (int i = 1; i < chords; ++i) {
      const Vec3 next = curve.point(curve.at(static_cast<double>(i) / chords)) - start;
      area += cross(last, next);
      last = next;
    }
    return area;
  };
  return angle_between(area_about(one), area_about(two));
}

namespace {

/// Where edges of a side have to be divided; vertices of the other side that have one opposite are none.
std::optional<std::vector<SidePlace>> cuts_for(const ModelEdits& edits, const Side& vertices, const Side& cut,
                                               double most) {
  const SideCurve a(edits, vertices), b(edits, cut);
  std::vector<SidePlace> cuts;
  double last = 0;
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    const Vec3 x = a.point(a.at(a.begin(i)));
    const SidePlace place = b.nearest(x, 0, 1);
    if (norm(b.point(place) - x) > most) return std::nullopt;
    bool has_vertex = false;
    for (std::size_t k = 1; k < cut.size(); ++k) has_vertex = has_vertex || norm(b.point(b.at(b.begin(k))) - x) <= most;
    if (has_vertex) continue;
    const double margin = most / b.length();
    if (place.share <= last + margin || place.share >= 1 - margin) return std::nullopt;
    cuts.push_back(place);
    last = place.share;
  }
  return cuts;
}

void divide(ModelEdits& edits, Side& side, const std::vector<SidePlace>& cuts) {
  for (std::size_t i = cuts.size(); i-- > 0;) {
    const SideEdge whole = side[cuts[i].at];
    const int behind = edits.split(whole.edge, cuts[i].t);
    SideEdge other{behind, whole.is_reversed};
    side.insert(side.begin() + static_cast<std::ptrdiff_t>(cuts[i].at + (whole.is_reversed ? 0 : 1)), other);
  }
}

}  // namespace

bool divide_alike(ModelEdits& edits, Side& one, Side& two, double most) {
  const auto of_two = cuts_for(edits, one, two, most), of_one = cuts_for(edits, two, one, most);
  if (!of_one || !of_two || one.size() + of_one->size() != two.size() + of_two->size()) return false;
  divide(edits, one, *of_one);
  divide(edits, two, *of_two);
  return true;
}

std::shared_ptr<const ParameterMatch> match_edges(const Edge& one, const Edge& two, bool is_against) {
  std::vector<double> from, to;
  const auto other = [&](double share) { return parameter(two, is_against, share); };
  double before = 0;
  for (int i = 0; i <= match_rows; ++i) {
    const double share = static_cast<double>(i) / match_rows, step = 0.5 / match_rows;
    const Vec3 x = one.curve->point(parameter(one, false, share));
    double best = share, least = norm(two.curve->point(other(share)) - x);
    for (double reach = 8 * step; i > 0 && i < match_rows && reach > 1e-4 * step; reach *= 0.5)
      for (double next : {best - reach, best + reach}) {
        next = std::clamp(next, before, 1.0);
        const double here = norm(two.curve->point(other(next)) - x);
        if (here < least) least = here, best = next;
      }
    before = best = i == match_rows ? 1 : std::max(best, before);
    from.push_back(parameter(one, false, share));
    to.push_back(other(best));
  }
  return std::make_shared<ParameterMatch>(std::move(from), std::move(to));
}

}  // namespace paver
