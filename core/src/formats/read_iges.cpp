// IGES: reads the file, transfers all roots (also blanked ones) in millimetres, and takes names of faces along; then
// what is not as the file has it: shapes of which nothing came; transformations of transformations; unit and scale.
#include <BRepAdaptor_Curve.hxx>
#include <BRepGProp.hxx>
#include <Extrema_ExtPC.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <GProp_GProps.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESData_BasicEditor.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESEntity.hxx>
#include <IGESData_IGESModel.hxx>
#include <IGESData_TransfEntity.hxx>
#include <IGESGeom_CurveOnSurface.hxx>
#include <IGESGeom_HArray1OfCurveOnSurface.hxx>
#include <IGESGeom_TrimmedSurface.hxx>
#include <IGESSolid_Face.hxx>
#include <IGESSolid_Shell.hxx>
#include <IGESToBRep_BRepEntity.hxx>
#include <IGESToBRep_TopoCurve.hxx>
#include <Standard_Failure.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include "formats/restored_faces_impl.h"
#include "formats/transfer_impl.h"

namespace paver {
namespace {

constexpr int trimmed_surface = 144, face_entity = 510;
constexpr double same_scale = 1e-9;
constexpr double same_area = 1e-5;             // of a face: what two readings of it may differ by
constexpr double same_curve = 1e-3;            // of its length: what an edge and its image may be apart
constexpr int named_unit = 3, last_unit = 11;  // unit flags: IGES 5.3, 2.2.4.3.14

// By number of type, IGES 5.3, 3.2: bounded, trimmed and curve-bounded surfaces; solids from primitives up to
// assemblies, B-rep solids, instances; subfigure instances, also in arrays; faces and shells.
constexpr std::array shape_types = {142, 143, 144, 150, 152, 154, 156, 158, 160, 162, 164, 168,
                                    180, 182, 184, 186, 408, 412, 414, 420, 430, 508, 510, 514};

std::string stated_unit(const IGESData_GlobalSection& global) {
  static const char* const names[] = {"", "INCH", "MM", "", "FOOT", "MILE", "M", "KM", "MIL", "UM", "CM", "UIN"};
  int flag = global.UnitFlag();
  if (flag >= 1 && flag <= last_unit && flag != named_unit) return names[flag];
  Handle(TCollection_HAsciiString) name = global.UnitName();
  return name.IsNull() || name->IsEmpty() ? "not stated" : name->ToCString();
}

Handle(TCollection_HAsciiString) face_name(const Handle(Standard_Transient) & entity) {
  Handle(IGESData_IGESEntity) part = Handle(IGESData_IGESEntity)::DownCast(entity);
  const bool is_face = !part.IsNull() && (part->TypeNumber() == trimmed_surface || part->TypeNumber() == face_entity);
  return is_face ? part->NameValue() : Handle(TCollection_HAsciiString)();
}

bool is_shape(const Handle(Standard_Transient) & entity) {
  const auto part = Handle(IGESData_IGESEntity)::DownCast(entity);
  return !part.IsNull() && std::binary_search(shape_types.begin(), shape_types.end(), part->TypeNumber());
}

/// Flags and names as IGES 5.3 has them, of which the kernel takes all others for millimetres.
bool is_known_unit(const IGESData_GlobalSection& global) {
  if (global.UnitFlag() != named_unit) return global.UnitFlag() >= 1 && global.UnitFlag() <= last_unit;
  const Handle(TCollection_HAsciiString) name = global.UnitName();
  return !name.IsNull() && IGESData_BasicEditor::UnitNameFlag(name->ToCString()) > 0;
}

/// Labels of shapes of which nothing came, of transformations that have one of their own, which is not applied, and of
/// a unit and a scale of the model that are not understood. After the transfer.
std::vector<std::string> losses(IGESControl_Reader& reader,
                                const std::vector<Handle(IGESGeom_CurveOnSurface)>& dropped) {
  if (!has_entities(reader)) return {};
  std::vector<std::string> labels = LostEntities(reader).labels(is_shape);
  for (const Handle(IGESGeom_CurveOnSurface) & loop : dropped) std::erase(labels, entity_label(reader, loop));
  for (const Handle(Standard_Transient) & entity : entities_of(reader))
    if (const auto matrix = Handle(IGESData_TransfEntity)::DownCast(entity); !matrix.IsNull() && matrix->HasTransf())
      labels.push_back(entity_label(reader, matrix) + " (transformation of its own)");
  const IGESData_GlobalSection& global = reader.IGESModel()->GlobalSection();
  if (!is_known_unit(global)) labels.emplace_back("unit of length");
  if (std::abs(global.Scale() - 1) > same_scale && global.Scale() != 0) labels.emplace_back("scale of the model");
  return labels;
}

/// Faces that look against the normals of their surfaces in their shells.
std::set<Handle(IGESSolid_Face)> faces_against(IGESControl_Reader& reader) {
  std::set<Handle(IGESSolid_Face)> against;
  for (const Handle(Standard_Transient) & any : entities_of(reader))
    if (const auto shell = Handle(IGESSolid_Shell)::DownCast(any); !shell.IsNull())
      for (int i = 1; i <= shell->NbFaces(); ++i)
        if (!shell->Orientation(i)) against.insert(shell->Face(i));
  return against;
}

/// Faces with loops of edges. Which way these run tells only another transfer: the reader mends what it transferred.
std::vector<FileFace> faces_of_solids(IGESControl_Reader& reader) {
  IGESToBRep_BRepEntity plain;
  plain.SetModel(reader.IGESModel());
  plain.SetTransferProcess(new Transfer_TransientProcess);
  const std::set<Handle(IGESSolid_Face)> against = faces_against(reader);
  std::vector<FileFace> faces;
  for (const Handle(Standard_Transient) & any : entities_of(reader)) {
    const auto entity = Handle(IGESSolid_Face)::DownCast(any);
    if (entity.IsNull()) continue;
    auto walked = [plain, entity]() mutable {
      std::vector<FileEdge> edges;
      for (const TopoDS_Face& face : faces_of(plain.TransferFace(entity)))
        for (const TopoDS_Edge& edge : edges_of(forward(face)))
          edges.push_back(file_edge(edge, edge.Orientation() == TopAbs_FORWARD));
      return edges;
    };
    FileFace face{faces_of(shape_of(reader, entity)), walked, against.count(entity) == 0};
    if (!face.read.empty()) faces.push_back(std::move(face));
  }
  return faces;
}

/// Ends of edges that the loops walk there and back which no other edge has.
std::vector<gp_Pnt> dead_ends(const std::vector<FileEdge>& edges) {
  auto is_way_back = [](const FileEdge& edge, const FileEdge& other) {
    const double near = same_curve * edge.places.front().Distance(edge.places[edge.places.size() / 2]);
    for (std::size_t i = 0; i < edge.places.size(); ++i)
      if (edge.places[i].Distance(other.places[other.places.size() - 1 - i]) > near) return false;
    return true;
  };
  std::vector<gp_Pnt> ends;
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t k = i + 1; k < edges.size(); ++k) {
      if (!is_way_back(edges[i], edges[k])) continue;
      const double near = same_curve * edges[i].places.front().Distance(edges[i].places.back());
      for (const gp_Pnt& end : {edges[i].places.front(), edges[i].places.back()}) {
        std::size_t there = 0;
        for (const FileEdge& edge : edges)
          there += (edge.places.front().Distance(end) < near) + (edge.places.back().Distance(end) < near);
        if (there == 2) ends.push_back(end);
      }
    }
  return ends;
}

/// The kernel writes a loop without edges as the one before it once more, without its curve in space, or as an outer
/// one without any curve. Gives the loops that it took from faces.
std::vector<Handle(IGESGeom_CurveOnSurface)> drop_empty_loops(const IGESControl_Reader& reader) {
  if (!has_entities(reader)) return {};
  std::vector<Handle(IGESGeom_CurveOnSurface)> dropped;
  for (const Handle(Standard_Transient) & any : entities_of(reader)) {
    const auto face = Handle(IGESGeom_TrimmedSurface)::DownCast(any);
    if (face.IsNull() || face->OuterContour().IsNull() || face->NbInnerContours() == 0) continue;
    std::set<Handle(IGESData_IGESEntity)> images;
    std::vector<Handle(IGESGeom_CurveOnSurface)> loops, empty;
    for (int i = 0; i <= face->NbInnerContours(); ++i) {
      const Handle(IGESGeom_CurveOnSurface) loop = i == 0 ? face->OuterContour() : face->InnerContour(i);
      if (loop.IsNull()) continue;
      const bool is_new = !loop->CurveUV().IsNull() && images.insert(loop->CurveUV()).second;
      (is_new || !loop->Curve3D().IsNull() ? loops : empty).push_back(loop);
    }
    const int inner_count = static_cast<int>(loops.size()) - 1;
    if (inner_count < 0 || empty.empty()) continue;
    dropped.insert(dropped.end(), empty.begin(), empty.end());
    Handle(IGESGeom_HArray1OfCurveOnSurface) inner;
    if (inner_count > 0) inner = new IGESGeom_HArray1OfCurveOnSurface(1, inner_count);
    for (int i = 1; i <= inner_count; ++i) inner->SetValue(i, loops[i]);
    face->Init(face->Surface(), face->OuterBoundaryType(), loops.front(), inner);
  }
  return dropped;
}

double area_of(const TopoDS_Face& face) {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(face, properties);
  return properties.Mass();
}

/// As a torus is.
bool is_closed_both_ways(const TopoDS_Face& face) {
  const Handle(Geom_Surface) surface = untrimmed(BRep_Tool::Surface(face));
  return !surface.IsNull() && surface->IsUClosed() && surface->IsVClosed();
}

TopoDS_Face unplaced(const TopoDS_Face& face) { return TopoDS::Face(face.Located(TopLoc_Location())); }

/// Whether all edges of a face but its periodic ones lie along these.
bool has_edges_along(const TopoDS_Face& one, const std::vector<TopoDS_Edge>& others) {
  std::vector<BRepAdaptor_Curve> borders;
  for (const TopoDS_Edge& edge : others)
    if (!BRep_Tool::Degenerated(edge)) borders.emplace_back(edge);
  auto is_on_border = [&](const gp_Pnt& point, double near) {
    return std::ranges::any_of(borders, [&](const BRepAdaptor_Curve& curve) {
      if (std::min(point.Distance(curve.Value(curve.FirstParameter())),
                   point.Distance(curve.Value(curve.LastParameter()))) < near)
        return true;
      const Extrema_ExtPC foot(point, curve);
      for (int i = 1; foot.IsDone() && i <= foot.NbExt(); ++i)
        if (foot.SquareDistance(i) < near * near) return true;
      return false;
    });
  };
  for (const TopoDS_Edge& edge : edges_of(one)) {
    if (BRep_Tool::Degenerated(edge) || BRep_Tool::IsClosed(edge, one)) continue;
    const BRepAdaptor_Curve curve(edge);
    const double near = same_curve * GCPnts_AbscissaPoint::Length(curve);
    for (const double share : {0.2, 0.5, 0.8})
      if (!is_on_border(curve.Value((1 - share) * curve.FirstParameter() + share * curve.LastParameter()), near))
        return false;
  }
  return true;
}

/// Trimmed surfaces have their loops twice, in space and as images on the surface: reads them once more, by one of the
/// two.
class OtherReading {
 public:
  OtherReading(const IGESControl_Reader& first, const char* mode)
      : model_(first.IGESModel()), setting_("read.surfacecurve.mode", mode) {}

