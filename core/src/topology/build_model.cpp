// Shape to Model, in order: measure, repair, drop doubles, mend, fault lost areas, sew, connect, divide along creases,
// number edges and vertices, chain loops, orient faces, report. A face that cannot be used is data: it keeps its place
// and name, with has_area = false or a fault.
#include "topology/build_model.h"

#include <fmt/format.h>

#include <ShapeAnalysis_Surface.hxx>
#include <TopoDS_Iterator.hxx>
#include <algorithm>
#include <map>
#include <numbers>
#include <set>

#include "base/box.h"
#include "brep/connecting/connect_impl.h"
#include "brep/connecting/workpiece_impl.h"
#include "brep/mending/mend_impl.h"
#include "brep/occt_impl.h"
#include "brep/occt_shapes_impl.h"
#include "brep/recognising/recognise_impl.h"
#include "brep/surfaces/evaluators_impl.h"
#include "topology/build_parts_impl.h"

namespace paver {
namespace {

constexpr long loop_units = 2;
constexpr std::size_t most_names = 1000;
/// Images are improved where they are farther from their curves than this share of the diagonal
constexpr double exact_share = 1e-8;
/// and than this multiple of the edge's tolerance (others measured it at other points),
constexpr double claimed_share = 1.5;
/// of which no more than this share of the diagonal is believed.
constexpr double coarse_share = 1e-5;
/// They are noted where they still are farther than this.
constexpr double noted_share = 1e-6;
/// A multiple of 4: images fitted by polynomials are worst at kinks, which sit at quarters and halves more than
/// elsewhere.
constexpr int deviation_samples = 64;
/// Gap between parts that is closed, of the diagonal: what rounding in files and in placements leaves, and no more.
constexpr double contact_share = 1e-7;
/// Of the diagonal: a narrower face is a sliver, whose sides are one.
constexpr double least_width = 1e-7;
/// Gap between images, over the face's extent in (u, v), that is worth a note.
constexpr double gap_share = 1e-3;

/// The smallest width that turns by a right angle and has elements as narrow as that takes, mm.
double unresolved_turn(const Options& options) {
  return target_length(options) / options.aspect * std::numbers::pi / 2 / options.turn_limit();
}

class ModelBuilder {
 public:
  ModelBuilder(const Shape& shape, ModelReport report, Progress& progress, SharedTasks& tasks)
      : shape_(shape), progress_(progress), tasks_(tasks) {
    model_.report = std::move(report);
  }

  Model build(const Options& options, std::string* brep) {
    const auto faces = shapes_of(shape_.shape, TopAbs_FACE);
    progress_.begin(Stage::topology,
                    (measure_units + repair_units + sew_units + connect_units + loop_units) * faces.Extent());
    work_ = make_workpiece(shape_, progress_, tasks_);
    repair(work_, progress_);
    drop_doubles(work_);
    open_lost_caps(work_);
    mend_faces(work_, progress_);
    fault_lost_areas(work_);
    recognise(work_);
    sewn_ = sew(work_, options.sew_tolerance, progress_);
    list_parts(work_, shape_.shape);
    name_parts(work_, shape_.labels);
    if (!brep)  // what is written has the faces as they were read
      for (const DividedFace& face : divide_creases(work_, unresolved_turn(options))) note_divided(face);
    // Far less than what is sewn: parts that lie so near have been put there.
    const double contact_tolerance = options.sew_tolerance.value_or(contact_share * work_.diagonal);
    connected_ = connect(work_, options.connect, contact_tolerance, progress_);
    progress_.advance(connect_units * faces.Extent());
    EdgeIndex index = build_edges(work_, model_);
    model_.read_edges = work_.read_edges.Extent();
    note_tolerances(index);
    for (std::size_t i = 0; i < work_.faces.size(); ++i) {
      add_face(static_cast<int>(i), index);
      bool is_last_piece = i + 1 == work_.faces.size() || work_.faces[i + 1].origin != work_.faces[i].origin;
      if (is_last_piece) progress_.advance(loop_units);
    }
    list_named(faces);
    fill_parts(index);
    mark_periodic_edges();
    add_periodic_points(model_);
    for (const std::string& face : orient_faces(work_, model_, tasks_))
      work_.note_repair(RepairKind::turned_face, 1, 0, face);
    fill_report();
    model_.report.holes = find_holes(index);
    add_notes();
    if (options.strict) refuse_faults();
    if (brep) *brep = repaired_brep(work_, model_.faces);
    return std::move(model_);
  }

