// Table of arc length, turn and size along one edge.
// In: the curve, the sizes of adjacent faces. Out: rows t -> s, turn, h, integral of ds/h.
// Steps: panels halved until Gauss quadrature of the speed agrees with its halves and the tangent turns little in each;
// h at every row; gradation forwards and backwards; the integral with 1/h linear in s, which inverts in closed form.
#include "boundary/edge_metric.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "boundary/small_bends.h"

namespace paver {
namespace {

constexpr double no_step = 1e-9;        // of the length: rows so near each other are not parted further
constexpr double exact_length = 1e-13;  // of the length: what a parameter for a length is right to
constexpr int most_newton_steps = 40;
constexpr int first_panels = 16;            // catches size changes of faces along straight edges
constexpr int deepest_split = 10;           // of a first panel: a kink ends the halving here
constexpr double panel_turn = 0.25;         // radians; the table keeps half panels
constexpr double slack_of_turns = 1.001;    // the turn is linear between rows only
constexpr double kink_turn = 0.2;           // radians: a sharper jump of the tangent takes a node
constexpr int kink_halvings = 30;           // of a deepest panel
constexpr double kink_end_share = 1e-6;     // of the length: a kink so near an end is the vertex's
constexpr double standstill = 1e-9;         // of the top speed: the tangent there is only rounding
constexpr double standstill_step = 1e-6;    // of the parameter range
constexpr double length_tolerance = 1e-9;   // of the edge's length, per panel
constexpr double most_change = 0.3;         // of h between rows, where lengths of parts make it vary
constexpr double small_share = 0.03;        // of the edge: bends that are longer are not small
constexpr double most_by_curvature = 4096;  // intervals on one edge that its own curvature may ask for

Vec3 velocity(const Curve& curve, double t) {
  const Vec3 a = curve.slope(t).t;
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z) ? a : Vec3{};
}

// Between unit vectors; 0 where the curve has no tangent.
double angle_between(Vec3 a, Vec3 b) {
  if (a == Vec3{} || b == Vec3{}) return 0;
  return std::atan2(norm(cross(a, b)), dot(a, b));
}

}  // namespace

EdgeMetric::EdgeMetric(const Edge& edge, const SizeField& size, std::span<const TurningSide> sides)
    : curve_(edge.curve.get()), t0_(edge.t0), t1_(edge.t1), limit_(size.turn_limit_of(edge)) {
  tabulate();
  if (!size.local->is_empty()) refine_rows(edge, size);
  if (size.small_bend > 0) make_kinks_of_small_bends(edge, size);
  set_sizes(edge, size);
  for (const TurningSide& side : sides) count_turns(*side.pcurve, size.faces[side.face]);
  weigh();
}

// Four Gauss points: degree 7, so panels of smooth curves rarely need halving.
double EdgeMetric::quadrature(double a, double b) const {
  static constexpr std::array<double, 2> points = {0.3399810435848563, 0.8611363115940526};
  static constexpr std::array<double, 2> weights = {0.6521451548625461, 0.3478548451374538};
  double middle = 0.5 * (a + b), half = 0.5 * (b - a), sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    sum += weights[i] *
           (norm(velocity(*curve_, middle - half * points[i])) + norm(velocity(*curve_, middle + half * points[i])));
  }
  return half * sum;
}

// Where the curve stands still its direction is that just before: a curve that folds back there has a kink.
Vec3 EdgeMetric::direction_at(double t) const {
  Vec3 ahead = velocity(*curve_, t);
  if (norm(ahead) > standstill * top_speed_) return unit(ahead);
  double step = standstill_step * (t1_ - t0_);
  return unit(velocity(*curve_, t > t0_ ? t - step : t + step));
}

void EdgeMetric::tabulate() {
  auto at = [&](int i) {
    const double share = static_cast<double>(i) / first_panels;
    return (1 - share) * t0_ + share * t1_;
  };
  for (int i = 0; i <= first_panels; ++i) top_speed_ = std::max(top_speed_, norm(velocity(*curve_, at(i))));
  std::vector<Panel> panels;
  double total = 0;
  for (int i = 0; i < first_panels; ++i) {
    Panel panel{at(i), at(i + 1), {}, {}, 0};
    panel.direction_a = i == 0 ? direction_at(panel.a) : panels.back().direction_b;
    panel.direction_b = direction_at(panel.b);
    panel.length = quadrature(panel.a, panel.b);
    total += panel.length;
    panels.push_back(panel);
  }
  rows_.assign(1, Row{t0_, 0, 0, 0, 0});
  for (const Panel& panel : panels) add_panel(panel, length_tolerance * total, 0);
  drop_kinks_at_ends();
}

