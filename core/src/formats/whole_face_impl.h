// Faces of which the reader has taken the wrong side of their loops, made anew.
#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <functional>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>
#include <vector>

#include "brep/shape_impl.h"

namespace paver {

/// An edge as the file walks it: some places along it, and how it goes on there, with the face to the left seen from
/// where the normal of the surface points.
struct FileEdge {
  std::vector<gp_Pnt> places;
  std::vector<gp_Vec> ways;
};

/// What the reader has made of a face of the file.
struct FileFace {
  std::vector<TopoDS_Face> read;  ///< more than one where the reader took its loops for borders of several
  bool is_along_surface = true;   ///< whether its normal is that of its surface
  std::function<std::vector<FileEdge>()> edges;
  bool ends_at_poles = false;  ///< the file has a periodic edge between two poles in it
};

/// An edge as a file walks it: along its curve or against it.
FileEdge file_edge(const TopoDS_Edge& edge, bool is_along_curve);

/// Puts faces that were read on the wrong side of their loops, or without their poles, in their place anew: one face of
/// all edges, on the same surface, with the whole of it and its loops as holes where none of them goes round. What
/// cannot be made stays, and goes to `shape.turned`; the others go to `shape.restored`. Not where most loops of the
/// file run the wrong way round.
void restore_faces(const std::vector<FileFace>& faces, Shape& shape);

}  // namespace paver
