// Sewing: edges of one face only that coincide with such an edge of another face become one common edge.
// Solids are sewn each by itself, then compounds of faces that this closes, as IGES has bodies, then all other faces
// together. Faces without a free edge keep their edges as they
// are, so sharing in the input is never undone. Faces keep their order and number.
//
// The tolerance is chosen by what it closes. First what fits as drawn is sewn. Where free edges stay that have other
// free edges along them, the gap between these is tried, on what was sewn before; it counts when it closes the group,
// the borders that run along others all round (a crack, as drawn faces that hang together elsewhere), or most of what
// was open, and when nothing collapses: no face is lost, none comes to lie on another one. Nor where both sides lie on
// one surface: such slots are drawn, as that of a ring antenna or between the arms of a dipole. Ends of edges may lie
// farther apart than the edges do, which leaves short pieces between them: what makes these vanish, too, is better.
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <Bnd_Box.hxx>
#include <ElSLib.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "brep/connecting/workpiece_impl.h"
#include "brep/occt_impl.h"
#include "brep/occt_shapes_impl.h"
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
constexpr int foot_steps = 4;
// What is wider between two faces on one surface is a slot, of the diagonal: rounding leaves less.
constexpr double slot_share = 5e-5;
// Edges that leave a vertex are two sides of a crack where they are no farther apart than this share of their length.
constexpr double wedge_share = 3e-3;

long free_count(const EdgeUses& uses) { return static_cast<long>(uses.free_edges().size()); }

bool has_free_edge(const TopoDS_Face& face, const EdgeUses& uses) {
  return std::ranges::any_of(edges_of(face), [&](const TopoDS_Edge& edge) { return uses.is_free(edge); });
}