void EdgeMetric::add_panel(const Panel& panel, double tolerance, int depth) {
  double middle = 0.5 * (panel.a + panel.b);
  Vec3 direction = direction_at(middle);
  Panel first{panel.a, middle, panel.direction_a, direction, quadrature(panel.a, middle)};
  Panel second{middle, panel.b, direction, panel.direction_b, quadrature(middle, panel.b)};
  double turn_first = angle_between(panel.direction_a, direction);
  double turn_second = angle_between(direction, panel.direction_b);
  bool is_accurate = std::abs(first.length + second.length - panel.length) <= tolerance;
  if (depth < deepest_split && !(is_accurate && turn_first + turn_second <= panel_turn)) {
    add_panel(first, tolerance, depth + 1);
    add_panel(second, tolerance, depth + 1);
    return;
  }
  add_rows(first, depth == deepest_split);
  add_rows(second, depth == deepest_split);
}

// The tangent's jump is narrowed down by halving; a bend that is only tight fades on the way.
void EdgeMetric::add_rows(const Panel& half, bool may_hold_kink) {
  const Row before = rows_.back();
  double turn = angle_between(half.direction_a, half.direction_b);
  if (may_hold_kink && turn > kink_turn) {
    double lo = half.a, hi = half.b;
    Vec3 direction_lo = half.direction_a, direction_hi = half.direction_b;
    for (int i = 0; i < kink_halvings; ++i) {
      double middle = 0.5 * (lo + hi);
      Vec3 direction = direction_at(middle);
      bool is_in_first = angle_between(direction_lo, direction) > angle_between(direction, direction_hi);
      (is_in_first ? hi : lo) = middle;
      (is_in_first ? direction_hi : direction_lo) = direction;
    }
    double jump = angle_between(direction_lo, direction_hi);
    if (jump > kink_turn) {
      double s = std::min(before.s + quadrature(half.a, lo), before.s + half.length);
      double turn_before = before.turn + angle_between(half.direction_a, direction_lo);
      rows_.push_back({lo, s, turn_before, 0, 0});
      rows_.push_back({lo, s, turn_before + jump, 0, 0});
      kinks_.push_back({rows_.size() - 1, jump});
      turn = angle_between(half.direction_a, direction_lo) + jump + angle_between(direction_hi, half.direction_b);
    }
  }
  rows_.push_back({half.b, before.s + half.length, before.turn + turn, 0, 0});
}

// An edge that ends on a kink of its curve may be evaluated beyond it there: no turn of the edge.
void EdgeMetric::drop_kinks_at_ends() {
  const double margin = kink_end_share * length();
  auto is_at_end = [this, margin](const Kink& kink) {
    double s = rows_[kink.row].s;
    return s <= margin || s >= length() - margin;
  };
  for (const Kink& kink : kinks_) {
    if (!is_at_end(kink)) continue;
    for (std::size_t i = kink.row; i < rows_.size(); ++i) rows_[i].turn -= kink.turn;
  }
  std::erase_if(kinks_, is_at_end);
}

// Where lengths of parts make h vary, rows are so near each other that it is as good as linear between them.
void EdgeMetric::refine_rows(const Edge& edge, const SizeField& size) {
  std::vector<Row> fine{rows_.front()};
  std::size_t kink = 0;
  for (std::size_t i = 1; i < rows_.size(); ++i) {
    if (kink < kinks_.size() && kinks_[kink].row == i) kinks_[kink++].row = fine.size();
    refine_between(rows_[i - 1], rows_[i], edge, size, fine);
  }
  rows_ = std::move(fine);
}

