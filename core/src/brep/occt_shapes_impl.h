// What OpenCASCADE's shapes consist of, and from where to where their curves go.
#pragma once

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_Surface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <vector>

namespace paver {

/// The shapes of one kind in another, each once, in the order of TopExp.
inline TopTools_IndexedMapOfShape shapes_of(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape shapes;
  TopExp::MapShapes(shape, kind, shapes);
  return shapes;
}

/// Every use of an edge, with its orientation: one that is used twice comes twice.
inline std::vector<TopoDS_Edge> edges_of(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Edge> edges;
  for (TopExp_Explorer parts(shape, TopAbs_EDGE); parts.More(); parts.Next())
    edges.push_back(TopoDS::Edge(parts.Current()));
  return edges;
}

inline std::vector<TopoDS_Face> faces_of(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Face> faces;
  for (TopExp_Explorer parts(shape, TopAbs_FACE); parts.More(); parts.Next())
    faces.push_back(TopoDS::Face(parts.Current()));
  return faces;
}

/// The loops of a face, as it has them.
inline std::vector<TopoDS_Wire> wires_of(const TopoDS_Face& face) {
  std::vector<TopoDS_Wire> wires;
  for (TopoDS_Iterator parts(face); parts.More(); parts.Next())
    if (parts.Value().ShapeType() == TopAbs_WIRE) wires.push_back(TopoDS::Wire(parts.Value()));
  return wires;
}

/// The face with another loop, in place of one of its own where that is not null.
inline TopoDS_Face face_with(const TopoDS_Face& face, const TopoDS_Wire& wire, const TopoDS_Shape& replaced) {
  TopoDS_Face made = TopoDS::Face(face.EmptyCopied());
  BRep_Builder builder;
  builder.NaturalRestriction(made, Standard_False);
  for (TopoDS_Iterator parts(face); parts.More(); parts.Next())
    builder.Add(made, parts.Value().IsSame(replaced) ? wire : parts.Value());
  if (replaced.IsNull()) builder.Add(made, wire);
  return made;
}

/// How often the shape uses an edge.
inline long use_count(const TopoDS_Edge& edge, const TopoDS_Shape& shape) {
  return std::ranges::count_if(edges_of(shape), [&](const TopoDS_Edge& use) { return use.IsSame(edge); });
}

/// Whether a face has a solid, or an edge a face, on one side only: not inside of it.
inline bool is_bounding(const TopoDS_Shape& shape) {
  return shape.Orientation() == TopAbs_FORWARD || shape.Orientation() == TopAbs_REVERSED;
}

inline TopoDS_Edge forward(const TopoDS_Edge& edge) { return TopoDS::Edge(edge.Oriented(TopAbs_FORWARD)); }
inline TopoDS_Face forward(const TopoDS_Face& face) { return TopoDS::Face(face.Oriented(TopAbs_FORWARD)); }

/// Parameters of a curve.
struct CurveRange {
  double first = 0, last = 0;
  bool is_finite() const { return !Precision::IsInfinite(first) && !Precision::IsInfinite(last); }
  double at(double share) const { return first + share * (last - first); }
};

inline CurveRange range_of(const TopoDS_Edge& edge) {
  CurveRange range;
  BRep_Tool::Range(edge, range.first, range.last);
  return range;
}

/// An edge in the (u, v) of a face.
struct EdgeImage : CurveRange {
  Handle(Geom2d_Curve) curve;  ///< null: it has none there
  gp_Pnt2d uv(double share) const { return curve->Value(at(share)); }
};

inline EdgeImage image_of(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  EdgeImage image;
  image.curve = BRep_Tool::CurveOnSurface(edge, face, image.first, image.last);
  return image;
}

/// The curve under its trims.
inline Handle(Geom_Curve) untrimmed(Handle(Geom_Curve) curve) {
  while (auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve)) curve = trimmed->BasisCurve();
  return curve;
}

/// The surface under its trims.
inline Handle(Geom_Surface) untrimmed(Handle(Geom_Surface) surface) {
  while (auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface)) surface = trimmed->BasisSurface();
  return surface;
}

}  // namespace paver
