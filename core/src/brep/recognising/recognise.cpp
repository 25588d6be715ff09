// Which faces and edges get another surface or curve, decided before anything is changed.
// 1. What could be: surfaces of faces, curves of edges.
// 2. Every edge of such a face, and every such edge, needs an image on each of its faces: on planes none, else an
//    iso-line for a line or arc, the converted image for a curve that stays. An edge without all of them keeps its
//    curve; a face with an edge that has none keeps its surface; until nothing changes.
// 3. Surfaces, curves and images are put in place.
#include <BRep_Builder.hxx>
#include <BRep_TEdge.hxx>
#include <Geom2dAPI_Interpolate.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_ElementarySurface.hxx>
#include <Geom_Plane.hxx>
#include <NCollection_IndexedDataMap.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_HArray1OfPnt2d.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <algorithm>
#include <cmath>
#include <vector>

#include "brep/occt_impl.h"
#include "brep/occt_shapes_impl.h"
#include "brep/recognising/recognise_impl.h"

namespace paver {
namespace {

/// Surfaces and curves that are one are no farther apart than this share of the diagonal; curves, where their
/// tolerance is larger, than that and the second share: they may have been laid through points.
constexpr double same_share = 1e-8, coarse_share = 1e-6;
/// The other parameter of an iso-line changes by less, mm or radians.
constexpr double iso_change = 1e-7;
/// Places along an edge where image and curve are compared; and points that converted images are laid through, between
/// these: an image may start a period away from where it goes on.
constexpr int samples = 25, image_points = 33;

struct FaceChange {
  TopoDS_Face face;  ///< FORWARD
  std::optional<Elementary> elementary;
};

/// An edge in a face: one image, or two of a periodic edge; none on a plane.
struct EdgeUse {
  int face = -1;  ///< of the changes
  std::vector<Handle(Geom2d_Curve)> images;
  CurveRange range;
};

struct EdgeChange {
  TopoDS_Edge edge;  ///< FORWARD
  std::optional<PlainCurve> plain;
  std::vector<EdgeUse> uses;
};

class Recognition {
 public:
  explicit Recognition(Workpiece& work) : work_(work) {
    list_faces();
    list_edges();
  }

  bool has_candidates() const {
    return std::ranges::any_of(faces_, [](const FaceChange& face) { return face.elementary.has_value(); }) ||
           std::ranges::any_of(edges_, [](const EdgeChange& edge) { return edge.plain.has_value(); });
  }

  void decide() {
    bool is_settled = false;
    while (!is_settled) {
      is_settled = true;
      for (EdgeChange& edge : edges_)
        if (is_touched(edge)) is_settled = fit(edge) && is_settled;
    }
  }

  void apply() const {
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      const FaceChange& face = faces_[f];
      if (!face.elementary) continue;
      TopLoc_Location location;
      BRep_Tool::Surface(face.face, location);
      BRep_Builder().UpdateFace(face.face, face.elementary->surface, location, BRep_Tool::Tolerance(face.face));
      work_.faces[f].converted = [convert = face.elementary->converted](Vec2 uv) {
        const gp_Pnt2d there = convert({uv.x, uv.y});
        return Vec2{there.X(), there.Y()};
      };
    }
    for (const EdgeChange& edge : edges_)
      if (is_touched(edge)) apply(edge);
  }

 private:
  void list_faces() {
    for (const WorkFace& work : work_.faces) {
      FaceChange change{forward(work.face), {}};
      try {
        if (work.is_usable()) change.elementary = recognise_surface(change.face, same_share * work_.diagonal);
      } catch (const Standard_Failure&) {
        // What the kernel cannot evaluate is reported where it is used.
      }
      faces_.push_back(std::move(change));
    }
  }

