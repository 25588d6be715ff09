// Cells and pieces are halved, across the longer way, until the target length varies little in each: only near what
// asks for a short one.
#include "sizing/parts/local_counts.h"

#include <algorithm>
#include <cmath>

namespace paver {
namespace {

constexpr int first_cells = 8;       // per direction
constexpr int deepest_cell = 24;     // halvings, of either direction
constexpr int most_cells = 200000;   // of a face, where all of it is near
constexpr int deepest_piece = 20;    // halvings
constexpr double coarse_cell = 0.8;  // of h over the gradation: size of a cell that is not halved
constexpr double graded_share = 0.9;
constexpr double rim = 0.01;           // of the box of a face: nodes on its border may lie a rounding outside
constexpr double graded_excess = 1.9;  // rows give up nodes more slowly than the gradation allows (docs/prediction.md)

/// What a surface and its turn come to about a place, per area of its (u, v).
class TurnedArea {
 public:
  TurnedArea(const Surface& surface, Vec2 uv) {
    const SurfaceJet at = surface.jet(uv);
    xu_ = at.u, xv_ = at.v;
    const Vec3 across = cross(xu_, xv_);
    if (!(norm(across) > 0)) return;  // a pole: none
    const Vec3 n = unit(across);
    auto turn = [&](Vec3 slope) { return 1 / norm(across) * (slope - dot(slope, n) * n); };
    nu_ = turn(cross(at.uu, xv_) + cross(xu_, at.uv)), nv_ = turn(cross(at.uv, xv_) + cross(xu_, at.vv));
  }

  /// In squares of the target length `h`, of which a turn by `turn_limit` radians is one, too.
  double in(double h, double turn_limit) const {
    auto product = [&](Vec3 a, Vec3 b, Vec3 m, Vec3 n) {
      return dot(a, b) / (h * h) + dot(m, n) / (turn_limit * turn_limit);
    };
    const double uu = product(xu_, xu_, nu_, nu_), mixed = product(xu_, xv_, nu_, nv_),
                 vv = product(xv_, xv_, nv_, nv_);
    return std::sqrt(std::max(0.0, uu * vv - mixed * mixed));
  }

 private:
  Vec3 xu_, xv_, nu_, nv_;
};

class CellCounter {
 public:
  CellCounter(const Surface& surface, const FaceSize& size, const SizeField& field, LocalCounts& counts)
      : surface_(surface), size_(size), gradation_(field.gradation), turn_limit_(field.turn_limit), counts_(counts) {}

  void add(Vec2 lo, Vec2 hi, int depth) {
    Vec2 middle = 0.5 * (lo + hi);
    const auto [x, xu, xv] = surface_.slope(middle);
    double wide = norm(xu) * (hi.x - lo.x), high = norm(xv) * (hi.y - lo.y), reach = wide + high;
    double h = size_.at(middle, surface_), plain = size_.by_curvature(middle);
    const double least_far = plain + 0.5 * gradation_ * reach;
    bool is_near = size_.around_parts(x, least_far) < least_far;
    if (depth < deepest_cell && cells_ < most_cells && is_near && gradation_ * reach > coarse_cell * h) {
      cells_ += 2;
      const bool is_wide = wide > high;  // faces are often long and thin
      add(lo, is_wide ? Vec2{middle.x, hi.y} : Vec2{hi.x, middle.y}, depth + 1);
      add(is_wide ? Vec2{middle.x, lo.y} : Vec2{lo.x, middle.y}, hi, depth + 1);
      return;
    }
    if (is_near) counts_.near.add(lo), counts_.near.add(hi);
    const bool is_graded = size_.given_at(x) < graded_share * size_.own();
    counts_.is_graded = counts_.is_graded || is_graded;
    double cell = norm(cross(xu, xv)) * (hi.x - lo.x) * (hi.y - lo.y);
    if (!std::isfinite(cell)) return;
    area_ += cell;
    const double more = graded_excess * (cell / (h * h) - cell / (plain * plain));
    more_ += is_graded ? std::max(more, more_by_turns(middle, h, plain) * (hi.x - lo.x) * (hi.y - lo.y)) : more;
  }
  double more_density() const { return area_ > 0 ? more_ / area_ : 0; }

 private:
  // Per area of (u, v). About a tip the surface turns as much on faces, too, where turns do not count elsewhere.
  double more_by_turns(Vec2 uv, double h, double plain) const {
    const TurnedArea area(surface_, uv);
    return area.in(h, turn_limit_) - area.in(plain, size_.turn_weight() > 0 ? turn_limit_ : INFINITY);
  }

  const Surface& surface_;
  const FaceSize& size_;
  double gradation_, turn_limit_, area_ = 0, more_ = 0;
  int cells_ = 0;
  LocalCounts& counts_;
};

// Integral of ds / h along an edge on a face whose own length is `face_h`.
double facets_on(const Edge& edge, double t0, double t1, double face_h, const SizeField& field, int depth) {
  double t = 0.5 * (t0 + t1);
  double length = edge.length * (t1 - t0) / (edge.t1 - edge.t0);
  double given = field.given_at(edge, edge.curve->point(t)), h = std::min(face_h, given);
  bool is_near = given - 0.5 * field.gradation * length < face_h;
  if (depth < deepest_piece && is_near && field.gradation * length > h)
    return facets_on(edge, t0, t, face_h, field, depth + 1) + facets_on(edge, t, t1, face_h, field, depth + 1);
  return length / h;
}

}  // namespace

LocalCounts count_with_local(const Model& model, const Face& face, const FaceSize& size, const SizeField& field) {
  LocalCounts counts;
  double face_h = size.own();
  for (const Coedge& coedge : coedges_of(face.loops)) {
    const Edge& edge = edge_of(model, coedge);
    if (!edge.is_degenerate && edge.curve) counts.perimeter += facets_on(edge, edge.t0, edge.t1, face_h, field, 0);
  }
  SampleBox box = sample_box(model, face);
  if (!face.surface || !box.has_area()) return counts;
  CellCounter cells(*face.surface, size, field, counts);
  Vec2 step{(box.hi.x - box.lo.x) / first_cells, (box.hi.y - box.lo.y) / first_cells};
  for (int j = 0; j < first_cells; ++j)
    for (int i = 0; i < first_cells; ++i) {
      Vec2 lo{box.lo.x + i * step.x, box.lo.y + j * step.y};
      cells.add(lo, lo + step, 0);
    }
  counts.more_density = cells.more_density();
  if (counts.near.has_area()) counts.near.widen(rim * (box.hi - box.lo));
  return counts;
}

}  // namespace paver
