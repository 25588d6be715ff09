// 1. Rows across the face are sampled where they turn: the turn of the normal and the length so far.
// 2. A ridge of a row is what turns by a right angle and more within ridge_share of its length; the middle half of the
//    turn is where the ridge may be cut.
// 3. A ridge is followed from row to row. Where the middle halves have an iso-line in common that is the line, else a
//    curve through the middles on as many rows as it needs.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>

#include "brep/mending/find_ridges_impl.h"

namespace paver {
namespace {

constexpr double right_angle = std::numbers::pi / 2;
/// Of a row's length: within that a ridge turns by a right angle. What is rounder keeps its elements.
constexpr double ridge_share = 0.02;
constexpr int first_samples = 32;
constexpr double step_turn = std::numbers::pi / 18;
/// Of the turn: normals at its ends differ by that where it goes one way.
constexpr double one_way_share = 0.9;
constexpr int most_halvings = 24;
/// Of a row's length: ends that lie nearer to each other are one.
constexpr double closed_share = 1e-6;
/// Of the range between two rows a line is looked for on so many halves at most.
constexpr int line_halvings = 5;
/// Of a row's length, and of the narrowest elements: nearer to a vertex a line ends there.
constexpr double near_share = 2e-3, near_share_of_elements = 0.1;

struct Sample {
  double at = 0;
  gp_Pnt point;
  gp_Dir normal;
  double length = 0, turn = 0;  ///< from the row's start
};

struct Ridge {
  double from = 0, to = 0;
  double low = 0, middle = 0, high = 0;  ///< a quarter, half, and three quarters of the turn
  double width = 0;                      ///< the shortest piece of the row that turns by a right angle, mm
  bool at_start = false, at_end = false;
  bool is_one_way = true;  ///< it does not turn to and fro, as rows of surfaces that fold do
};

class Row {
 public:
  Row(const BRepAdaptor_Surface& surface, bool is_u, double other) : surface_(surface), is_u_(is_u), other_(other) {
    const double first = is_u ? surface.FirstUParameter() : surface.FirstVParameter();
    const double last = is_u ? surface.LastUParameter() : surface.LastVParameter();
    for (int i = 0; i <= first_samples; ++i)
      if (const auto next = sample(first + (last - first) * i / first_samples)) reach(*next, most_halvings);
  }

  std::vector<Ridge> ridges() const {
    std::vector<Ridge> found;
    if (samples_.size() < 2) return found;
    const double widest = ridge_share * samples_.back().length;
    std::size_t end = 0;
    std::size_t low = 0, high = 0;  // of the ridge that is being walked
    double width = 0;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      while (end < samples_.size() && samples_[end].turn - samples_[i].turn < right_angle) ++end;
      if (end == samples_.size()) break;
      const double length = samples_[end].length - samples_[i].length;
      if (length > widest) continue;
      if (high > i) {
        width = std::min(width, length);
      } else {
        if (high > 0) found.push_back(ridge(low, high, width));
        low = i, width = length;
      }
      high = end;
    }
    if (high > 0) found.push_back(ridge(low, high, width));
    return found;
  }

  double length() const { return samples_.empty() ? 0 : samples_.back().length; }

  bool is_closed() const {
    return samples_.size() > 1 &&
           samples_.front().point.Distance(samples_.back().point) <= closed_share * samples_.back().length;
  }

 private:
  /// Nothing at poles.
  std::optional<Sample> sample(double at) const {
    Sample result;
    gp_Vec xu, xv;
    surface_.D1(is_u_ ? at : other_, is_u_ ? other_ : at, result.point, xu, xv);
    const gp_Vec across = xu.Crossed(xv);
    if (!(across.SquareMagnitude() > gp::Resolution())) return std::nullopt;
    result.at = at;
    result.normal = gp_Dir(across);
    return result;
  }