/// The kernel takes a closed edge whose first span is tiny for a point.
bool has_border(const TopoDS_Face& face) {
  return std::ranges::any_of(edges_of(face), [](const TopoDS_Edge& edge) { return !BRep_Tool::Degenerated(edge); });
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
      : work_(work), progress_(progress) {
    std::vector<WorkFace> faces;
    for (int i : group) faces.push_back(work.faces[i]);
    as_drawn_.uses = count_uses(faces);
    as_drawn_.free = free_count(as_drawn_.uses);
    for (const WorkFace& face : faces) as_drawn_.faces.push_back(face.face);
  }

  /// At this tolerance, whatever comes of it; without one at that which fits.
  Sewn sew(std::optional<double> tolerance) const { return tolerance ? sew_at(*tolerance, as_drawn_) : sew_well(); }

  long free_before() const { return as_drawn_.free; }

  /// Whether two of the edges that are free by `uses` lie on one another.
  bool meets_itself(const EdgeUses& uses) const {
    std::vector<TopoDS_Edge> edges = as_drawn_.uses.free_edges();
    std::erase_if(edges, [&](const TopoDS_Edge& edge) { return !uses.is_free(edge); });
    const double near = fitting_share * work_.diagonal;
    const std::vector<Polyline> lines = polylines(edges, near);
    auto lies_along = [&](const Polyline& one, const Polyline& other) { return distance_along(one, other) <= near; };
    for (std::size_t i = 0; i < lines.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (!lines[i].box.IsOut(lines[j].box) && lies_along(lines[i], lines[j]) && lies_along(lines[j], lines[i]))
          return true;
    return false;
  }

 private:
  /// What a tolerance is to close.
  struct Gap {
    double width = 0;
    double edges = 0;  ///< how many are free at it
  };

  struct Polyline : SampledCurve {
    Bnd_Box box;
  };

  Sewn sew_well() const {
    const double most = most_tolerance(as_drawn_.uses);
    const Sewn fitting = sew_at(std::min(fitting_share * work_.diagonal, most), as_drawn_);
    if (fitting.free == 0) return fitting;
    const double most_left = most_tolerance(fitting.uses);
    for (const Gap& gap : gaps_to_close(fitting, std::max(most, most_left))) {
      const double tolerance = corner_factor * gap.width;
      const bool is_anew = tolerance <= most;  // what fits in part leaves short pieces
      if (!(is_anew || tolerance <= most_left) || tolerance <= fitting.tolerance) continue;
      const Sewn& before = is_anew ? as_drawn_ : fitting;
      Sewn wider = sew_at(tolerance, before);
      const double left = static_cast<double>(wider.free - fitting.free) + gap.edges;
      if (left <= open_share * gap.edges && !wider.has_lost && !collapses(wider, before))
        return without_short_pieces(std::move(wider), before, is_anew ? most : most_left);
    }
    return fitting;
  }

  /// At which no free edge collapses, and none that has an end of one; all others stay as they are.
  double most_tolerance(const EdgeUses& uses) const {
    TopTools_IndexedMapOfShape ends;
    for (const TopoDS_Edge& edge : uses.free_edges()) TopExp::MapShapes(edge, TopAbs_VERTEX, ends);
    double most = gap_share * work_.diagonal;
    for (int i = 1; i <= uses.count.Extent(); ++i) {
      const TopoDS_Edge& edge = TopoDS::Edge(uses.count.FindKey(i));
      if (!ends.Contains(TopExp::FirstVertex(edge)) && !ends.Contains(TopExp::LastVertex(edge))) continue;
      double length = edge_length(edge);
      if (length > sliver_share * work_.diagonal) most = std::min(most, edge_share * length);
    }
    return most;
  }

  /// Where the kernel fails to cut edges at the ends of others it sews whole ones only, or nothing: edges may lack
  /// ends.
  Sewn sew_at(double tolerance, const Sewn& before) const {
    for (bool cuts_edges : {true, false}) {
      try {
        return sew_at(tolerance, before, cuts_edges);
      } catch (const Standard_Failure&) {
        continue;
      }
    }
    return before;
  }

  Sewn sew_at(double tolerance, const Sewn& before, bool cuts_edges) const {
    Sewn sewn;
    sewn.tolerance = tolerance;
    BRepBuilderAPI_Sewing sewing(tolerance, true, true, cuts_edges);
    for (const TopoDS_Face& face : before.faces)
      if (!face.IsNull()) sewing.Add(face);
    Handle(OcctProgress) indicator = new OcctProgress(progress_, 0);
    sewing.Perform(indicator->Start());
    progress_.check();
    std::vector<WorkFace> after;
    for (const TopoDS_Face& face : before.faces) {
      TopoDS_Shape image = !face.IsNull() && sewing.IsModified(face) ? sewing.Modified(face) : TopoDS_Shape(face);
      bool is_face = !image.IsNull() && image.ShapeType() == TopAbs_FACE;
      if (is_face && has_border(face) && !has_border(TopoDS::Face(image))) image = face;
      sewn.has_lost |= !is_face;
      sewn.faces.push_back(is_face ? TopoDS::Face(image) : TopoDS_Face());
      if (is_face) after.emplace_back().face = sewn.faces.back();
    }
    sewn.edges = before.edges;
    for (int i = 1; i <= before.uses.count.Extent(); ++i) {
      const TopoDS_Shape& edge = before.uses.count.FindKey(i);
      const TopoDS_Shape image = sewing.ModifiedSubShape(edge);
      if (!image.IsNull() && !image.IsSame(edge)) sewn.edges.push_back({edge, image});
    }
    sewn.uses = count_uses(after);
    sewn.free = free_count(sewn.uses);
    return sewn;
  }

  static Polyline polyline(const TopoDS_Edge& edge) {
    constexpr int pieces = 32;
    const auto [t0, t1] = range_of(edge);
    Polyline line;
    if (auto curve = make_curve(edge)) line = {sampled(curve, t0, t1, pieces), {}};
    for (Vec3 x : line.points) line.box.Add(to_point(x));
    return line;
  }

  /// Their boxes reach so much farther.
  static std::vector<Polyline> polylines(const std::vector<TopoDS_Edge>& edges, double reach) {
    std::vector<Polyline> lines;
    for (const TopoDS_Edge& edge : edges) {
      lines.push_back(polyline(edge));
      lines.back().box.Enlarge(reach);
    }
    return lines;
  }

  Sewn without_short_pieces(Sewn sewn, const Sewn& before, double most) const {
    double longest = 0;
    for (int i = 1; i <= sewn.uses.count.Extent(); ++i) {
      const double length = edge_length(TopoDS::Edge(sewn.uses.count.FindKey(i)));
      if (length < short_factor * sewn.tolerance) longest = std::max(longest, length);
    }
    const double tolerance = corner_factor * longest;
    if (!(tolerance > sewn.tolerance && tolerance <= most)) return sewn;
    Sewn wider = sew_at(tolerance, before);
    const bool has_fewer = wider.free <= sewn.free && wider.uses.count.Extent() < sewn.uses.count.Extent();
    return has_fewer && !wider.has_lost && !collapses(wider, before) ? wider : sewn;
  }

  /// The widest that are worth a try: of all free edges, of borders along which there is something all round, of edges
  /// that leave a vertex along each other, and of most free edges.
  std::vector<Gap> gaps_to_close(const Sewn& sewn, double most) const {
    const std::vector<TopoDS_Edge> edges = sewn.uses.free_edges();
    const std::vector<Polyline> lines = polylines(edges, most);
    std::vector<double> widths = gaps_between(lines);
    leave_slots(sewn.faces, edges, lines, widths);
    Gap cracks;
    for (const std::vector<std::size_t>& border : borders(edges)) {
      double width = 0;
      for (std::size_t i : border) width = std::max(width, widths[i]);
      if (width > most) continue;
      cracks.width = std::max(cracks.width, width);
      cracks.edges += static_cast<double>(border.size());
    }
    std::sort(widths.begin(), widths.end());
    const auto all = static_cast<double>(edges.size());
    const std::size_t enough = edges.size() - static_cast<std::size_t>(open_share * all);
    return {{widths.back(), all}, cracks, wedges(sewn.faces, edges, most), {widths[enough - 1], all}};
  }

  using FaceOfEdge = NCollection_IndexedDataMap<TopoDS_Shape, int, TopTools_ShapeMapHasher>;

  /// By their places in the list.
  static FaceOfEdge faces_of_edges(const std::vector<TopoDS_Face>& faces) {
    FaceOfEdge face_of;
    for (std::size_t f = 0; f < faces.size(); ++f)
      if (!faces[f].IsNull())
        for (const TopoDS_Edge& edge : edges_of(faces[f])) face_of.Add(edge, static_cast<int>(f));
    return face_of;
  }

  /// What lies on one surface with what is along it is no gap.
  void leave_slots(const std::vector<TopoDS_Face>& faces, const std::vector<TopoDS_Edge>& edges,
                   const std::vector<Polyline>& lines, std::vector<double>& widths) const {
    const FaceOfEdge face_of = faces_of_edges(faces);
    const double fitting = fitting_share * work_.diagonal;
    auto face = [&](std::size_t i) { return faces[face_of.FindFromKey(edges[i])]; };
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (!std::isfinite(widths[i]) || widths[i] < slot_share * work_.diagonal) continue;
      const Vec3 middle = lines[i].points[lines[i].points.size() / 2];
      for (std::size_t j = 0; j < lines.size() && std::isfinite(widths[i]); ++j)
        if (j != i && !lines[j].box.IsOut(to_point(middle)) && lines[j].curve &&
            distance_to(lines[j], foot_steps, middle) <= widths[i] + fitting && lies_on(lines[i], face(j), fitting) &&
            lies_on(lines[j], face(i), fitting))
          widths[i] = std::numeric_limits<double>::infinity();
    }
  }

  /// Whether a line lies on the surface of a face, which is a plane, a cylinder, a cone, a ball or a torus.
  static bool lies_on(const Polyline& line, const TopoDS_Face& face, double near) {
    const BRepAdaptor_Surface surface(face, Standard_False);
    auto distance = [&](const gp_Pnt& x) {
      auto to = [&](const auto& elementary) {
        double u = 0, v = 0;
        ElSLib::Parameters(elementary, x, u, v);
        return x.Distance(ElSLib::Value(u, v, elementary));
      };
      switch (surface.GetType()) {
        case GeomAbs_Plane:
          return to(surface.Plane());
        case GeomAbs_Cylinder:
          return to(surface.Cylinder());
        case GeomAbs_Cone:
          return to(surface.Cone());
        case GeomAbs_Sphere:
          return to(surface.Sphere());
        case GeomAbs_Torus:
          return to(surface.Torus());
        default:
          return std::numeric_limits<double>::infinity();
      }
    };
    for (std::size_t k = 0; k < line.points.size(); k += 4)
      if (!(distance(to_point(line.points[k])) <= near)) return false;
    return true;
  }

  /// Of edges of two faces.
  static Gap wedges(const std::vector<TopoDS_Face>& faces, const std::vector<TopoDS_Edge>& edges, double most) {
    struct Side {
      int face = -1;
      TopoDS_Edge edge;
    };
    const FaceOfEdge face_of = faces_of_edges(faces);
    NCollection_IndexedDataMap<TopoDS_Shape, std::vector<Side>, TopTools_ShapeMapHasher> leaving;
    for (const TopoDS_Edge& edge : edges)
      for (const TopoDS_Vertex& end : {TopExp::FirstVertex(edge), TopExp::LastVertex(edge)})
        leaving(leaving.Add(end, {})).push_back({face_of.FindFromKey(edge), edge});
    Gap gap;
    for (int v = 1; v <= leaving.Extent(); ++v)
      for (const Side& one : leaving(v))
        for (const Side& other : leaving(v)) {
          if (one.face >= other.face) continue;
          const Polyline a = polyline(one.edge), b = polyline(other.edge);
          const double width = std::max(distance_along(a, b), distance_along(b, a));
          if (width > std::min(most, wedge_share * length_of(a))) continue;
          gap.width = std::max(gap.width, width);
          gap.edges += 2;
        }
    return gap;
  }

  static double distance_along(const Polyline& line, const Polyline& other) {
    double distance = 0;
    for (std::size_t k = 1; k < line.points.size(); k += 6)
      distance = std::max(distance, other.curve ? distance_to(other, foot_steps, line.points[k]) : INFINITY);
    return distance;
  }

  /// Edges that hang together.
  static std::vector<std::vector<std::size_t>> borders(const std::vector<TopoDS_Edge>& edges) {
    Hanging together(edges.size(), TopAbs_VERTEX);
    for (std::size_t i = 0; i < edges.size(); ++i) together.add(i, edges[i]);
    std::map<int, std::vector<std::size_t>> found;
    for (std::size_t i = 0; i < edges.size(); ++i) found[together.group_of(i)].push_back(i);
    std::vector<std::vector<std::size_t>> all;
    for (auto& [set, border] : found) all.push_back(std::move(border));
    return all;
  }

  /// Per free edge, how far it is from other free edges all along; infinite where that is no gap.
  static std::vector<double> gaps_between(const std::vector<Polyline>& lines) {
    std::vector<double> gaps;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      double gap = 0;
      for (std::size_t k = 1; k < lines[i].points.size() && std::isfinite(gap); k += 6)
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
      // To the curve: chords cut corners by more than gaps are wide.
      if (lines[j].curve) least = std::min(least, distance_to(lines[j], foot_steps, x));
      if (least <= enough) break;
    }
    return least;
  }

  /// Whether a face that had free edges lies on another one, as near as what was sewn: two sheets that face each other
  /// are no body.
  bool collapses(const Sewn& sewn, const Sewn& before) const {
    std::vector<Bnd_Box> boxes;
    for (const TopoDS_Face& face : sewn.faces) {
      BRepBndLib::Add(face, boxes.emplace_back(), Standard_False);
      boxes.back().Enlarge(2 * sewn.tolerance);
    }
    Handle(IntTools_Context) context = new IntTools_Context;
    for (std::size_t i = 0; i < sewn.faces.size(); ++i) {
      if (!has_free_edge(before.faces[i], before.uses)) continue;
      const auto point = point_inside(sewn.faces[i], context);
      for (std::size_t j = 0; point && j < sewn.faces.size(); ++j)
        if (j != i && !boxes[j].IsOut(*point) && is_near(*point, sewn.faces[j], 2 * sewn.tolerance)) return true;
    }
    return false;
  }

  const Workpiece& work_;
  Progress& progress_;
  Sewn as_drawn_;
};

