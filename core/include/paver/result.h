// What a run gives: the mesh, a report of every face, and the figures of the whole.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "paver/error.h"
#include "paver/options.h"
#include "paver/progress.h"
#include "paver/vec.h"

namespace paver {

/// Conforming surface mesh of order p. Node order inside elements is Gmsh's for Lagrange elements:
/// corners, then the inner nodes of each side in turn, then the inside (order 2: quad9, tri6, line3).
/// Elements run counter-clockwise seen against the outward normal of their B-rep face.
struct SurfaceMesh {
  int order = 1;
  std::vector<Vec3> nodes;         ///< mm
  std::vector<int> quads;          ///< (p+1)^2 node indices per quad
  std::vector<int> quad_face;      ///< 0-based B-rep face per quad
  std::vector<int> triangles;      ///< (p+1)(p+2)/2 node indices per triangle
  std::vector<int> triangle_face;  ///< 0-based B-rep face per triangle
  std::vector<int> lines;          ///< p+1 node indices per piece of a B-rep edge
  std::vector<int> line_edge;      ///< 0-based B-rep edge per line; edges that dividing added follow the model's own
  std::vector<int> node_edge;      ///< per node: the B-rep edge it lies on (ends: any of its edges), or -1
  /// (line, 0-based B-rep edge): where sewing made edges common, those a line lies on besides its line_edge.
  std::vector<std::array<int, 2>> further_edges;
  std::vector<double> node_target;  ///< per node: target length h there, mm (corner nodes; 0 elsewhere)
  std::vector<int> points;          ///< nodes of vertices that end no edge, then of those in ports

  /// Nodes of a line, its ends first.
  std::span<const int> line(std::size_t i) const {
    const std::size_t count = static_cast<std::size_t>(order) + 1;
    return {lines.data() + i * count, count};
  }
  int nodes_per_quad() const { return (order + 1) * (order + 1); }
  int nodes_per_triangle() const { return (order + 1) * (order + 2) / 2; }
  std::size_t quad_count() const { return quad_face.size(); }
  std::size_t triangle_count() const { return triangle_face.size(); }
};

enum class FaceStatus {
  meshed,
  no_area,
  failed,
  common,   ///< all of it is common with other faces: what they have in common is an entry of its own
  dropped,  ///< left out, as it lies between or inside solids of a union
  merged,   ///< left to its neighbours, as it is small against the target length
};

/// How far elements are from the surface that they stand for, and the other way; sampled (core/docs/quality.md).
struct SurfaceDistance {
  double largest = 0;  ///< mm, between elements and surface, or their sides and curves
  double mean = 0;     ///< mm, over the elements
  double angle = 0;    ///< largest between normals at the same place, radians
};

struct FaceReport {
  std::string name;                      ///< "Face12"; "Face3 + Face9" for what these have in common
  std::vector<std::string> front, back;  ///< solids in front of all of it, where its normal looks, and behind it
  std::optional<double> wavelength;      ///< mm, the shortest of the media on both sides; none without a frequency
  /// Of the first of these that has one; empty: that around the solids; none: its pieces lie in different ones.
  std::optional<std::string> front_medium, back_medium;
  FaceStatus status = FaceStatus::meshed;
  std::string stage, reason;  ///< when not meshed: where it stopped and why
  std::optional<Vec3> where;  ///< when failed: a point near the trouble, where one is known
  long quads = 0, triangles = 0;
  double worst_sj = 1;      ///< worst straight-sided scaled Jacobian
  double longest_side = 0;  ///< of its elements, chord, mm
  double cad_area = 0;      ///< mm^2
  double mesh_area = 0;     ///< mm^2, of the curved elements
  SurfaceDistance distance;
  long closed_by_triangulation = 0;  ///< pieces of front that paving left to triangulate-and-merge