  /// Takes samples up to `next`, so many that it turns little from one to the next.
  void reach(Sample next, int halvings) {
    if (samples_.empty()) {
      samples_.push_back(next);
      return;
    }
    const Sample last = samples_.back();
    const double turn = last.normal.Angle(next.normal);
    if (turn > step_turn && halvings > 0) {
      if (const auto middle = sample(0.5 * (last.at + next.at))) {
        reach(*middle, halvings - 1);
        reach(next, halvings - 1);
        return;
      }
    }
    next.length = last.length + last.point.Distance(next.point);
    next.turn = last.turn + turn;
    samples_.push_back(next);
  }

  Ridge ridge(std::size_t low, std::size_t high, double width) const {
    const double first = samples_[low].turn, turn = samples_[high].turn - first;
    return {samples_[low].at,
            samples_[high].at,
            at_turn(first + 0.25 * turn),
            at_turn(first + 0.5 * turn),
            at_turn(first + 0.75 * turn),
            width,
            low == 0,
            high + 1 == samples_.size(),
            samples_[low].normal.Angle(samples_[high].normal) >= one_way_share * turn};
  }

  /// Between the row's ends.
  double at_turn(double turn) const {
    const auto after = std::ranges::upper_bound(samples_, turn, {}, &Sample::turn), before = std::prev(after);
    return std::lerp(before->at, after->at, (turn - before->turn) / (after->turn - before->turn));
  }

  const BRepAdaptor_Surface& surface_;
  bool is_u_;
  double other_;
  std::vector<Sample> samples_;
};

/// The rows of a face in one direction, each sampled when it is first asked for.
class Rows {
 public:
  Rows(const BRepAdaptor_Surface& surface, bool is_u) : surface_(surface), is_u_(is_u) {}

  double first() const { return is_u_ ? surface_.FirstVParameter() : surface_.FirstUParameter(); }
  double last() const { return is_u_ ? surface_.LastVParameter() : surface_.LastUParameter(); }
  double at(double share) const { return std::lerp(first(), last(), share); }
  /// Those looked at, but for the ends.
  bool are_closed() const {
    return std::ranges::all_of(
        known_, [&](const auto& row) { return row.second.is_closed || row.first == first() || row.first == last(); });
  }

  const std::vector<Ridge>& ridges(double at) {
    const auto known = known_.find(at);
    if (known != known_.end()) return known->second.ridges;
    const Row row(surface_, is_u_, at);
    return known_.insert({at, {row.ridges(), row.length(), row.is_closed()}}).first->second.ridges;
  }

  /// Of one that has been asked for.
  double length(double at) const { return known_.at(at).length; }

  /// The same ridge on another row; where it lies far aside, by way of rows between.
  std::optional<Ridge> follow(const Ridge& ridge, double from, double to, int halvings) {
    std::optional<Ridge> nearest;
    for (const Ridge& other : ridges(to)) {
      if (other.at_start != ridge.at_start || other.at_end != ridge.at_end) continue;
      if (other.from > ridge.to || other.to < ridge.from) continue;
      if (!nearest || std::abs(other.middle - ridge.middle) < std::abs(nearest->middle - ridge.middle)) nearest = other;
    }
    if (nearest || halvings == 0) return nearest;
    const double middle = std::midpoint(from, to);
    const std::optional<Ridge> between = follow(ridge, from, middle, halvings - 1);
    return between ? follow(*between, middle, to, halvings - 1) : std::nullopt;
  }

 private:
  struct Known {
    std::vector<Ridge> ridges;
    double length = 0;
    bool is_closed = false;
  };
  const BRepAdaptor_Surface& surface_;
  bool is_u_;
  std::map<double, Known> known_;
};

/// One ridge on all rows.
class Line {
 public:
  /// From the row in the middle on; not complete where a row does not have it.
  Line(Rows& rows, const Ridge& ridge) : rows_(rows) {
    ridges_[rows.at(0.5)] = ridge;
    is_complete_ = step(0.5, 0.25) && step(0.25, 0.03) && step(0.5, 0.75) && step(0.75, 0.97);
    if (is_complete_) step(0.03, 0), step(0.97, 1);  // at poles there is none
  }

