// Faces of which the reader has taken the wrong side of their loops, or which lack a pole, made anew.
#pragma once

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <functional>
#include <gp_Pnt.hxx>
#include <map>
#include <set>
#include <vector>

#include "brep/occt_shapes_impl.h"
#include "brep/shape_impl.h"
#include "formats/whole_face_impl.h"

namespace paver {

/// What the reader has made of a face of the file.
struct FileFace {
  std::vector<TopoDS_Face> read;  ///< more than one where the reader took its loops for borders of several
  std::function<std::vector<FileEdge>()> edges;
  bool is_along_surface = true;     ///< whether its normal is that of its surface; in IGES within its shell
  bool is_read_turned = false;      ///< by the reader, as its normal is not that of its surface
  std::vector<gp_Pnt> dead_ends{};  ///< of edges that its loops walk twice, no other: poles that lie in it
  bool are_loops_known = true;      ///< not where the file's faces contradict each other
  int shell = -1;                   ///< of faces whose loops agree; negative: not known
};

/// Faces of a shape as read in whose place others come, wherever they stand.
class FaceChanges {
 public:
  explicit FaceChanges(const TopoDS_Shape& shape) : before_(shapes_of(shape, TopAbs_FACE)) {}

  /// `made` comes in place of the first of `read`, turned as that is; the others go.
  void replace(const std::vector<TopoDS_Face>& read, const TopoDS_Face& made);
  /// They stay, and go to `shape.turned`.
  void leave_turned(const std::vector<TopoDS_Face>& read);
  /// What was made goes to `shape.restored`.
  void apply(Shape& shape) const;

 private:
  template <class Visit>
  void visit(const std::vector<TopoDS_Face>& read, Visit&& at) const;

  TopTools_IndexedMapOfShape before_;
  std::map<int, TopoDS_Shape> made_;  // by number in `before_`
  std::set<int> gone_, turned_;
};

/// Puts faces that were read on the wrong side of their loops, or without their poles, in their place anew: one face of
/// all edges, on the same surface, with the whole of it and its loops as holes where none of them goes round. What
/// cannot be made stays turned. Loops tell the side unless most of the file run the wrong way round; poles always.
void restore_faces(const std::vector<FileFace>& faces, FaceChanges& changes);

}  // namespace paver
