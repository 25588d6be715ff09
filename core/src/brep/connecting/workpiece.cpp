// Faces of a shape with their measures, and small questions about faces and edges.
#include <BOPTools_AlgoTools3D.hxx>
#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepGProp.hxx>
#include <BRepGProp_Domain.hxx>
#include <BRepGProp_Face.hxx>
#include <BRepGProp_Vinert.hxx>
#include <Bnd_Box.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <GProp_GProps.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TopLoc_Location.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "base/listed.h"
#include "brep/connecting/workpiece_impl.h"
#include "brep/occt_impl.h"
#include "brep/occt_shapes_impl.h"
#include "brep/surfaces/evaluators_impl.h"

namespace paver {
namespace {

constexpr std::size_t listed_names = 10;
/// Area by the square of the border: of a disc 0.08, of a triangle 4 by 1 0.02.
constexpr double compact_share = 0.01;
/// Points per direction for the bounding box; multiples of 4 meet the extremes of spheres and circles.
constexpr int surface_samples = 32, edge_samples = 64;

/// Points of the surface over the face's range; a plane lies within its edges.
void add_surface_points(const TopoDS_Face& face, Bnd_Box& box) {
  BRepAdaptor_Surface surface(face);
  if (surface.GetType() == GeomAbs_Plane) return;
  double u0 = surface.FirstUParameter(), u1 = surface.LastUParameter();
  double v0 = surface.FirstVParameter(), v1 = surface.LastVParameter();
  if (Precision::IsInfinite(u0) || Precision::IsInfinite(u1) || Precision::IsInfinite(v0) || Precision::IsInfinite(v1))
    return;
  for (int i = 0; i <= surface_samples; ++i)
    for (int j = 0; j <= surface_samples; ++j)
      box.Add(surface.Value(u0 + (u1 - u0) * i / surface_samples, v0 + (v1 - v0) * j / surface_samples));
}

void add_edge_points(const TopoDS_Edge& edge, Bnd_Box& box) {
  if (BRep_Tool::Degenerated(edge)) return;
  BRepAdaptor_Curve curve(edge);
  double t0 = curve.FirstParameter(), t1 = curve.LastParameter();
  if (Precision::IsInfinite(t0) || Precision::IsInfinite(t1)) return;
  for (int i = 0; i <= edge_samples; ++i) box.Add(curve.Value(t0 + (t1 - t0) * i / edge_samples));
}

}  // namespace

const char* repair_name(RepairKind kind) {
  static constexpr const char* names[] = {"sewn edges", "closed loops",   "turned loops",
                                          "images",     "periodic edges", "poles",
                                          "borders",    "turned faces",   "dropped faces"};
  static_assert(std::size(names) == static_cast<std::size_t>(RepairKind::dropped_face) + 1);
  return names[static_cast<std::size_t>(kind)];
}

void measure_diagonal(Workpiece& work) {
  Bnd_Box box;
  for (const WorkFace& face : work.faces) {
    try {
      add_surface_points(face.face, box);
    } catch (const Standard_Failure&) {
      // A face without a usable surface is reported later, as a fault.
    }
  }
  for (int i = 1; i <= work.read_edges.Extent(); ++i) {
    try {
      add_edge_points(TopoDS::Edge(work.read_edges(i)), box);
    } catch (const Standard_Failure&) {
      // An edge without any curve likewise.
    }
  }
  work.diagonal = box.IsVoid() ? 0 : std::sqrt(box.SquareExtent());
  if (!box.IsVoid()) work.centre = 0.5 * (to_vec(box.CornerMin()) + to_vec(box.CornerMax()));
}

Workpiece make_workpiece(const Shape& shape, Progress& progress, SharedTasks& tasks) {
  Workpiece work;
  work.shape = shape.shape;
  const auto faces = shapes_of(shape.shape, TopAbs_FACE), solids = shapes_of(shape.shape, TopAbs_SOLID);
  TopExp::MapShapes(shape.shape, TopAbs_EDGE, work.read_edges);
  work.read_faces = faces.Extent();
  work.faces.resize(static_cast<std::size_t>(faces.Extent()));
  for (int s = solids.Extent(); s >= 1; --s)  // backwards: a face of two solids counts to the first
    for (TopExp_Explorer inner(solids(s), TopAbs_FACE); inner.More(); inner.Next())
      if (is_bounding(inner.Current())) work.faces[faces.FindIndex(inner.Current()) - 1].solid = s - 1;
  std::vector<double> costs;
  for (int i = 1; i <= faces.Extent(); ++i) {
    WorkFace& face = work.faces[i - 1];
    face.face = is_bounding(faces(i)) ? TopoDS::Face(faces(i)) : forward(TopoDS::Face(faces(i)));
    face.origin = i - 1;
    costs.push_back(measuring_cost(face.face));
  }
  measure_diagonal(work);
  const std::vector<double> areas =
      tasks.run<double>(Stage::topology, costs, [&](int i) { return face_area(work.faces[i].face); });
  for (std::size_t i = 0; i < work.faces.size(); ++i) {
    WorkFace& face = work.faces[i];
    face.area = areas[i];
    if (!std::isfinite(face.area)) {
      face.area = 0;
      face.fault = "its area cannot be computed";
    }
    // A face without loops gets its bounds, and with them its area, in repair().
    bool has_loops = TopExp_Explorer(face.face, TopAbs_WIRE).More();
    face.has_area = !face.fault.empty() || !has_loops || work.has_area(face);
    progress.advance(measure_units);
  }
  for (const int face : shape.turned)
    work.faces[face].fault = "it was read as what its loops leave of the surface; divide it in the CAD program";
  for (const int face : shape.restored) work.note_repair(RepairKind::pole, 1, 0, face_name(face));
  return work;
}

bool Workpiece::has_area(const WorkFace& face) const {
  if (is_area(face.area) || face.solid < 0) return is_area(face.area);
  double border = 0, longest = 0;
  for (const TopoDS_Edge& edge : edges_of(face.face)) {
    if (BRep_Tool::Degenerated(edge)) continue;
    const double length = edge_length(edge);
    border += length;
    longest = std::max(longest, length);
  }
  return longest > point_share * diagonal && face.area > compact_share * border * border;
}

void Workpiece::note_repair(RepairKind kind, long count, double distance, const std::string& face) {
  if (count == 0) return;
  auto at = std::find_if(repairs.begin(), repairs.end(), [&](const Repair& repair) { return repair.kind >= kind; });
  if (at == repairs.end() || at->kind != kind) at = repairs.insert(at, {kind, 0, 0, {}});
  at->count += count;
  at->distance = std::max(at->distance, distance);
  if (!face.empty() && (at->faces.empty() || at->faces.back() != face)) at->faces.push_back(face);
}

void copy_shape(Workpiece& work) {
  if (work.is_copied) return;
  BRepBuilderAPI_Copy copy(work.shape, Standard_False);
  const auto faces = shapes_of(copy.Shape(), TopAbs_FACE);
  if (static_cast<std::size_t>(faces.Extent()) != work.faces.size())
    throw Error(ErrorCode::internal, "The copy of the shape has another number of faces.", {"topology", -1, -1, {}});
  work.shape = copy.Shape();
  work.read_edges = shapes_of(work.shape, TopAbs_EDGE);
  for (int i = 1; i <= faces.Extent(); ++i) work.faces[i - 1].face = TopoDS::Face(faces(i));
  for (WorkWire& wire : work.wires) wire.edge = TopoDS::Edge(copy.ModifiedShape(wire.edge));
  for (WorkPoint& point : work.points) point.vertex = TopoDS::Vertex(copy.ModifiedShape(point.vertex));
  work.is_copied = true;
}

TopTools_IndexedMapOfShape edge_map(const Workpiece& work) {
  TopTools_IndexedMapOfShape edges;
  if (!work.is_rebuilt) return work.read_edges;
  for (const WorkFace& face : work.faces) TopExp::MapShapes(face.face, TopAbs_EDGE, edges);
  for (const WorkWire& wire : work.wires) edges.Add(wire.edge);
  return edges;
}

std::vector<int> edge_origins(const Workpiece& work, const TopoDS_Shape& edge) {
  if (const auto* origins = work.replaced_edges.Seek(edge)) return *origins;
  int position = work.read_edges.FindIndex(edge);
  return position > 0 ? std::vector<int>{position - 1} : std::vector<int>();
}

void add_edge_origins(Workpiece& work, const TopoDS_Shape& image, const TopoDS_Shape& edge) {
  const std::vector<int> origins = edge_origins(work, edge);
  for (const TopoDS_Edge& piece : edges_of(image)) {
    const std::vector<int> known = edge_origins(work, piece);
    std::set<int> all(known.begin(), known.end());
    all.insert(origins.begin(), origins.end());
    work.replaced_edges.Bind(piece, {all.begin(), all.end()});
  }
}

void Hanging::add(std::size_t item, const TopoDS_Shape& shape) {
  for (TopExp_Explorer inner(shape, by_); inner.More(); inner.Next()) {
    if (by_ == TopAbs_EDGE && BRep_Tool::Degenerated(TopoDS::Edge(inner.Current()))) continue;
    const int index = first_item_.Add(inner.Current(), static_cast<int>(item));
    groups_.merge(first_item_(index), static_cast<int>(item));
  }
}

void EdgeUses::add(const TopoDS_Face& face) {
  for (const TopoDS_Edge& edge : edges_of(face)) ++count.ChangeFromIndex(count.Add(edge, 0));
}

bool EdgeUses::is_free(const TopoDS_Shape& edge) const {
  const int* uses = count.Seek(edge);
  return uses && *uses == 1 && !BRep_Tool::Degenerated(TopoDS::Edge(edge));
}

std::vector<TopoDS_Edge> EdgeUses::free_edges() const {
  std::vector<TopoDS_Edge> edges;
  for (int i = 1; i <= count.Extent(); ++i)
    if (is_free(count.FindKey(i))) edges.push_back(TopoDS::Edge(count.FindKey(i)));
  return edges;
}

EdgeUses count_uses(const std::vector<WorkFace>& faces) {
  EdgeUses result;
  for (const WorkFace& face : faces)
    if (face.has_area) result.add(face.face);
  return result;
}

double face_area(const TopoDS_Face& face) {
  try {
    if (const std::optional<double> area = area_within_images(face)) return std::abs(*area);
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(face, properties);
    return std::abs(properties.Mass());
  } catch (const Standard_Failure&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

std::optional<gp_Pnt> point_inside(const TopoDS_Face& face, const Handle(IntTools_Context) & context) {
  gp_Pnt point;
  gp_Pnt2d uv;
  return BOPTools_AlgoTools3D::PointInFace(face, point, uv, context) == 0 ? std::optional(point) : std::nullopt;
}

std::optional<BRepExtrema_DistShapeShape> nearest_places(const TopoDS_Shape& one, const TopoDS_Shape& two) {
  try {
    BRepExtrema_DistShapeShape nearest(one, two);
    return nearest.IsDone() && nearest.NbSolution() > 0 ? std::optional(nearest) : std::nullopt;
  } catch (const Standard_Failure&) {
    return std::nullopt;
  }
}

bool is_near(const gp_Pnt& point, const TopoDS_Face& face, double distance) {
  const auto nearest = nearest_places(BRepBuilderAPI_MakeVertex(point).Vertex(), face);
  return nearest && nearest->Value() <= distance;
}

std::vector<char> marked_parts(const Workpiece& work, const std::vector<int>& parts) {
  std::vector<char> is_member(work.parts.size(), 0);
  for (const int part : parts) is_member[part] = 1;
  return is_member;
}

double edge_length(const TopoDS_Edge& edge) {
  if (BRep_Tool::Degenerated(edge)) return 0;
  try {
    return GCPnts_AbscissaPoint::Length(BRepAdaptor_Curve(edge));
  } catch (const Standard_Failure&) {
    // The integrator gives up on some curves; chords are near enough for what lengths are used for.
    auto curve = make_curve(edge);
    if (!curve) return 0;
    const auto [t0, t1] = range_of(edge);
    constexpr int chords = 256;
    return length_of(sampled(curve, t0, t1, chords));
  }
}

double volume_to(const TopoDS_Face& face, Vec3 apex) {
  try {
    BRepGProp_Face surface(face);
    BRepGProp_Domain edges(face);
    return BRepGProp_Vinert(surface, edges, to_point(apex)).Mass();
  } catch (const Standard_Failure&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

double measuring_cost(const TopoDS_Face& face) {
  constexpr double per_edge = 20, per_span = 10;
  const auto edges = static_cast<double>(edges_of(face).size());
  double spans = 0;
  TopLoc_Location location;
  auto spline = Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(face, location));
  if (!spline.IsNull()) spans = (spline->NbUKnots() - 1.0) * (spline->NbVKnots() - 1.0);
  return edges * (per_edge + per_span * spans);
}

std::string list_names(std::vector<std::string> names) {
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return listed(names, listed_names);
}

}  // namespace paver
