// Mending faces, in two steps, on a copy of the shape when there is anything to do.
// 1. Open loops: ends that are no start are joined with the nearest start that is no end. Vertices are joined all over
//    the model at once, so faces that share them go on sharing. So are vertices of different loops of a face in one
//    place, where a hole touches a side.
// 2. Images that jump or are nowhere near their curve: wrong ones are removed, and the kernel adds images, periodic
//    edges and poles; before that, faces that lack nothing but their pole are completed to it. Each face is tried on a
//    copy; what the trial makes better is done, in one memory of replaced edges for all faces.
// Files of clean models have neither, and pay for the look at their loops only.
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepCheck_ListIteratorOfListOfStatus.hxx>
#include <BRepCheck_Result.hxx>
#include <BRepTools_ReShape.hxx>
#include <BRep_Builder.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeFix_Face.hxx>
#include <ShapeFix_Wire.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "base/union_find.h"
#include "brep/mending/mend_impl.h"
#include "brep/occt_impl.h"
#include "brep/occt_shapes_impl.h"

namespace paver {
namespace {

/// No ends farther apart than this share of the diagonal are joined,
constexpr double join_share = 3e-3;
/// nor than this share of the shortest edge of the loop.
constexpr double edge_share = 0.25;
/// Precision of the kernel's repairs, of the diagonal; and how far it may raise tolerances.
constexpr double exact_share = 1e-7, coarse_share = 1e-4;
/// The border of a face must keep its length up to this share; its area is often unknown while its images are wrong.
constexpr double same_share = 1e-4;

/// Puts what a memory of replacements made of faces and edges in their place.
template <class Context>
void take_over(Workpiece& work, Context& context) {
  TopTools_IndexedMapOfShape before;
  for (const WorkFace& face : work.faces) TopExp::MapShapes(face.face, TopAbs_EDGE, before);
  for (WorkFace& face : work.faces) {
    const TopoDS_Shape image = context.Apply(face.face);
    if (!image.IsNull() && image.ShapeType() == TopAbs_FACE) face.face = TopoDS::Face(image);
  }
  for (int i = 1; i <= before.Extent(); ++i) {
    const TopoDS_Shape image = context.Apply(before(i));
    if (!image.IsNull() && !image.IsSame(before(i))) add_edge_origins(work, image, before(i));
  }
  work.is_rebuilt = true;
}

struct LoopVertex {
  TopoDS_Vertex vertex;
  std::size_t loop = 0;
  gp_Pnt at;
};

/// Vertices of different loops of a face that are in one place: loops that touch there.
std::vector<std::array<TopoDS_Vertex, 2>> touching_vertices(const TopoDS_Face& face, double within) {
  const std::vector<TopoDS_Wire> wires = wires_of(face);
  if (wires.size() < 2) return {};
  std::vector<LoopVertex> list;
  for (std::size_t loop = 0; loop < wires.size(); ++loop) {
    const auto vertices = shapes_of(wires[loop], TopAbs_VERTEX);
    for (int i = 1; i <= vertices.Extent(); ++i) {
      const TopoDS_Vertex& vertex = TopoDS::Vertex(vertices(i));
      list.push_back({vertex, loop, BRep_Tool::Pnt(vertex)});
    }
  }
  std::ranges::stable_sort(list, {}, [](const LoopVertex& one) { return one.at.X(); });
  std::vector<std::array<TopoDS_Vertex, 2>> pairs;
  for (std::size_t i = 0; i < list.size(); ++i)
    for (std::size_t j = i + 1; j < list.size() && list[j].at.X() - list[i].at.X() <= within; ++j)
      if (list[i].loop != list[j].loop && !list[i].vertex.IsSame(list[j].vertex) &&
          list[i].at.Distance(list[j].at) <= within)
        pairs.push_back({list[i].vertex, list[j].vertex});
  return pairs;
}

/// Joins the ends of open loops, and loops that touch.
class LoopCloser {
 public:
  explicit LoopCloser(Workpiece& work) : work_(work) {}

  void add_face(const WorkFace& work) {
    const std::size_t before = joined_.size();
    for (const TopoDS_Wire& wire : wires_of(work.face)) add_loop(wire);
    if (joined_.size() > before) names_.push_back(face_name(work.origin));
  }

  void add_touching(const WorkFace& work) {
    const auto pairs = touching_vertices(work.face, exact_share * work_.diagonal);
    for (const auto& [a, b] : pairs) joined_.push_back({0, vertices_.Add(a), vertices_.Add(b)});
    if (!pairs.empty()) names_.push_back(face_name(work.origin));
  }