void EdgeMetric::refine_between(const Row& a, const Row& b, const Edge& edge, const SizeField& size,
                                std::vector<Row>& fine) const {
  double step = b.s - a.s, change = size.gradation * step;
  double h_a = size.given_at(edge, curve_->point(a.t)), h_b = size.given_at(edge, curve_->point(b.t));
  bool is_far = 0.5 * (h_a + h_b - change) >= size.h;
  bool is_fine = change <= most_change * std::min(h_a, h_b) || !(step > no_step * length());
  bool is_constant = std::max(h_a, h_b) <= size.local->least();
  double t = 0.5 * (a.t + b.t);
  if (is_far || is_fine || is_constant || !(t > a.t && t < b.t)) {
    fine.push_back(b);
    return;
  }
  double s = std::clamp(a.s + quadrature(a.t, t), a.s, b.s), share = (s - a.s) / step;
  Row middle{t, s, (1 - share) * a.turn + share * b.turn, 0, 0};
  refine_between(a, middle, edge, size, fine);
  refine_between(middle, b, edge, size, fine);
}

void EdgeMetric::make_kinks_of_small_bends(const Edge& edge, const SizeField& size) {
  if (turn() <= size.turn_limit) return;
  std::vector<TurnedTo> places;
  std::vector<double> width;
  for (const Row& row : rows_) {
    places.push_back({row.s, row.turn});
    width.push_back(std::min(size.small_bend * size.given_at(edge, curve_->point(row.t)), small_share * length()));
  }
  const std::vector<SmallBend> bends = find_small_bends(places, width, size.turn_limit);
  for (auto bend = bends.rbegin(); bend != bends.rend(); ++bend)  // rows before stay where they are
    make_kink(bend->first, bend->last, width[bend->first]);
}

EdgeMetric::Row EdgeMetric::row_at_turn(double turn, std::size_t first) const {
  std::size_t i = first;
  while (rows_[i + 1].turn < turn) ++i;
  const Row &a = rows_[i], &b = rows_[i + 1];
  const double t = a.t + (b.t - a.t) * (turn - a.turn) / (b.turn - a.turn);
  return {t, std::clamp(a.s + quadrature(a.t, t), a.s, b.s), turn, 0, 0};
}

// All its turn is in its middle; near an end of the edge it is the vertex's, and no turn of the edge.
void EdgeMetric::make_kink(int first, int last, double width) {
  const auto from = static_cast<std::size_t>(first), to = static_cast<std::size_t>(last);
  const double before = rows_[from].turn, behind = rows_[to].turn;
  Row middle = row_at_turn(0.5 * (before + behind), from);
  const bool is_at_end = middle.s <= width || middle.s >= length() - width;
  std::erase_if(kinks_, [&](const Kink& kink) { return kink.row > from && kink.row <= to; });
  for (std::size_t i = from; i <= to; ++i) {
    rows_[i].is_in_small_bend = true;
    rows_[i].turn = rows_[i].s < middle.s || is_at_end ? before : behind;
  }
  if (is_at_end) {
    for (std::size_t i = to + 1; i < rows_.size(); ++i) rows_[i].turn -= behind - before;
    return;
  }
  std::size_t at = from;
  while (rows_[at].s < middle.s) ++at;
  middle.is_in_small_bend = true;
  middle.turn = behind;
  rows_.insert(rows_.begin() + static_cast<std::ptrdiff_t>(at), 2, middle);
  rows_[at].turn = before;
  for (Kink& kink : kinks_)
    if (kink.row > to) kink.row += 2;
  kinks_.push_back({at + 1, behind - before});
  std::ranges::sort(kinks_, {}, &Kink::row);
}

// By what the curve turns nearby, where that is far less than its curvature says: a bend of a curve of intersection
// that ends on another may be all rounding.
double EdgeMetric::length_at_bend(double s, double by_curvature) const {
  constexpr double about = 4;  // less than what nearby intervals turn, were the curvature the same there
  auto may_span = [&](double width) {
    const double from = std::max(0.0, s - 0.5 * width), to = std::min(length(), s + 0.5 * width);
    return limit_.may_turn(turn_at_length(to, KinkSide::behind) - turn_at_length(from, KinkSide::before), to - from);
  };
  double width = about * by_curvature;
  if (!may_span(width)) return by_curvature;
  while (width < length() && may_span(2 * width)) width *= 2;
  return width / about;
}