  void list_edges() {
    NCollection_IndexedDataMap<TopoDS_Shape, std::vector<EdgeUse>, TopTools_ShapeMapHasher> uses;
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      const auto edges = shapes_of(faces_[f].face, TopAbs_EDGE);
      for (int i = 1; i <= edges.Extent(); ++i) {
        const TopoDS_Shape edge = edges(i).Oriented(TopAbs_FORWARD);
        if (!uses.Contains(edge)) uses.Add(edge, {});
        uses.ChangeFromKey(edge).push_back({static_cast<int>(f), {}, {}});
      }
    }
    for (int i = 1; i <= uses.Extent(); ++i) {
      EdgeChange change{TopoDS::Edge(uses.FindKey(i)), {}, uses(i)};
      try {
        change.plain = recognise_curve(change.edge, tolerance_of(change.edge));
      } catch (const Standard_Failure&) {
        // Likewise.
      }
      edges_.push_back(std::move(change));
    }
  }

  /// The edge's own as far as it is believed, mm.
  double tolerance_of(const TopoDS_Edge& edge) const {
    return std::clamp(BRep_Tool::Tolerance(edge), same_share * work_.diagonal, coarse_share * work_.diagonal);
  }

  bool is_touched(const EdgeChange& edge) const {
    return edge.plain ||
           std::ranges::any_of(edge.uses, [&](const EdgeUse& use) { return faces_[use.face].elementary.has_value(); });
  }

  /// Makes the images of an edge; false where it or one of its faces stays as it is for want of one.
  bool fit(EdgeChange& edge) {
    for (EdgeUse& use : edge.uses) {
      FaceChange& face = faces_[use.face];
      use.images.clear();
      if (!edge.plain && !face.elementary) continue;
      try {
        if (make_images(edge, face, use)) continue;
      } catch (const Standard_Failure&) {
        // There is none.
      }
      if (edge.plain)
        edge.plain.reset();
      else
        face.elementary.reset();
      return false;
    }
    return true;
  }

  static Handle(Geom_Surface) surface_of(const FaceChange& face) {
    TopLoc_Location location;
    return face.elementary ? face.elementary->surface : untrimmed(BRep_Tool::Surface(face.face, location));
  }

  bool make_images(const EdgeChange& edge, const FaceChange& face, EdgeUse& use) const {
    const Handle(Geom_Surface) surface = surface_of(face);
    // A plane has no poles, and the kernel breaks down on what has no image.
    if (surface->IsKind(STANDARD_TYPE(Geom_Plane))) return !face.elementary || !BRep_Tool::Degenerated(edge.edge);
    if (!surface->IsKind(STANDARD_TYPE(Geom_ElementarySurface))) return false;
    std::vector<TopoDS_Edge> sides = {edge.edge};
    if (BRep_Tool::IsClosed(edge.edge, face.face)) sides.push_back(TopoDS::Edge(edge.edge.Reversed()));
    for (const TopoDS_Edge& side : sides) {
      const EdgeImage old = image_of(side, face.face);
      if (old.curve.IsNull()) return false;
      const Handle(Geom2d_Curve) image = edge.plain ? iso_line(old, face, edge.plain->last) : converted(old, face);
      if (image.IsNull() || !is_near(edge, face, *image, old)) return false;
      use.images.push_back(image);
      use.range = edge.plain ? CurveRange{0, edge.plain->last} : CurveRange(old);
    }
    return true;
  }

  static gp_Pnt2d converted_point(const gp_Pnt2d& uv, const FaceChange& face) {
    return face.elementary ? face.elementary->converted(uv) : uv;
  }

  /// As the old image runs, but by length or angle; null where that is no iso-line.
  static Handle(Geom2d_Curve) iso_line(const EdgeImage& old, const FaceChange& face, double last) {
    auto at = [&](double share) { return converted_point(old.uv(share), face); };
    const gp_Pnt2d start = at(0);
    const gp_Vec2d way(start, at(1));
    const bool is_along_u = std::abs(way.X()) > std::abs(way.Y());
    for (int i = 1; i <= samples; ++i) {
      const gp_Vec2d from(start, at(static_cast<double>(i) / samples));
      if (std::abs(is_along_u ? from.Y() : from.X()) > iso_change) return {};
    }
    const double run = is_along_u ? way.X() : way.Y();
    if (std::abs(std::abs(run) - last) > iso_change * (1 + last)) return {};
    return new Geom2d_Line(start, is_along_u ? gp_Dir2d(run, 0) : gp_Dir2d(0, run));
  }

