#include "support/faulty_shapes.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepTools_ReShape.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Plane.hxx>
#include <Geom_Surface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <functional>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <map>

namespace paver::test {
namespace {

std::vector<TopoDS_Shape> parts_of(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, kind, map);
  std::vector<TopoDS_Shape> parts;
  for (int i = 1; i <= map.Extent(); ++i) parts.push_back(map(i));
  return parts;
}

TopoDS_Shape copy_of(const TopoDS_Shape& shape) { return BRepBuilderAPI_Copy(shape).Shape(); }

/// A copy whose faces are what `make` makes of them; edges and vertices stay common.
TopoDS_Shape with_faces(const TopoDS_Shape& shape, const std::function<TopoDS_Shape(const TopoDS_Face&)>& make) {
  const TopoDS_Shape copy = copy_of(shape);
  BRepTools_ReShape context;
  for (const TopoDS_Shape& face : parts_of(copy, TopAbs_FACE)) {
    const TopoDS_Face forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
    context.Replace(forward, make(forward));
  }
  return context.Apply(copy);
}

bool is_flat(const TopoDS_Face& face) { return !Handle(Geom_Plane)::DownCast(BRep_Tool::Surface(face)).IsNull(); }

/// The face with other loops.
TopoDS_Face with_loops(const TopoDS_Face& face, const std::vector<TopoDS_Wire>& loops) {
  TopoDS_Face made = TopoDS::Face(face.EmptyCopied());
  for (const TopoDS_Wire& loop : loops) BRep_Builder().Add(made, loop);
  return made;
}

TopoDS_Wire wire_of(const std::vector<TopoDS_Shape>& edges) {
  TopoDS_Wire wire;
  BRep_Builder().MakeWire(wire);
  for (const TopoDS_Shape& edge : edges) BRep_Builder().Add(wire, edge);
  wire.Closed(true);
  return wire;
}

std::vector<TopoDS_Shape> members(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Shape> list;
  for (TopoDS_Iterator parts(shape); parts.More(); parts.Next()) list.push_back(parts.Value());
  return list;
}

/// Edges in one loop per group that hangs together by vertices.
std::vector<TopoDS_Wire> chained(std::vector<TopoDS_Shape> edges) {
  std::vector<TopoDS_Wire> loops;
  while (!edges.empty()) {
    std::vector<TopoDS_Shape> group{edges.front()};
    edges.erase(edges.begin());
    for (bool is_grown = true; is_grown;) {
      is_grown = false;
      for (std::size_t i = 0; i < edges.size() && !is_grown; ++i) {
        if (!TopExp::FirstVertex(TopoDS::Edge(edges[i]), true)
                 .IsSame(TopExp::LastVertex(TopoDS::Edge(group.back()), true)))
          continue;
        group.push_back(edges[i]);
        edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(i));
        is_grown = true;
      }
    }
    loops.push_back(wire_of(group));
  }
  return loops;
}

/// Calls `change` with image and range for edges of curved faces, each use by itself, `every` counting over all.
TopoDS_Shape with_images(
    const TopoDS_Shape& shape, int every,
    const std::function<Handle(Geom2d_Curve)(const Handle(Geom2d_Curve) &, const TopoDS_Face&, double, double)>& make,
    double tolerance = 0) {
  const TopoDS_Shape copy = copy_of(shape);
  int count = 0;
  for (const TopoDS_Shape& part : parts_of(copy, TopAbs_FACE)) {
    const TopoDS_Face face = TopoDS::Face(part.Oriented(TopAbs_FORWARD));
    if (is_flat(face)) continue;
    for (const TopoDS_Shape& edge_part : parts_of(face, TopAbs_EDGE)) {
      const TopoDS_Edge edge = TopoDS::Edge(edge_part.Oriented(TopAbs_FORWARD));
      if (BRep_Tool::IsClosed(edge, face) || BRep_Tool::Degenerated(edge) || count++ % every) continue;
      double first = 0, last = 0;
      const Handle(Geom2d_Curve) image = BRep_Tool::CurveOnSurface(edge, face, first, last);
      BRep_Builder().UpdateEdge(edge, make(image, face, first, last), face,
                                std::max(tolerance, BRep_Tool::Tolerance(edge)));
      BRep_Builder().Range(edge, face, first, last);
    }
  }
  return copy;
}

}  // namespace

TopoDS_Shape slotted_tube() {
  TopoDS_Shape tube = BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(30, 100),
                                      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -1), gp_Dir(0, 0, 1)), 21, 102));
  for (double z : {12.0, 62.0})
    tube = BRepAlgoAPI_Cut(tube, BRepPrimAPI_MakeBox(gp_Pnt(0, -8, z), gp_Pnt(40, 8, z + 22)));
  tube = BRepAlgoAPI_Cut(tube, BRepPrimAPI_MakeBox(gp_Pnt(-7, 0, 30), gp_Pnt(7, 40, 70)));
  return BRepAlgoAPI_Cut(tube, BRepPrimAPI_MakeBox(gp_Pnt(-40, -6, 40), gp_Pnt(0, 6, 55)));
}

