// The piece that bulges more is halved until chords are farther apart than both bulge, or until bulges are as small as
// rounding and chords still meet. Pieces that share an end part there at once where the angle between their chords is
// wide, and by what lies behind where the curves are tangent.
#include "regions/curves_apart.h"

#include <algorithm>

#include "base/predicates.h"
#include "base/segment.h"

namespace paver {
namespace {

constexpr double rounding = 1e-9;                // of the curves' length
constexpr int most_steps = 4000;                 // for curves that come as near as 1e-6 of their length along all of it
constexpr int most_depth = 40, small_depth = 8;  // halvings

struct Piece {
  double from, to;
  Vec2 a, b;
  double bulge;
  int depth;
};

struct Nearest {
  Vec2 at;
  double distance;  // between the chords
};

Nearest nearest(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  if (do_cross(a, b, c, d)) {
    const double u = orientation(c, d, a), v = orientation(c, d, b);
    return {a + (u / (u - v)) * (b - a), 0};
  }
  Nearest found{a, distance_to_segment(a, c, d)};
  for (const Nearest& end : {Nearest{b, distance_to_segment(b, c, d)}, Nearest{c, distance_to_segment(c, a, b)},
                             Nearest{d, distance_to_segment(d, a, b)}})
    if (end.distance < found.distance) found = end;
  return found;
}

class Pair {
 public:
  Pair(const PlaneCurve& one, const PlaneCurve& other, const std::vector<SharedEnd>& shared)
      : one_(one), other_(other), shared_(shared) {
    least_ = rounding * (norm(one.end - one.start) + norm(other.end - other.start));
  }

  Meeting run() {
    if (keep_apart(piece(one_, 0, 1, 0), piece(other_, 0, 1, 0))) return {};
    return {steps_ > most_steps ? Meeting::Kind::near : Meeting::Kind::meet, at_};
  }

 private:
  static Piece piece(const PlaneCurve& curve, double from, double to, int depth) {
    return {from, to, curve.point(from), curve.point(to), curve.bulge(from, to), depth};
  }

  bool keep_apart(const Piece& s, const Piece& t) {
    const Nearest found = nearest(s.a, s.b, t.a, t.b);
    at_ = found.at;
    if (++steps_ > most_steps) return false;
    std::vector<SharedEnd> ends;
    for (const SharedEnd& end : shared_)
      if ((end.first == s.from || end.first == s.to) && (end.second == t.from || end.second == t.to))
        ends.push_back(end);
    if (ends.empty() && found.distance > s.bulge + t.bulge) return true;
    const bool is_first = s.bulge >= t.bulge;
    const Piece& wider = is_first ? s : t;
    const bool is_straight = !(wider.bulge > least_);
    if (ends.size() == 1) {
      if (has_wide_angle(s, t, ends.front())) return true;
      if (is_straight) return !overlap(s, t, ends.front());
      if (is_small(s) && is_small(t)) return true;
    }
    if (is_straight || wider.depth >= most_depth) return false;
    const double middle = 0.5 * (wider.from + wider.to);
    const PlaneCurve& curve = is_first ? one_ : other_;
    for (const Piece& half :
         {piece(curve, wider.from, middle, wider.depth + 1), piece(curve, middle, wider.to, wider.depth + 1)})
      if (!(is_first ? keep_apart(half, t) : keep_apart(s, half))) return false;
    return true;
  }

  // Too near to a common end to tell tangent curves apart; what lies behind does.
  bool is_small(const Piece& s) const { return s.depth >= small_depth || !(s.bulge > least_); }

  struct Fork {
    Vec2 u, v;  // chords from the end that they share
    Fork(const Piece& s, const Piece& t, const SharedEnd& end) {
      const Vec2 o = end.first == s.from ? s.a : s.b;
      u = (end.first == s.from ? s.b : s.a) - o;
      v = (end.second == t.from ? t.b : t.a) - o;
    }
  };

  // An arc leaves its chord by an angle of four times its bulge over its length.
  static bool has_wide_angle(const Piece& s, const Piece& t, const SharedEnd& end) {
    const Fork f(s, t, end);
    if (dot(f.u, f.v) < 0) return true;
    return std::fabs(cross(f.u, f.v)) > 4 * (s.bulge * norm(f.v) + t.bulge * norm(f.u));
  }

  static bool overlap(const Piece& s, const Piece& t, const SharedEnd& end) {
    const Fork f(s, t, end);
    return orientation({0, 0}, f.u, f.v) == 0 && dot(f.u, f.v) > 0;
  }

  const PlaneCurve &one_, &other_;
  const std::vector<SharedEnd>& shared_;
  double least_ = 0;
  int steps_ = 0;
  Vec2 at_;  // of the pieces looked at last
};

}  // namespace

bool do_cross(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  return side_of_line(a, b, c) * side_of_line(a, b, d) < 0 && side_of_line(c, d, a) * side_of_line(c, d, b) < 0;
}

double PlaneCurve::bulge(double from, double to) const {
  constexpr double safety = 1.25;  // for what lies between the points looked at
  if (!at) return 0;
  const Vec2 a = point(from), b = point(to);
  double most = 0;
  for (double share : {0.25, 0.5, 0.75})
    most = std::max(most, distance_to_segment(point(from + share * (to - from)), a, b));
  return safety * most;
}

Vec2 nearest_point(Vec2 a, Vec2 b, Vec2 c, Vec2 d) { return nearest(a, b, c, d).at; }

Meeting find_meeting(const PlaneCurve& one, const PlaneCurve& other, const std::vector<SharedEnd>& shared) {
  return Pair(one, other, shared).run();
}

}  // namespace paver