  /// With the parameters of the edge.
  static Handle(Geom2d_Curve) converted(const EdgeImage& old, const FaceChange& face) {
    const gp_Vec2d shift(old.uv(0), converted_point(old.uv(0), face));
    auto is_shifted = [&](double share) {
      return converted_point(old.uv(share), face).Distance(old.uv(share).Translated(shift)) <= gp::Resolution();
    };
    if (is_shifted(0.3) && is_shifted(0.6) && is_shifted(1)) {
      auto moved = Handle(Geom2d_Curve)::DownCast(old.curve->Copy());
      moved->Translate(shift);
      return moved;
    }
    Handle(TColgp_HArray1OfPnt2d) points = new TColgp_HArray1OfPnt2d(1, image_points);
    Handle(TColStd_HArray1OfReal) parameters = new TColStd_HArray1OfReal(1, image_points);
    for (int i = 0; i < image_points; ++i) {
      const double share = static_cast<double>(i) / (image_points - 1);
      points->SetValue(i + 1, converted_point(old.uv(share), face));
      parameters->SetValue(i + 1, old.at(share));
    }
    Geom2dAPI_Interpolate through(points, parameters, false, gp::Resolution());
    through.Perform();
    if (!through.IsDone()) return {};
    return Handle(Geom2d_Curve)(through.Curve());
  }

  /// Whether an image lies on the edge's curve all along, as far as the edge claims.
  bool is_near(const EdgeChange& change, const FaceChange& face, const Geom2d_Curve& image,
               const EdgeImage& old) const {
    const double tolerance = tolerance_of(change.edge);
    TopLoc_Location of_face, of_edge;
    BRep_Tool::Surface(face.face, of_face);
    const Handle(Geom_Surface) surface = surface_of(face), before = BRep_Tool::Surface(face.face);
    double first = 0, last = 0;
    Handle(Geom_Curve) curve = BRep_Tool::Curve(change.edge, of_edge, first, last);
    if (change.plain) curve = change.plain->curve;
    for (int i = 0; i <= samples; ++i) {
      const double share = static_cast<double>(i) / samples;
      const double t = change.plain ? share * change.plain->last : old.at(share);
      const gp_Pnt2d uv = image.Value(t), old_uv = old.uv(share);
      const gp_Pnt on_surface = surface->Value(uv.X(), uv.Y()).Transformed(of_face.Transformation());
      // Poles and edges without a curve are where they were.
      const gp_Pnt wanted = curve.IsNull() ? before->Value(old_uv.X(), old_uv.Y())
                                           : curve->Value(t).Transformed(of_edge.Transformation());
      if (!(on_surface.Distance(wanted) <= tolerance)) return false;
    }
    return true;
  }

  void apply(const EdgeChange& change) const {
    BRep_Builder builder;
    const double tolerance = BRep_Tool::Tolerance(change.edge);
    if (change.plain) {
      Handle(BRep_TEdge)::DownCast(change.edge.TShape())->ChangeCurves().Clear();
      builder.UpdateEdge(change.edge, change.plain->curve, change.plain->location, tolerance);
    }
    for (const EdgeUse& use : change.uses) {
      if (use.images.empty()) continue;
      const TopoDS_Face& face = faces_[use.face].face;
      if (use.images.size() == 1)
        builder.UpdateEdge(change.edge, use.images[0], face, tolerance);
      else
        builder.UpdateEdge(change.edge, use.images[0], use.images[1], face, tolerance);
      builder.Range(change.edge, face, use.range.first, use.range.last);
    }
    if (change.plain) builder.Range(change.edge, 0, change.plain->last);
  }

  Workpiece& work_;
  std::vector<FaceChange> faces_;
  std::vector<EdgeChange> edges_;
};

}  // namespace

void recognise(Workpiece& work) {
  if (!work.is_copied) {
    if (!Recognition(work).has_candidates()) return;
    copy_shape(work);
  }
  Recognition recognition(work);
  recognition.decide();
  recognition.apply();
}

}  // namespace paver