 private:
  // What users may name besides faces and edges.
  void list_named(const TopTools_IndexedMapOfShape& faces) {
    const auto vertices = shapes_of(shape_.shape, TopAbs_VERTEX), solids = shapes_of(shape_.shape, TopAbs_SOLID);
    for (int i = 1; i <= vertices.Extent(); ++i)
      model_.read_vertices.push_back(to_vec(BRep_Tool::Pnt(TopoDS::Vertex(vertices(i)))));
    for (int i = 1; i <= solids.Extent(); ++i) {
      std::vector<int>& list = model_.solid_faces.emplace_back();
      for (TopExp_Explorer inner(solids(i), TopAbs_FACE); inner.More(); inner.Next())
        list.push_back(faces.FindIndex(inner.Current()) - 1);
    }
  }

  void note_divided(const DividedFace& face) {
    model_.notes.push_back(entry_name(work_, face.origin) + " was divided along " + std::to_string(face.creases) +
                           (face.creases == 1 ? " crease." : " creases."));
  }

  void note_tolerances(const EdgeIndex& index) {
    tolerances_.resize(model_.edges.size());
    for (int i = 1; i <= index.map.Extent(); ++i) {
      int edge = index.edge[i];
      if (edge >= 0) tolerances_[edge] = BRep_Tool::Tolerance(TopoDS::Edge(index.map(i)));
    }
  }

  /// Of a face as read, or of all that have it in common; empty where none of them has one.
  std::string label_of(int origin) const {
    if (shape_.labels.empty()) return "";
    std::string label;
    bool has_label = false;
    for (int face : work_.faces_as_read(origin)) {
      const std::string& own = shape_.labels[face];
      has_label = has_label || !own.empty();
      label += (label.empty() ? "" : " + ") + (own.empty() ? face_name(face) : own);
    }
    return has_label ? label : "";
  }

  void add_face(int i, const EdgeIndex& index) {
    const WorkFace& work = work_.faces[i];
    Face face;
    face.name = entry_name(work_, work.origin);
    face.origin = work.origin;
    face.is_common = work.is_common;
    face.is_dropped = work.is_dropped;
    face.label = label_of(work.origin);
    face.area = work.area;
    face.has_area = work.has_area;
    face.fault = work.fault;
    face.converted = work.converted;
    face.is_reversed = work.face.Orientation() == TopAbs_REVERSED;
    if (face.has_area) {
      note_uses(i, index);
      if (face.fault.empty()) fill_face(face, index, work.face);
    }
    model_.faces.push_back(std::move(face));
  }

  void note_uses(int i, const EdgeIndex& index) {
    for (const TopoDS_Edge& use : edges_of(work_.faces[i].face)) {
      int edge = index.find(use);
      if (edge < 0 || use.Orientation() == TopAbs_EXTERNAL) continue;
      std::vector<int>& users = model_.edges[edge].faces;
      bool is_inside = use.Orientation() == TopAbs_INTERNAL;
      users.insert(users.end(), is_inside ? 2 : 1, i);
    }
  }

  void fill_face(Face& face, const EdgeIndex& index, const TopoDS_Face& shape) {
    const TopoDS_Face plain = forward(shape);
    try {
      face.surface = make_surface(plain, closure_tolerance(plain));
      if (!face.surface) {
        face.fault = "it has no surface; export the model again";
        return;
      }
      LoopResult result = build_loops(plain, *face.surface, index, model_.edges);
      face.fault = result.fault;
      face.loops = std::move(result.loops);
      note_points(face, shape, index);
      if (result.skipped_edges > 0) inner_edges_.push_back(face.name);
      if (result.turned_loops > 0) turned_loops_.push_back(face.name);
      work_.note_repair(RepairKind::turned_loop, result.turned_loops, 0, face.name);
      if (result.largest_gap > gap_share) gaps_.push_back(face.name);
      if (face.fault.empty()) check_images(face, plain);
      if (face.fault.empty() && result.turned_loops > 0) measure(face, plain);
    } catch (const Error& error) {
      face.fault = error.what();
    } catch (const Standard_Failure& failure) {
      face.fault = "the CAD kernel cannot evaluate it (" + failure_text(failure) + "); repair it in the CAD program";
    }
    if (!face.fault.empty()) face.loops.clear();
  }

