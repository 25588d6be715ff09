// Area of a part of a surface from its border alone. By Green's theorem the integral of the speed |xu x xv| over (u, v)
// becomes one along the border, of what lies between it and a line of one u:
// 1. the speed over the border's box becomes a table of polynomials, at least one for each span of the surface;
// 2. each image is cut where it passes from column to column of the table;
// 3. its pieces are halved until their integrals stay as they are.
#include <BRepAdaptor_Surface.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <algorithm>
#include <cmath>
#include <limits>

#include "brep/occt_impl.h"
#include "brep/occt_shapes_impl.h"
#include "brep/surfaces/evaluators_impl.h"
#include "brep/surfaces/speed_table.h"

namespace paver {
namespace {

constexpr double accuracy = 1e-7;   // of the area, for each piece
constexpr double thinnest = 1e-3;   // of all that is added and taken away: smaller areas are measured no better
constexpr int most_halves = 10;     // of a piece
constexpr int pieces_unknown = 16;  // of an image that is not known to be smooth
constexpr double same_line = 1e-9;  // lines of the surface as near, over the box, are one
constexpr double flat = 1e-13;      // steps of v, over the box, that are none

/// Lobatto's rule of five points: neighbours have their ends in common.
constexpr int points = 5;
const std::array<double, points> lobatto{-1, -std::sqrt(3.0 / 7), 0, std::sqrt(3.0 / 7), 1};
constexpr std::array<double, points> lobatto_weights{0.1, 49.0 / 90, 32.0 / 45, 49.0 / 90, 0.1};

using Rule = std::array<std::array<double, points>, points>;

/// The integral of f dv is the sum over i and j of [i][j], f at point i and v at point j: slopes of v are those of the
/// polynomial through its values, which images that are projections have no other way.
Rule make_rule() {
  auto product = [](int i) {
    double result = 1;
    for (int k = 0; k < points; ++k)
      if (k != i) result *= lobatto[i] - lobatto[k];
    return result;
  };
  Rule rule{};
  for (int i = 0; i < points; ++i)
    for (int j = 0; j < points; ++j) {
      if (i == j) continue;
      rule[i][j] = lobatto_weights[i] * product(i) / product(j) / (lobatto[i] - lobatto[j]);
      rule[i][i] -= rule[i][j];
    }
  return rule;
}

/// Of an image, with its places at Lobatto's points.
struct Piece {
  const BorderImage* image;
  double t0, t1;
  std::array<Vec2, points> uv;
  double integral = 0;
};

Piece make_piece(const BorderImage* image, double t0, double t1, Vec2 first, Vec2 last) {
  Piece piece{image, t0, t1, {first, {}, {}, {}, last}};
  for (int i = 1; i + 1 < points; ++i) piece.uv[i] = image->image->uv(0.5 * (t0 + t1) + 0.5 * (t1 - t0) * lobatto[i]);
  return piece;
}

std::vector<Piece> pieces_of(const std::vector<BorderImage>& border) {
  std::vector<Piece> pieces;
  for (const BorderImage& image : border) {
    std::vector<double> t = image.breaks;
    for (int i = 0; i <= pieces_unknown && image.breaks.empty(); ++i)
      t.push_back(image.t0 + (image.t1 - image.t0) * i / pieces_unknown);
    Vec2 first = image.image->uv(t.front());
    for (std::size_t k = 1; k < t.size(); ++k) {
      const Vec2 last = image.image->uv(t[k]);
      pieces.push_back(make_piece(&image, t[k - 1], t[k], first, last));
      first = last;
    }
  }
  return pieces;
}

/// One direction of the border's box.
struct Extent {
  double from = std::numeric_limits<double>::infinity(), to = -from;
  double round = 0, walked = 0;  ///< sums of steps: with their signs, and without

  void add(const Piece& piece, double Vec2::*way) {
    const double first = piece.uv.front().*way, step = piece.uv.back().*way - first;
    double low = first, high = first, before = first, bow = 0;
    for (int i = 1; i < points; ++i) {
      const double here = piece.uv[i].*way;
      low = std::min(low, here), high = std::max(high, here);
      bow = std::max(bow, std::abs(here - first - 0.5 * (1 + lobatto[i]) * step));
      walked += std::abs(here - before);
      before = here;
    }
    // Between the points of a parabola it goes on by a tenth of its height over the chord.
    from = std::min(from, low - 0.25 * bow);
    to = std::max(to, high + 0.25 * bow);
    round += piece.image->is_reversed ? -step : step;
  }