void EdgeMetric::set_sizes(const Edge& edge, const SizeField& size) {
  const bool is_closed = edge.start == edge.end;
  const double least = length() / most_by_curvature;
  for (Row& row : rows_) {
    double bend = curvature(*curve_, row.t);
    row.pace = 1 / std::max(norm(velocity(*curve_, row.t)), standstill * top_speed_);
    row.h = row.given = size.given_at(edge, curve_->point(row.t));
    if (bend > 0 && !row.is_in_small_bend)
      row.h = std::min(row.h, length_at_bend(row.s, std::max(limit_.longest_edge(bend), least)));
  }
  // A second round carries the size through the point where a closed edge meets itself.
  auto limit_by = [&](const Row& beside, Row& row) {
    row.h = std::min(row.h, beside.h + size.gradation * std::abs(row.s - beside.s));
  };
  for (int round = 0; round < (is_closed ? 2 : 1); ++round) {
    if (is_closed) rows_.front().h = rows_.back().h = std::min(rows_.front().h, rows_.back().h);
    for (std::size_t i = 1; i < rows_.size(); ++i) limit_by(rows_[i - 1], rows_[i]);
    for (std::size_t i = rows_.size() - 1; i-- > 0;) limit_by(rows_[i + 1], rows_[i]);
  }
}

// Where the face turns along the edge lengths count its turn, too: the edge is divided as the rows that end on it.
void EdgeMetric::count_turns(const ParameterCurve& pcurve, const FaceSize& face) {
  std::vector<double> turn(rows_.size(), 0);  // per mm, from the row before
  Vec3 before = face.normals()->at(pcurve.uv(rows_[0].t));
  for (std::size_t i = 1; i < rows_.size(); ++i) {
    const Vec3 here = face.normals()->at(pcurve.uv(rows_[i].t));
    const double step = rows_[i].s - rows_[i - 1].s;
    if (step > 0) turn[i] = norm(here - before) / step;
    before = here;
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    Row& row = rows_[i];
    const double pace = 0.5 * (turn[std::max<std::size_t>(i, 1)] + turn[std::min(i + 1, rows_.size() - 1)]);
    const double stretch = face.turn_weight() * row.given * pace;
    row.h = std::min(row.h, row.given / std::sqrt(1 + stretch * stretch));
  }
}

void EdgeMetric::weigh() {
  for (std::size_t i = 1; i < rows_.size(); ++i) {
    double mean_density = 0.5 * (1 / rows_[i - 1].h + 1 / rows_[i].h);
    rows_[i].weight = rows_[i - 1].weight + (rows_[i].s - rows_[i - 1].s) * mean_density;
  }
}

std::size_t EdgeMetric::row_before(double value, Column column) const {
  const auto after = std::ranges::upper_bound(rows_, value, {}, column);
  return std::clamp<std::size_t>(static_cast<std::size_t>(after - rows_.begin()), 1, rows_.size() - 1) - 1;
}

double EdgeMetric::share_between(const Row& a, const Row& b, double s) {
  return b.s > a.s ? std::clamp((s - a.s) / (b.s - a.s), 0.0, 1.0) : 0;
}

double EdgeMetric::length_at_weight(double target) const {
  const std::size_t i = row_before(target, &Row::weight);
  const Row &a = rows_[i], &b = rows_[i + 1];
  double step = b.s - a.s;
  if (!(step > 0)) return a.s;
  // With 1/h linear over the panel the weight is quadratic in its share; this form of the root never cancels.
  double density_a = 1 / a.h, growth = 1 / b.h - density_a, wanted = (target - a.weight) / step;
  double root = std::sqrt(std::max(0.0, density_a * density_a + 2 * growth * wanted));
  double share = 2 * wanted / (density_a + root);
  return a.s + step * std::clamp(share, 0.0, 1.0);
}

// Cubic through both rows with their paces; straight where it would leave the rows.
double EdgeMetric::first_guess(const Row& a, const Row& b, double share) {
  double step = b.s - a.s, rest = 1 - share, linear = rest * a.t + share * b.t;
  double bow = (a.pace * step - (b.t - a.t)) * rest - (b.pace * step - (b.t - a.t)) * share;
  double t = linear + share * rest * bow;
  return t > a.t && t < b.t ? t : linear;
}

double EdgeMetric::parameter_at_length(double s) const {
  const std::size_t i = row_before(s, &Row::s);
  const Row &a = rows_[i], &b = rows_[i + 1];
  if (!(b.s > a.s)) return a.t;
  double lo = a.t, hi = b.t, t = first_guess(a, b, share_between(a, b, s));
  const double tolerance = exact_length * length();
  for (int iteration = 0; iteration < most_newton_steps; ++iteration) {
    double error = a.s + quadrature(a.t, t) - s;
    if (std::abs(error) <= tolerance) break;
    (error > 0 ? hi : lo) = t;
    double speed = norm(velocity(*curve_, t));
    double newton = t - error / speed;
    double next = newton > lo && newton < hi ? newton : 0.5 * (lo + hi);
    if (next == t) break;
    t = next;
  }
  return t;
}