void put(Workpiece& work, const std::vector<int>& group, const Sewn& sewn, SewResult& result) {
  for (const auto& [edge, image] : sewn.edges) add_edge_origins(work, image, edge);
  for (std::size_t k = 0; k < group.size(); ++k) {
    WorkFace& face = work.faces[group[k]];
    if (!sewn.faces[k].IsNull()) {
      face.face = sewn.faces[k];
      continue;
    }
    face.has_area = false;
    result.lost_faces.push_back(group[k]);
  }
  result.tolerance = std::max(result.tolerance, sewn.tolerance);
}

/// Makes one edge of two by which a face without a solid meets itself, as IGES has periodic edges: sewn together with
/// all others, where bodies touch those of different faces were joined.
void close_faces(Workpiece& work, std::optional<double> most, Progress& progress, SewResult& result) {
  const EdgeUses uses = count_uses(work.faces);
  const double fitting = fitting_share * work.diagonal, tolerance = std::min(most.value_or(fitting), fitting);
  for (std::size_t f = 0; f < work.faces.size(); ++f) {
    if (!work.faces[f].is_usable() || work.faces[f].solid >= 0) continue;
    const GroupSewer sewer(work, {static_cast<int>(f)}, progress);
    if (!sewer.meets_itself(uses)) continue;
    const Sewn sewn = sewer.sew(tolerance);
    if (sewn.free < sewer.free_before() && !sewn.has_lost) put(work, {static_cast<int>(f)}, sewn, result);
  }
}