  /// Its ends and what lies between them of `breaks` and of these a whole number of periods away; without a period it
  /// ends where these do, as the kernel's rules have it.
  std::vector<double> lines(const std::vector<double>& breaks, double period) const {
    constexpr double most_periods = 16;  // an image that goes on without end is no reason to
    const bool is_repeated = period > 0 && to - from < most_periods * period;
    const bool is_bounded = !(period > 0) && breaks.size() > 1 && breaks.front() < to && breaks.back() > from;
    const double first = is_bounded ? std::max(from, breaks.front()) : from;
    const double last = is_bounded ? std::min(to, breaks.back()) : to;
    std::vector<double> inner, lines{first};
    for (double line : breaks) {
      if (is_repeated) line += period * std::ceil((first - line) / period);
      do inner.push_back(line);
      while (is_repeated && (line += period) < last);
    }
    std::ranges::sort(inner);
    const double apart = same_line * (last - first);
    for (const double line : inner)
      if (line - lines.back() > apart && last - line > apart) lines.push_back(line);
    lines.push_back(last);
    return lines;
  }
};

/// Where a piece passes a line of one v that lies between its ends: rule of false position, as Illinois has it.
std::pair<double, Vec2> crossing(const Piece& piece, double v) {
  constexpr double near_enough = 1e-9;
  constexpr int most_steps = 60;
  double t0 = piece.t0, t1 = piece.t1, low = piece.uv.front().y - v, high = piece.uv.back().y - v;
  const double allowed = near_enough * std::abs(high - low);
  double t = t0;
  Vec2 uv = piece.uv.front();
  for (int i = 0, side = 0; i < most_steps; ++i) {
    t = (t0 * high - t1 * low) / (high - low);
    uv = piece.image->image->uv(t);
    const double off = uv.y - v;
    if (std::abs(off) <= allowed) break;
    if (off * high > 0) {
      t1 = t, high = off;
      if (side < 0) low *= 0.5;
      side = -1;
    } else {
      t0 = t, low = off;
      if (side > 0) high *= 0.5;
      side = 1;
    }
  }
  return {t, uv};
}

class BorderIntegral {
 public:
  BorderIntegral(const SpeedTable& table, double height) : table_(table), flat_(flat * height) {}

  double over(const std::vector<Piece>& whole) const {
    std::vector<Piece> pieces;
    for (const Piece& piece : whole) cut(piece, pieces);
    double area = 0, sum = 0;
    for (Piece& piece : pieces) {
      piece.integral = rough(piece);
      area += piece.integral, sum += std::abs(piece.integral);
    }
    const double allowed = accuracy * std::max(std::abs(area), thinnest * sum);
    area = 0;
    for (const Piece& piece : pieces) area += refined(piece, allowed, most_halves);
    return area;
  }

 private:
  /// Appends a piece in parts, each from one line between columns to the next.
  void cut(Piece piece, std::vector<Piece>& parts) const {
    const Vec2 last = piece.uv.back();
    std::vector<double> lines =
        table_.lines_between(std::min(piece.uv.front().y, last.y), std::max(piece.uv.front().y, last.y));
    if (last.y < piece.uv.front().y) std::ranges::reverse(lines);
    for (const double v : lines) {
      const auto [t, uv] = crossing(piece, v);
      if (!(t > piece.t0 && t < piece.t1)) continue;
      parts.push_back(make_piece(piece.image, piece.t0, t, piece.uv.front(), uv));
      piece = make_piece(piece.image, t, piece.t1, uv, last);
    }
    parts.push_back(piece);
  }

  double rough(const Piece& piece) const {
    static const Rule rule = make_rule();
    // Its ends may lie on lines between columns: what counts is the side that it comes from.
    constexpr double inwards = 1e-3;
    const double v = piece.uv.front().y, middle = piece.uv[points / 2].y;
    if (std::ranges::all_of(piece.uv, [&](Vec2 uv) { return std::abs(uv.y - v) <= flat_; })) return 0;
    double sum = 0;
    for (int i = 0; i < points; ++i) {
      double dv = 0;
      for (int j = 0; j < points; ++j) dv += rule[i][j] * (piece.uv[j].y - v);
      sum += dv * table_.up_to(piece.uv[i], piece.uv[i].y + inwards * (middle - piece.uv[i].y));
    }
    return piece.image->is_reversed ? -sum : sum;
  }