  /// In (u, v), of its loops.
  Vec2 middle_of(const Face& face) const {
    constexpr int steps = 4;
    Box box;
    for (const Coedge& coedge : coedges_of(face.loops))
      for (int i = 0; coedge.pcurve && i <= steps; ++i)
        box.add(coedge.pcurve->uv(edge_of(model_, coedge).parameter(i / double{steps})));
    return box.is_empty() ? Vec2{} : 0.5 * Vec2{box.low.x + box.high.x, box.low.y + box.high.y};
  }

  /// Points, and where wires end; in the period in which the face lies.
  void note_points(Face& face, const TopoDS_Face& shape, const EdgeIndex& index) const {
    const Vec2 middle = middle_of(face);
    for (TopoDS_Iterator parts(shape); parts.More(); parts.Next()) {
      if (parts.Value().ShapeType() != TopAbs_VERTEX) continue;
      const int vertex = index.find_vertex(parts.Value());
      if (vertex < 0) continue;
      auto is_same = [&](const InnerPoint& point) { return point.vertex == vertex; };
      // What several faces have in common has the vertex from each of them.
      if (std::ranges::any_of(face.points, is_same)) continue;
      TopLoc_Location location;
      Handle(Geom_Surface) surface = BRep_Tool::Surface(shape, location);
      gp_Pnt at = BRep_Tool::Pnt(TopoDS::Vertex(parts.Value())).Transformed(location.Transformation().Inverted());
      gp_Pnt2d uv = ShapeAnalysis_Surface(surface).ValueOfUV(at, Precision::Confusion());
      face.points.push_back({vertex, nearest_image({uv.X(), uv.Y()}, middle, face.surface->period())});
    }
  }

  /// Twice the tolerance of the face's own periodic edges: so far apart its ends may be and still be joined.
  static double closure_tolerance(const TopoDS_Face& face) {
    TopTools_IndexedMapOfShape seen;
    double tolerance = 0;
    for (const TopoDS_Edge& edge : edges_of(face)) {
      int before = seen.Extent();
      if (seen.Add(edge) <= before) tolerance = std::max(tolerance, 2 * BRep_Tool::Tolerance(edge));
    }
    return tolerance;
  }

  /// Distance of curve and image on the surface, over the edge.
  static double deviation(const Edge& edge, const ParameterCurve& image, const Surface& surface) {
    double worst = 0;
    for (int i = 0; i <= deviation_samples; ++i) {
      double t = edge.t0 + (edge.t1 - edge.t0) * i / deviation_samples;
      worst = std::max(worst, norm(edge.curve->point(t) - surface.point(image.uv(t))));
    }
    return worst;
  }

  /// What the file itself claims, as far as that is sensible.
  double allowed_deviation(int edge) const {
    double claimed = claimed_share * tolerances_[edge];
    return std::max(exact_share * work_.diagonal, std::min(claimed, coarse_share * work_.diagonal));
  }

