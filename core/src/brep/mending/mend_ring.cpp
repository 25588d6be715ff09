// Rings that readers have given poles: where they take the images of the two loops for each other's, they close the
// loop with edges of no length along the ends of the surface, and use the seam once, or there are two of it. In: the
// face. Out: the ring.
#include <BRep_Builder.hxx>
#include <ShapeBuild_Edge.hxx>
#include <ShapeFix_ShapeTolerance.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "brep/mending/mend_impl.h"
#include "brep/occt_shapes_impl.h"

namespace paver {
namespace {

constexpr double split_share = 1e-8;  // of the diagonal: files whose parts fit do so within that

/// A face between two loops that go round a periodic surface, and the edge that leads from one to the other.
class Ring {
 public:
  /// Nothing where a FORWARD face is none.
  static std::optional<Ring> of(const TopoDS_Face& face, double diagonal) {
    Ring ring(face);
    for (const TopoDS_Edge& edge : edges_of(face))
      if (!ring.add(edge, diagonal)) return std::nullopt;
    if (ring.loops_.size() != 2 || ring.loops_[0].IsSame(ring.loops_[1]) || ring.seam_.IsNull()) return std::nullopt;
    auto has_image = [&](const TopoDS_Edge& loop) { return !image_of(loop, face).curve.IsNull(); };
    if (!std::ranges::all_of(ring.loops_, has_image)) return std::nullopt;
    if (ring.is_split_) ring.close();
    return !ring.surface_.IsNull() && ring.surface_->IsUPeriodic() && ring.joins_loops() && ring.goes_back()
               ? std::optional(ring)
               : std::nullopt;
  }

  /// Whether the second loop does not begin where the first ends, or there are poles.
  bool is_garbled() const {
    const double gap = ends_of(loops_[0]).second - ends_of(loops_[1]).first;
    return has_false_poles_ || std::abs(gap) > 0.5 * surface_->UPeriod();
  }

  /// The same face, once round the first loop, along the seam, back round the second, and back along the seam.
  TopoDS_Face rebuilt() const {
    const double period = surface_->UPeriod();
    const auto [start, end] = ends_of(loops_[0]);
    const double shift = end - ends_of(loops_[1]).first;
    move(loops_[1], period * std::round(shift / period));
    const TopoDS_Edge out = TopoDS::Edge(seam_.Oriented(leaves_first() ? TopAbs_FORWARD : TopAbs_REVERSED));
    const Handle(Geom2d_Curve) there = image_at(end), back = image_at(start);
    BRep_Builder builder;
    builder.UpdateEdge(seam_, leaves_first() ? there : back, leaves_first() ? back : there, surface_, location_,
                       BRep_Tool::Tolerance(seam_));
    TopoDS_Face face;
    builder.MakeFace(face, surface_, location_, BRep_Tool::Tolerance(face_));
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    for (const TopoDS_Shape& edge :
         {TopoDS_Shape(loops_[0]), TopoDS_Shape(out), TopoDS_Shape(loops_[1]), out.Reversed()})
      builder.Add(wire, edge);
    wire.Closed(Standard_True);
    builder.Add(face, wire);
    // Vertices have been given what the false poles are off; the fuse takes all within for one.
    double tolerance = Precision::Confusion();
    for (const TopoDS_Edge& edge : {loops_[0], loops_[1], seam_})
      tolerance = std::max(tolerance, BRep_Tool::Tolerance(edge));
    ShapeFix_ShapeTolerance().SetTolerance(face, tolerance, TopAbs_VERTEX);
    return face;
  }

 private:
  explicit Ring(const TopoDS_Face& face) : face_(face), surface_(BRep_Tool::Surface(face, location_)) {}

  bool add(const TopoDS_Edge& edge, double diagonal) {
    if (BRep_Tool::Degenerated(edge)) {
      has_false_poles_ = true;
      return is_false_pole(edge, face_, diagonal);
    }
    const TopoDS_Vertex first = TopExp::FirstVertex(edge), last = TopExp::LastVertex(edge);
    const bool is_loop = first.IsSame(last) || are_near(first, last, diagonal);
    is_split_ |= is_loop && !first.IsSame(last);
    if (is_loop) {
      loops_.push_back(edge);
    } else if (seam_.IsNull()) {
      seam_ = forward(edge);
    } else if (!seam_.IsSame(edge)) {
      if (!runs_along_seam(edge, diagonal)) return false;
      is_split_ = true;
    }
    return true;
  }

  static bool are_near(const TopoDS_Vertex& a, const TopoDS_Vertex& b, double diagonal) {
    return BRep_Tool::Pnt(a).Distance(BRep_Tool::Pnt(b)) <= split_share * diagonal;
  }

