// A face made anew of all edges of what was read, on one side of its loops.
#pragma once

#include <Geom_Surface.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>
#include <optional>
#include <vector>

namespace paver {

/// An edge as the file walks it: some places along it, and how it goes on there, with the face to the left seen from
/// where the normal of the surface points.
struct FileEdge {
  std::vector<gp_Pnt> places;
  std::vector<gp_Vec> ways;
};

/// An edge as a file walks it: along its curve or against it.
FileEdge file_edge(const TopoDS_Edge& edge, bool is_along_curve);

/// How many edges run as the file has them, less those that run the other way. By the place of the file nearest to the
/// middle of each.
int agreement(const std::vector<TopoDS_Edge>& edges, const std::vector<FileEdge>& file);

/// The face's surface, which repeats in u; null where it does not.
Handle(Geom_Surface) periodic_surface(const TopoDS_Face& face);

/// Whether the surface goes round and has a pole at either end.
bool has_two_poles(const TopoDS_Face& face);

/// Whether the surface as a whole has an end: goes round both ways, or from pole to pole.
bool may_be_whole(const std::vector<TopoDS_Face>& read);

/// One face of all edges, on the same surface, on the side that `walked` tells; with the whole of it and its loops as
/// holes where none of them goes round. Nothing where that cannot be made.
std::optional<TopoDS_Face> make_whole_face(const std::vector<TopoDS_Face>& read, const std::vector<FileEdge>& walked);

}  // namespace paver
