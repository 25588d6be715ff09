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

/// Tags are numbers in the file, from 1. Surface tag = B-rep face + 1 (Face12: 12), curve tag = B-rep edge + 1.
struct Numbering {
  explicit Numbering(const MeshResult& result);

  std::vector<int> node_tag;                 ///< per node; 0: no element or line uses it, so it is not written
  int node_count = 0;                        ///< written nodes; tags run from 1 to this
  Grouping quads, triangles;                 ///< by face
  Grouping lines;                            ///< by edge
  Grouping curve_nodes;                      ///< by edge: nodes on lines
  Grouping surface_nodes;                    ///< by face: the others
  std::vector<int> face_group;               ///< per face: number of its physical group, or 0 when it has no elements
  std::vector<std::string> group_names;      ///< of group 1, 2, ...; faces of one name share a group
  std::vector<std::vector<int>> face_edges;  ///< per face: edges whose lines are sides of its elements, rising

  bool has_elements(std::size_t face) const { return quads.size(face) + triangles.size(face) > 0; }
};

/// Gmsh's numbers of the Lagrange elements of order 1 to 4.
int gmsh_line_type(int order);
int gmsh_quad_type(int order);
int gmsh_triangle_type(int order);

}  // namespace paver
