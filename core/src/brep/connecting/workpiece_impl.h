// A shape on its way to a Model: its faces in the order of the file, as repaired and sewn so far.
#pragma once

#include <BRepExtrema_DistShapeShape.hxx>
#include <IntTools_Context.hxx>
#include <NCollection_DataMap.hxx>
#include <NCollection_IndexedDataMap.hxx>
#include <TopAbs_ShapeEnum.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/tasks/shared_tasks.h"
#include "base/union_find.h"
#include "brep/shape_impl.h"
#include "paver/progress.h"
#include "paver/result.h"

namespace paver {

/// A part that has a face, and on which side.
struct FaceUse {
  int part = -1;
  bool is_opposed = false;  ///< the part's own outward side is the other one
};

struct WorkFace {
  TopoDS_Face face;  ///< current image, with the orientation it has in the shape
  /// Index of the face of the shape as read that it is, or is a piece of; beyond these an entry of Workpiece::common.
  int origin = -1;
  int solid = -1;              ///< index of the solid it belongs to, -1: none
  int read_sheet = -1;         ///< faces of the shape as read that share edges there have the same; by list_parts()
  std::vector<FaceUse> uses;   ///< known from list_parts() on; the first one's side is the face's
  std::vector<int> inside_of;  ///< parts that it lies inside of, both sides; rising
  double area = 0;             ///< mm^2
  double gap = 0;              ///< mm, that was closed between the faces it is a piece of; by connect()
  bool has_area = true;
  bool is_loose = false;    ///< of a solid that touches itself: it is where that does
  bool is_common = false;   ///< stands for a face all of which is common with others: they have an entry of their own
  bool is_dropped = false;  ///< left out since it lies inside the union of parts, or of a solid that touches itself
  std::string fault;        ///< not empty: cannot be meshed, and why
  std::function<Vec2(Vec2)> converted;  ///< (u, v) from those of the surface as read; empty: they are the same

  bool is_usable() const { return has_area && fault.empty(); }
  void lose_area() { has_area = false, area = 0; }
  bool has_part(int part) const {
    return std::any_of(uses.begin(), uses.end(), [&](const FaceUse& use) { return use.part == part; });
  }
};

/// An object of the input: a solid, faces that hang together without one, edges that bound no face likewise, or a
/// vertex that ends no edge.
struct WorkPart {
  std::string name;       ///< "Solid2", "Sheet1", "Wire1", "Point1"
  int solid = -1;         ///< index of the solid of the shape as read
  bool is_loose = false;  ///< touches itself where its pieces share nothing
};

/// An edge that bounds no face.
struct WorkWire {
  TopoDS_Edge edge;
  int part = -1;
  int origin = -1;                  ///< index in LooseShapes::edges of the shape as read
  std::vector<int> inside_of = {};  ///< parts that are solids that it lies inside of, rising
};

/// A vertex that ends no edge.
struct WorkPoint {
  TopoDS_Vertex vertex;
  int part = -1;
  int origin = -1;      ///< index in LooseShapes::vertices of the shape as read
  bool is_end = false;  ///< it is where an edge ends: `vertex` is that edge's
};

/// A face below this share of the diagonal squared has no area.
inline constexpr double no_area_share = 1e-10;
/// Of the diagonal: edges this short are points.
inline constexpr double point_share = 1e-7;

struct Workpiece {
  TopoDS_Shape shape;
  /// In the order of TopExp::MapShapes of the shape as read, pieces of one in a row; what several faces have in common
  /// comes last.
  std::vector<WorkFace> faces;
  int read_faces = 0;                    ///< of the shape as read
  std::vector<std::vector<int>> common;  ///< per set of faces with pieces in common: their indices, rising
  std::vector<WorkWire> wires;
  std::vector<WorkPoint> points;
  int left_points = 0;          ///< left out: more than most_points
  std::vector<WorkPart> parts;  ///< known from list_parts() on
  double diagonal = 0;          ///< of the bounding box, mm
  Vec3 centre;                  ///< of the bounding box
  bool is_copied = false;       ///< shape and faces are our own, to be changed in place
  bool is_rebuilt = false;      ///< faces are no longer those of `shape`: edges are listed over the faces instead
  TopTools_IndexedMapOfShape read_edges;  ///< of `shape`, in the order of the shape as read
  /// Edges that took the place of others, when sewn or divided: the 0-based edges as read that they lie on, rising.
  NCollection_DataMap<TopoDS_Shape, std::vector<int>, TopTools_ShapeMapHasher> replaced_edges;
  std::vector<Repair> repairs;              ///< in the order of their kinds
  std::vector<std::array<int, 2>> doubles;  ///< (face that was left out, face that it lies on)

  /// The face of the shape as read that has this WorkFace::origin, or those that have it in common.
  std::vector<int> faces_as_read(int origin) const {
    return origin < read_faces ? std::vector{origin} : common[origin - read_faces];
  }
  /// Whether an area in mm^2 is more than rounding: a face with less has none.
  bool is_area(double area) const { return area > no_area_share * diagonal * diagonal; }
  /// The same of a face; what is small but no sliver has one in a solid, too, which would be open without it.
  bool has_area(const WorkFace& face) const;
  void note_repair(RepairKind kind, long count, double distance, const std::string& face = {});
};

/// Items that hang together by the edges, or vertices, of their shapes.
class Hanging {
 public:
  Hanging(std::size_t items, TopAbs_ShapeEnum by) : by_(by), groups_(items) {}
  void add(std::size_t item, const TopoDS_Shape& shape);
  /// The first item of the group.
  int group_of(std::size_t item) { return groups_.find(static_cast<int>(item)); }