/// Sews compounds of faces without a solid from the inside out.
class BodySewer {
 public:
  BodySewer(Workpiece& work, std::optional<double> tolerance, Progress& progress, SewResult& result)
      : work_(work),
        tolerance_(tolerance),
        progress_(progress),
        result_(result),
        indices_(shapes_of(work.shape, TopAbs_FACE)) {}

  /// The faces without a solid that are in no compound which is closed, or is when sewn.
  std::vector<int> run() { return open_faces(work_.shape, true); }

 private:
  std::vector<int> open_faces(const TopoDS_Shape& shape, bool is_outermost) {
    std::vector<int> open;
    for (TopoDS_Iterator child(shape); child.More(); child.Next()) {
      if (child.Value().ShapeType() == TopAbs_COMPOUND) {
        const bool is_only = is_outermost && shape.NbChildren() == 1;
        const std::vector<int> inner = open_faces(child.Value(), is_only);
        open.insert(open.end(), inner.begin(), inner.end());
      } else {
        for (TopExp_Explorer face(child.Value(), TopAbs_FACE); face.More(); face.Next()) {
          const int index = indices_.FindIndex(face.Current()) - 1;
          if (work_.faces[index].solid < 0 && work_.faces[index].is_usable()) open.push_back(index);
        }
      }
    }
    std::ranges::sort(open);
    open.erase(std::unique(open.begin(), open.end()), open.end());
    if (!is_outermost && shape.NbChildren() > 1 && open.size() > 1 && is_closed(open)) open.clear();
    return open;
  }

