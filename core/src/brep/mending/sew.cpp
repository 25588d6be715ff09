// Sewing: edges of one face only that coincide with such an edge of another face become one common edge.
// Solids are sewn each by itself, and so are the faces without one. Faces without a free edge keep their edges as they
// are, so sharing in the input is never undone. Faces keep their order and number.
//
// The tolerance is chosen by what it closes. First what fits as drawn is sewn. Where free edges stay that have other
// free edges along them, the gap between these is tried; it counts when it closes the group, or most of what was open,
// and when nothing collapses: no face is lost, none comes to lie on another one. Ends of edges may lie farther apart
// than the edges do, which leaves short pieces between them: what makes these vanish, too, is better.
#include <BOPTools_AlgoTools3D.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <IntTools_Context.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "brep/connecting/workpiece_impl.h"
#include "brep/occt_impl.h"
#include "brep/surfaces/evaluators_impl.h"

namespace paver {
namespace {

// Files whose parts fit do so within 1e-8 of the diagonal; two sheets 5e-6 of it apart are drawn so.
constexpr double fitting_share = 1e-7;
// No gap is larger, of the diagonal.
constexpr double gap_share = 3e-3;
// Never so much that an edge collapses, unless it is a sliver anyhow.
constexpr double edge_share = 0.25;
constexpr double sliver_share = 1e-6;  // of the diagonal
// Corners are farther apart than edges are.
constexpr double corner_factor = 1.6;
// Edges below this many tolerances may be what is left between two ends.
constexpr double short_factor = 6;
// An open group counts as sewn when no more than this share of its free edges is left.
constexpr double open_share = 1.0 / 3;

long free_count(const EdgeUses& uses) {
  long count = 0;
  for (int i = 1; i <= uses.edges.Extent(); ++i) count += uses.is_free(i);
  return count;
}

bool has_free_edge(const TopoDS_Face& face, const EdgeUses& uses) {
  for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next()) {
    int index = uses.edges.FindIndex(edges.Current());
    if (index > 0 && uses.is_free(index)) return true;
  }
  return false;
}

/// Indices of faces to sew, per solid (-1: faces without one); only groups that have a free edge.
std::map<int, std::vector<int>> groups_to_sew(const Workpiece& work, const EdgeUses& uses) {
  std::map<int, std::vector<int>> groups;
  std::map<int, bool> is_open;
  for (std::size_t i = 0; i < work.faces.size(); ++i) {
    const WorkFace& face = work.faces[i];
    if (!face.is_usable()) continue;
    groups[face.solid].push_back(static_cast<int>(i));
    if (has_free_edge(face.face, uses)) is_open[face.solid] = true;
  }
  std::erase_if(groups, [&](const auto& group) { return !is_open[group.first]; });
  return groups;
}

/// A group after sewing.
struct Sewn {
  std::vector<TopoDS_Face> faces;                            ///< in the order of the group; null: lost
  std::vector<std::pair<TopoDS_Shape, TopoDS_Shape>> edges;  ///< edge and what took its place
  double tolerance = 0;
  EdgeUses uses;
  long free = 0;
  bool has_lost = false;
};

class GroupSewer {
 public:
  GroupSewer(const Workpiece& work, const std::vector<int>& group, Progress& progress)
      : work_(work), group_(group), progress_(progress) {
    std::vector<WorkFace> faces;
    for (int i : group) faces.push_back(work.faces[static_cast<std::size_t>(i)]);
    uses_ = count_uses(faces);
    free_ = free_count(uses_);
    most_ = gap_share * work.diagonal;
    for (int i = 1; i <= uses_.edges.Extent(); ++i) {
      double length = edge_length(TopoDS::Edge(uses_.edges(i)));
      if (length > sliver_share * work.diagonal) most_ = std::min(most_, edge_share * length);
    }
  }