  void run() {
    if (joined_.empty()) return;
    UnionFind together(static_cast<std::size_t>(vertices_.Extent()) + 1);
    for (const Link& link : joined_) together.merge(link.end, link.start);
    BRepTools_ReShape context;
    double reach = 0;
    for (const std::vector<int>& cluster : together.sets())
      if (cluster.size() > 1) reach = std::max(reach, join(cluster, context));
    take_over(work_, context);
    for (const std::string& name : names_) work_.note_repair(RepairKind::closed_loop, 1, reach, name);
  }

 private:
  struct Link {
    double distance;
    int end, start;
  };

  void add_loop(const TopoDS_Shape& wire) {
    std::map<int, int> balance;  // starts less ends
    double shortest = std::numeric_limits<double>::infinity();
    auto add = [&](const TopoDS_Edge& edge, const TopoDS_Vertex& first, const TopoDS_Vertex& last) {
      ++balance[vertices_.Add(first)];
      --balance[vertices_.Add(last)];
      if (!first.IsSame(last)) shortest = std::min(shortest, edge_length(edge));
    };
    if (!visit_border(wire, add)) return;
    const double most = std::min(join_share * work_.diagonal, edge_share * shortest);
    std::vector<Link> links = links_between(balance, most);
    const auto joined = close(balance, links);
    const bool is_closed =
        std::all_of(balance.begin(), balance.end(), [](const auto& entry) { return entry.second == 0; });
    if (is_closed) joined_.insert(joined_.end(), joined.begin(), joined.end());
  }

  std::vector<Link> links_between(const std::map<int, int>& balance, double most) const {
    std::vector<Link> links;
    for (const auto& [end, ends] : balance)
      for (const auto& [start, starts] : balance) {
        if (ends >= 0 || starts <= 0) continue;
        const double distance = point(end).Distance(point(start));
        if (distance <= most) links.push_back({distance, end, start});
      }
    std::stable_sort(links.begin(), links.end(), [](const Link& a, const Link& b) { return a.distance < b.distance; });
    return links;
  }

  /// The nearest first, each end and start once.
  static std::vector<Link> close(std::map<int, int>& balance, const std::vector<Link>& links) {
    std::vector<Link> joined;
    for (const Link& link : links) {
      if (balance[link.end] >= 0 || balance[link.start] <= 0) continue;
      ++balance[link.end];
      --balance[link.start];
      joined.push_back(link);
    }
    return joined;
  }

  const TopoDS_Vertex& vertex(int number) const { return TopoDS::Vertex(vertices_(number)); }
  gp_Pnt point(int number) const { return BRep_Tool::Pnt(vertex(number)); }

  /// One vertex in their middle, with a tolerance that holds them all; gives how far they were moved.
  double join(const std::vector<int>& cluster, BRepTools_ReShape& context) const {
    gp_XYZ sum(0, 0, 0);
    for (int i : cluster) sum += point(i).XYZ();
    const gp_Pnt middle(sum / static_cast<double>(cluster.size()));
    double reach = 0, tolerance = 0;
    for (int i : cluster) {
      reach = std::max(reach, middle.Distance(point(i)));
      tolerance = std::max(tolerance, middle.Distance(point(i)) + BRep_Tool::Tolerance(vertex(i)));
    }
    TopoDS_Vertex common;
    BRep_Builder().MakeVertex(common, middle, tolerance);
    for (int i : cluster) context.Replace(vertex(i).Oriented(TopAbs_FORWARD), common);
    return reach;
  }

  Workpiece& work_;
  TopTools_IndexedMapOfShape vertices_;
  std::vector<Link> joined_;        ///< of loops that these close; between numbers of vertices
  std::vector<std::string> names_;  ///< of the faces
};

/// Number of faults that the kernel finds in a face and its edges.
long kernel_faults(const TopoDS_Face& face) {
  const BRepCheck_Analyzer analyzer(face);
  long count = 0;
  auto add = [&](const TopoDS_Shape& shape) {
    const Handle(BRepCheck_Result)& result = analyzer.Result(shape);
    if (result.IsNull()) return;
    for (BRepCheck_ListIteratorOfListOfStatus status(result->Status()); status.More(); status.Next())
      count += status.Value() != BRepCheck_NoError;
    for (result->InitContextIterator(); result->MoreShapeInContext(); result->NextShapeInContext())
      for (BRepCheck_ListIteratorOfListOfStatus status(result->StatusOnShape()); status.More(); status.Next())
        count += status.Value() != BRepCheck_NoError;
  };
  add(face);
  for (TopAbs_ShapeEnum kind : {TopAbs_WIRE, TopAbs_EDGE}) {
    const auto parts = shapes_of(face, kind);
    for (int i = 1; i <= parts.Extent(); ++i) add(parts(i));
  }
  return count;
}

/// What a face must keep, and what it may have more of.
struct Figures {
  double border = 0;  ///< length of its edges without periodic ones
  int periodic = 0, poles = 0, vertices = 0;
};

Figures figures_of(const TopoDS_Face& face) {
  Figures figures;
  const auto edges = shapes_of(face, TopAbs_EDGE);
  for (int i = 1; i <= edges.Extent(); ++i) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges(i));
    const bool is_pole = BRep_Tool::Degenerated(edge), is_periodic = !is_pole && BRep_Tool::IsClosed(edge, face);
    figures.poles += is_pole;
    figures.periodic += is_periodic;
    if (!is_pole && !is_periodic) figures.border += edge_length(edge);
  }
  figures.vertices = shapes_of(face, TopAbs_VERTEX).Extent();
  return figures;
}

