// A mesh cut into flat triangles and straight pieces of line, for drawing.
#pragma once

#include <vector>

#include "paver/result.h"

namespace paver {

inline constexpr int most_subdivisions = 32;

/// Arrays as OpenGL and Coin want them: single precision, indices that end with -1. Elements are numbered quads first,
/// then triangles. Points are shared between the elements of one B-rep face and never between faces, so that shading is
/// smooth on a face and sharp at its edges.
struct Tessellation {
  int subdivision = 1;                ///< n: pieces per element side
  std::vector<float> points;          ///< x, y, z per point, mm
  std::vector<float> normals;         ///< x, y, z per point, unit length, outward
  std::vector<int> triangles;         ///< per triangle three points, counter-clockwise from outside, and -1
  std::vector<int> triangle_element;  ///< per triangle: the element it is a piece of
  std::vector<int> outlines;          ///< per mesh edge, each once: n + 1 points, and -1
  std::vector<int> outline_edge;      ///< per mesh edge: the 0-based B-rep edge it lies on, or -1
  std::vector<int> outline_elements;  ///< per mesh edge: how many elements have it; 1: a free edge
};

/// Cuts every quad into 2 n^2 triangles and every triangle into n^2, following the curved elements. `subdivision` n
/// from 1 to most_subdivisions, else Error{bad_option}.
Tessellation tessellate(const SurfaceMesh& mesh, int subdivision);

/// As tessellate, but no two elements share a point, so that each can have a colour of its own; normals are as smooth
/// as there. The points of element e follow those of e - 1, (n + 1)^2 of a quad and (n + 1)(n + 2) / 2 of a triangle:
/// the reference points (i / n, j / n), row by row in i. Triangles, too, are in the order of the elements.
Tessellation tessellate_apart(const SurfaceMesh& mesh, int subdivision);

}  // namespace paver