TopoDS_Shape cone_on_ball() {
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 30, -std::acos(0.0), 0);
  return BRepAlgoAPI_Fuse(ball, BRepPrimAPI_MakeCone(30, 0, 70));
}

TopoDS_Shape frustum() { return BRepPrimAPI_MakeCone(20, 12, 30).Shape(); }

TopoDS_Shape quarter_ring() {
  BRepBuilderAPI_MakeWire profile;
  const gp_Ax2 corner(gp_Pnt(30, 0, 12), gp_Dir(0, -1, 0), gp_Dir(1, 0, 0));
  profile.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(10, 0, 0), gp_Pnt(38, 0, 0)));
  profile.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(38, 0, 0), gp_Pnt(38, 0, 12)));
  profile.Add(BRepBuilderAPI_MakeEdge(gp_Circ(corner, 8), gp_Pnt(38, 0, 12), gp_Pnt(30, 0, 20)));
  profile.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(30, 0, 20), gp_Pnt(10, 0, 20)));
  profile.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(10, 0, 20), gp_Pnt(10, 0, 0)));
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(profile.Wire());
  return BRepPrimAPI_MakeRevol(face, gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), std::acos(0.0));
}

TopoDS_Shape with_garbled_rings(const TopoDS_Shape& shape, bool has_poles) {
  return with_faces(shape, [has_poles](const TopoDS_Face& face) -> TopoDS_Shape {
    if (is_flat(face)) return face;
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
    BRep_Builder builder;
    std::vector<TopoDS_Shape> edges;
    TopoDS_Shape seam;
    for (const TopoDS_Shape& wire : members(face))
      for (const TopoDS_Shape& part : members(wire)) {
        const TopoDS_Edge edge = TopoDS::Edge(part);
        if (BRep_Tool::IsClosed(edge, face)) {
          if (seam.IsNull()) edges.push_back(seam = edge);
          continue;
        }
        double first = 0, last = 0;
        const Handle(Geom2d_Curve) image = BRep_Tool::CurveOnSurface(edge, face, first, last);
        const double v = image->Value(first).Y(), period = surface->UPeriod();
        TopoDS_Edge pole;
        builder.MakeEdge(pole);
        builder.UpdateEdge(pole, new Geom2d_Line(gp_Pnt2d(-period, v), gp_Dir2d(1, 0)), face, 1e-7);
        builder.Range(pole, 0, period);
        builder.Degenerated(pole, true);
        const TopoDS_Vertex vertex = TopExp::FirstVertex(edge);
        builder.Add(pole, vertex.Oriented(TopAbs_FORWARD));
        builder.Add(pole, vertex.Oriented(TopAbs_REVERSED));
        builder.UpdateVertex(vertex, 20);
        if (!seam.IsNull())  // the second loop ends up a period aside
          builder.UpdateEdge(edge, Handle(Geom2d_Curve)::DownCast(image->Translated(gp_Vec2d(-period, 0))), face, 1e-7);
        if (has_poles) edges.push_back(pole);
        edges.push_back(edge);
      }
    return with_loops(face, {wire_of(edges)});
  });
}

TopoDS_Shape with_allowed_images(const TopoDS_Shape& shape) {
  constexpr double allowed = 40;
  return with_images(
      shape, 1,
      [](const Handle(Geom2d_Curve) & image, const TopoDS_Face& face, double first, double last) {
        const double aside = BRep_Tool::Surface(face)->IsUPeriodic() ? 2 * std::acos(0.0) : 0;
        TColgp_Array1OfPnt2d points(1, 2);
        TColStd_Array1OfReal knots(1, 2);
        TColStd_Array1OfInteger multiplicities(1, 2);
        points(1) = image->Value(first).Translated(gp_Vec2d(aside, 0)), points(2) = image->Value(last);
        knots(1) = first, knots(2) = last;
        multiplicities.Init(2);
        return Handle(Geom2d_Curve)(new Geom2d_BSplineCurve(points, knots, multiplicities, 1));
      },
      allowed);
}

