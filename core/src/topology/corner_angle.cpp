// By the tangents of edges and, about a pole, by points a little inside the face.
#include "topology/corner_angle.h"

#include <cmath>

#include "topology/end_direction.h"

namespace paver {
namespace {

constexpr int pole_chords = 16;
constexpr double turn_step = 1e-2;        // of an edge's parameter range
constexpr double pole_step = 1e-3;        // of the parameter range of the pole's coedge
constexpr double bend_reach = 1.0 / 128;  // of an edge's parameter range: bends that end so near its end are none

// Direction into the coedge at its start or its end.
Vec3 direction_into(const Model& model, const Coedge& coedge, bool at_end) {
  const Edge& edge = edge_of(model, coedge);
  const double from = at_end ? end_parameter(edge, coedge) : start_parameter(edge, coedge),
               to = at_end ? start_parameter(edge, coedge) : end_parameter(edge, coedge),
               inside = from + bend_reach * (to - from);
  const Vec3 chord = edge.curve->point(inside) - edge.curve->point(from);
  return end_direction(*edge.curve, from, inside, unit(chord));
}

// Where the border runs back along the edge it came by, its tangents tell nothing: a slit ends there, or the face is
// pressed flat. Summed up between points on an arc about the corner, from `after` to the left.
double angle_about_turn(const Face& face, const Edge& edge, const Coedge& before, const Coedge& after) {
  const double corner = start_parameter(edge, after);
  const double beside = corner + turn_step * (end_parameter(edge, after) - corner);
  const Vec2 at = after.pcurve->uv(corner), from = after.pcurve->uv(beside) - at, to = before.pcurve->uv(beside) - at;
  const double turn = angle_to_left(from, to);
  const Vec3 x = face.surface->point(at);
  double sum = 0;
  Vec3 last{};
  for (int i = 0; i <= pole_chords; ++i) {
    const double share = static_cast<double>(i) / pole_chords, c = std::cos(share * turn), s = std::sin(share * turn);
    const Vec2 step =
        ((1 - share) + share * norm(to) / norm(from)) * Vec2{c * from.x - s * from.y, s * from.x + c * from.y};
    const Vec3 way = face.surface->point(at + step) - x;
    if (i > 0) sum += angle_between(last, way);
    last = way;
  }
  return sum;
}

}  // namespace

double corner_angle(const Model& model, const Face& face, const Coedge& before, const Coedge& after) {
  const bool turns_back = before.edge == after.edge && before.is_reversed != after.is_reversed;
  if (turns_back && before.pcurve && after.pcurve && face.surface)
    return angle_about_turn(face, edge_of(model, after), before, after);
  const Vec3 back = direction_into(model, before, true), ahead = direction_into(model, after, false);
  const double angle = angle_between(back, ahead);
  if (!after.pcurve || !face.surface) return angle;
  const Edge& edge = edge_of(model, after);
  const auto [x, xu, xv] = face.surface->slope(after.pcurve->uv(start_parameter(edge, after)));
  return dot(cross(ahead, back), cross(xu, xv)) < 0 ? 2 * M_PI - angle : angle;
}

double pole_angle(const Model& model, const Face& face, const Coedge& pole) {
  const Edge& edge = edge_of(model, pole);
  const Vec2 start = pole.pcurve->uv(start_parameter(edge, pole)), end = pole.pcurve->uv(end_parameter(edge, pole));
  const Vec2 inward{-pole_step * (end - start).y, pole_step * (end - start).x};  // to the left, where the face is
  double sum = 0;
  Vec3 before{};
  for (int i = 0; i <= pole_chords; ++i) {
    const double share = static_cast<double>(i) / pole_chords;
    const Vec2 at = (1 - share) * start + share * end;
    const Vec3 way = face.surface->point(at + inward) - face.surface->point(at);
    if (i > 0) sum += angle_between(before, way);
    before = way;
  }
  return sum;
}

}  // namespace paver
