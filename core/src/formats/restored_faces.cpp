// Which faces were read wrong: those without the poles that their loops lead to; those whose loops run the other way
// than in the file, where these can be told.
#include <BRepAdaptor_Curve.hxx>
#include <BRepTools_ReShape.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <TopAbs.hxx>
#include <TopLoc_Location.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "formats/restored_faces_impl.h"

namespace paver {
namespace {

constexpr int edge_samples = 16;
constexpr std::size_t most_asked_edges = 64;
constexpr double same_place = 1e-3;  // of the period, or of the surface in v
constexpr double pole_reach = 1e-4;  // of the surface's height: how far from a pole an edge ends that leads there

/// Whether the face holds both poles of its surface, and lies within one period.
bool has_both_poles(const TopoDS_Face& face) {
  const Handle(Geom_Surface) surface = periodic_surface(face);
  if (surface.IsNull()) return false;
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  surface->Bounds(u0, u1, v0, v1);
  int poles = 0;
  double low = INFINITY, high = -INFINITY;
  for (const TopoDS_Edge& edge : edges_of(face)) {
    poles += BRep_Tool::Degenerated(edge);
    const EdgeImage image = image_of(edge, face);
    for (int i = 0; !image.curve.IsNull() && i <= edge_samples; ++i) {
      const double u = image.curve->Value(image.first + (image.last - image.first) * i / edge_samples).X();
      low = std::min(low, u), high = std::max(high, u);
    }
  }
  return poles == 2 && high - low < (1 + same_place) * (u1 - u0);
}

/// Whether a dead end is a pole of the surface that the face lacks; a slit may end anywhere.
bool lacks_pole_at(const TopoDS_Face& face, const gp_Pnt& end) {
  if (!has_two_poles(face)) return false;
  const Handle(Geom_Surface) surface = untrimmed(BRep_Tool::Surface(face));
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  surface->Bounds(u0, u1, v0, v1);
  const double low = surface->Value(u0, v0).Distance(end), high = surface->Value(u0, v1).Distance(end);
  if (std::min(low, high) > pole_reach * std::max(low, high)) return false;
  const double pole = low < high ? v0 : v1;
  return std::ranges::none_of(edges_of(face), [&](const TopoDS_Edge& edge) {
    const EdgeImage image = image_of(edge, face);
    return BRep_Tool::Degenerated(edge) && !image.curve.IsNull() &&
           std::fabs(image.uv(0.5).Y() - pole) < same_place * (v1 - v0);
  });
}

bool lacks_pole(const FileFace& face) {
  const TopoDS_Face read = forward(face.read.front());
  if (face.dead_ends.size() == 2) return !has_both_poles(read);
  return face.dead_ends.size() == 1 && lacks_pole_at(read, face.dead_ends[0]);
}

/// Whether a loop runs the other way than in the file.
bool is_turned(const FileFace& face, const std::vector<FileEdge>& file) {
  for (const TopoDS_Face& read : face.read)
    for (const TopoDS_Wire& wire : wires_of(forward(read))) {
      std::vector<TopoDS_Edge> edges;
      for (const TopoDS_Edge& edge : edges_of(wire))
        if (!BRep_Tool::Degenerated(edge) && !BRep_Tool::IsClosed(edge, read)) edges.push_back(edge);
      if (agreement(edges, file) < 0) return true;
    }
  return false;
}

/// Whether what a loop leaves of the surface may have an end, too.
bool may_be_either_side(const FileFace& face) {
  TopLoc_Location location;
  const Handle(Geom_Surface) surface = untrimmed(BRep_Tool::Surface(face.read.front(), location));
  return !surface.IsNull() && surface->IsUClosed() && !surface->IsKind(STANDARD_TYPE(Geom_CylindricalSurface)) &&
         !surface->IsKind(STANDARD_TYPE(Geom_SurfaceOfLinearExtrusion));
}

/// Faces turned less the others.
struct TurnedSums {
  std::map<int, int> of_shells;
  int against = 0, along = 0;  ///< of all whose normals are against those of their surfaces, or along these

  int& of_sense(const FileFace& face) { return face.is_along_surface ? along : against; }

  void add(const FileFace& face, int sign) {
    of_sense(face) += sign;
    if (face.shell >= 0) of_shells[face.shell] += sign;
  }