TopoDS_Shape with_loose_vertices(const TopoDS_Shape& shape, double gap) {
  const TopoDS_Shape copy = copy_of(shape);
  BRepTools_ReShape context;
  BRep_Builder builder;
  int count = 0;
  for (const TopoDS_Shape& part : parts_of(copy, TopAbs_EDGE)) {
    const TopoDS_Edge edge = TopoDS::Edge(part.Oriented(TopAbs_FORWARD));
    TopoDS_Edge made = TopoDS::Edge(edge.EmptyCopied());
    std::map<const Standard_Transient*, TopoDS_Vertex> vertices;
    for (const TopoDS_Shape& end : members(edge)) {
      TopoDS_Vertex& vertex = vertices[end.TShape().get()];
      if (vertex.IsNull()) {
        ++count;
        const gp_Vec aside(count % 2 ? gap : 0, count % 3 ? gap : 0, 0);
        builder.MakeVertex(vertex, BRep_Tool::Pnt(TopoDS::Vertex(end)).Translated(aside), 1e-7);
      }
      builder.Add(made, vertex.Oriented(end.Orientation()));
    }
    context.Replace(edge, made);
  }
  return context.Apply(copy);
}

TopoDS_Shape without_periodic_edges(const TopoDS_Shape& shape) {
  return with_faces(shape, [](const TopoDS_Face& face) {
    std::vector<TopoDS_Shape> edges;
    for (TopExp_Explorer uses(face, TopAbs_EDGE); uses.More(); uses.Next())
      if (!BRep_Tool::IsClosed(TopoDS::Edge(uses.Current()), face)) edges.push_back(uses.Current());
    return with_loops(face, chained(edges));
  });
}

TopoDS_Shape with_shifted_images(const TopoDS_Shape& shape) {
  return with_images(shape, 3, [](const Handle(Geom2d_Curve) & image, const TopoDS_Face& face, double, double) {
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
    const Handle(Geom2d_Curve) moved = Handle(Geom2d_Curve)::DownCast(image->Copy());
    moved->Translate(gp_Vec2d(surface->IsUPeriodic() ? surface->UPeriod() : 0, 0));
    return moved;
  });
}

TopoDS_Shape with_wrong_images(const TopoDS_Shape& shape) {
  return with_images(shape, 5, [](const Handle(Geom2d_Curve) & image, const TopoDS_Face&, double, double) {
    const Handle(Geom2d_Curve) moved = Handle(Geom2d_Curve)::DownCast(image->Copy());
    moved->Translate(gp_Vec2d(0.7, 5));
    return moved;
  });
}

TopoDS_Shape with_uneven_images(const TopoDS_Shape& shape) {
  return with_images(shape, 1, [](const Handle(Geom2d_Curve) & image, const TopoDS_Face&, double first, double last) {
    constexpr int count = 41;
    TColgp_Array1OfPnt2d points(1, count);
    TColStd_Array1OfReal knots(1, count);
    TColStd_Array1OfInteger multiplicities(1, count);
    for (int i = 0; i < count; ++i) {
      const double s = i / (count - 1.0), uneven = s + 0.3 * s * (1 - s);
      points(i + 1) = image->Value(first + (last - first) * uneven);
      knots(i + 1) = first + (last - first) * s;
      multiplicities(i + 1) = i == 0 || i == count - 1 ? 2 : 1;
    }
    return Handle(Geom2d_Curve)(new Geom2d_BSplineCurve(points, knots, multiplicities, 1));
  });
}

TopoDS_Shape without_poles(const TopoDS_Shape& shape) {
  return with_faces(shape, [](const TopoDS_Face& face) {
    std::vector<TopoDS_Wire> loops;
    for (const TopoDS_Shape& wire : members(face)) {
      std::vector<TopoDS_Shape> edges;
      for (const TopoDS_Shape& edge : members(wire))
        if (!BRep_Tool::Degenerated(TopoDS::Edge(edge))) edges.push_back(edge);
      loops.push_back(TopoDS::Wire(wire_of(edges).Oriented(wire.Orientation())));
    }
    return with_loops(face, loops);
  });
}

TopoDS_Shape with_shuffled_loops(const TopoDS_Shape& shape) {
  return with_faces(shape, [](const TopoDS_Face& face) {
    std::vector<TopoDS_Wire> loops;
    for (const TopoDS_Shape& wire : members(face)) {
      std::vector<TopoDS_Shape> edges = members(wire);
      for (std::size_t i = 1; i + 1 < edges.size(); i += 2) std::swap(edges[i], edges[i + 1]);
      loops.push_back(TopoDS::Wire(wire_of(edges).Oriented(wire.Orientation())));
    }
    return with_loops(face, loops);
  });
}

TopoDS_Shape with_turned_faces(const TopoDS_Shape& shape) {
  BRep_Builder builder;
  TopoDS_Shell shell;
  TopoDS_Solid solid;
  builder.MakeShell(shell);
  builder.MakeSolid(solid);
  int count = 0;
  for (const TopoDS_Shape& face : parts_of(copy_of(shape), TopAbs_FACE))
    builder.Add(shell, ++count % 2 ? face : face.Reversed());
  builder.Add(solid, shell);
  return solid;
}

