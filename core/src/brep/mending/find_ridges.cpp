// 1. Rows across the face are sampled where they turn: the turn of the normal and the length so far.
// 2. A ridge of a row is what turns by a right angle and more within ridge_share of its length; the middle half of the
//    turn is where the ridge may be cut.
// 3. Ridges whose middle halves have a line in common on all rows are one.
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>

#include "brep/mending/find_ridges_impl.h"

namespace paver {
namespace {

constexpr double right_angle = std::numbers::pi / 2;
/// Of a row's length: within that a ridge turns by a right angle. What is rounder keeps its elements.
constexpr double ridge_share = 0.02;
/// Where rows lie, as shares of the range: near both ends, where blades are thinnest, and in between.
constexpr std::array rows = {0.5, 0.03, 0.25, 0.75, 0.97};
constexpr int first_samples = 32;
constexpr double step_turn = std::numbers::pi / 18;
constexpr int most_halvings = 24;
/// Of a row's length: ends that lie nearer to each other are one.
constexpr double closed_share = 1e-6;

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
            high + 1 == samples_.size()};
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

bool is_common(Ridge& ridge, const std::vector<Ridge>& others) {
  for (const Ridge& other : others) {
    if (other.at_start != ridge.at_start || other.at_end != ridge.at_end) continue;
    const double low = std::max(ridge.low, other.low), high = std::min(ridge.high, other.high);
    if (low > high && !ridge.at_start && !ridge.at_end) continue;
    ridge.from = std::min(ridge.from, other.from), ridge.to = std::max(ridge.to, other.to);
    ridge.low = low, ridge.high = high, ridge.width = std::min(ridge.width, other.width);
    return true;
  }
  return false;
}

double cut_at(const Ridge& ridge, const std::vector<double>& preferred) {
  const double middle = std::clamp(ridge.middle, ridge.low, ridge.high);
  double best = middle;
  for (const double place : preferred)
    if (place >= ridge.low && place <= ridge.high &&
        (best == middle || std::abs(place - middle) < std::abs(best - middle)))
      best = place;
  return best;
}

}  // namespace

Ridges find_ridges(const BRepAdaptor_Surface& surface, bool is_u, double unresolved, const std::vector<double>& creases,
                   const std::vector<double>& preferred) {
  const double start = is_u ? surface.FirstVParameter() : surface.FirstUParameter();
  const double range = (is_u ? surface.LastVParameter() : surface.LastUParameter()) - start;
  std::vector<Ridge> ridges;
  bool is_closed = true;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row row(surface, is_u, start + rows[i] * range);
    const std::vector<Ridge> found = row.ridges();
    if (i == 0) ridges = found;
    std::erase_if(ridges, [&](Ridge& ridge) { return !is_common(ridge, found); });
    is_closed &= row.is_closed();
    if (ridges.empty()) return {};
  }
  Ridges result;
  for (const Ridge& ridge : ridges) {
    auto is_within = [&](double crease) { return crease >= ridge.from && crease <= ridge.to; };
    if (ridge.width > unresolved || std::ranges::any_of(creases, is_within)) continue;
    if (ridge.at_start || ridge.at_end) {
      result.at_ends |= is_closed;
    } else {
      result.inside.push_back(cut_at(ridge, preferred));
    }
  }
  return result;
}

}  // namespace paver
