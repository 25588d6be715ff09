// Balls get another axis, and so other poles and another periodic edge, where the kernel fails at these: it loses track
// of an intersection that goes through a pole.
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Tool.hxx>
#include <ElSLib.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "brep/connecting/connect_impl.h"
#include "brep/occt_shapes_impl.h"

namespace paver {
namespace {

constexpr double whole_share = 1e-6;  // of its area, that a whole ball may lack
constexpr double near_share = 1e-3;   // of its radius: a pole this near a surface may be on it

/// Of no symmetry that models have; the first one does but by chance.
constexpr std::array<std::array<double, 3>, 3> directions{
    {{0.318, 0.577, 0.752}, {-0.641, 0.263, 0.721}, {0.529, -0.807, 0.262}}};

/// The sphere that the face is all of; null for others.
Handle(Geom_SphericalSurface) ball_of(const WorkFace& face) {
  const auto sphere = Handle(Geom_SphericalSurface)::DownCast(untrimmed(BRep_Tool::Surface(face.face)));
  if (sphere.IsNull() || !face.is_usable() || face.uses.size() != 1) return nullptr;
  const double area = 4 * std::numbers::pi * sphere->Radius() * sphere->Radius();
  const bool is_whole = std::abs(face.area - area) <= whole_share * area && wires_of(face.face).size() == 1;
  return is_whole ? sphere : Handle(Geom_SphericalSurface)();
}

/// Whether a pole of a ball with that axis comes near a bent face of the parts.
bool has_pole_on(const Workpiece& work, const gp_Pnt& centre, const gp_Vec& to_pole, const std::vector<int>& parts) {
  const double near = near_share * to_pole.Magnitude();
  for (const gp_Pnt& pole : {centre.Translated(to_pole), centre.Translated(-to_pole)})
    for (const WorkFace& face : work.faces) {
      if (!face.is_usable() || !std::ranges::any_of(parts, [&](int part) { return face.has_part(part); })) continue;
      if (!Handle(Geom_Plane)::DownCast(untrimmed(BRep_Tool::Surface(face.face))).IsNull()) continue;
      if (is_near(pole, face.face, near)) return true;
    }
  return false;
}

/// The same ball with its axis along `to_pole`.
void turn(Workpiece& work, WorkFace& face, const Handle(Geom_SphericalSurface) & ball, const gp_Dir& to_pole) {
  const gp_Ax3 was = ball->Position(), axes(was.Location(), to_pole);
  const TopoDS_Face made = BRepBuilderAPI_MakeFace(gp_Sphere(axes, ball->Radius())).Face();
  auto periodic_edge = [](const TopoDS_Face& any) {
    const std::vector<TopoDS_Edge> edges = edges_of(any);
    const auto found = std::ranges::find_if_not(edges, &BRep_Tool::Degenerated);
    return found == edges.end() ? TopoDS_Edge() : *found;
  };
  const TopoDS_Edge before = periodic_edge(face.face), after = periodic_edge(made);
  if (!before.IsNull() && !after.IsNull()) add_edge_origins(work, after, before);
  const TopAbs_Orientation sense = face.face.Orientation();
  face.face = TopoDS::Face(made.Oriented(was.Direct() ? sense : TopAbs::Reverse(sense)));
  face.converted = [known = face.converted, was, axes](Vec2 uv) {
    if (known) uv = known(uv);
    const gp_Pnt at = ElSLib::SphereValue(uv.x, uv.y, was, 1);
    ElSLib::SphereParameters(axes, 1, at, uv.x, uv.y);
    return uv;
  };
  work.is_rebuilt = true;
}

}  // namespace

bool turn_balls(Workpiece& work, const std::vector<int>& parts, const std::vector<PartPair>& pairs, bool are_all) {
  const std::vector<char> is_member = marked_parts(work, parts);
  bool has_turned = false;
  for (WorkFace& face : work.faces) {
    const Handle(Geom_SphericalSurface) ball = ball_of(face);
    if (ball.IsNull()) continue;
    const int part = face.uses[0].part;
    if (!is_member[part]) continue;
    std::vector<int> others;
    for (const PartPair& pair : pairs)
      if (pair[0] == part || pair[1] == part) others.push_back(pair[0] == part ? pair[1] : pair[0]);
    const gp_Pnt centre = ball->Position().Location();
    auto is_clear = [&](const gp_Dir& axis) {
      return !has_pole_on(work, centre, ball->Radius() * gp_Vec(axis), others);
    };
    if (!are_all && is_clear(ball->Position().Direction())) continue;
    auto to_dir = [](const std::array<double, 3>& a) { return gp_Dir(a[0], a[1], a[2]); };
    const auto found = std::ranges::find_if(directions, is_clear, to_dir);
    turn(work, face, ball, to_dir(found == directions.end() ? directions[0] : *found));
    has_turned = true;
  }
  return has_turned;
}

}  // namespace paver
