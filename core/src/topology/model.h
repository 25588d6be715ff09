// The B-rep as index arrays: what every later stage reads. Built once, const afterwards.
#pragma once

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "brep/surfaces/surface.h"
#include "paver/result.h"

namespace paver {

/// One use of an edge by a loop. Periodic edges have two coedges on the same face.
struct Coedge {
  int edge = -1;
  bool is_reversed = false;                      ///< runs from the edge's t1 to t0
  std::shared_ptr<const ParameterCurve> pcurve;  ///< over the edge's own t in [t0, t1], whatever is_reversed says
  bool is_slit = false;                          ///< lies inside the face, which has another coedge for the other side
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
  bool is_periodic = false;    ///< used twice by one face, a period apart, and by nothing else: its parametric seam
  std::shared_ptr<const Curve> curve;
  std::vector<int> faces;  ///< every face that uses it, a face twice where it has the face on both sides; none: a wire
  std::vector<int> inside_of;  ///< of a wire: parts that are solids that it lies inside of
  bool is_wire() const { return faces.empty() && curve; }
  double parameter(double share) const { return (1 - share) * t0 + share * t1; }
};

/// Vertex inside a face that must be a node.
struct InnerPoint {
  int vertex = -1;
  Vec2 uv;
};

/// A vertex that is a part, or in a port.
struct PartPoint {
  int part = -1, vertex = -1;  ///< part: -1 of a port
  bool is_apart = false;       ///< nothing of the model has it
  std::string name;            ///< of the part or port
};

struct Face {
  std::string name;   ///< "Face12", "Face3 + Face9" where common to these; pieces of a face keep its name
  int origin = -1;    ///< 0-based entry of the report that it is, or is a piece of; pieces stand in a row
  std::string label;  ///< name given in the file, or empty
  std::shared_ptr<const Surface> surface;
  std::function<Vec2(Vec2)> converted;  ///< (u, v) from those of the surface as read; empty: they are the same
  bool is_reversed = false;             ///< outward normal is -(xu x xv)
  double area = 0;                      ///< mm^2
  double merged_area = 0;               ///< mm^2 that merging its neighbours or edges may have taken or given
  double gap_area = 0;           ///< mm^2, at most, between edges and their images, which ended beside the vertices
  bool has_area = true;          ///< false: left out with a note, has no loops
  bool is_common = false;        ///< no face but a place in the report: all of it is common with others
  bool is_dropped = false;       ///< left out since it lies inside the union of parts
  bool is_merged = false;        ///< left to its neighbours, as it is small against the target length
  std::vector<int> front, back;  ///< parts that are solids in front of it (where its normal looks) and behind it
  std::string fault;             ///< not empty: cannot be meshed, and why (e.g. an edge without a curve on the face)
  std::vector<Loop> loops;
  std::vector<InnerPoint> points;
  bool is_meshed() const { return has_area && fault.empty() && !is_common && !is_dropped && !is_merged; }
};

struct Model {
  std::vector<Vec3> vertices;
  std::vector<Edge> edges;
  std::vector<Face> faces;
  /// Names of solids ("Solid2"), of faces that hang together without one ("Sheet1"), of edges that bound no face
  /// ("Wire1"), of vertices that end no edge ("Point1").
  std::vector<std::string> parts;
  std::vector<int> part_solid;                ///< per part: the solid of the shape as read that it is, or -1
  std::vector<std::vector<int>> face_parts;   ///< per face: the parts that have it
  std::vector<int> edge_part;                 ///< per edge: the part that it is a wire of, or -1
  std::vector<PartPoint> points;              ///< parts that are vertices, then vertices of ports
  int read_faces = 0;                         ///< of the shape as read: the first entries of the report
  std::vector<std::vector<int>> common;       ///< per further entry: the faces as read that have it in common, rising
  int read_edges = 0;                         ///< edges of the shape as read, used or not
  std::vector<Vec3> read_vertices;            ///< of the shape as read
  std::vector<std::vector<int>> solid_faces;  ///< per solid of the shape as read: its faces, as Face::origin
  /// What they were named by ports and wires, empty where by none: entries of the report, edges as read.
  std::vector<std::string> face_group, edge_group;
  std::vector<std::string> solid_medium;  ///< per solid of the shape as read; empty: none
  ModelReport report;
  std::vector<std::string> notes;

  /// The face of the shape as read that an entry of the report is, or those that have it in common.
  std::vector<int> faces_as_read(int entry) const {
    return entry < read_faces ? std::vector{entry} : common[entry - read_faces];
  }
};

/// Whether an edge is of a wire: by itself, or in faces that it lies on.
inline bool is_of_wire(const Model& model, int edge) {
  const auto e = static_cast<std::size_t>(edge);
  return e < model.edge_part.size() && model.edge_part[e] >= 0;
}

/// The coedges of loops, one after the other. (Clang 14 cannot compile the views of the library that would do it.)
template <class Loops>
class CoedgesOf {
 public:
  class Iterator {
   public:
    Iterator(Loops& loops, std::size_t loop) : loops_(loops), loop_(loop) { skip(); }
    auto& operator*() const { return loops_[loop_].coedges[at_]; }
    Iterator& operator++() {
      ++at_;
      skip();
      return *this;
    }
    bool operator==(const Iterator& other) const { return loop_ == other.loop_ && at_ == other.at_; }

   private:
    void skip() {
      for (; loop_ < loops_.size() && at_ == loops_[loop_].coedges.size(); ++loop_) at_ = 0;
    }

    Loops& loops_;
    std::size_t loop_, at_ = 0;
  };

  explicit CoedgesOf(Loops& loops) : loops_(loops) {}
  Iterator begin() const { return {loops_, 0}; }
  Iterator end() const { return {loops_, loops_.size()}; }

 private:
  Loops& loops_;
};

template <class Loops>
CoedgesOf<Loops> coedges_of(Loops& loops) {
  return CoedgesOf<Loops>(loops);
}

inline const Edge& edge_of(const Model& model, const Coedge& coedge) { return model.edges[coedge.edge]; }

inline std::vector<int> edges_of(const Loop& loop) {
  std::vector<int> edges;
  for (const Coedge& coedge : loop.coedges) edges.push_back(coedge.edge);
  return edges;
}

/// Vertices where a coedge starts and ends.
inline int start_of(const Edge& edge, const Coedge& coedge) { return coedge.is_reversed ? edge.end : edge.start; }
inline int end_of(const Edge& edge, const Coedge& coedge) { return coedge.is_reversed ? edge.start : edge.end; }

/// Parameters of its edge there.
inline double start_parameter(const Edge& edge, const Coedge& coedge) { return coedge.is_reversed ? edge.t1 : edge.t0; }
inline double end_parameter(const Edge& edge, const Coedge& coedge) { return coedge.is_reversed ? edge.t0 : edge.t1; }

/// Whether another face uses the edge, or a wire lies on it.
bool has_other_user(const Model& model, int edge, int face);

/// Adds to Face::points the vertices on periodic edges that others have as well, and those of `wanted`.
void add_periodic_points(Model& model, const std::set<int>& wanted = {});

}  // namespace paver
