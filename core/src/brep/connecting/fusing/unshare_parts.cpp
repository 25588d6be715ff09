// Solids that a program cut out of one share edges, vertices and surfaces with each other. Where a shared edge is the
// periodic edge of the surface, as of two octants of a ball, the kernel finds no union.
#include <BRepBuilderAPI_Copy.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>

#include "base/union_find.h"
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

/// Of parts that have faces in common.
struct Group {
  std::vector<int> faces;  // of the workpiece
  bool is_separate;        // has a solid, and no face of it is another part's, too
};

std::vector<Group> groups_of(const Workpiece& work, const std::vector<int>& parts) {
  const std::vector<char> is_member = marked_parts(work, parts);
  UnionFind together(work.parts.size());
  for (const WorkFace& face : work.faces)
    for (const FaceUse& use : face.uses) together.merge(face.uses[0].part, use.part);
  std::vector<Group> groups;
  std::vector<int> group_of(work.parts.size(), -1);
  for (const std::vector<int>& set : together.sets()) {
    auto is_in_question = [&](int part) { return is_member[part] != 0; };
    if (std::ranges::none_of(set, is_in_question)) continue;
    for (const int part : set) group_of[part] = static_cast<int>(groups.size());
    const bool has_solid = std::ranges::any_of(set, [&](int part) { return work.parts[part].solid >= 0; });
    groups.push_back({{}, has_solid && std::ranges::all_of(set, is_in_question)});
  }
  for (std::size_t f = 0; f < work.faces.size(); ++f) {
    if (work.faces[f].uses.empty()) continue;
    if (const int group = group_of[work.faces[f].uses[0].part]; group >= 0)
      groups[group].faces.push_back(static_cast<int>(f));
  }
  return groups;
}

}  // namespace

bool unshare_parts(Workpiece& work, const std::vector<int>& parts) {
  std::vector<Group> groups = groups_of(work, parts);
  std::stable_partition(groups.begin(), groups.end(), [](const Group& group) { return !group.is_separate; });
  TopTools_IndexedMapOfShape known;
  bool has_shared = false;
  for (const Group& group : groups) {
    TopTools_IndexedMapOfShape vertices;
    for (const int face : group.faces) TopExp::MapShapes(work.faces[face].face, TopAbs_VERTEX, vertices);
    bool is_shared = false;
    for (int i = 1; i <= vertices.Extent(); ++i) {
      is_shared = is_shared || known.Contains(vertices(i));
      known.Add(vertices(i));
    }
    if (!group.is_separate || !is_shared) continue;
    copy_faces(work, group.faces);
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