  /// Images must be where their curves are: those that are not are replaced by projected ones where that helps.
  void check_images(Face& face, const TopoDS_Face& shape) {
    double moved = 0;
    for (Coedge& c : coedges_of(face.loops)) {
      const Edge& edge = edge_of(model_, c);
      if (edge.is_degenerate) continue;
      double worst = deviation(edge, *c.pcurve, *face.surface);
      if (worst > allowed_deviation(c.edge)) {
        auto projected = make_projected_image(shape, edge.curve, *c.pcurve, edge.t0, edge.t1);
        double better = projected ? deviation(edge, *projected, *face.surface) : worst;
        if (better < 0.5 * worst) {
          c.pcurve = projected;
          // Images of what connecting made are the kernel's, not the file's.
          if (connected_.contacts.empty()) work_.note_repair(RepairKind::image, 1, worst, face.name);
          moved = std::max(moved, worst);
          worst = better;
        }
      }
      fit_ends(c, edge, face, shape);
      if (worst <= std::max(noted_share * work_.diagonal, sewn_.tolerance)) continue;
      model_.report.curve_distance = std::max(model_.report.curve_distance, worst);
      model_.report.stray_edges.push_back(edge.name);
    }
    if (moved <= coarse_share * work_.diagonal) return;
    for (Loop& loop : face.loops) chain_images(loop, face.surface->period());
    // The area so far is that within the images it had.
    measure(face, shape);
  }

  /// Images that were looked for each by itself begin where the one before ends, not periods away.
  void chain_images(Loop& loop, Vec2 period) const {
    for (std::size_t i = 1; i < loop.coedges.size(); ++i) {
      const Coedge &before = loop.coedges[i - 1], &here = loop.coedges[i];
      const Vec2 gap = before.pcurve->uv(end_parameter(edge_of(model_, before), before)) -
                       here.pcurve->uv(start_parameter(edge_of(model_, here), here));
      const Vec2 shift = whole_periods(gap, period);
      if (shift.x != 0 || shift.y != 0) loop.coedges[i].pcurve = make_shifted_image(loop.coedges[i].pcurve, shift);
    }
  }

  /// Gives a face the area within its images, where they say so.
  void measure(Face& face, const TopoDS_Face& shape) const {
    std::vector<BorderImage> border;
    for (const Coedge& c : coedges_of(face.loops)) {
      const Edge& edge = edge_of(model_, c);
      border.push_back({c.pcurve, edge.t0, edge.t1, c.is_reversed});
    }
    const auto area = area_within(shape, *face.surface, border);
    if (area && *area > 0) face.area = *area;
  }

  /// Nodes at the ends of edges lie in the vertices: their images must lie there, too, or elements turn over that are
  /// sound in the chart.
  void fit_ends(Coedge& c, const Edge& edge, Face& face, const TopoDS_Face& shape) {
    const std::array<Vec3, 2> ends{model_.vertices[edge.start], model_.vertices[edge.end]};
    double off = 0;
    const double allowed = std::max(coarse_share * work_.diagonal, allowed_deviation(c.edge));
    auto fitted = make_image_with_ends(shape, c.pcurve, edge.t0, edge.t1, ends, allowed, off);
    if (!fitted) return;
    c.pcurve = fitted;
    face.gap_area += edge.length * off;
    if (connected_.contacts.empty()) work_.note_repair(RepairKind::image, 1, off, face.name);
  }

  void mark_periodic_edges() {
    for (std::size_t e = 0; e < model_.edges.size(); ++e) {
      Edge& edge = model_.edges[e];
      edge.is_periodic = !edge.is_degenerate && edge.faces.size() == 2 && edge.faces[0] == edge.faces[1] &&
                         !has_other_user(model_, static_cast<int>(e), edge.faces[0]);
    }
    for (const Face& face : model_.faces)
      for (const Coedge& c : coedges_of(face.loops))
        if (c.is_slit) model_.edges[c.edge].is_periodic = false;
  }

