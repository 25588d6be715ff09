// The model as it is meshed, as a shape: what the report calls repaired and connected, for other programs.
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <map>
#include <sstream>

#include "topology/build_parts_impl.h"

namespace paver {
namespace {

struct Shell {
  TopoDS_Shell shell;
  EdgeUses uses;

  void add(const TopoDS_Face& face) {
    BRep_Builder().Add(shell, face);
    uses.add(face);
  }
  bool is_closed() const {
    for (int i = 1; i <= uses.count.Extent(); ++i)
      if (uses.count(i) != 2 && !BRep_Tool::Degenerated(TopoDS::Edge(uses.count.FindKey(i)))) return false;
    return true;
  }
};

void add_part(const std::vector<TopoDS_Face>& faces, TopoDS_Compound& whole) {
  BRep_Builder builder;
  Hanging together(faces.size(), TopAbs_EDGE);
  for (std::size_t f = 0; f < faces.size(); ++f) together.add(f, faces[f]);
  std::map<int, Shell> shells;  // of faces that hang together by edges
  for (std::size_t f = 0; f < faces.size(); ++f) {
    Shell& shell = shells[together.group_of(f)];
    if (shell.shell.IsNull()) builder.MakeShell(shell.shell);
    shell.add(faces[f]);
  }
  TopoDS_Solid solid;
  for (auto& [root, shell] : shells) {
    const bool is_closed = shell.is_closed();
    shell.shell.Closed(is_closed);
    if (!is_closed) {
      builder.Add(whole, shell.shell);
      continue;
    }
    if (solid.IsNull()) builder.MakeSolid(solid);
    builder.Add(solid, shell.shell);
  }
  if (!solid.IsNull()) builder.Add(whole, solid);
}

}  // namespace

std::string repaired_brep(const Workpiece& work, const std::vector<Face>& faces) {
  BRep_Builder builder;
  TopoDS_Compound whole;
  builder.MakeCompound(whole);
  std::vector<std::vector<TopoDS_Face>> of_parts(work.parts.size());
  for (std::size_t f = 0; f < work.faces.size(); ++f) {
    const WorkFace& face = work.faces[f];
    if (!face.has_area) continue;
    if (face.uses.empty()) builder.Add(whole, face.face);
    for (const FaceUse& use : face.uses) {
      const bool is_turned = faces[f].is_reversed != use.is_opposed;
      const TopoDS_Shape side = face.face.Oriented(is_turned ? TopAbs_REVERSED : TopAbs_FORWARD);
      of_parts[use.part].push_back(TopoDS::Face(side));
    }
  }
  for (const auto& part : of_parts)
    if (!part.empty()) add_part(part, whole);
  for (const WorkWire& wire : work.wires) builder.Add(whole, wire.edge);
  for (const WorkPoint& point : work.points) builder.Add(whole, point.vertex);
  std::ostringstream text;
  BRepTools::Write(whole, text);
  return std::move(text).str();
}

}  // namespace paver