  /// Whether these faces are closed, or now are. Not those on which another body's face lay: that body is open without
  /// it, and sewn to these.
  bool is_closed(const std::vector<int>& faces) {
    auto lies_beneath = [&](const std::array<int, 2>& pair) { return std::ranges::binary_search(faces, pair[1]); };
    if (std::ranges::any_of(work_.doubles, lies_beneath)) return false;
    const GroupSewer sewer(work_, faces, progress_);
    if (sewer.free_before() == 0) return true;
    const Sewn sewn = sewer.sew(tolerance_);
    if (sewn.free > 0 || sewn.has_lost) return false;
    put(work_, faces, sewn, result_);
    return true;
  }

  Workpiece& work_;
  const std::optional<double> tolerance_;
  Progress& progress_;
  SewResult& result_;
  const TopTools_IndexedMapOfShape indices_;
};

}  // namespace

SewResult sew(Workpiece& work, std::optional<double> tolerance, Progress& progress) {
  SewResult result;
  result.free_before = result.free_after = free_count(count_uses(work.faces));
  long units = sew_units * static_cast<long>(work.faces.size());
  if (result.free_before > 0 && tolerance != 0) {
    copy_shape(work);
    close_faces(work, tolerance, progress, result);
    std::map<int, std::vector<int>> groups = groups_to_sew(work, count_uses(work.faces));
    if (const auto loose = groups.find(-1); loose != groups.end())
      loose->second = BodySewer(work, tolerance, progress, result).run();
    for (const auto& [solid, group] : groups) {
      const GroupSewer sewer(work, group, progress);
      const Sewn sewn = sewer.sew(tolerance);
      if (sewn.free < sewer.free_before()) put(work, group, sewn, result);
    }
    result.free_after = free_count(count_uses(work.faces));
    work.is_rebuilt |= result.tolerance > 0;
  }
  progress.advance(units);
  return result;
}

}  // namespace paver
