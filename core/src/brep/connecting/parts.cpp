// The parts of the input: which faces and edges belong together, and who else has them.
#include <TopoDS_Vertex.hxx>
#include <map>
#include <set>

#include "brep/connecting/connect_impl.h"
#include "brep/occt_shapes_impl.h"

namespace paver {
namespace {

class PartLister {
 public:
  PartLister(Workpiece& work, const TopoDS_Shape& as_read) : work_(work), as_read_(as_read), loose_(work.shape) {}

  void run() {
    add_solids();
    find_read_sheets();
    add_sheets();
    add_wires();
    add_points();
  }

 private:
  int add_part(const std::string& name, int solid) {
    work_.parts.push_back({name, solid});
    return static_cast<int>(work_.parts.size()) - 1;
  }

  void add_solids() {
    const auto faces = shapes_of(as_read_, TopAbs_FACE), solids = shapes_of(as_read_, TopAbs_SOLID);
    for (int s = 1; s <= solids.Extent(); ++s) {
      int part = add_part("Solid" + std::to_string(s), s - 1);
      for (TopExp_Explorer inner(solids(s), TopAbs_FACE); inner.More(); inner.Next()) {
        if (!is_bounding(inner.Current())) continue;  // a sheet that a fuse has put into the solid
        int index = faces.FindIndex(inner.Current());
        bool is_opposed = inner.Current().Orientation() != faces(index).Orientation();
        work_.faces[index - 1].uses.push_back({part, is_opposed});
      }
    }
  }

  void find_read_sheets() {
    const auto faces = shapes_of(as_read_, TopAbs_FACE);
    Hanging sheets(work_.faces.size(), TopAbs_EDGE);
    for (int f = 0; f < faces.Extent(); ++f) sheets.add(static_cast<std::size_t>(f), faces(f + 1));
    for (std::size_t f = 0; f < work_.faces.size(); ++f) work_.faces[f].read_sheet = sheets.group_of(f);
  }

  static bool is_of_sheet(const WorkFace& face) { return face.uses.empty() && !face.is_dropped; }

  void add_sheets() {
    Hanging groups(work_.faces.size(), TopAbs_EDGE);
    for (std::size_t f = 0; f < work_.faces.size(); ++f)
      if (is_of_sheet(work_.faces[f])) groups.add(f, work_.faces[f].face);
    int sheets = 0;
    std::vector<int> part_of(work_.faces.size(), -1);
    for (std::size_t f = 0; f < work_.faces.size(); ++f) {
      if (!is_of_sheet(work_.faces[f])) continue;
      int& part = part_of[groups.group_of(f)];
      if (part < 0) part = add_part("Sheet" + std::to_string(++sheets), -1);
      work_.faces[f].uses.push_back({part, false});
    }
  }

  void add_wires() {
    TopTools_IndexedMapOfShape bounding;
    for (const WorkFace& face : work_.faces) TopExp::MapShapes(face.face, TopAbs_EDGE, bounding);
    for (int i = 1; i <= loose_.edges.Extent(); ++i)
      if (!bounding.Contains(loose_.edges(i)))
        work_.wires.push_back({TopoDS::Edge(loose_.edges(i).Oriented(TopAbs_FORWARD)), -1, i - 1});
    Hanging groups(work_.wires.size(), TopAbs_VERTEX);
    for (std::size_t w = 0; w < work_.wires.size(); ++w) groups.add(w, work_.wires[w].edge);
    int wires = 0;
    for (std::size_t w = 0; w < work_.wires.size(); ++w) {
      const auto root = static_cast<std::size_t>(groups.group_of(w));
      if (root == w) work_.wires[w].part = add_part("Wire" + std::to_string(++wires), -1);
      work_.wires[w].part = work_.wires[root].part;
    }
  }

  void add_points() {
    if (loose_.vertices.Extent() > most_points) {
      work_.left_points = loose_.vertices.Extent();
      return;
    }
    TopTools_IndexedMapOfShape ends;
    for (const WorkFace& face : work_.faces) TopExp::MapShapes(face.face, TopAbs_VERTEX, ends);
    for (const WorkWire& wire : work_.wires) TopExp::MapShapes(wire.edge, TopAbs_VERTEX, ends);
    for (int i = 1; i <= loose_.vertices.Extent(); ++i) {
      const TopoDS_Vertex vertex = TopoDS::Vertex(loose_.vertices(i).Oriented(TopAbs_FORWARD));
      const TopoDS_Vertex end = end_at(vertex, ends);
      const int part = add_part("Point" + std::to_string(i), -1);
      work_.points.push_back({end.IsNull() ? vertex : end, part, i - 1, !end.IsNull()});
    }
  }

  /// The vertex of an edge that is at the same place, or none.
  static TopoDS_Vertex end_at(const TopoDS_Vertex& point, const TopTools_IndexedMapOfShape& ends) {
    for (int i = 1; i <= ends.Extent(); ++i) {
      const TopoDS_Vertex end = TopoDS::Vertex(ends(i).Oriented(TopAbs_FORWARD));
      if (BRep_Tool::Pnt(end).Distance(BRep_Tool::Pnt(point)) <= Precision::Confusion()) return end;
    }
    return {};
  }

  Workpiece& work_;
  const TopoDS_Shape& as_read_;
  const LooseShapes loose_;
};

}  // namespace

void list_parts(Workpiece& work, const TopoDS_Shape& as_read) { PartLister(work, as_read).run(); }

void name_parts(Workpiece& work, const std::vector<std::string>& labels) {
  std::vector<std::set<std::string>> objects_of(work.parts.size());
  std::map<std::string, std::set<int>> parts_of;
  auto note = [&](int part, std::size_t place) {
    if (place >= labels.size()) return;
    const std::size_t end = labels[place].rfind('/');
    const std::string object = end == std::string::npos ? "" : labels[place].substr(0, end);
    objects_of[part].insert(object);
    parts_of[object].insert(part);
  };
  const std::size_t faces = static_cast<std::size_t>(work.read_faces);
  const std::size_t edges = static_cast<std::size_t>(LooseShapes(work.shape).edges.Extent());
  for (const WorkFace& face : work.faces)
    for (const FaceUse& use : face.uses) note(use.part, static_cast<std::size_t>(face.origin));
  for (const WorkWire& wire : work.wires) note(wire.part, faces + static_cast<std::size_t>(wire.origin));
  for (const WorkPoint& point : work.points) note(point.part, faces + edges + static_cast<std::size_t>(point.origin));
  for (std::size_t part = 0; part < work.parts.size(); ++part) {
    if (objects_of[part].size() != 1) continue;
    const std::string& object = *objects_of[part].begin();
    if (!object.empty() && parts_of[object].size() == 1) work.parts[part].name = object;
  }
}

std::string entry_name(const Workpiece& work, int origin) {
  std::string name;
  for (int face : work.faces_as_read(origin)) name += (name.empty() ? "" : " + ") + face_name(face);
  return name;
}

}  // namespace paver
