// How a mesh is numbered in a file: node tags, groups, elements by face.
#pragma once

#include <string>
#include <vector>

#include "paver/result.h"

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

/// Physical groups: faces of one name share one, and so do edges; numbers of edges' groups follow those of faces.
struct Groups {
  std::vector<int> of_face;                         ///< number of the group, or 0 when the face has no elements
  std::vector<int> of_edge;                         ///< number of the group, or 0 when the edge is in none
  std::vector<std::string> face_names, edge_names;  ///< of group 1, 2, ...

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

/// Tags are numbers in the file, from 1. Surface tag = B-rep face + 1 (Face12: 12), curve tag = B-rep edge + 1.
struct Numbering {
  explicit Numbering(const MeshResult& result);

  std::vector<int> node_tag;                 ///< per node; 0: no element or line uses it, so it is not written
  int node_count = 0;                        ///< written nodes; tags run from 1 to this
  Grouping quads, triangles;                 ///< by face
  Grouping lines;                            ///< by edge
  Grouping curve_nodes;                      ///< by edge: nodes on lines
  Grouping surface_nodes;                    ///< by face: the others
  Groups groups;                             ///< physical groups
  std::vector<std::vector<int>> face_edges;  ///< per face: edges whose lines are sides of its elements, rising

  bool has_elements(std::size_t face) const { return quads.size(face) + triangles.size(face) > 0; }
};

/// Gmsh's numbers of the Lagrange elements of order 1 to 4.
int gmsh_line_type(int order);
int gmsh_quad_type(int order);
int gmsh_triangle_type(int order);

}  // namespace paver