  double refined(const Piece& piece, double allowed, int halves) const {
    if (piece.integral == 0) return 0;
    const double middle = 0.5 * (piece.t0 + piece.t1);
    const Vec2 uv = piece.uv[points / 2];
    Piece left = make_piece(piece.image, piece.t0, middle, piece.uv.front(), uv);
    Piece right = make_piece(piece.image, middle, piece.t1, uv, piece.uv.back());
    left.integral = rough(left), right.integral = rough(right);
    const double sum = left.integral + right.integral;
    if (halves == 0 || std::abs(sum - piece.integral) <= allowed) return sum;
    return refined(left, allowed, halves - 1) + refined(right, allowed, halves - 1);
  }

  const SpeedTable& table_;
  double flat_;
};

/// Finite ends of the intervals that an adaptor of the kernel's tells.
template <class Tell>
std::vector<double> ends_of(int count, Tell&& tell) {
  TColStd_Array1OfReal all(1, count + 1);
  tell(all);
  std::vector<double> ends;
  std::ranges::copy_if(all, std::back_inserter(ends), [](double t) { return !Precision::IsInfinite(t); });
  return ends;
}

/// BorderImage::breaks. What is no line is cut in four at least: of a whole circle Lobatto's points see half the
/// height.
std::vector<double> breaks_of(const Geom2dAdaptor_Curve& curve) {
  constexpr std::size_t fewest = 4;
  const std::vector<double> ends =
      ends_of(curve.NbIntervals(GeomAbs_CN), [&](auto& all) { curve.Intervals(all, GeomAbs_CN); });
  if (curve.GetType() == GeomAbs_Line || ends.size() > fewest || ends.size() < 2) return ends;
  std::vector<double> breaks{ends.front()};
  for (std::size_t k = 1; k < ends.size(); ++k)
    for (std::size_t i = 1; i <= fewest; ++i) breaks.push_back(std::lerp(ends[k - 1], ends[k], double(i) / fewest));
  return breaks;
}

}  // namespace

std::optional<double> area_within(const TopoDS_Face& face, const Surface& surface,
                                  const std::vector<BorderImage>& border) {
  constexpr double most_round = 1e-3;
  const std::vector<Piece> pieces = pieces_of(border);
  Extent u, v;
  for (const Piece& piece : pieces) u.add(piece, &Vec2::x), v.add(piece, &Vec2::y);
  if (!(u.from < u.to && v.from < v.to && std::abs(v.round) <= most_round * v.walked)) return std::nullopt;
  const BRepAdaptor_Surface whole(face, false);
  const std::vector<double> breaks_u =
      ends_of(whole.NbUIntervals(GeomAbs_CN), [&](auto& ends) { whole.UIntervals(ends, GeomAbs_CN); });
  const std::vector<double> breaks_v =
      ends_of(whole.NbVIntervals(GeomAbs_CN), [&](auto& ends) { whole.VIntervals(ends, GeomAbs_CN); });
  const std::vector<double> lines_u = u.lines(breaks_u, surface.period().x);
  const SpeedTable table(surface, lines_u, v.lines(breaks_v, surface.period().y));
  const double area = BorderIntegral(table, v.to - v.from).over(pieces);
  return std::isfinite(area) ? std::optional(area) : std::nullopt;
}

std::optional<double> area_within_images(const TopoDS_Face& face) {
  const TopoDS_Face plain = forward(face);
  std::vector<BorderImage> border;
  try {
    for (const TopoDS_Edge& edge : edges_of(plain)) {
      if (!is_bounding(edge)) continue;
      const EdgeImage image = image_of(edge, plain);
      if (image.curve.IsNull()) return std::nullopt;
      const Geom2dAdaptor_Curve curve(image.curve, image.first, image.last);
      border.push_back({make_parameter_curve(edge, plain, image.first, image.last), image.first, image.last,
                        edge.Orientation() == TopAbs_REVERSED, breaks_of(curve)});
    }
    const std::unique_ptr<Surface> surface = make_surface(plain, 0);
    return surface ? area_within(plain, *surface, border) : std::nullopt;
  } catch (const Error&) {
    return std::nullopt;
  } catch (const Standard_Failure&) {
    return std::nullopt;
  }
}

}  // namespace paver