  bool is_complete() const { return is_complete_; }
  bool is_at_end() const { return ridges_.begin()->second.at_start || ridges_.begin()->second.at_end; }

  double width() const {
    return std::ranges::min_element(ridges_, {}, [](const auto& row) { return row.second.width; })->second.width;
  }

  bool holds(double place) const {
    return std::ranges::any_of(ridges_, [&](const auto& row) { return place >= row.second.from; }) &&
           std::ranges::any_of(ridges_, [&](const auto& row) { return place <= row.second.to; });
  }

  /// The iso-line in the middle halves of all rows' turns, if there is one: through a place of `preferred` where one
  /// lies in them.
  std::optional<double> iso_line(const std::vector<double>& preferred) const {
    double low = ridges_.begin()->second.low, high = ridges_.begin()->second.high;
    for (const auto& [at, ridge] : ridges_) low = std::max(low, ridge.low), high = std::min(high, ridge.high);
    if (low > high) return std::nullopt;
    const double middle = std::clamp(ridges_.at(rows_.at(0.5)).middle, low, high);
    double best = middle;
    for (const double place : preferred)
      if (place >= low && place <= high && (best == middle || std::abs(place - middle) < std::abs(best - middle)))
        best = place;
    return best;
  }

  /// Its middle on so many rows that between them it stays in the middle half of the turn. Empty where it gets lost or
  /// folds.
  std::map<double, double> places() {
    ridges_.insert({rows_.first(), ridges_.begin()->second});
    ridges_.insert({rows_.last(), ridges_.rbegin()->second});
    if (!std::ranges::all_of(ridges_, [](const auto& row) { return row.second.is_one_way; })) return {};
    const std::map<double, Ridge> coarse = ridges_;
    for (auto low = coarse.begin(), high = std::next(low); high != coarse.end(); ++low, ++high)
      if (!refine(*low, *high, line_halvings)) return {};
    std::map<double, double> result;
    for (const auto& [at, ridge] : ridges_) result[at] = ridge.middle;
    return result;
  }

 private:
  using Place = std::pair<const double, Ridge>;

  bool step(double from, double to) {
    const double near = rows_.at(from), at = rows_.at(to);
    const auto found = rows_.follow(ridges_.at(near), near, at, line_halvings);
    if (found) ridges_[at] = *found;
    return found.has_value();
  }

  bool refine(const Place& low, const Place& high, int halvings) {
    const double at = std::midpoint(low.first, high.first);
    const auto found = rows_.follow(low.second, low.first, at, halvings);
    if (!found || !found->is_one_way) return false;
    const double straight = std::midpoint(low.second.middle, high.second.middle);
    if (straight >= found->low && straight <= found->high) return true;
    if (halvings == 0) return false;
    const Place middle{at, *found};
    ridges_.insert(middle);
    return refine(low, middle, halvings - 1) && refine(middle, high, halvings - 1);
  }

  Rows& rows_;
  std::map<double, Ridge> ridges_;
  bool is_complete_ = false;
};

}  // namespace

Ridges find_ridges(const BRepAdaptor_Surface& surface, bool is_u, double unresolved, const std::vector<double>& creases,
                   const std::vector<double>& preferred) {
  Rows rows(surface, is_u);
  Ridges result;
  for (const Ridge& ridge : rows.ridges(rows.at(0.5))) {
    Line line(rows, ridge);
    auto is_within = [&](double crease) { return line.holds(crease); };
    if (!line.is_complete() || line.width() > unresolved || std::ranges::any_of(creases, is_within)) continue;
    if (line.is_at_end()) {
      result.at_ends |= rows.are_closed();
    } else if (const auto iso_line = line.iso_line(preferred)) {
      result.iso_lines.push_back(*iso_line);
    } else if (const auto places = line.places(); !places.empty()) {
      result.curves.push_back(
          {places, std::min(near_share * rows.length(rows.at(0.5)), near_share_of_elements * unresolved)});
    }
  }
  return result;
}

}  // namespace paver
