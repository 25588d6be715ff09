#include "sizing/merging/side_match.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "base/cells.h"
#include "base/search/golden_section.h"

namespace paver {
namespace {

constexpr int steps = 24;       // per edge, where distances are taken
constexpr int match_rows = 64;  // per edge

double parameter(const Edge& edge, bool is_reversed, double share) {
  return is_reversed ? edge.t1 + share * (edge.t0 - edge.t1) : edge.t0 + share * (edge.t1 - edge.t0);
}

/// A place on a side: one of its edges, and the edge's parameter.
struct SidePlace {
  std::size_t at = 0;
  double t = 0;
  double share = 0;  // of the side's length
};

/// Points along a side.
class SideCurve {
 public:
  SideCurve(const ModelEdits& edits, const Side& side) : edits_(edits), side_(side) {
    begins_.push_back(0);
    for (const SideEdge& edge : side) begins_.push_back(length_ += edits.edge(edge.edge).length);
    for (double& begin : begins_) begin = length_ > 0 ? begin / length_ : 0;
    begins_.back() = 1;
  }

  double length() const { return length_; }

  /// Share of the vertex before edge i.
  double begin(std::size_t i) const { return begins_[i]; }

  /// At a share of the length, as the edges' parameters go.
  SidePlace at(double share) const {
    const std::size_t i = cell_of(begins_, share);
    const double step = begins_[i + 1] - begins_[i], within = step > 0 ? (share - begins_[i]) / step : 0;
    return {i, parameter(edits_.edge(side_[i].edge), side_[i].is_reversed, std::clamp(within, 0.0, 1.0)), share};
  }

  Vec3 point(const SidePlace& place) const { return edits_.edge(side_[place.at].edge).curve->point(place.t); }
  Vec3 point(double share) const { return point(at(share)); }

  /// Nearest to x.
  SidePlace nearest(Vec3 x) const { return nearest(x, nearest_sample(x)); }

  /// Of x; where it is less than `enough` any such number.
  double distance(Vec3 x, double enough) const {
    const Sample sample = nearest_sample(x);
    return sample.distance <= enough ? sample.distance : norm(point(nearest(x, sample)) - x);
  }

 private:
  struct Sample {
    std::size_t index = 0;
    double distance = 0;
  };

  /// At equal shares, made when first asked for.
  const std::vector<Vec3>& samples() const {
    const int count = samples_.empty() ? steps * static_cast<int>(side_.size()) : -1;
    for (int i = 0; i <= count; ++i) samples_.push_back(point(static_cast<double>(i) / count));
    return samples_;
  }

  Sample nearest_sample(Vec3 x) const {
    Sample best{0, INFINITY};
    for (std::size_t i = 0; i < samples().size(); ++i)
      if (const double here = norm(samples_[i] - x); here < best.distance) best = {i, here};
    return best;
  }

  /// Golden section between the neighbours of the nearest sample.
  SidePlace nearest(Vec3 x, const Sample& sample) const {
    constexpr int rounds = 30;
    const auto distance_at = [&](double share) { return norm(point(share) - x); };
    const double step = 1.0 / static_cast<double>(samples().size() - 1),
                 best = static_cast<double>(sample.index) * step;
    const double middle =
        golden_section(std::max(0.0, best - step), std::min(1.0, best + step), rounds, distance_at).middle();
    return at(distance_at(middle) < sample.distance ? middle : best);
  }

  const ModelEdits& edits_;
  const Side& side_;
  std::vector<double> begins_;  // one more than edges
  double length_ = 0;
  mutable std::vector<Vec3> samples_;
};

/// Largest distance from `most` on of points of a side from the other one; of those beyond `limit` one.
double one_way(const ModelEdits& edits, const Side& from, const Side& to, double most, double limit) {
  const SideCurve a(edits, from), b(edits, to);
  for (std::size_t i = 0; i < from.size(); ++i)
    for (int k = 0; k <= steps && most <= limit; ++k) {
      const double within = static_cast<double>(k) / steps, share = (1 - within) * a.begin(i) + within * a.begin(i + 1);
      most = std::max(most, b.distance(a.point(share), most));
    }
  return most;
}

/// Where edges of a side have to be divided; vertices of the other side that have one opposite are none.
std::optional<std::vector<SidePlace>> cuts_for(const ModelEdits& edits, const Side& vertices, const Side& cut,
                                               double most) {
  const SideCurve a(edits, vertices), b(edits, cut);
  std::vector<SidePlace> cuts;
  double last = 0;
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    const Vec3 x = a.point(a.begin(i));
    const SidePlace place = b.nearest(x);
    if (norm(b.point(place) - x) > most) return std::nullopt;
    bool has_vertex = false;
    for (std::size_t k = 1; k < cut.size(); ++k) has_vertex = has_vertex || norm(b.point(b.begin(k)) - x) <= most;
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
    const SideEdge other{edits.split(whole.edge, cuts[i].t), whole.is_reversed};
    side.insert(side.begin() + static_cast<std::ptrdiff_t>(cuts[i].at + (whole.is_reversed ? 0 : 1)), other);
  }
}

}  // namespace

double distance_between(const ModelEdits& edits, const Side& one, const Side& two, double limit) {
  return one_way(edits, two, one, one_way(edits, one, two, 0, limit), limit);
}

double tilt_between(const ModelEdits& edits, const Side& one, const Side& two) {
  const auto area_about = [&](const Side& side) {
    constexpr int chords = 32;
    const SideCurve curve(edits, side);
    const Vec3 start = curve.point(0.0);
    Vec3 area, last;
    for (int i = 1; i < chords; ++i) {
      const Vec3 next = curve.point(static_cast<double>(i) / chords) - start;
      area += cross(last, next);
      last = next;
    }
    return area;
  };
  return angle_between(area_about(one), area_about(two));
}

bool divide_alike(ModelEdits& edits, Side& one, Side& two, double most) {
  const auto of_two = cuts_for(edits, one, two, most), of_one = cuts_for(edits, two, one, most);
  if (!of_one || !of_two || one.size() + of_one->size() != two.size() + of_two->size()) return false;
  divide(edits, one, *of_one);
  divide(edits, two, *of_two);
  return true;
}

ParameterMatch match_edges(const Edge& one, const Edge& two, bool is_against) {
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
  return {std::move(from), std::move(to)};
}

}  // namespace paver