  /// Sewn at this tolerance, whatever comes of it.
  Sewn sew_at(double tolerance) {
    Sewn sewn;
    sewn.tolerance = tolerance;
    BRepBuilderAPI_Sewing sewing(tolerance);
    for (int i : group_) sewing.Add(work_.faces[static_cast<std::size_t>(i)].face);
    Handle(OcctProgress) indicator = new OcctProgress(progress_, 0);
    sewing.Perform(indicator->Start());
    progress_.check();
    std::vector<WorkFace> after;
    for (int i : group_) {
      const TopoDS_Face& face = work_.faces[static_cast<std::size_t>(i)].face;
      TopoDS_Shape image = sewing.IsModified(face) ? sewing.Modified(face) : TopoDS_Shape(face);
      bool is_face = !image.IsNull() && image.ShapeType() == TopAbs_FACE;
      sewn.has_lost |= !is_face;
      sewn.faces.push_back(is_face ? TopoDS::Face(image) : TopoDS_Face());
      if (is_face) after.emplace_back().face = sewn.faces.back();
    }
    for (int i = 1; i <= uses_.edges.Extent(); ++i) {
      TopoDS_Shape image = sewing.ModifiedSubShape(uses_.edges(i));
      if (!image.IsNull() && !image.IsSame(uses_.edges(i))) sewn.edges.push_back({uses_.edges(i), image});
    }
    sewn.uses = count_uses(after);
    sewn.free = free_count(sewn.uses);
    return sewn;
  }

  /// Sewn at the tolerance that fits.
  Sewn sew_well() {
    Sewn best = sew_at(std::min(fitting_share * work_.diagonal, most_));
    if (best.free == 0) return best;
    std::vector<double> gaps = gaps_between(best.uses);
    std::sort(gaps.begin(), gaps.end());
    const std::size_t enough = gaps.size() - static_cast<std::size_t>(open_share * static_cast<double>(gaps.size()));
    for (double gap : {gaps.back(), gaps[enough - 1]}) {
      double tolerance = corner_factor * gap;
      if (!(tolerance <= most_) || tolerance <= best.tolerance) continue;
      Sewn wider = sew_at(tolerance);
      bool is_sewn = wider.free == 0 || static_cast<double>(wider.free) <= open_share * static_cast<double>(best.free);
      if (is_sewn && !wider.has_lost && !collapses(wider)) return without_short_pieces(std::move(wider));
    }
    return best;
  }

  long free_before() const { return free_; }

 private:
  struct Polyline {
    std::shared_ptr<const Curve> curve;
    std::vector<double> t;
    std::vector<Vec3> points;
    Bnd_Box box;
  };

  static Polyline polyline(const TopoDS_Edge& edge) {
    constexpr int pieces = 32;
    Polyline line;
    line.curve = make_curve(edge);
    double t0 = 0, t1 = 0;
    BRep_Tool::Range(edge, t0, t1);
    for (int i = 0; line.curve && i <= pieces; ++i) {
      line.t.push_back(t0 + (t1 - t0) * i / pieces);
      line.points.push_back(line.curve->point(line.t.back()));
      line.box.Add(to_point(line.points.back()));
    }
    return line;
  }

  /// To the curve near piece k: chords cut corners by more than gaps are wide.
  static double refined(const Polyline& line, std::size_t k, Vec3 x) {
    constexpr int steps = 4;
    const double low = line.t[std::max<std::size_t>(k, 2) - 2], high = line.t[std::min(k + 1, line.t.size() - 1)];
    double t = 0.5 * (line.t[k - 1] + line.t[k]), least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= steps; ++i) {
      Vec3 y, yt;
      line.curve->d1(t, y, yt);
      least = std::min(least, norm(x - y));
      if (!(dot(yt, yt) > 0)) break;
      t = std::clamp(t + dot(x - y, yt) / dot(yt, yt), low, high);
    }
    return least;
  }

  Sewn without_short_pieces(Sewn sewn) {
    double longest = 0;
    for (int i = 1; i <= sewn.uses.edges.Extent(); ++i) {
      const double length = edge_length(TopoDS::Edge(sewn.uses.edges(i)));
      if (length < short_factor * sewn.tolerance) longest = std::max(longest, length);
    }
    const double tolerance = corner_factor * longest;
    if (!(tolerance > sewn.tolerance && tolerance <= most_)) return sewn;
    Sewn wider = sew_at(tolerance);
    const bool has_fewer = wider.free <= sewn.free && wider.uses.edges.Extent() < sewn.uses.edges.Extent();
    return has_fewer && !wider.has_lost && !collapses(wider) ? wider : sewn;
  }

  static double distance(Vec3 x, Vec3 a, Vec3 b) {
    Vec3 side = b - a;
    double square = dot(side, side);
    double share = square > 0 ? std::clamp(dot(x - a, side) / square, 0.0, 1.0) : 0;
    return norm(x - (a + share * side));
  }

