// How a mesh is numbered in a file, and where in it the parts that several ranks hold have their places. One rank that
// has all of the mesh is no other case.
#pragma once

#include <string>
#include <vector>

#include "output/mesh_writers_impl.h"

namespace paver {

/// Rows of one table dealt into groups, stable: group g holds rows[start[g]] to rows[start[g + 1]].
struct Grouping {
  std::vector<std::size_t> start;
  std::vector<int> rows;

  std::size_t count() const { return start.size() - 1; }
  std::size_t size(std::size_t group) const { return start[group + 1] - start[group]; }
};

/// `group_of`: per row its group, from 0 to groups - 1; -1 leaves it out.
Grouping group_rows(const std::vector<int>& group_of, int groups);

/// Physical groups: faces of one name share one, and so do edges, and points; the numbers of edges' groups follow those
/// of faces, those of points come last.
struct Groups {
  std::vector<int> of_face;    ///< number of the group, or 0 when the face has no elements
  std::vector<int> of_edge;    ///< number of the group, or 0 when the edge is in none
  std::vector<int> of_point;   ///< number of the group
  std::vector<int> of_volume;  ///< number of the group, or 0 when no face of the volume has elements
  std::vector<std::string> face_names, edge_names, point_names, volume_names;  ///< of group 1, 2, ...

  int of_line(int edge) const { return edge < static_cast<int>(of_edge.size()) ? of_edge[edge] : 0; }
};
Groups find_groups(const MeshResult& result, const std::vector<char>& has_elements);

/// Number of faces to file elements under: those with elements here and those with names.
int face_count(const MeshResult& result);

/// Per node: the edge to file it under, or -1 when it is on no line. Its own edge before that of a line ending there.
/// `lines`: by edge.
std::vector<int> curve_of_nodes(const SurfaceMesh& mesh, const Grouping& lines);

/// Per face: edges whose lines are sides of its elements, rising. `curve`: of nodes.
std::vector<std::vector<int>> edges_of_faces(const SurfaceMesh& mesh, const std::vector<int>& curve, int faces);

/// Rows of one group that follow each other in the file.
struct PlacedRun {
  int group;
  long position;           ///< of the first one, among all rows of the group
  std::size_t begin, end;  ///< in PlacedRows::held.rows
};

/// The rows of one table that all ranks hold together, dealt into groups and in each group in the order of the whole.
struct PlacedRows {
  Grouping held;                ///< rows of this rank; for nodes also those that other ranks write
  std::vector<long> size;       ///< per group: rows of all ranks
  std::vector<PlacedRun> runs;  ///< that this rank writes, by group and position; of a mesh that is whole one per group

  std::size_t used_groups() const;
  long total() const;
};

/// Per node of this rank its number in the file, from 1; 0: not written.
struct NodeTags {
  std::vector<long> of_node;
  long count = 0;  ///< of the whole
};

/// Collective. 1, 2, ... in the order of the whole for all that are written. `is_written`: per node of this rank, the
/// same on all that hold it.
NodeTags number_nodes(const ShareNumbers& numbers, const std::vector<char>& is_written, Ranks& ranks);

/// Collective. Per node of this rank: the face of the last element, of all ranks, that uses it (triangles before
/// quads); -1: none, or the node lies on a curve. `curve`: per node, the same on all ranks that hold it, -1: none;
/// empty: no node lies on one.
std::vector<int> faces_of_nodes(HeldMesh held, const std::vector<int>& curve, Ranks& ranks);

/// Surface tag = B-rep face + 1 (Face12: 12), curve tag = B-rep edge + 1.
struct Numbering {
  /// Collective.
  Numbering(HeldMesh held, Ranks& ranks);

  NodeTags tags;                             ///< all nodes that an element or line uses
  PlacedRows quads, triangles;               ///< by face
  PlacedRows lines;                          ///< by edge
  PlacedRows points;                         ///< each by itself
  PlacedRows curve_nodes;                    ///< by edge: nodes on lines
  PlacedRows surface_nodes;                  ///< by face: the others
  Groups groups;                             ///< physical groups
  std::vector<std::vector<int>> face_edges;  ///< per face: edges whose lines are sides of its elements, rising
};

/// Gmsh's numbers of the Lagrange elements of order 1 to 4.
inline constexpr int gmsh_point_type = 15;
int gmsh_line_type(int order);
int gmsh_quad_type(int order);
int gmsh_triangle_type(int order);

}  // namespace paver