  void fill_parts(const EdgeIndex& index) {
    model_.read_faces = work_.read_faces;
    model_.common = work_.common;
    for (const WorkPart& part : work_.parts) {
      model_.parts.push_back(part.name);
      model_.part_solid.push_back(part.solid);
    }
    for (const WorkFace& face : work_.faces) {
      std::vector<int>& parts = model_.face_parts.emplace_back();
      for (const FaceUse& use : face.uses) parts.push_back(use.part);
    }
    model_.edge_part.assign(model_.edges.size(), -1);
    for (const WorkWire& wire : work_.wires) {
      int edge = index.find(wire.edge);
      if (edge < 0) continue;
      model_.edge_part[edge] = wire.part;
      model_.edges[edge].inside_of = wire.inside_of;
    }
    for (const WorkPoint& point : work_.points)
      model_.points.push_back({point.part, index.find_vertex(point.vertex), false, model_.parts[point.part]});
    model_.report.contacts = connected_.contacts;
    for (auto [a, b] : connected_.failed) model_.report.unconnected.push_back({model_.parts[a], model_.parts[b]});
    if (connected_.merged.parts.empty()) return;
    std::vector<std::string>& names = model_.report.merged_parts;
    for (int part : connected_.merged.parts) names.push_back(model_.parts[part]);
    model_.report.merged_gap = connected_.merged.gap;
    model_.notes.push_back(
        fmt::format("Faces of parts that touch are written differently, up to {:.2g} mm apart, and were "
                    "taken for one: {}.",
                    connected_.merged.gap, list_names(names)));
  }

  void fill_report() {
    ModelReport& report = model_.report;
    auto count = [&](TopAbs_ShapeEnum kind) { return static_cast<long>(shapes_of(shape_.shape, kind).Extent()); };
    report.solids = count(TopAbs_SOLID);
    report.shells = count(TopAbs_SHELL);
    report.faces = work_.read_faces;
    report.edges = static_cast<long>(model_.edges.size());
    report.vertices = static_cast<long>(model_.vertices.size());
    report.diagonal = work_.diagonal;
    report.area = 0;
    for (const Face& face : model_.faces) report.area += face.area;
    report.sew_tolerance = sewn_.tolerance;
    report.sewn_edges = sewn_.free_before - sewn_.free_after;
    work_.note_repair(RepairKind::sewn_edge, report.sewn_edges, sewn_.tolerance);
    report.repairs = work_.repairs;
    note_free_edges(model_);
  }

  /// Faces that were left out though they are no slivers, whose sides meet without them, and that are missed: a tip cut
  /// off, a nick.
  std::vector<std::string> find_holes(const EdgeIndex& index) const {
    std::vector<std::string> names;
    for (const WorkFace& face : work_.faces) {
      if (face.has_area || face.is_dropped || !face.fault.empty()) continue;
      double border = 0;
      bool is_missed = false;
      for (const TopoDS_Edge& shape : edges_of(face.face)) {
        border += edge_length(shape);
        const int e = index.find(shape);
        is_missed |= e >= 0 && model_.edges[e].faces.size() == 1 && !model_.edges[e].is_degenerate;
      }
      if (is_missed && 2 * face_area(face.face) > least_width * work_.diagonal * border)
        names.push_back(face_name(face.origin));
    }
    return names;
  }

  /// What is not as it should be, in one sentence; nothing of it is meshed.
  void refuse_faults() const {
    std::string faults;
    auto add = [&](const std::string& fault) { faults += (faults.empty() ? "" : ", ") + fault; };
    for (const Face& face : model_.faces)
      if (!face.fault.empty()) add(face.name + " (" + face.fault.substr(0, face.fault.find(';')) + ")");
    for (const Repair& repair : model_.report.repairs)
      add(std::to_string(repair.count) + " " + repair_name(repair.kind) +
          (repair.faces.empty() ? "" : " (" + list_names(repair.faces) + ")"));
    for (const auto& pair : model_.report.unconnected) add(pair[0] + " and " + pair[1] + " touch and stay apart");
    for (const std::string& part : model_.report.one_sided) add(part + " has no outside");
    if (faults.empty()) return;
    throw Error(ErrorCode::damaged_file,
                "'" + model_.report.file + "' is not clean, and strict is on: " + faults +
                    "; repair it in the CAD program, or mesh it without strict, which repairs what it can.",
                {"topology", -1, -1, {}});
  }