  /// Per free edge, how far it is from other free edges all along; infinite where that is no gap.
  std::vector<double> gaps_between(const EdgeUses& uses) const {
    std::vector<Polyline> lines;
    for (int i = 1; i <= uses.edges.Extent(); ++i)
      if (uses.is_free(i)) lines.push_back(polyline(TopoDS::Edge(uses.edges(i))));
    for (Polyline& line : lines) line.box.Enlarge(most_);
    std::vector<double> gaps;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      double gap = 0;
      for (std::size_t k = 1; k < lines[i].points.size(); k += 6)
        gap = std::max(gap, nearest(lines, i, lines[i].points[k], gap));
      gaps.push_back(gap);
    }
    return gaps;
  }

  /// To other lines than line `own`; what comes below `enough` need not be exact.
  static double nearest(const std::vector<Polyline>& lines, std::size_t own, Vec3 x, double enough) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < lines.size(); ++j) {
      if (j == own || lines[j].box.IsOut(to_point(x))) continue;
      const std::vector<Vec3>& points = lines[j].points;
      std::size_t nearest = 0;
      double chord = std::numeric_limits<double>::infinity();
      for (std::size_t k = 1; k < points.size(); ++k) {
        const double now = distance(x, points[k - 1], points[k]);
        if (now < chord) chord = now, nearest = k;
      }
      if (nearest > 0) least = std::min(least, refined(lines[j], nearest, x));
      if (least <= enough) break;
    }
    return least;
  }

  /// Whether a face lies on another one, as near as what was sewn: two sheets that face each other are no body.
  bool collapses(const Sewn& sewn) const {
    std::vector<Bnd_Box> boxes;
    for (const TopoDS_Face& face : sewn.faces) {
      BRepBndLib::Add(face, boxes.emplace_back(), Standard_False);
      boxes.back().Enlarge(2 * sewn.tolerance);
    }
    Handle(IntTools_Context) context = new IntTools_Context;
    for (std::size_t i = 0; i < sewn.faces.size(); ++i) {
      gp_Pnt point;
      gp_Pnt2d uv;
      if (BOPTools_AlgoTools3D::PointInFace(sewn.faces[i], point, uv, context) != 0) continue;
      for (std::size_t j = 0; j < sewn.faces.size(); ++j) {
        if (j == i || boxes[j].IsOut(point)) continue;
        BRepExtrema_DistShapeShape extrema(BRepBuilderAPI_MakeVertex(point).Vertex(), sewn.faces[j]);
        if (extrema.IsDone() && extrema.NbSolution() > 0 && extrema.Value() <= 2 * sewn.tolerance) return true;
      }
    }
    return false;
  }

  const Workpiece& work_;
  const std::vector<int>& group_;
  Progress& progress_;
  EdgeUses uses_;
  long free_ = 0;
  double most_ = 0;  ///< tolerance
};

void put(Workpiece& work, const std::vector<int>& group, const Sewn& sewn, SewResult& result) {
  for (const auto& [edge, image] : sewn.edges) add_edge_origins(work, image, edge_origins(work, edge));
  for (std::size_t k = 0; k < group.size(); ++k) {
    WorkFace& face = work.faces[static_cast<std::size_t>(group[k])];
    if (!sewn.faces[k].IsNull()) {
      face.face = sewn.faces[k];
      continue;
    }
    face.has_area = false;
    result.lost_faces.push_back(group[k]);
  }
  result.tolerance = std::max(result.tolerance, sewn.tolerance);
}

}  // namespace

SewResult sew(Workpiece& work, std::optional<double> tolerance, Progress& progress) {
  SewResult result;
  const EdgeUses uses = count_uses(work.faces);
  result.free_before = result.free_after = free_count(uses);
  long units = sew_units * static_cast<long>(work.faces.size());
  if (result.free_before > 0 && tolerance != 0) {
    const std::map<int, std::vector<int>> groups = groups_to_sew(work, uses);
    copy_shape(work);
    for (const auto& [solid, group] : groups) {
      GroupSewer sewer(work, group, progress);
      Sewn sewn = tolerance ? sewer.sew_at(*tolerance) : sewer.sew_well();
      if (sewn.free < sewer.free_before()) put(work, group, sewn, result);
    }
    result.free_after = free_count(count_uses(work.faces));
    work.is_rebuilt |= result.tolerance > 0;
  }
  progress.advance(units);
  return result;
}

}  // namespace paver