TopoDS_Shape with_doubled_faces(const TopoDS_Shape& shape) {
  BRep_Builder builder;
  TopoDS_Compound loose;
  builder.MakeCompound(loose);
  int count = 0;
  for (const TopoDS_Shape& face : parts_of(shape, TopAbs_FACE)) {
    builder.Add(loose, copy_of(face));
    if (count++ % 3 == 0) builder.Add(loose, copy_of(face).Reversed());
  }
  return loose;
}

TopoDS_Shape with_doubled_shell(const TopoDS_Shape& shape) {
  BRep_Builder builder;
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  const TopoDS_Shape shell = parts_of(shape, TopAbs_SHELL).front();
  builder.Add(solid, copy_of(shell));
  builder.Add(solid, copy_of(shell).Reversed());
  return solid;
}

TopoDS_Shape plate_with_corners_aside(double aside) {
  const TopoDS_Shape plate =
      copy_of(BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 0, 20, 0, 20).Shape());
  for (const TopoDS_Shape& vertex : parts_of(plate, TopAbs_VERTEX))
    BRep_Builder().UpdateVertex(TopoDS::Vertex(vertex),
                                BRep_Tool::Pnt(TopoDS::Vertex(vertex)).Translated(gp_Vec(aside, aside, 0)), 2 * aside);
  return plate;
}

TopoDS_Shape without_an_edge(const TopoDS_Shape& shape) {
  bool is_done = false;
  return with_faces(shape, [&](const TopoDS_Face& face) -> TopoDS_Shape {
    if (is_done || !is_flat(face)) return face;
    is_done = true;
    std::vector<TopoDS_Shape> edges = members(members(face).front());
    edges.pop_back();
    return with_loops(face, {wire_of(edges)});
  });
}

TopoDS_Shape lens() {
  const double low = std::asin(0.8);
  const TopoDS_Shape top =
      BRepPrimAPI_MakeSphere(gp_Ax2(gp_Pnt(0, 0, -24), gp_Dir(0, 0, 1)), 30, low, std::acos(0.0)).Face();
  BRepBuilderAPI_Sewing sewing(1e-6);
  gp_Trsf down;
  down.SetMirror(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)));
  sewing.Add(top);
  sewing.Add(BRepBuilderAPI_Transform(top, down, true).Shape());
  sewing.Perform();
  return sewing.SewedShape();
}

double FaultyShape::area() const {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(clean(), properties);
  return properties.Mass();
}

std::vector<FaultyShape> faulty_shapes() {
  auto garbled = [](bool has_poles) {
    return [has_poles](const TopoDS_Shape& shape) { return with_garbled_rings(shape, has_poles); };
  };
  auto loose = [](double gap) { return [gap](const TopoDS_Shape& shape) { return with_loose_vertices(shape, gap); }; };
  return {
      {"CleanTube", slotted_tube, copy_of, {}},
      {"OpenTube", slotted_tube, loose(0), {"closed loops"}},
      {"OpenTubeWithGaps", slotted_tube, loose(1e-3), {"closed loops", "images"}},
      {"OpenCone", cone_on_ball, loose(1e-3), {"closed loops"}},
      {"TubeWithoutPeriodicEdges", slotted_tube, without_periodic_edges, {"periodic edges"}},
      {"ConeWithoutPeriodicEdges", cone_on_ball, without_periodic_edges, {"periodic edges"}},
      {"ConeWithoutPoles", cone_on_ball, without_poles, {"poles"}},
      {"TubeWithShiftedImages", slotted_tube, with_shifted_images, {"images"}},
      {"ConeWithShiftedImages", cone_on_ball, with_shifted_images, {"images"}},
      {"TubeWithWrongImages", slotted_tube, with_wrong_images, {"images"}},
      {"ConeWithWrongImages", cone_on_ball, with_wrong_images, {"images"}},
      {"RingWithAllowedImages", quarter_ring, with_allowed_images, {"images"}},
      {"FrustumWithFalsePoles", frustum, garbled(true), {"poles"}},
      {"FrustumWithImagesApart", frustum, garbled(false), {"periodic edges"}},
      {"TubeWithUnevenImages", slotted_tube, with_uneven_images, {"images"}},
      {"ShuffledTube", slotted_tube, with_shuffled_loops, {}},
      {"TubeWithTurnedFaces", slotted_tube, with_turned_faces, {"turned faces"}},
      {"TubeWithDoubledFaces", slotted_tube, with_doubled_faces, {"sewn edges", "dropped faces"}},
      {"TubeWithDoubledShell", slotted_tube, with_doubled_shell, {"dropped faces"}},
      {"ConeWithDoubledShell", cone_on_ball, with_doubled_shell, {"dropped faces"}},
  };
}

}  // namespace paver::test