 private:
  TopAbs_ShapeEnum by_;
  UnionFind groups_;
  NCollection_IndexedDataMap<TopoDS_Shape, int, TopTools_ShapeMapHasher> first_item_;  ///< of those with a joint
};

/// Points taken for parts: files with more have them from drawing.
inline constexpr int most_points = 100;

/// Progress units that the functions below credit per face.
inline constexpr long measure_units = 1, repair_units = 1, sew_units = 2;

/// Faces, their solids and areas, and the diagonal. A face with less than 1e-10 diagonal^2 has no area.
/// Credits measure_units per face. Collective.
Workpiece make_workpiece(const Shape& shape, Progress& progress, SharedTasks& tasks);

/// Diagonal and centre, from points of faces and of the edges as read: the kernel's quick box holds the poles of
/// B-splines, far outside of trimmed faces, and its exact one takes longer than all that make_workpiece() does else.
void measure_diagonal(Workpiece& work);

/// Makes shape and faces our own, so that they may be changed in place. Order of faces and edges stays.
void copy_shape(Workpiece& work);

/// Moves all shapes, which are our own then, and scales them about the origin. False, and nothing done, where the
/// kernel cannot.
bool move_work(Workpiece& work, Vec3 by, double scale = 1);

/// Gives faces without loops their natural bounds, edges without an image on a face that image, and edges wrongly
/// flagged as poles their curve. What fails becomes the face's fault. The input's own data stay as they are.
/// Credits repair_units per face.
void repair(Workpiece& work, Progress& progress);

/// All edges, in the order in which the model lists them.
TopTools_IndexedMapOfShape edge_map(const Workpiece& work);

/// The 0-based edges of the shape as read that an edge is or lies on; none for an edge that was added.
std::vector<int> edge_origins(const Workpiece& work, const TopoDS_Shape& edge);

/// Notes that the edges of `image` lie where `edge` does, besides what they are known to lie on.
void add_edge_origins(Workpiece& work, const TopoDS_Shape& image, const TopoDS_Shape& edge);

/// How often faces use their edges.
struct EdgeUses {
  NCollection_IndexedDataMap<TopoDS_Shape, int, TopTools_ShapeMapHasher> count;
  void add(const TopoDS_Face& face);
  /// One use only, not a pole.
  bool is_free(const TopoDS_Shape& edge) const;
  std::vector<TopoDS_Edge> free_edges() const;
};
/// Of faces with area.
EdgeUses count_uses(const std::vector<WorkFace>& faces);

struct SewResult {
  double tolerance = 0;  ///< 0: nothing was sewn
  long free_before = 0, free_after = 0;
  std::vector<int> lost_faces;  ///< indices of faces that sewing dropped as smaller than the tolerance
};

/// Makes coinciding free edges common, solid by solid and among the faces without a solid. Without `tolerance` (mm, 0:
/// never sew) what is drawn to fit, and larger gaps as far as that closes what is open. Credits sew_units per face.
SewResult sew(Workpiece& work, std::optional<double> tolerance, Progress& progress);

struct DividedFace {
  int origin = -1;  ///< WorkFace::origin
  int creases = 0;  ///< along which it was divided
};

/// Cuts faces along the iso-lines where their normal jumps, or turns by a right angle within `unresolved` mm and a
/// small part of the face, so that these become edges; faces afterwards are the pieces. Nothing changes where there is
/// no such line.
std::vector<DividedFace> divide_creases(Workpiece& work, double unresolved);

/// Area in mm^2 whatever the orientation; NaN when the kernel cannot compute it.
double face_area(const TopoDS_Face& face);

/// Microseconds that its area or its share of a volume takes, as far as its edges and the spans of its surface tell.
double measuring_cost(const TopoDS_Face& face);

/// A point inside of a face; nothing where the kernel finds none.
std::optional<gp_Pnt> point_inside(const TopoDS_Face& face, const Handle(IntTools_Context) & context);

/// The nearest places of two shapes; nothing where the kernel finds none.
std::optional<BRepExtrema_DistShapeShape> nearest_places(const TopoDS_Shape& one, const TopoDS_Shape& two);

/// Per part of the work whether it is one of these.
std::vector<char> marked_parts(const Workpiece& work, const std::vector<int>& parts);

/// Whether a face comes as near to a point, mm.
bool is_near(const gp_Pnt& point, const TopoDS_Face& face, double distance);

/// Length of an edge in mm; 0 for a pole.
double edge_length(const TopoDS_Edge& edge);

/// Volume between the face and `apex`, mm^3; negative where its normal looks at the apex. The sum over closed faces is
/// what they enclose. NaN when the kernel cannot compute it.
double volume_to(const TopoDS_Face& face, Vec3 apex);

/// "Face12" for index 11.
inline std::string face_name(int index) { return "Face" + std::to_string(index + 1); }

/// "Face3, Face8, Face9 and 29 more"; a name that follows itself (pieces of a face) is listed once.
std::string list_names(std::vector<std::string> names);

}  // namespace paver
