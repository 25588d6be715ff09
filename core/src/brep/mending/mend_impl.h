// Faces that are faulty as drawn: what is wrong with their loops, and how they are made whole.
#pragma once

#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>
#include <array>
#include <functional>
#include <gp_Pnt2d.hxx>
#include <optional>
#include <string>
#include <vector>

#include "brep/connecting/workpiece_impl.h"
#include "brep/occt_shapes_impl.h"

namespace paver {

/// Visits the edges of a wire that bound the face, each with the vertices that it leads from and to, in the wire's
/// order; false, without the rest, when one has none.
template <class Visit>
bool visit_border(const TopoDS_Shape& wire, Visit visit) {
  for (TopoDS_Iterator parts(wire); parts.More(); parts.Next()) {
    if (parts.Value().ShapeType() != TopAbs_EDGE) continue;
    const TopoDS_Edge& edge = TopoDS::Edge(parts.Value());
    if (edge.Orientation() != TopAbs_FORWARD && edge.Orientation() != TopAbs_REVERSED) continue;
    const TopoDS_Vertex first = TopExp::FirstVertex(edge, Standard_True),
                        last = TopExp::LastVertex(edge, Standard_True);
    if (first.IsNull() || last.IsNull()) return false;
    visit(edge, first, last);
  }
  return true;
}

/// What a loop needs and does not have. Planes are asked for their vertices alone: their images are made from curves.
struct LoopFaults {
  int open = 0;                           ///< ends of edges that are no start of another
  int jumps = 0;                          ///< starts and ends in one vertex whose images lie apart
  std::vector<TopoDS_Edge> wrong_images;  ///< that are nowhere near their curve
  double off = 0;                         ///< how far these are, mm
  long count() const { return open + jumps + static_cast<long>(wrong_images.size()); }
};

/// Of a FORWARD face. Takes a few evaluations per edge.
LoopFaults find_loop_faults(const TopoDS_Face& face, double diagonal);

/// A flagged pole whose image on the surface has length after all: readers compare only a few of its points, and a
/// nose or tip pressed flat runs out and back through the same point.
bool is_false_pole(const TopoDS_Edge& edge, const TopoDS_Face& face, double diagonal);

/// An edge along a meridian whose image runs round the pole that it leads to.
struct BentMeridian {
  TopoDS_Edge edge;
  EdgeImage image;
  std::array<gp_Pnt2d, 2> was, ends;  ///< of the image, and of the iso-line in its place
  double off = 0;                     ///< mm, of that from the curve
};

/// Of a FORWARD face with poles.
std::vector<BentMeridian> find_bent_meridians(const TopoDS_Face& face);
void straighten(const TopoDS_Face& face, const std::vector<BentMeridian>& all);

/// A FORWARD face without the edges by which two of its loops run along each other; nothing for others.
std::optional<TopoDS_Face> without_doubled_edges(const TopoDS_Face& face, double diagonal);

/// Two edges of a face on a torus that lie in one place, their images periods apart.
struct PeriodicPair {
  TopoDS_Edge edge, back;                        ///< the loop walks along one, and back along the other
  std::array<TopoDS_Vertex, 2> ends, back_ends;  ///< where `edge` starts and ends, of both
  gp_Vec2d shift;                                ///< from the image of `edge` to the other
  bool has_common_ends() const { return ends[0].IsSame(back_ends[0]) && ends[1].IsSame(back_ends[1]); }
  /// Whether the curve of `back` runs the other way than that of `edge`.
  bool is_turned() const { return edge.Orientation() == back.Orientation(); }
};

/// Of a FORWARD face.
std::vector<PeriodicPair> find_periodic_pairs(const TopoDS_Face& face, double diagonal);
/// With `edge` in place of `back`; changes the edges.
TopoDS_Face with_periodic_edges(const TopoDS_Face& face, const std::vector<PeriodicPair>& pairs);

struct PressedFlat {
  TopoDS_Face face;
  std::vector<TopoDS_Edge> edges;  ///< each twice, with the orientation of its use
};

/// A FORWARD face with an edge (or two, where it starts in between) that it uses twice in place of a false pole that is
/// an iso-line and runs out and back along itself, as the end of a body pressed flat does; nothing for others.
std::optional<PressedFlat> pressed_flat(const TopoDS_Face& face, const TopoDS_Edge& pole, double diagonal);

/// Whether a FORWARD face lies between two loops that go round a periodic surface, and its images do not make one
/// border of that, or it has false poles besides.
bool is_garbled_ring(const TopoDS_Face& face, double diagonal);

/// Such a face, put right.
TopoDS_Face mended_ring(const TopoDS_Face& face, double diagonal);

/// A FORWARD face that is all of a surface of revolution whose closed meridian crosses the axis twice, cut down to the
/// piece between these poles that starts where its parameters do; one that touches it once, opened there; nothing for
/// others.
std::optional<TopoDS_Face> between_poles(const TopoDS_Face& face);

struct CompletedFace {
  TopoDS_Face face;
  TopoDS_Edge periodic_edge;
  std::vector<TopoDS_Edge> replaced;  ///< by it
};

/// A FORWARD face one of whose loops goes once round a period while nothing ends the face on the other side, with the
/// pole that its surface has there. Nothing for other faces, and where the surface has no pole on that side.
std::optional<CompletedFace> completed_to_pole(const TopoDS_Face& face, double diagonal);

/// Of a FORWARD face that completed_to_pole() would complete if its surface had the pole, an edge that goes round; null
/// for other faces.
TopoDS_Edge edge_without_end(const TopoDS_Face& face);

/// " at Edge7"; empty for an edge that was added.
std::string at_edge(const Workpiece& work, const TopoDS_Edge& edge);

/// Faces, and middles of their edges, this near each other, of the diagonal, are one; two sheets 5e-6 of it apart are
/// drawn so.
constexpr double doubled_share = 1e-7;
constexpr double doubled_area_share = 1e-6;

/// (later, earlier) face of usable ones that lie on one another, border on border, among those that `may_be_one`.
std::vector<std::array<int, 2>> find_doubles(const Workpiece& work,
                                             const std::function<bool(const WorkFace&, const WorkFace&)>& may_be_one);

/// Leaves out faces that lie on another one of the same solid, or of none, border on border.
void drop_doubles(Workpiece& work);

/// Closes open loops, and gives faces whose images jump or are wrong their periodic edges, poles and images; each face
/// only where that makes it better, does not change what it covers and leaves its edges where they are. Faces that go
/// round and still have no other end get a fault.
void mend_faces(Workpiece& work, Progress& progress);

/// Takes out of faces without area the edge by which a reader closes the image of a loop that goes round, as caps have
/// whose pole lies within the surface's range: mend_faces() completes what is left. Those whose border runs from pole
/// to pole and back become all that lies between.
void open_lost_caps(Workpiece& work);

/// Faults faces for which the kernel finds no area though their border encloses something.
void fault_lost_areas(Workpiece& work);

}  // namespace paver