  /// Some writers take the side of the surface for that of the face; in a shell with others that shows.
  int about(const FileFace& face) { return face.shell >= 0 ? of_shells[face.shell] : of_sense(face); }
};

/// Places of faces that have a loop the other way round than in the file. Not where most of their shell have, or most
/// faces that look the same way from their surface.
std::vector<std::size_t> turned_faces(const std::vector<FileFace>& faces) {
  std::vector<std::size_t> turned;
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (faces[i].are_loops_known && may_be_either_side(faces[i]) && is_turned(faces[i], faces[i].edges()))
      turned.push_back(i);
  if (turned.empty()) return turned;
  TurnedSums sums;
  for (const FileFace& face : faces)
    if (const std::vector<FileEdge> edges = face.edges(); face.are_loops_known && edges.size() <= most_asked_edges)
      sums.add(face, is_turned(face, edges) ? 1 : -1);
  std::erase_if(turned, [&](std::size_t i) { return sums.about(faces[i]) > 0; });
  return turned;
}

std::vector<FileEdge> reversed(std::vector<FileEdge> walked) {
  for (FileEdge& edge : walked)
    for (gp_Vec& way : edge.ways) way.Reverse();
  return walked;
}

/// Whichever way the file's loops run where they lead to a pole.
std::optional<TopoDS_Face> made_anew(const FileFace& face) {
  const std::vector<FileEdge> walked = face.edges();
  if (face.dead_ends.size() != 1) return make_whole_face(face.read, walked);
  for (const std::vector<FileEdge>& way : {walked, reversed(walked)})
    if (const std::optional<TopoDS_Face> made = make_whole_face(face.read, way);
        made && !lacks_pole_at(forward(*made), face.dead_ends[0]))
      return made;
  return std::nullopt;
}

}  // namespace

template <class Visit>
void FaceChanges::visit(const std::vector<TopoDS_Face>& read, Visit&& at) const {
  for (int k = 1; k <= before_.Extent(); ++k)
    for (const TopoDS_Face& face : read)
      if (before_(k).IsPartner(face)) at(k, face);
}

void FaceChanges::replace(const std::vector<TopoDS_Face>& read, const TopoDS_Face& made) {
  visit(read, [&](int k, const TopoDS_Face& face) {
    if (!face.IsSame(read.front())) {
      gone_.insert(k);
      return;
    }
    const TopAbs_Orientation turn = TopAbs::Compose(before_(k).Orientation(), face.Orientation());
    made_[k] = made.Located(before_(k).Location()).Oriented(TopAbs::Compose(made.Orientation(), turn));
  });
}

void FaceChanges::leave_turned(const std::vector<TopoDS_Face>& read) {
  visit(read, [&](int k, const TopoDS_Face&) { turned_.insert(k); });
}

void FaceChanges::apply(Shape& shape) const {
  BRepTools_ReShape change;
  change.ModeConsiderLocation() = true;  // parts may stand in several places
  for (const auto& [k, made] : made_) change.Replace(before_(k), made);
  for (const int k : gone_) change.Remove(before_(k));
  if (!made_.empty()) shape.shape = change.Apply(shape.shape);
  const auto after = shapes_of(shape.shape, TopAbs_FACE);
  for (const auto& [k, made] : made_) shape.restored.push_back(after.FindIndex(made) - 1);
  for (const int k : turned_) shape.turned.push_back(after.FindIndex(before_(k)) - 1);
  for (auto k = gone_.rbegin(); k != gone_.rend(); ++k)
    if (*k <= static_cast<int>(shape.labels.size())) shape.labels.erase(shape.labels.begin() + (*k - 1));
}

void restore_faces(const std::vector<FileFace>& faces, FaceChanges& changes) {
  const std::vector<std::size_t> turned = turned_faces(faces);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const FileFace& face = faces[i];
    const bool lacks_poles = lacks_pole(face);
    if (!lacks_poles && !std::binary_search(turned.begin(), turned.end(), i)) continue;
    // The reader may have turned the face over with its loop.
    const TopAbs_Orientation sense = face.is_read_turned ? TopAbs_REVERSED : TopAbs_FORWARD;
    if (const std::optional<TopoDS_Face> whole = made_anew(face))
      changes.replace(face.read, TopoDS::Face(whole->Oriented(sense)));
    else if (!lacks_poles && (face.read.size() > 1 || may_be_whole(face.read)))
      changes.leave_turned(face.read);  // a patch of a cylinder has one side only, whatever the file says
  }
}

}  // namespace paver