/// How far the vertices of one face lie from those of another at most.
double largest_move(const TopoDS_Face& before, const TopoDS_Face& after) {
  const auto from = shapes_of(before, TopAbs_VERTEX), to = shapes_of(after, TopAbs_VERTEX);
  double largest = 0;
  for (int i = 1; i <= from.Extent(); ++i) {
    double nearest = std::numeric_limits<double>::infinity();
    for (int j = 1; j <= to.Extent(); ++j)
      nearest =
          std::min(nearest, BRep_Tool::Pnt(TopoDS::Vertex(from(i))).Distance(BRep_Tool::Pnt(TopoDS::Vertex(to(j)))));
    largest = std::max(largest, nearest);
  }
  return largest;
}

class FaceMender {
 public:
  explicit FaceMender(Workpiece& work) : work_(work) {}

  void mend(WorkFace& face, const LoopFaults& faults) {
    // The kernel does not always take the pole on the face's side.
    const bool is_completed = mend_by(&FaceMender::completed, face, faults);
    has_completed_ = has_completed_ || is_completed;
    if (is_completed || mend_by(&FaceMender::fixed, face, faults)) return;
    const TopoDS_Edge edge = edge_without_end(forward(face.face));
    if (edge.IsNull()) return;
    face.fault = "its boundary goes once round and nothing ends it on the other side" + at_edge(work_, edge) +
                 "; repair it in the CAD program";
    face.has_area = true;
  }

  void finish() {
    if (is_mended_) take_over(work_, *context_);
    // What was added may be most of the model.
    if (has_completed_) measure_diagonal(work_);
  }

 private:
  /// What a face becomes; nothing where the way does not lead to one.
  using Way = std::optional<TopoDS_Face> (FaceMender::*)(const TopoDS_Face&, const LoopFaults&,
                                                         const Handle(ShapeBuild_ReShape) &) const;

  /// Tries on a copy, and does it where that helps.
  bool mend_by(Way make, WorkFace& face, const LoopFaults& faults) {
    const TopoDS_Face plain = forward(face.face);
    const TopoDS_Face copy = TopoDS::Face(BRepBuilderAPI_Copy(plain).Shape());
    const auto trial = (this->*make)(copy, find_loop_faults(copy, work_.diagonal), new ShapeBuild_ReShape);
    if (!trial || !is_better(plain, faults, *trial)) return false;
    const auto done = (this->*make)(TopoDS::Face(context_->Apply(plain)), faults, context_);
    if (!done) return false;
    const Figures before = figures_of(plain), after = figures_of(*done);
    context_->Replace(plain, *done);
    face.area = face_area(*done);
    face.has_area = true;
    is_mended_ = true;
    note(before, after, faults, largest_move(plain, *done), face_name(face.origin));
    return true;
  }

  void note(const Figures& before, const Figures& after, const LoopFaults& faults, double move,
            const std::string& face) {
    const bool is_joined = after.vertices < before.vertices;
    const bool is_extended = after.periodic > before.periodic || after.poles > before.poles;
    const auto wrong = static_cast<long>(faults.wrong_images.size());
    work_.note_repair(RepairKind::closed_loop, is_joined, move, face);
    work_.note_repair(RepairKind::periodic_edge, std::max(0, after.periodic - before.periodic), 0, face);
    work_.note_repair(RepairKind::pole, std::max(0, after.poles - before.poles), 0, face);
    work_.note_repair(RepairKind::image, wrong > 0 || is_joined || is_extended ? wrong : faults.jumps, faults.off,
                      face);
  }

