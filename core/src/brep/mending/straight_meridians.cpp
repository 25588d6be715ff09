// Meridians that miss the pole they lead to by rounding, as in files with few decimals: about the pole their longitude
// turns by any angle, and a kernel's image of them, near the curve as it is, runs round the pole there. Such an image
// becomes the iso-line that it was meant to be, and the pole's goes from one of these to the next.
#include <BRep_Builder.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <TopLoc_Location.hxx>
#include <algorithm>
#include <array>
#include <cmath>

#include "brep/mending/mend_impl.h"
#include "brep/occt_impl.h"
#include "brep/occt_shapes_impl.h"
#include "brep/surfaces/evaluators_impl.h"

namespace paver {
namespace {

/// Of the edge's extent: what is farther from the iso-line, or from the pole, was meant so. Four decimals come to half.
constexpr double most_rounded = 1e-4;
/// Of the surface's range round: images that turn by less do no harm.
constexpr double bent_share = 1e-4;
/// Of the surface's range across: a pole's image is this near the end of that.
constexpr double end_share = 1e-3;
constexpr int samples = 8;

enum : int { along_u = 1, along_v = 2 };  // as gp_Pnt2d counts coordinates

struct Range {
  double low = 0, high = 0;
  double size() const { return high - low; }
  double nearer_end(double value) const { return value - low < high - value ? low : high; }
};

/// From one place to another, at the parameters of an edge.
Handle(Geom2d_Curve) straight(const std::array<gp_Pnt2d, 2>& ends, const CurveRange& range) {
  TColgp_Array1OfPnt2d points(1, 2);
  points(1) = ends[0], points(2) = ends[1];
  TColStd_Array1OfReal knots(1, 2);
  knots(1) = range.first, knots(2) = range.last;
  TColStd_Array1OfInteger multiplicities(1, 2);
  multiplicities.Init(2);
  return new Geom2d_BSplineCurve(points, knots, multiplicities, 1);
}

class MeridianFinder {
 public:
  explicit MeridianFinder(const TopoDS_Face& face) : face_(face) {
    TopLoc_Location location;
    surface_ = BRep_Tool::Surface(face, location);
    placement_ = location.Transformation();
    if (!surface_.IsNull()) surface_->Bounds(ranges_[0].low, ranges_[0].high, ranges_[1].low, ranges_[1].high);
  }

  /// The iso-line that the image of an edge was meant to be, where that is not the image itself.
  std::optional<BentMeridian> bent(const TopoDS_Edge& edge) const {
    BentMeridian bent{edge, image_of(edge, face_), {}, {}, 0};
    if (bent.image.curve.IsNull() || !bent.image.is_finite()) return std::nullopt;
    bent.was = bent.ends = {bent.image.uv(0), bent.image.uv(1)};
    return lead_to_poles(bent, along_u) || lead_to_poles(bent, along_v) ? std::optional(bent) : std::nullopt;
  }

 private:
  const Range& range(int direction) const { return ranges_[static_cast<std::size_t>(direction - 1)]; }
  gp_Pnt at(const gp_Pnt2d& uv) const { return surface_->Value(uv.X(), uv.Y()).Transformed(placement_); }

  /// Where the row that goes round at the end of the range beside `uv` is one point: puts `uv` there.
  bool lead_to_pole(gp_Pnt2d& uv, int round, double allowed) const {
    const int across = along_u + along_v - round;
    const gp_Pnt place = at(uv);
    gp_Pnt2d end = uv;
    end.SetCoord(across, range(across).nearer_end(uv.Coord(across)));
    if (std::fabs(end.Coord(across) - uv.Coord(across)) > end_share * range(across).size()) return false;
    for (const double share : {0.0, 0.3, 0.6}) {
      gp_Pnt2d other = end;
      other.SetCoord(round, range(round).low + share * range(round).size());
      if (at(other).Distance(place) > allowed) return false;
    }
    uv = end;
    return true;
  }

  bool lead_to_poles(BentMeridian& bent, int round) const {
    const auto curve = make_curve(bent.edge);
    const CurveRange own = range_of(bent.edge);
    if (!curve || Precision::IsInfinite(range(round).size())) return false;
    const double extent = norm(curve->point(own.at(0.5)) - curve->point(own.first));
    const bool at_first = lead_to_pole(bent.ends[0], round, most_rounded * extent),
               at_last = lead_to_pole(bent.ends[1], round, most_rounded * extent);
    if (!at_first && !at_last) return false;
    // What does not end at a pole is where the next edge starts; halfway between poles nothing turns.
    const double meant = (at_first && at_last ? bent.image.uv(0.5) : bent.ends[at_first ? 1 : 0]).Coord(round);
    double turn = 0;
    for (gp_Pnt2d& end : bent.ends) {
      turn = std::max(turn, std::fabs(end.Coord(round) - meant));
      end.SetCoord(round, meant);
    }
    if (turn <= bent_share * range(round).size()) return false;
    for (int i = 0; i <= samples; ++i) {
      const double share = static_cast<double>(i) / samples;
      const gp_Pnt2d uv(bent.ends[0].XY() * (1 - share) + bent.ends[1].XY() * share);
      bent.off = std::max(bent.off, norm(to_vec(at(uv)) - curve->point(own.at(share))));
    }
    return bent.off <= most_rounded * extent;
  }

  const TopoDS_Face& face_;
  Handle(Geom_Surface) surface_;
  gp_Trsf placement_;
  std::array<Range, 2> ranges_;
};

/// From where it went the image of a pole goes on with what it meets there.
void lead_on(const TopoDS_Edge& pole, const TopoDS_Face& face, const std::vector<BentMeridian>& all) {
  const EdgeImage image = image_of(pole, face);
  if (image.curve.IsNull() || !image.is_finite()) return;
  std::array<gp_Pnt2d, 2> ends = {image.uv(0), image.uv(1)};
  const double near = end_share * ends[0].Distance(ends[1]);
  for (gp_Pnt2d& end : ends) {
    const gp_Pnt2d was = end;
    for (const BentMeridian& bent : all)
      for (const std::size_t k : {0U, 1U})
        if (bent.was[k].Distance(was) <= near) end = bent.ends[k];
  }
  BRep_Builder().UpdateEdge(pole, straight(ends, image), face, BRep_Tool::Tolerance(pole));
}

}  // namespace

std::vector<BentMeridian> find_bent_meridians(const TopoDS_Face& face) {
  const std::vector<TopoDS_Edge> edges = edges_of(face);
  if (!std::ranges::any_of(edges, &BRep_Tool::Degenerated)) return {};
  const MeridianFinder finder(face);
  std::vector<BentMeridian> found;
  for (const TopoDS_Edge& edge : edges)
    if (!BRep_Tool::Degenerated(edge) && !BRep_Tool::IsClosed(edge, face))
      if (const auto bent = finder.bent(edge)) found.push_back(*bent);
  return found;
}

void straighten(const TopoDS_Face& face, const std::vector<BentMeridian>& all) {
  const BRep_Builder builder;
  for (const TopoDS_Edge& edge : edges_of(face))
    if (BRep_Tool::Degenerated(edge)) lead_on(edge, face, all);
  for (const BentMeridian& bent : all) {
    builder.UpdateEdge(bent.edge, straight(bent.ends, bent.image), face, bent.off);
    for (const TopoDS_Vertex& vertex : {TopExp::FirstVertex(bent.edge), TopExp::LastVertex(bent.edge)})
      builder.UpdateVertex(vertex, bent.off);
  }
}

}  // namespace paver
