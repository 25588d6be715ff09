// Small repairs that later stages rely on, done on a copy when there is anything to do:
// 1. a face without loops (a whole sphere or torus in some files) gets the natural bounds of its surface; of a whole
//    spindle one piece between its poles is left;
// 2. an edge without an image in a face's (u, v) gets one, by projection, and the face its area;
// 3. an edge flagged as a pole (of no length) that has length becomes an ordinary edge, or goes where it only leads
//    from one loop of a ring to the other;
// 4. a loop of a plane within another one that runs the same way around is turned: with the wrong area inside, faces
//    that touch this one would be connected with what it does not cover;
// 5. loops of a face that run along each other for a stretch become one;
// 6. images of meridians that run round the pole they lead to become straight.
#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <Geom2d_Line.hxx>
#include <ShapeFix_Edge.hxx>
#include <ShapeFix_Face.hxx>
#include <TopLoc_Location.hxx>
#include <algorithm>
#include <cmath>
#include <gp.hxx>
#include <optional>
#include <vector>

#include "brep/mending/mend_impl.h"
#include "brep/occt_impl.h"
#include "brep/occt_shapes_impl.h"

namespace paver {
namespace {

/// A pole reaches no farther than this share of the diagonal.
constexpr double pole_share = 1e-6;
/// Odd, so that a curve out and back is not met at its turning points' mirror images only.
constexpr int pole_samples = 23;

bool has_loops(const TopoDS_Face& face) { return TopExp_Explorer(face, TopAbs_WIRE).More(); }

bool has_image(const TopoDS_Edge& edge, const TopoDS_Face& face) { return !image_of(edge, face).curve.IsNull(); }

bool lacks_image(const TopoDS_Face& face) {
  const TopoDS_Face plain = forward(face);
  return std::ranges::any_of(edges_of(plain), [&](const TopoDS_Edge& edge) {
    return !BRep_Tool::Degenerated(edge) && !has_image(edge, plain);
  });
}

/// Twice what a loop of a FORWARD face encloses in (u, v), negative where it runs clockwise.
double area_about(const TopoDS_Wire& wire, const TopoDS_Face& face) {
  constexpr int chords = 16;
  double area = 0;
  visit_border(wire, [&](const TopoDS_Edge& edge, const TopoDS_Vertex&, const TopoDS_Vertex&) {
    const EdgeImage image = image_of(edge, face);
    if (image.curve.IsNull()) return;
    const double way = edge.Orientation() == TopAbs_REVERSED ? -1 : 1;
    gp_Pnt2d from = image.uv(0);
    for (int i = 1; i <= chords; ++i) {
      const gp_Pnt2d to = image.uv(static_cast<double>(i) / chords);
      area += way * (from.X() * to.Y() - to.X() * from.Y());
      from = to;
    }
  });
  return area;
}

/// Whether some loop of a plane may be turned: it runs as the largest one does.
bool has_loops_alike(const TopoDS_Face& face) {
  const std::vector<TopoDS_Wire> wires = wires_of(face);
  if (wires.size() < 2 || BRepAdaptor_Surface(face, Standard_False).GetType() != GeomAbs_Plane) return false;
  std::vector<double> areas;
  for (const TopoDS_Wire& wire : wires) areas.push_back(area_about(wire, face));
  const double largest = std::ranges::max(areas, {}, [](double area) { return std::abs(area); });
  return std::ranges::count_if(areas, [&](double area) { return area * largest > 0; }) > 1;
}

bool needs_repair(const TopoDS_Face& face, double diagonal) {
  if (!has_loops(face)) return true;
  const TopoDS_Face plain = forward(face);
  auto is_false = [&](const TopoDS_Edge& edge) { return is_false_pole(edge, plain, diagonal); };
  return std::ranges::any_of(edges_of(plain), is_false) || lacks_image(face) || is_garbled_ring(plain, diagonal) ||
         has_loops_alike(plain) || between_poles(plain) || without_doubled_edges(plain, diagonal) ||
         !find_bent_meridians(plain).empty() || !find_periodic_pairs(plain, diagonal).empty();
}

/// Puts another face in its place, on the same side.
void replace(WorkFace& face, const TopoDS_Face& by, RepairKind kind, Workpiece& work) {
  face.face = TopoDS::Face(by.Oriented(face.face.Orientation()));
  work.note_repair(kind, 1, 0, face_name(face.origin));
  work.is_rebuilt = true;
}

void add_natural_bounds(WorkFace& face, Workpiece& work) {
  TopLoc_Location location;
  Handle(Geom_Surface) surface = BRep_Tool::Surface(face.face, location);
  if (surface.IsNull()) {
    face.fault = "it has no surface; export the model again";
    return;
  }
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  surface->Bounds(u0, u1, v0, v1);
  if (Precision::IsInfinite(u0) || Precision::IsInfinite(u1) || Precision::IsInfinite(v0) ||
      Precision::IsInfinite(v1)) {
    face.fault = "it has no boundary and its surface is infinite; trim it in the CAD program";
    return;
  }
  BRepBuilderAPI_MakeFace maker(surface, u0, u1, v0, v1, Precision::Confusion());
  if (!maker.IsDone()) {
    face.fault = "it has no boundary and none can be made; trim it in the CAD program";
    return;
  }
  replace(face, TopoDS::Face(maker.Face().Moved(location)), RepairKind::border, work);
  face.area = face_area(face.face);
  if (!std::isfinite(face.area)) face.fault = "its area cannot be computed";
}

/// Whether the face was a whole spindle.
bool end_at_poles(WorkFace& face, Workpiece& work) {
  const std::optional<TopoDS_Face> piece = between_poles(forward(face.face));
  if (!piece) return false;
  replace(face, *piece, RepairKind::border, work);
  face.area = face_area(face.face);
  return true;
}

/// Iso lines, as the borders of faces are, become exact curves; others are approximated.
void add_curve(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  const EdgeImage image = image_of(edge, face);
  TopLoc_Location location;
  Handle(Geom_Surface) surface = BRep_Tool::Surface(face, location);
  BRep_Builder builder;
  builder.Degenerated(edge, Standard_False);
  auto line = Handle(Geom2d_Line)::DownCast(image.curve);
  if (!line.IsNull() && line->Direction().IsEqual(gp::DY2d(), Precision::Angular()) && line->Location().Y() == 0) {
    builder.UpdateEdge(edge, surface->UIso(line->Location().X()), location, BRep_Tool::Tolerance(edge));
    builder.Range(edge, image.first, image.last);
  } else {
    BRepLib::BuildCurve3d(edge);
  }
}

/// Whether the face was a ring that readers have garbled.
bool mend_ring(WorkFace& face, Workpiece& work) {
  const TopoDS_Face plain = forward(face.face);
  if (!is_garbled_ring(plain, work.diagonal)) return false;
  const bool has_poles = std::ranges::any_of(edges_of(plain), &BRep_Tool::Degenerated);
  replace(face, mended_ring(plain, work.diagonal), has_poles ? RepairKind::pole : RepairKind::periodic_edge, work);
  return true;
}

/// Whether loops were turned; loops side by side are left as they are.
bool turn_loops(WorkFace& face, Workpiece& work) {
  const TopoDS_Face plain = forward(face.face);
  if (!has_loops_alike(plain)) return false;
  ShapeFix_Face fix(plain);
  if (!fix.FixOrientation() || (!fix.Result().IsNull() && fix.Result().ShapeType() != TopAbs_FACE)) return false;
  const TopoDS_Face turned = fix.Face();
  if (!(face_area(turned) < face.area)) return false;
  replace(face, turned, RepairKind::turned_loop, work);
  return true;
}

/// Whether loops ran along each other.
bool join_loops(WorkFace& face, Workpiece& work) {
  const std::optional<TopoDS_Face> joined = without_doubled_edges(forward(face.face), work.diagonal);
  if (joined) replace(face, *joined, RepairKind::closed_loop, work);
  return joined.has_value();
}

void straighten_meridians(WorkFace& face, Workpiece& work) {
  const TopoDS_Face plain = forward(face.face);
  const std::vector<BentMeridian> bent = find_bent_meridians(plain);
  if (bent.empty()) return;
  straighten(plain, bent);
  const double off = std::ranges::max(bent, {}, &BentMeridian::off).off;
  work.note_repair(RepairKind::image, static_cast<long>(bent.size()), off, face_name(face.origin));
}

bool is_shared(const TopoDS_Edge& edge, const WorkFace& owner, const Workpiece& work) {
  return std::any_of(work.faces.begin(), work.faces.end(),
                     [&](const WorkFace& face) { return &face != &owner && use_count(edge, face.face) > 0; });
}

/// Not where neighbours have edges that would get other ends.
void join_periodic_edges(WorkFace& face, Workpiece& work) {
  const TopoDS_Face plain = forward(face.face);
  const std::vector<PeriodicPair> pairs = find_periodic_pairs(plain, work.diagonal);
  if (pairs.empty()) return;
  const bool has_ends = std::ranges::all_of(pairs, &PeriodicPair::has_common_ends);
  if (!has_ends &&
      std::ranges::any_of(edges_of(plain), [&](const TopoDS_Edge& edge) { return is_shared(edge, face, work); }))
    return;
  replace(face, with_periodic_edges(plain, pairs), RepairKind::periodic_edge, work);
}

/// Ends that are pressed flat become common to both of their sides, unless another face goes on there.
void close_flat_ends(WorkFace& face, Workpiece& work) {
  const TopoDS_Face plain = forward(face.face);
  std::vector<TopoDS_Edge> poles;
  for (const TopoDS_Edge& edge : edges_of(plain))
    if (is_false_pole(edge, plain, work.diagonal) && !is_shared(edge, face, work)) poles.push_back(edge);
  for (const TopoDS_Edge& pole : poles) {
    const auto flat = pressed_flat(forward(face.face), pole, work.diagonal);
    if (!flat) continue;
    replace(face, flat->face, RepairKind::pole, work);
    for (const TopoDS_Edge& edge : flat->edges)
      if (edge.Orientation() == TopAbs_FORWARD) add_edge_origins(work, edge, pole);
  }
}

void repair_edges(WorkFace& face, Workpiece& work) {
  close_flat_ends(face, work);
  TopoDS_Face plain = forward(face.face);
  for (const TopoDS_Edge& edge : edges_of(plain)) {
    if (is_false_pole(edge, plain, work.diagonal)) {
      add_curve(edge, plain);
      work.note_repair(RepairKind::pole, 1, 0, face_name(face.origin));
    }
    if (BRep_Tool::Degenerated(edge)) continue;
    if (!has_image(edge, plain)) {
      ShapeFix_Edge().FixAddPCurve(edge, plain, use_count(edge, plain) > 1);
      work.note_repair(RepairKind::image, 1, 0, face_name(face.origin));
    }
    if (!has_image(edge, plain)) {
      face.fault = "an edge has no curve in its surface and none can be made; repair it in the CAD program";
      return;
    }
  }
}

/// Without images the kernel finds no area.
void measure_again(WorkFace& face, const Workpiece& work) {
  face.area = face_area(face.face);
  if (!std::isfinite(face.area)) face.area = 0;
  face.has_area = !face.fault.empty() || work.has_area(face);
}

}  // namespace

bool is_false_pole(const TopoDS_Edge& edge, const TopoDS_Face& face, double diagonal) {
  if (!BRep_Tool::Degenerated(edge)) return false;
  const EdgeImage image = image_of(edge, face);
  if (image.curve.IsNull()) return false;
  BRepAdaptor_Surface surface(face, Standard_False);
  auto at = [&](double share) {
    gp_Pnt2d uv = image.uv(share);
    return surface.Value(uv.X(), uv.Y());
  };
  gp_Pnt start = at(0);
  double reach = 0;
  for (int i = 1; i <= pole_samples; ++i) reach = std::max(reach, start.Distance(at(double(i) / pole_samples)));
  return reach > std::max(pole_share * diagonal, 2 * BRep_Tool::Tolerance(edge));
}

void repair(Workpiece& work, Progress& progress) {
  for (std::size_t i = 0; i < work.faces.size(); ++i) {
    progress.advance(repair_units);
    WorkFace& face = work.faces[i];
    if (!face.fault.empty()) continue;
    try {
      if (!(face.has_area ? needs_repair(face.face, work.diagonal) : lacks_image(face.face))) continue;
      copy_shape(work);
      if (!has_loops(face.face)) {
        add_natural_bounds(face, work);
      } else if (!end_at_poles(face, work)) {
        bool is_other = mend_ring(face, work) || turn_loops(face, work);
        is_other |= join_loops(face, work);
        straighten_meridians(face, work);
        join_periodic_edges(face, work);
        repair_edges(face, work);
        if (is_other || !face.has_area) measure_again(face, work);
      }
    } catch (const Standard_Failure& failure) {
      face.fault = "the CAD kernel cannot repair it (" + failure_text(failure) + "); repair it in the CAD program";
      face.has_area = true;
    }
  }
}

}  // namespace paver
