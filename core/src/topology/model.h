// The B-rep as index arrays: what every later stage reads. Built once, const afterwards.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "brep/surface.h"
#include "paver/result.h"

namespace paver {

/// One use of an edge by a loop. Periodic edges have two coedges on the same face.
struct Coedge {
  int edge = -1;
  bool is_reversed = false;                      ///< runs from the edge's t1 to t0
  std::shared_ptr<const ParameterCurve> pcurve;  ///< over the edge's own t in [t0, t1], whatever is_reversed says
};

/// Closed chain: the end vertex of each coedge is the start vertex of the next.
/// Oriented so that the face lies to the left in (u, v) (as if the face were not reversed).
struct Loop {
  std::vector<Coedge> coedges;
};

struct Edge {
  std::string name;          ///< of the first of its origins: "Edge7"; edges that were added are "Added1"
  std::vector<int> origins;  ///< 0-based edges of the shape as read that it is or lies on: several where sewn together
  int start = -1, end = -1;  ///< vertices at t0 and t1
  double t0 = 0, t1 = 0;     ///< t0 < t1
  double length = 0;         ///< mm
  bool is_degenerate = false;  ///< a pole: no length, curve is null
  bool is_periodic = false;    ///< used twice by one face (that face's own parametric seam)
  std::shared_ptr<const Curve> curve;
  std::vector<int> faces;  ///< every face that uses it, a face twice where periodic
};

struct Face {
  std::string name;   ///< "Face12"; pieces of a face keep its name
  int origin = -1;    ///< 0-based face of the shape as read that it is, or is a piece of; pieces stand in a row
  std::string label;  ///< name given in the file, or empty
  std::shared_ptr<const Surface> surface;
  bool is_reversed = false;  ///< outward normal is -(xu x xv)
  double area = 0;           ///< mm^2
  bool has_area = true;      ///< false: dropped with a note, has no loops
  std::string fault;         ///< not empty: cannot be meshed, and why (e.g. an edge without a curve on the face)
  std::vector<Loop> loops;
};

struct Model {
  std::vector<Vec3> vertices;
  std::vector<Edge> edges;
  std::vector<Face> faces;
  int read_edges = 0;                         ///< edges of the shape as read, used or not
  std::vector<Vec3> read_vertices;            ///< of the shape as read
  std::vector<std::vector<int>> solid_faces;  ///< per solid of the shape as read: its faces, as Face::origin
  ModelReport report;
  std::vector<std::string> notes;
};

}  // namespace paver