  /// Nothing where it fails, or is several faces.
  std::optional<TopoDS_Face> face_of(const Handle(IGESGeom_TrimmedSurface) & entity) {
    if (!reader_) reader_.emplace().WS()->SetModel(model_);
    try {
      reader_->TransferEntity(entity);
      const std::vector<TopoDS_Face> faces = faces_of(shape_of(*reader_, entity));
      return faces.size() == 1 ? std::optional(faces[0]) : std::nullopt;
    } catch (const Standard_Failure&) {
      return std::nullopt;
    }
  }

 private:
  Handle(IGESData_IGESModel) model_;
  ReaderSetting setting_;
  std::optional<IGESControl_Reader> reader_;
};

/// The edges of its loops in space, as the file walks them; none where it has only images, or curves that cannot be
/// made.
std::vector<TopoDS_Edge> edges_in_space(const IGESControl_Reader& reader, const IGESGeom_TrimmedSurface& entity) {
  IGESToBRep_TopoCurve plain;
  plain.SetModel(reader.IGESModel());
  plain.SetTransferProcess(new Transfer_TransientProcess);
  std::vector<TopoDS_Edge> edges;
  auto add = [&](const Handle(IGESGeom_CurveOnSurface) & loop) {
    if (!loop.IsNull() && !loop->Curve3D().IsNull())
      for (const TopoDS_Edge& edge : edges_of(plain.TransferTopoCurve(loop->Curve3D())))
        if (!BRep_Tool::Degenerated(edge)) edges.push_back(edge);
  };
  try {
    add(entity.OuterContour());
    for (int i = 1; i <= entity.NbInnerContours(); ++i) add(entity.InnerContour(i));
  } catch (const Standard_Failure&) {
    return {};
  }
  return edges;
}

/// Of trimmed surfaces with poles: images of what comes through a pole may be wrong. Where they are and the reader took
/// them, space tells. Gives those whose loops lead to a pole.
std::vector<FileFace> read_by_curves(const IGESControl_Reader& reader, FaceChanges& changes) {
  OtherReading by_curves(reader, "3");
  std::vector<FileFace> faces;
  for (const Handle(Standard_Transient) & any : entities_of(reader)) {
    const auto entity = Handle(IGESGeom_TrimmedSurface)::DownCast(any);
    if (entity.IsNull()) continue;
    const std::vector<TopoDS_Face> read = faces_of(shape_of(reader, entity));
    if (read.empty() || !has_two_poles(forward(read.front()))) continue;
    const std::vector<TopoDS_Edge> edges = edges_in_space(reader, *entity);
    if (edges.empty()) continue;
    auto lies_along = [&](const TopoDS_Face& face) { return has_edges_along(unplaced(face), edges); };
    if (!std::ranges::all_of(read, lies_along)) {
      const std::optional<TopoDS_Face> other = by_curves.face_of(entity);
      if (other && lies_along(*other)) changes.replace(read, *other);
      continue;
    }
    std::vector<FileEdge> walked;
    for (const TopoDS_Edge& edge : edges) walked.push_back(file_edge(edge, edge.Orientation() == TopAbs_FORWARD));
    FileFace face{read, [walked] { return walked; }};
    face.dead_ends = dead_ends(walked);
    face.are_loops_known = false;
    if (!face.dead_ends.empty()) faces.push_back(std::move(face));
  }
  return faces;
}

/// On a torus the kernel may take other pieces of the surface where it matches the two; where they agree, the images
/// alone tell which is meant.
void read_by_images(const IGESControl_Reader& reader, FaceChanges& changes) {
  OtherReading by_images(reader, "-2");
  for (const Handle(Standard_Transient) & any : entities_of(reader)) {
    const auto entity = Handle(IGESGeom_TrimmedSurface)::DownCast(any);
    if (entity.IsNull()) continue;
    const std::vector<TopoDS_Face> read = faces_of(shape_of(reader, entity));
    if (read.empty() || !is_closed_both_ways(read.front())) continue;
    const std::optional<TopoDS_Face> other = by_images.face_of(entity);
    if (!other) continue;
    double area = 0;
    for (const TopoDS_Face& face : read) area += area_of(face);
    if (std::abs(area_of(*other) - area) <= same_area * area) continue;
    auto lies_along = [&](const TopoDS_Face& face) {
      return has_edges_along(unplaced(face), edges_of(unplaced(*other)));
    };
    if (std::ranges::all_of(read, lies_along)) changes.replace(read, *other);
  }
}

}  // namespace

extern "C" void paver_read_format(const FileSource& file, std::string_view /*content*/, const Doubt& doubt,
                                  Shape& shape, ModelReport& report, Progress& progress) {
  IGESControl_Reader reader;
  const ReaderSetting millimetres("xstep.cascade.unit", "MM");
  check_loaded(reader.ReadFile(file.path.c_str()), file, "IGES", progress);
  Handle(IGESData_IGESModel) model = reader.IGESModel();
  if (!model.IsNull()) report.unit = stated_unit(model->GlobalSection());
  if (has_fails(model)) doubt();
  reader.SetReadVisible(Standard_False);
  const std::vector<Handle(IGESGeom_CurveOnSurface)> dropped = drop_empty_loops(reader);
  transfer(reader, shape, progress, face_name);
  report.unread = losses(reader, dropped);
  if (shape.shape.IsNull()) return;
  FaceChanges changes(shape.shape);
  restore_faces(faces_of_solids(reader), changes);
  restore_faces(read_by_curves(reader, changes), changes);
  read_by_images(reader, changes);
  changes.apply(shape);
}

}  // namespace paver
