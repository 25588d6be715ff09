// Solids that a program cut out of one share edges, vertices and surfaces with each other. Where a shared edge is the
// periodic edge of the surface, as of two octants of a ball, the kernel finds no union.
#include <BRepBuilderAPI_Copy.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>

#include "brep/connecting/connect_impl.h"
#include "brep/occt_shapes_impl.h"

namespace paver {
namespace {

/// Gives the faces topology and geometry of their own, in place; edges keep what is known of them.
void copy_faces(Workpiece& work, const std::vector<int>& faces) {
  BRep_Builder builder;
  TopoDS_Compound together;
  builder.MakeCompound(together);
  for (int f : faces) builder.Add(together, work.faces[f].face);
  BRepBuilderAPI_Copy copy(together);
  const auto edges = shapes_of(together, TopAbs_EDGE);
  for (int i = 1; i <= edges.Extent(); ++i) add_edge_origins(work, copy.ModifiedShape(edges(i)), edges(i));
  const std::vector<TopoDS_Face> copies = faces_of(copy.Shape());
  for (std::size_t i = 0; i < faces.size(); ++i) work.faces[faces[i]].face = copies[i];
  work.is_rebuilt = true;
}

}  // namespace

bool unshare_parts(Workpiece& work, const std::vector<int>& parts) {
  TopTools_IndexedMapOfShape known;
  bool has_shared = false;
  for (const int part : parts) {
    std::vector<int> faces;
    bool is_own = work.parts[part].solid >= 0, is_shared = false;
    TopTools_IndexedMapOfShape vertices;
    for (std::size_t f = 0; f < work.faces.size(); ++f) {
      const WorkFace& face = work.faces[f];
      if (!face.has_part(part)) continue;
      is_own = is_own && face.uses.size() == 1;
      faces.push_back(static_cast<int>(f));
      TopExp::MapShapes(face.face, TopAbs_VERTEX, vertices);
    }
    for (int i = 1; i <= vertices.Extent(); ++i) {
      is_shared = is_shared || known.Contains(vertices(i));
      known.Add(vertices(i));
    }
    if (!is_own || !is_shared) continue;
    copy_faces(work, faces);
    has_shared = true;
  }
  return has_shared;
}

bool have_inner_shapes(const Workpiece& work, const std::vector<int>& parts) {
  const std::vector<char> is_member = marked_parts(work, parts);
  auto is_inner = [](const TopoDS_Edge& edge) { return edge.Orientation() == TopAbs_INTERNAL; };
  return std::ranges::any_of(work.faces, [&](const WorkFace& face) {
    return std::ranges::any_of(face.uses, [&](const FaceUse& use) { return is_member[use.part] != 0; }) &&
           (TopExp_Explorer(face.face, TopAbs_VERTEX, TopAbs_EDGE).More() ||
            std::ranges::any_of(edges_of(face.face), is_inner));
  });
}

}  // namespace paver