  void fail(const std::string& at_stage, const std::string& why, const std::optional<Vec3>& near = {}) {
    status = FaceStatus::failed, stage = at_stage, reason = why, where = near;
  }
};

/// Smallest, mean, and share below 0.3, of a scaled Jacobian.
struct ScaledJacobianStats {
  double min = 0, mean = 0, below_03 = 0;
};

/// By lengths that count how far the surface turns, as elements are made (core/docs/quality.md).
struct MetricFigures {
  double predicted = 0;  ///< elements to expect by sizes and counts of edges
  double least_sj = 0;   ///< scaled Jacobian
  double mean_sj = 0;
  double length_mean = 0;     ///< of the elements' sides, by the target length there
  double length_in_band = 0;  ///< share of sides within 0.5 to 1.5 of it
};

/// Figures of the whole mesh; definitions as in core/docs/quality.md.
struct QualityReport {
  long quads = 0, triangles = 0, nodes = 0;
  long wire_lines = 0;                                 ///< line elements of wires
  ScaledJacobianStats sj_quads, sj_triangles, sj_all;  ///< straight-sided
  double irregular_share =
      0;  ///< nodes inside faces (off B-rep edges, periodic edges do not count) with other than 4 edges
  long irregular_nodes = 0, face_interior_nodes = 0;
  long edges = 0;                              ///< mesh edges, each once
  double shortest_edge = 0, longest_edge = 0;  ///< chords, mm
  double length_mean = 0;                      ///< mean of edge length / target length of the run
  double length_cv = 0;                        ///< coefficient of variation
  double length_in_band = 0;                   ///< share of edges within 0.7 to 1.4 of the target length
  double mesh_area = 0, cad_area = 0;
  SurfaceDistance distance;
  long inverted = 0, undecided = 0;              ///< curved elements whose Jacobian is not proven positive
  double min_jacobian_ratio = 0;                 ///< lower bound of the curved Jacobian over its mean
  long border_edges = 0, nonmanifold_edges = 0;  ///< mesh edges with one element, with more than two
  bool watertight = false;
  MetricFigures metric;
};

enum class ContactKind { face, edge, point, crossing };

/// "face", "edge", "point" or "crossing".
const char* contact_name(ContactKind kind);

/// Where two parts of the input touch or cross.
struct Contact {
  std::array<std::string, 2> parts;  ///< "Solid1", "Sheet2", "Wire1", "Point1"
  ContactKind kind = ContactKind::point;
  std::vector<std::string> faces;  ///< of both parts, that have a share in it: "Face3"
  double size = 0;                 ///< mm^2 of common faces, mm of common edges, number of common points
  double gap = 0;                  ///< largest that was closed, mm
};

/// Two parts that come within a hundredth of the target length of each other and share no node there; or free edges of
/// one part that run along each other, nearer than a thousandth.
struct Gap {
  std::array<std::string, 2> parts;  ///< of a crack twice the same
  double distance = 0;               ///< least, of a crack the largest where it was looked at, mm
  Vec3 where;                        ///< on one of them
};

/// Elements of two faces, or of one, run through each other and share no node there.
struct Crossing {
  std::array<std::string, 2> faces;  ///< of one that crosses itself twice the same
  Vec3 where;
};

/// What was repaired in a model that is not clean.
enum class RepairKind {
  sewn_edge,      ///< edges made common
  closed_loop,    ///< faces with open loops whose ends were joined
  turned_loop,    ///< loops that ran the wrong way round
  image,          ///< missing or wrong images of edges in a surface's parameters
  periodic_edge,  ///< missing periodic edges
  pole,           ///< missing poles, and edges wrongly flagged as poles
  border,         ///< missing borders of faces that are whole surfaces
  turned_face,    ///< faces turned over so that they agree and look outwards
  dropped_face,   ///< left out, as they lie on another one
};

/// "sewn edges", "closed loops" and so on.
const char* repair_name(RepairKind kind);

struct Repair {
  RepairKind kind = RepairKind::sewn_edge;
  long count = 0;
  double distance = 0;             ///< largest by which anything was off or was moved, mm
  std::vector<std::string> faces;  ///< "Face3", where it is one face's
};

/// What was merged, as it is small against the target length.
enum class MergeKind { edge, face };

/// "edge" or "face".
const char* merge_name(MergeKind kind);

struct Merge {
  MergeKind kind = MergeKind::edge;
  std::string name, into;  ///< "Edge7" and the edge that goes on in its place; "Face3" and a neighbour
  double size = 0;         ///< of an edge its length, of a face its width, mm
  Vec3 where;
};

/// What reading and topology found.
struct ModelReport {
  std::string file, format, unit;  ///< unit the file states, e.g. "INCH"; lengths are millimetres all the same
  long solids = 0, shells = 0, faces = 0, edges = 0, vertices = 0;
  long free_edges = 0, nonmanifold_edges = 0;
  long sewn_edges = 0;                                               ///< edges made common by sewing
  double sew_tolerance = 0;                                          ///< mm; 0: not sewn
  double diagonal = 0;                                               ///< of the bounding box, mm
  double area = 0;                                                   ///< mm^2
  std::vector<std::string> free_edge_names, nonmanifold_edge_names;  ///< "Edge7"
  std::vector<Contact> contacts;
  std::vector<std::array<std::string, 2>> unconnected;  ///< pairs of parts that touch and could not be connected
  std::vector<std::string> merged_parts;  ///< that touch along faces which were written differently and taken for one
  double merged_gap = 0;                  ///< between those, mm
  std::vector<std::string> one_sided;     ///< solids whose faces have no side in common that is outside
  double curve_distance = 0;              ///< largest of an edge's curve from a face that uses it, mm
  std::vector<std::string> stray_edges;   ///< those whose curves are farther from a face than tolerances explain
  /// What a STEP or IGES file has and the kernel makes nothing of, or something else: "#12 ConicalSurface".
  std::vector<std::string> unread;
  std::vector<std::string> open_solids;  ///< with edges on one face only: "Solid2", in a file "#158 ManifoldSolidBrep"
  std::vector<std::string> holes;        ///< faces left out as too small, without which their bodies are open
  std::vector<Repair> repairs;           ///< in the order of RepairKind, those that occurred
};

/// One piece of work that may run on any thread or rank; those of one stage in the order of the queue.
struct TaskTime {
  Stage stage =
      Stage::paving;   ///< regions: a region paved or, when on levels, its coarse mesh; paving: one of its pieces
  double seconds = 0;  ///< wall time
  long elements = 0;   ///< of the mesh, those that it laid: none by a coarse mesh
};

/// How an element that would fold or miss its surface, or was poor, was mended where it was.
enum class ElementRepairKind {
  moved,         ///< its free corners
  refilled,      ///< other elements about it
  divided,       ///< nodes on sides inside the face
  paved_again,   ///< a region, whose lengths do not count turns any more
  divided_edge,  ///< a node on a side on a B-rep edge
};

/// "moved", "refilled", "divided", "paved again" or "divided edge".
const char* element_repair_name(ElementRepairKind kind);

struct ElementRepair {
  ElementRepairKind kind = ElementRepairKind::moved;
  std::string entity;  ///< "Face3"; of a divided edge "Edge7"
  Vec3 where;
};

struct RunReport {
  ModelReport model;
  std::vector<std::vector<std::string>> components;  ///< separate meshes, each by the parts it is of
  std::vector<Gap> gaps;                             ///< not of parts that are named as unconnected
  std::vector<Crossing> crossings;                   ///< not of parts that are named there or in gaps
  double target_length = 0;                          ///< mm
  double off_edge = 0;  ///< mm, of sides that were straightened along edges of the shape to keep elements valid
  int order = 2, threads = 1;
  Elements elements = Elements::quad_dominant;
  QualityReport quality;
  std::vector<FaceReport> faces;  ///< the faces as read, then what several of them have in common
  std::vector<Medium> media;      ///< as given, like ports and wires
  std::vector<Port> ports;
  std::vector<Wire> wires;
  std::optional<double> wavelength;     ///< mm, around the solids; none without a frequency
  std::optional<double> least_segment;  ///< of the lines of wires with a radius: length by radius
  std::vector<std::string> lost_parts;  ///< of ports and wires that are not in the mesh: "Edge5 of 'Feed'"
  std::vector<Merge> merges;
  std::vector<ElementRepair> element_repairs;
  std::vector<std::string> notes;                             ///< one sentence each
  std::vector<std::pair<std::string, double>> stage_seconds;  ///< wall time per stage, in order
  std::vector<std::pair<std::string, long>> stage_runs;       ///< how often each began, in order
  std::vector<TaskTime> tasks;                                ///< those done by this process
  double peak_memory_mib = 0;
};

/// The group of edges where more than two faces meet.
inline constexpr const char* junctions = "Junctions";

/// A solid that has a medium.
struct Volume {
  std::string name, medium;  ///< "Solid2", "FR4"
  std::vector<int> sides;    ///< B-rep faces that bound it, from 1; negative where the outward normal looks into it
};

struct MeshResult {
  SurfaceMesh mesh;
  RunReport report;
  std::vector<std::string> face_names;   ///< per B-rep face: its name in the file, else "Face12"
  std::vector<std::string> face_groups;  ///< per B-rep face: the port it is in, or empty
  /// Per B-rep edge: "Edge7"; "Added1" for those that dividing and connecting added; "Junction1", "Piece1" for pieces
  /// of an edge that are in another group than its other pieces.
  std::vector<std::string> edge_names;
  /// Per B-rep edge: the port or wire it is named in, the wire it is of ("Wire1"), `junctions`, or empty.
  std::vector<std::string> edge_groups;
  std::vector<std::string> point_names;  ///< per entry of the mesh's points: "Point1", or the port it is in
  std::vector<Volume> volumes;           ///< solids that have a medium
};

/// Whether there are neither elements nor lines of wires.
bool is_empty(const MeshResult& result);

/// What is wrong with the mesh, one sentence each. Without any, every face with an area is meshed and all elements,
/// sides and nodes have passed the checks of core/docs/quality.md.
std::vector<std::string> faults(const RunReport& report);

/// What keeps a mesh without faults from being called sound, one sentence each: parts that all but touch.
std::vector<std::string> doubts(const RunReport& report);

/// "faulty", "doubtful" or "sound".
const char* verdict(const RunReport& report);

/// Why a result is not all that was asked for: Error{face_failed} that names the faces and reasons, Error{no_faces}
/// when no face has an area, nothing when every face with an area is meshed.
std::optional<Error> shortfall(const MeshResult& result);

}  // namespace paver