  /// A face as the kernel makes it whole; nothing where it makes none, or several of it.
  std::optional<TopoDS_Face> fixed(const TopoDS_Face& face, const LoopFaults& faults,
                                   const Handle(ShapeBuild_ReShape) & context) const {
    BRep_Builder builder;
    for (const TopoDS_Edge& edge : faults.wrong_images)
      builder.UpdateEdge(TopoDS::Edge(context->Apply(edge)), Handle(Geom2d_Curve)(), face, BRep_Tool::Tolerance(edge));
    Handle(ShapeFix_Face) fixer = new ShapeFix_Face(face);
    fixer->SetContext(context);
    fixer->SetPrecision(exact_share * work_.diagonal);
    fixer->SetMinTolerance(Precision::Confusion());
    fixer->SetMaxTolerance(coarse_share * work_.diagonal);
    fixer->FixOrientationMode() = 0;
    fixer->FixAddNaturalBoundMode() = 0;
    fixer->FixSmallAreaWireMode() = 0;
    fixer->RemoveSmallAreaFaceMode() = 0;
    fixer->FixIntersectingWiresMode() = 0;
    fixer->FixLoopWiresMode() = 0;
    fixer->FixSplitFaceMode() = 0;
    fixer->FixMissingSeamMode() = 1;
    fixer->FixPeriodicDegeneratedMode() = 1;
    const Handle(ShapeFix_Wire) wires = fixer->FixWireTool();
    wires->ModifyTopologyMode() = Standard_True;
    wires->FixSelfIntersectionMode() = 0;
    wires->FixSmallMode() = 0;
    wires->FixLackingMode() = 0;
    wires->FixNotchedEdgesMode() = 0;
    wires->FixTailMode() = 0;
    fixer->Perform();
    const TopoDS_Shape result = fixer->Result();
    if (result.IsNull()) return std::nullopt;
    const auto faces = shapes_of(result, TopAbs_FACE);
    if (faces.Extent() != 1) return std::nullopt;
    return forward(TopoDS::Face(faces(1)));
  }

  std::optional<TopoDS_Face> completed(const TopoDS_Face& face, const LoopFaults& faults,
                                       const Handle(ShapeBuild_ReShape) & context) const {
    // A loop says on which side its face lies only where its images are right.
    const std::optional<TopoDS_Face> seen = faults.wrong_images.empty() ? face : fixed(face, faults, context);
    const auto whole = seen ? completed_to_pole(*seen, work_.diagonal) : std::nullopt;
    if (!whole) return std::nullopt;
    if (whole->periodic_edge.IsNull()) return fixed(whole->face, faults, context);
    for (const TopoDS_Edge& edge : whole->replaced)
      context->Replace(edge.Oriented(TopAbs_FORWARD), whole->periodic_edge.Oriented(TopAbs_FORWARD));
    return whole->face;
  }

  /// Fewer faults, none that the kernel sees more of; the same border.
  bool is_better(const TopoDS_Face& before, const LoopFaults& faults, const TopoDS_Face& after) const {
    if (find_loop_faults(after, work_.diagonal).count() >= faults.count()) return false;
    if (kernel_faults(after) > kernel_faults(before)) return false;
    if (largest_move(before, after) > join_share * work_.diagonal) return false;
    const double border = figures_of(before).border, area = face_area(after);
    return std::abs(figures_of(after).border - border) <= same_share * border && std::isfinite(area) &&
           work_.is_area(area);
  }

  Workpiece& work_;
  Handle(ShapeBuild_ReShape) context_ = new ShapeBuild_ReShape;
  bool is_mended_ = false, has_completed_ = false;
};

/// Faces with such faults; those that come without an area may have them because of these.
template <class Use>
void for_faults(Workpiece& work, Use&& use) {
  for (std::size_t i = 0; i < work.faces.size(); ++i) {
    const WorkFace& face = work.faces[i];
    if (!face.fault.empty() || face.is_dropped) continue;
    try {
      const LoopFaults faults = find_loop_faults(forward(face.face), work.diagonal);
      if (faults.count() > 0) use(i, faults);
    } catch (const Standard_Failure&) {
      // What the kernel cannot evaluate is reported where it is used.
    }
  }
}

}  // namespace

std::string at_edge(const Workpiece& work, const TopoDS_Edge& edge) {
  const std::vector<int> origins = edge_origins(work, edge);
  return origins.empty() ? "" : " at Edge" + std::to_string(origins.front() + 1);
}

void mend_faces(Workpiece& work, Progress& progress) {
  std::vector<std::size_t> open;
  bool has_images = false;
  for_faults(work, [&](std::size_t i, const LoopFaults& faults) {
    if (faults.open > 0) open.push_back(i);
    has_images |= faults.count() > faults.open;
  });
  std::vector<std::size_t> touching;
  for (std::size_t i = 0; i < work.faces.size(); ++i)
    if (work.faces[i].is_usable() && !touching_vertices(work.faces[i].face, exact_share * work.diagonal).empty())
      touching.push_back(i);
  if (open.empty() && !has_images && touching.empty()) return;
  copy_shape(work);
  LoopCloser closer(work);
  for (std::size_t i : open) closer.add_face(work.faces[i]);
  for (std::size_t i : touching) closer.add_touching(work.faces[i]);
  closer.run();
  FaceMender mender(work);
  for_faults(work, [&](std::size_t i, const LoopFaults& faults) {
    progress.check();
    if (faults.open == 0) mender.mend(work.faces[i], faults);
  });
  mender.finish();
}

}  // namespace paver