double EdgeMetric::size_at_length(double s) const {
  const std::size_t i = row_before(s, &Row::s);
  const Row &a = rows_[i], &b = rows_[i + 1];
  const double share = share_between(a, b, s);
  return 1 / ((1 - share) / a.h + share / b.h);
}

double EdgeMetric::smooth_turn() const {
  double sum = turn();
  for (const Kink& kink : kinks_) sum -= kink.turn;
  return sum;
}

// The sharpest first, while there are nodes for them; none of these may be all but on another or on an end.
std::vector<EdgeMetric::Kink> EdgeMetric::kinks_with_nodes(int n) const {
  constexpr double least_apart = 0.1;  // target lengths
  std::vector<Kink> kinks = kinks_, used;
  std::ranges::stable_sort(kinks, std::greater{}, &Kink::turn);
  for (const Kink& kink : kinks) {
    const double here = rows_[kink.row].weight;
    const auto is_near = [&](double other) { return std::abs(other - here) < least_apart; };
    if (static_cast<int>(used.size()) >= n - 1) break;
    if (is_near(0) || is_near(weight())) continue;
    if (std::ranges::none_of(used, [&](const Kink& k) { return is_near(rows_[k.row].weight); })) used.push_back(kink);
  }
  std::ranges::sort(used, {}, &Kink::row);
  return used;
}

std::vector<double> EdgeMetric::node_lengths(int n) const {
  std::vector<Row> ends = {rows_.front()};  // of the pieces between kinks
  for (const Kink& kink : kinks_with_nodes(n)) ends.push_back(rows_[kink.row]);
  ends.push_back(rows_.back());

  const std::vector<int> counts = share_intervals(ends, n);
  std::vector<double> lengths = {0};
  for (std::size_t piece = 0; piece < counts.size(); ++piece) {
    const Row &a = ends[piece], &b = ends[piece + 1];
    for (int i = 1; i < counts[piece]; ++i) {
      lengths.push_back(length_at_weight(a.weight + (b.weight - a.weight) * i / counts[piece]));
    }
    lengths.push_back(b.s);
  }
  return lengths;
}

// One interval for each piece, the others to wherever they are longest.
std::vector<int> EdgeMetric::share_intervals(const std::vector<Row>& ends, int n) const {
  const std::size_t pieces = ends.size() - 1;
  auto weight_of = [&](std::size_t i) { return ends[i + 1].weight - ends[i].weight; };
  std::vector<int> counts;
  int given = 0;
  for (std::size_t i = 0; i < pieces; ++i) {
    double share = weight() > 0 ? weight_of(i) / weight() : 0;
    counts.push_back(1 + static_cast<int>((n - static_cast<int>(pieces)) * share));
    given += counts.back();
  }
  for (; given < n; ++given) {
    std::size_t longest = 0;
    for (std::size_t i = 1; i < pieces; ++i)
      if (weight_of(i) / counts[i] > weight_of(longest) / counts[longest]) longest = i;
    ++counts[longest];
  }
  return counts;
}

double EdgeMetric::turn_at_length(double s, KinkSide side) const {
  std::size_t i = row_before(s, &Row::s);
  // Rows before and behind a kink share one s.
  while (side == KinkSide::before && i > 0 && rows_[i].s >= s) --i;
  const Row &a = rows_[i], &b = rows_[i + 1];
  const double share = share_between(a, b, s);
  return (1 - share) * a.turn + share * b.turn;
}

bool EdgeMetric::turns_within(int n) const {
  return turn() <= limit_.usual * slack_of_turns || turns_within(node_lengths(n));
}

bool EdgeMetric::turns_within(const std::vector<double>& lengths) const {
  for (std::size_t i = 1; i < lengths.size(); ++i) {
    double end = i + 1 == lengths.size() ? turn() : turn_at_length(lengths[i], KinkSide::before);
    double turn = end - turn_at_length(lengths[i - 1], KinkSide::behind);
    if (!limit_.may_turn(turn / slack_of_turns, (lengths[i] - lengths[i - 1]) / slack_of_turns)) return false;
  }
  return true;
}

}  // namespace paver
