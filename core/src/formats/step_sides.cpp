// Of the file's faces: which edges they use twice, and which of them end where no other does, at a pole; and how their
// loops run.
#include <StepShape_EdgeCurve.hxx>
#include <StepShape_Vertex.hxx>
#include <algorithm>
#include <map>
#include <vector>

#include "brep/occt_shapes_impl.h"
#include "formats/restored_faces_impl.h"
#include "formats/step_impl.h"
#include "formats/transfer_impl.h"

namespace paver {
namespace {

/// Ends of edges that the face uses twice which no other edge has: there they turn back at a pole.
std::vector<gp_Pnt> dead_ends(const XSControl_Reader& reader, const StepShape_FaceSurface& face) {
  std::map<const Standard_Transient*, std::pair<Handle(StepShape_Edge), int>> uses;
  visit_edges(face, [&](const StepShape_OrientedEdge& walked, const StepShape_FaceBound&) {
    const Handle(StepShape_Edge) edge = walked.EdgeElement();
    if (!edge.IsNull()) uses[edge.get()].first = edge, ++uses[edge.get()].second;
  });
  std::map<const Standard_Transient*, int> edges_at;
  for (const auto& [key, use] : uses)
    for (const Handle(StepShape_Vertex) & end : {use.first->EdgeStart(), use.first->EdgeEnd()}) ++edges_at[end.get()];
  std::vector<gp_Pnt> ends;
  for (const auto& [key, use] : uses)
    for (const Handle(StepShape_Vertex) & end : {use.first->EdgeStart(), use.first->EdgeEnd()}) {
      if (use.second != 2 || edges_at[end.get()] != 1) continue;
      const TopoDS_Shape read = shape_of(reader, end);
      if (!read.IsNull() && read.ShapeType() == TopAbs_VERTEX) ends.push_back(BRep_Tool::Pnt(TopoDS::Vertex(read)));
    }
  return ends;
}

/// The edges of its loops, turned or as written; along the surface's normal where the face is.
std::vector<FileEdge> edges_of(const XSControl_Reader& reader, const StepShape_FaceSurface& face, bool is_turned) {
  std::vector<FileEdge> edges;
  visit_edges(face, [&](const StepShape_OrientedEdge& walked, const StepShape_FaceBound& bound) {
    const auto edge = Handle(StepShape_EdgeCurve)::DownCast(walked.EdgeElement());
    if (edge.IsNull()) return;
    const TopoDS_Shape read = shape_of(reader, edge);
    if (read.IsNull() || read.ShapeType() != TopAbs_EDGE) return;
    const int turns = !walked.Orientation() + !bound.Orientation() + !edge->SameSense() + !face.SameSense() + is_turned;
    edges.push_back(file_edge(TopoDS::Edge(read), turns % 2 == 0));
  });
  return edges;
}

/// How the loops of a face run: writers turn those of some faces, such as tori.
struct LoopSense {
  enum { as_written, turned, unknown } sense = as_written;
  int shell = -1;  ///< none: no other face has an edge of it
};

/// Of neighbours in a shell one walks along their common edge and one against it. Where the file has that otherwise,
/// fewer than half of the faces of a shell are turned, or nobody knows.
class Neighbours {
 public:
  explicit Neighbours(const std::vector<Handle(StepShape_FaceSurface)>& faces) : beside_(faces.size()) {
    std::map<const Standard_Transient*, std::size_t> numbers;
    std::vector<std::vector<Use>> uses;  // per edge, in the order of the file
    for (std::size_t i = 0; i < faces.size(); ++i)
      visit_edges(*faces[i], [&](const StepShape_OrientedEdge& walked, const StepShape_FaceBound& bound) {
        const std::size_t edge = numbers.try_emplace(walked.EdgeElement().get(), uses.size()).first->second;
        if (edge == uses.size()) uses.emplace_back();
        uses[edge].push_back({i, walked.Orientation() == bound.Orientation()});
      });
    for (const std::vector<Use>& by : uses) {
      if (by.size() != 2 || by[0].face == by[1].face) continue;
      const bool is_alike = by[0].is_along == by[1].is_along;
      beside_[by[0].face].push_back({by[1].face, is_alike});
      beside_[by[1].face].push_back({by[0].face, is_alike});
    }
  }

  /// Per face.
  std::vector<LoopSense> loop_senses() const {
    std::vector<LoopSense> senses(beside_.size());
    std::vector<int> half(beside_.size(), 0);  // 1 and 2: of one shell, turned against each other
    for (std::size_t i = 0; i < beside_.size(); ++i) {
      if (half[i] != 0) continue;
      const std::vector<std::size_t> shell = divide_shell(i, half);
      const std::size_t first = std::ranges::count(shell, 1, [&](std::size_t face) { return half[face]; }),
                        second = shell.size() - first;
      for (const std::size_t face : shell) {
        const bool is_less = (half[face] == 1) == (first < second);
        if (shell.size() > 1) senses[face].shell = static_cast<int>(i);
        if (first == second)
          senses[face].sense = LoopSense::unknown;
        else if (is_less)
          senses[face].sense = LoopSense::turned;
      }
    }
    return senses;
  }

 private:
  struct Use {
    std::size_t face;
    bool is_along;
  };
  struct Beside {
    std::size_t face;
    bool is_alike;  ///< both walk the same way
  };

  /// The faces of the shell of one face, each put into a half.
  std::vector<std::size_t> divide_shell(std::size_t face, std::vector<int>& half) const {
    std::vector<std::size_t> shell{face};
    half[face] = 1;
    for (std::size_t k = 0; k < shell.size(); ++k)
      for (const Beside& next : beside_[shell[k]]) {
        if (half[next.face] != 0) continue;
        half[next.face] = next.is_alike ? 3 - half[shell[k]] : half[shell[k]];
        shell.push_back(next.face);
      }
    return shell;
  }

  std::vector<std::vector<Beside>> beside_;  // per face
};

}  // namespace

void restore_sides(XSControl_Reader& reader, Shape& shape) {
  std::vector<Handle(StepShape_FaceSurface)> entities;
  for (const Handle(Standard_Transient) & any : entities_of(reader))
    if (const auto entity = Handle(StepShape_FaceSurface)::DownCast(any); !entity.IsNull()) entities.push_back(entity);
  const std::vector<LoopSense> senses = Neighbours(entities).loop_senses();
  std::vector<FileFace> faces;
  for (std::size_t i = 0; i < entities.size(); ++i) {
    const Handle(StepShape_FaceSurface)& entity = entities[i];
    const bool is_along = entity->SameSense(), is_turned = senses[i].sense == LoopSense::turned;
    FileFace face{faces_of(shape_of(reader, entity)),
                  [&reader, entity, is_turned] { return edges_of(reader, *entity, is_turned); },
                  is_along,
                  !is_along,
                  dead_ends(reader, *entity),
                  senses[i].sense != LoopSense::unknown,
                  senses[i].shell};
    if (!face.read.empty()) faces.push_back(std::move(face));
  }
  FaceChanges changes(shape.shape);
  restore_faces(faces, changes);
  changes.apply(shape);
}

}  // namespace paver