  void add_notes() {
    std::vector<std::string> flat, faulty, lost;
    for (const Face& face : model_.faces) {
      if (!face.has_area && !face.is_common && !face.is_dropped) flat.push_back(face.name);
      if (!face.fault.empty()) faulty.push_back(face.name);
    }
    for (int i : sewn_.lost_faces) lost.push_back(face_name(i));
    note("On no face and on no edge, so that they are no nodes", find_points_apart());
    if (work_.left_points > 0)
      model_.notes.push_back(std::to_string(work_.left_points) + " points were left out: more than " +
                             std::to_string(most_points) + " are not taken for parts.");
    std::vector<std::string> doubles;
    for (auto [dropped, kept] : work_.doubles) doubles.push_back(face_name(dropped) + " on " + face_name(kept));
    note("Left out because they lie on another face", doubles);
    note("Left out because they have no area", flat);
    note("Left out because they are smaller than the sewing tolerance", lost);
    note("Cannot be meshed (reasons in the report of faces)", faulty);
    note("Edges inside a face that end at a pole were ignored", inner_edges_);
    note("Loops that ran the wrong way around were turned", turned_loops_);
    note("Images of consecutive edges in the surface's parameters do not meet", gaps_);
    std::vector<std::string>& stray = model_.report.stray_edges;
    std::sort(stray.begin(), stray.end());
    stray.erase(std::unique(stray.begin(), stray.end()), stray.end());
    note("Curves lie up to " + std::to_string(model_.report.curve_distance) + " mm off their faces", stray);
  }

  /// Marks points that nothing of the model has, and gives their names.
  std::vector<std::string> find_points_apart() {
    std::vector<char> is_used(model_.vertices.size(), 0);
    for (const Edge& edge : model_.edges)
      if (!edge.faces.empty() || edge.is_wire())
        for (int vertex : {edge.start, edge.end}) is_used[vertex] = 1;
    for (const Face& face : model_.faces)
      for (const InnerPoint& point : face.points) is_used[point.vertex] = 1;
    std::vector<std::string> names;
    for (PartPoint& point : model_.points) {
      point.is_apart = !is_used[point.vertex];
      if (point.is_apart) names.push_back(point.name);
    }
    return names;
  }

  void note(const std::string& text, const std::vector<std::string>& names) {
    if (!names.empty()) model_.notes.push_back(text + ": " + list_names(names) + ".");
  }

  const Shape& shape_;
  Progress& progress_;
  SharedTasks& tasks_;
  Workpiece work_;
  SewResult sewn_;
  ConnectResult connected_;
  Model model_;
  std::vector<std::string> inner_edges_, turned_loops_, gaps_;
  std::vector<double> tolerances_;  ///< per edge of the model
};

}  // namespace

void note_free_edges(Model& model) {
  ModelReport& report = model.report;
  report.free_edges = report.nonmanifold_edges = 0;
  report.free_edge_names.clear();
  report.nonmanifold_edge_names.clear();
  std::set<int> open_parts;
  for (const Edge& edge : model.edges) {
    if (edge.faces.size() == 1 && !edge.is_degenerate) {
      ++report.free_edges;
      if (report.free_edge_names.size() < most_names) report.free_edge_names.push_back(edge.name);
      for (const int part : model.face_parts[edge.faces.front()])
        if (model.part_solid[part] >= 0) open_parts.insert(part);
    } else if (edge.faces.size() > 2) {
      ++report.nonmanifold_edges;
      if (report.nonmanifold_edge_names.size() < most_names) report.nonmanifold_edge_names.push_back(edge.name);
    }
  }
  std::erase_if(report.open_solids, [&](const std::string& name) {  // those that the file reader names stay
    const auto part = std::find(model.parts.begin(), model.parts.end(), name);
    return part != model.parts.end() && model.part_solid[part - model.parts.begin()] >= 0;
  });
  if (report.free_edges == 0) {  // sewing or merging has closed them
    report.open_solids.clear();
    report.holes.clear();
  }
  for (const int part : open_parts) report.open_solids.push_back(model.parts[part]);
}

Model build_model(const Shape& shape, const Options& options, ModelReport report, Progress& progress,
                  SharedTasks& tasks, std::string* brep) {
  QuietMessages quiet;
  return guard_occt(ErrorCode::internal, "The topology of the model cannot be built", progress,
                    [&] { return ModelBuilder(shape, std::move(report), progress, tasks).build(options, brep); });
}

}  // namespace paver