  bool runs_along_seam(const TopoDS_Edge& edge, double diagonal) const {
    const auto [from, to] = std::pair{TopExp::FirstVertex(seam_), TopExp::LastVertex(seam_)};
    const auto [first, last] = std::pair{TopExp::FirstVertex(edge), TopExp::LastVertex(edge)};
    return (are_near(from, first, diagonal) && are_near(to, last, diagonal)) ||
           (are_near(from, last, diagonal) && are_near(to, first, diagonal));
  }

  /// A surface that is open by the last digit of its file: two seams, and loops that do not close; one runs the wrong
  /// way where its image lay a period away.
  void close() {
    std::array<TopoDS_Vertex, 2> at;
    for (std::size_t i = 0; i < 2; ++i) {
      const TopoDS_Vertex first = TopExp::FirstVertex(loops_[i]), last = TopExp::LastVertex(loops_[i]);
      at[i] = TopoDS::Vertex(first.EmptyCopied());  // the face may not be ours
      const double off = BRep_Tool::Pnt(at[i]).Distance(BRep_Tool::Pnt(last));
      BRep_Builder().UpdateVertex(at[i], off + std::max(BRep_Tool::Tolerance(at[i]), BRep_Tool::Tolerance(last)));
      loops_[i] = ShapeBuild_Edge().CopyReplaceVertices(loops_[i], at[i], at[i]);
    }
    const gp_Pnt from = BRep_Tool::Pnt(TopExp::FirstVertex(seam_));
    if (from.Distance(BRep_Tool::Pnt(at[0])) > from.Distance(BRep_Tool::Pnt(at[1]))) std::swap(at[0], at[1]);
    seam_ = ShapeBuild_Edge().CopyReplaceVertices(seam_, TopoDS::Vertex(at[0].Oriented(TopAbs_FORWARD)),
                                                  TopoDS::Vertex(at[1].Oriented(TopAbs_REVERSED)));
    for (std::size_t i = 0; i < 2; ++i) {
      const auto [start, end] = ends_of(loops_[i]);
      const bool is_low = height_of(loops_[i]) < height_of(loops_[1 - i]);
      if ((end > start) != is_low) loops_[i].Reverse();
    }
  }

  double height_of(const TopoDS_Edge& loop) const {
    const EdgeImage image = image_of(loop, face_);
    return image.curve->Value(image.first).Y();
  }

  bool leaves_first() const { return TopExp::FirstVertex(seam_).IsSame(TopExp::FirstVertex(loops_[0])); }

  bool joins_loops() const {
    const TopoDS_Vertex first = TopExp::FirstVertex(loops_[0]), second = TopExp::FirstVertex(loops_[1]),
                        from = TopExp::FirstVertex(seam_), to = TopExp::LastVertex(seam_);
    return (from.IsSame(first) && to.IsSame(second)) || (from.IsSame(second) && to.IsSame(first));
  }

  /// Whether each loop goes once round, one against the other.
  bool goes_back() const {
    std::array<double, 2> turn{};
    for (std::size_t i = 0; i < 2; ++i) {
      const auto [start, end] = ends_of(loops_[i]);
      turn[i] = (end - start) / surface_->UPeriod();
    }
    return std::abs(std::abs(turn[0]) - 1) < 0.01 && std::abs(turn[0] + turn[1]) < 0.01;
  }

  /// u where a loop begins and ends as it is walked.
  std::pair<double, double> ends_of(const TopoDS_Edge& loop) const {
    const EdgeImage image = image_of(loop, face_);
    const double a = image.curve->Value(image.first).X(), b = image.curve->Value(image.last).X();
    return loop.Orientation() == TopAbs_REVERSED ? std::pair{b, a} : std::pair{a, b};
  }

  void move(const TopoDS_Edge& loop, double by) const {
    if (by == 0) return;
    const auto moved = Handle(Geom2d_Curve)::DownCast(image_of(loop, face_).curve->Translated(gp_Vec2d(by, 0)));
    BRep_Builder().UpdateEdge(loop, moved, surface_, location_, BRep_Tool::Tolerance(loop));
  }

  Handle(Geom2d_Curve) image_at(double u) const {
    const EdgeImage image = image_of(seam_, face_);
    const gp_Vec2d shift(u - image.curve->Value(image.first).X(), 0);
    return Handle(Geom2d_Curve)::DownCast(image.curve->Translated(shift));
  }

  TopoDS_Face face_;
  TopLoc_Location location_;
  Handle(Geom_Surface) surface_;
  std::vector<TopoDS_Edge> loops_;
  TopoDS_Edge seam_;
  bool has_false_poles_ = false, is_split_ = false;
};

}  // namespace

bool is_garbled_ring(const TopoDS_Face& face, double diagonal) {
  const auto ring = Ring::of(face, diagonal);
  return ring && ring->is_garbled();
}

TopoDS_Face mended_ring(const TopoDS_Face& face, double diagonal) { return Ring::of(face, diagonal)->rebuilt(); }

}  // namespace paver
