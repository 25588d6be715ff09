// What is wrong with the loops of a face. Every face of every model is asked, so it is a few evaluations per edge; only
// an image that is off its curve is looked at closely.
#include <Geom_Plane.hxx>
#include <TopLoc_Location.hxx>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/box.h"
#include "brep/mending/mend_impl.h"
#include "brep/occt_impl.h"
#include "brep/occt_shapes_impl.h"
#include "brep/surfaces/evaluators_impl.h"

namespace paver {
namespace {

/// Images that are farther apart than this share of their loop's extent do not meet.
constexpr double jump_share = 1e-2;
/// An image farther from its curve than this share of the diagonal is looked at;
constexpr double off_share = 1e-5;
/// it is wrong where no point of the curve is nearer to it than this share of the curve's own extent.
constexpr double wrong_share = 0.02;
constexpr int curve_samples = 128;

/// One end of an edge in a loop.
struct End {
  int vertex = 0;
  gp_Pnt2d uv;
};

class LoopExaminer {
 public:
  LoopExaminer(const TopoDS_Face& face, double diagonal) : face_(face), diagonal_(diagonal) {
    TopLoc_Location location;
    surface_ = BRep_Tool::Surface(face, location);
    placement_ = location.Transformation();
    is_flat_ = surface_.IsNull() || !Handle(Geom_Plane)::DownCast(surface_).IsNull();
  }

  LoopFaults run() {
    for (const TopoDS_Wire& wire : wires_of(face_)) add_loop(wire);
    return std::move(faults_);
  }

 private:
  void add_loop(const TopoDS_Shape& wire) {
    std::vector<End> starts, ends;
    Box box;
    auto add = [&](const TopoDS_Edge& edge, const TopoDS_Vertex& first, const TopoDS_Vertex& last) {
      starts.push_back({vertices_.Add(first), {}});
      ends.push_back({vertices_.Add(last), {}});
      if (!is_flat_) add_image(edge, starts.back(), ends.back(), box);
    };
    if (!visit_border(wire, add)) return;
    const double extent = box.is_empty() ? 0 : std::hypot(box.high.x - box.low.x, box.high.y - box.low.y);
    compare(starts, ends, jump_share * extent);
  }

  void add_image(const TopoDS_Edge& edge, End& start, End& end, Box& box) {
    const EdgeImage image = image_of(edge, face_);
    has_images_ = has_images_ && !image.curve.IsNull() && image.is_finite();
    if (!has_images_) return;
    start.uv = image.curve->Value(image.first);
    end.uv = image.curve->Value(image.last);
    const gp_Pnt2d middle = image.curve->Value(0.5 * (image.first + image.last));
    for (const gp_Pnt2d& p : {start.uv, middle, end.uv}) box.add(Vec2{p.X(), p.Y()});
    if (edge.Orientation() == TopAbs_REVERSED) std::swap(start.uv, end.uv);
    if (!BRep_Tool::Degenerated(edge) && is_wrong(edge, image)) faults_.wrong_images.push_back(edge);
  }

  Vec3 on_surface(const gp_Pnt2d& uv) const { return to_vec(surface_->Value(uv.X(), uv.Y()).Transformed(placement_)); }

  bool is_wrong(const TopoDS_Edge& edge, const EdgeImage& image) {
    const auto curve = make_curve(edge);
    const CurveRange range = range_of(edge);
    if (!curve || !range.is_finite()) return false;
    const double allowed = std::max(off_share * diagonal_, 2 * BRep_Tool::Tolerance(edge));
    for (double share : {0.29, 0.71}) {
      const Vec3 x = on_surface(image.uv(share));
      if (norm(x - curve->point(range.at(share))) > allowed && is_far(x, *curve, range, allowed)) return true;
    }
    return false;
  }

  bool is_far(Vec3 x, const Curve& curve, CurveRange range, double allowed) {
    const auto [t0, t1] = range;
    const Vec3 start = curve.point(t0);
    double least = std::numeric_limits<double>::max(), extent = 0;
    for (int i = 0; i <= curve_samples; ++i) {
      const Vec3 y = curve.point(t0 + (t1 - t0) * i / curve_samples);
      least = std::min(least, norm(x - y));
      extent = std::max(extent, norm(y - start));
    }
    if (least <= std::max(allowed, wrong_share * extent)) return false;
    faults_.off = std::max(faults_.off, least);
    return true;
  }

  /// Every end needs a start of its own in its vertex, and their images should meet.
  void compare(const std::vector<End>& starts, const std::vector<End>& ends, double allowed) {
    std::vector<std::vector<const End*>> starts_in(static_cast<std::size_t>(vertices_.Extent()) + 1);
    std::vector<int> balance(starts_in.size(), 0);
    for (const End& start : starts) {
      starts_in[start.vertex].push_back(&start);
      ++balance[start.vertex];
    }
    for (const End& end : ends) {
      const auto vertex = static_cast<std::size_t>(end.vertex);
      --balance[vertex];
      const auto& here = starts_in[vertex];
      const bool meets = std::any_of(here.begin(), here.end(),
                                     [&](const End* start) { return start->uv.Distance(end.uv) <= allowed; });
      if (has_images_ && !is_flat_ && !here.empty() && !meets) ++faults_.jumps;
    }
    for (int b : balance) faults_.open += std::max(0, -b);
  }

  const TopoDS_Face& face_;
  double diagonal_;
  Handle(Geom_Surface) surface_;
  gp_Trsf placement_;
  bool is_flat_ = false, has_images_ = true;
  TopTools_IndexedMapOfShape vertices_;
  LoopFaults faults_;
};

}  // namespace

LoopFaults find_loop_faults(const TopoDS_Face& face, double diagonal) { return LoopExaminer(face, diagonal).run(); }

}  // namespace paver
