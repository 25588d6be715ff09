// The kernel's general fuse of several parts, with what every face and edge became.
// Steps: fuse; where pieces of different parts lie along each other without being one, again with the distance between
// them as the tolerance.
#include <BOPTools_AlgoTools3D.hxx>
#include <BRepAlgoAPI_BuilderAlgo.hxx>
#include <BRep_Builder.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <cmath>
#include <initializer_list>
#include <map>
#include <optional>
#include <set>

#include "brep/connecting/connect_impl.h"
#include "brep/occt_impl.h"
#include "brep/occt_shapes_impl.h"

namespace paver {
namespace {

/// Between one tolerance that is tried and the next.
constexpr double gap_factor = 10;
/// Images may differ from their face by this share of its area.
constexpr double area_share = 1e-3;

class Fuser {
 public:
  Fuser(const Workpiece& work, const std::vector<int>& parts) : work_(work), parts_(parts) {
    for (int part : parts) add_arguments(part);
  }

  std::optional<Fusion> run(double tolerance, Progress& progress) {
    BRepAlgoAPI_BuilderAlgo builder;
    builder.SetArguments(arguments_);
    builder.SetNonDestructive(Standard_True);
    builder.SetRunParallel(Standard_False);
    builder.SetFuzzyValue(tolerance);
    Handle(OcctProgress) indicator = new OcctProgress(progress, 0);
    builder.Build(indicator->Start());
    progress.check();
    if (builder.HasErrors()) return std::nullopt;
    Fusion fusion;
    fusion.tolerance = tolerance;
    images_.Clear();
    for (std::size_t f = 0; f < work_.faces.size(); ++f)
      if (is_member(work_.faces[f]) && !add_images(static_cast<int>(f), builder, tolerance, fusion))
        return std::nullopt;
    if (tolerance > 0 && std::ranges::any_of(fusion.images, [&](const auto& image) { return is_squashed(image); }))
      return std::nullopt;
    add_edges(builder, fusion);
    for (const WorkPoint& point : work_.points)
      for (const TopoDS_Shape& image : builder.Modified(point.vertex)) fusion.points.push_back({point.vertex, image});
    return fusion;
  }

  /// Of two balls whose periodic edges lie half a turn apart the kernel loses a half in one order.
  void reverse() { arguments_.Reverse(); }

 private:
  bool is_member(const WorkFace& face) const {
    return face.is_usable() && std::any_of(parts_.begin(), parts_.end(), [&](int part) { return face.has_part(part); });
  }

  /// One argument: the kernel looks for nothing between the faces of one.
  void add_arguments(int part) {
    if (!work_.parts[part].is_loose) {
      arguments_.Append(argument(part));
      return;
    }
    for (const WorkFace& face : work_.faces)
      if (face.is_usable() && face.has_part(part)) arguments_.Append(face.face);
  }

  TopoDS_Shape argument(int part) {
    BRep_Builder builder;
    TopoDS_Compound compound;
    builder.MakeCompound(compound);
    for (const WorkFace& face : work_.faces)
      if (face.is_usable() && face.has_part(part)) builder.Add(compound, face.face);
    for (const WorkWire& wire : work_.wires)
      if (wire.part == part) builder.Add(compound, wire.edge);
    for (const WorkPoint& point : work_.points)
      if (point.part == part && !point.is_end) builder.Add(compound, point.vertex);
    return compound;
  }

  bool add_images(int f, BRepAlgoAPI_BuilderAlgo& builder, double tolerance, Fusion& fusion) {
    const WorkFace& face = work_.faces[f];
    TopTools_ListOfShape images = builder.Modified(face.face);
    if (images.IsEmpty() && !builder.IsDeleted(face.face)) images.Append(face.face);
    double area = 0, perimeter = 0;
    for (const TopoDS_Shape& image : images) {
      area += face_area(TopoDS::Face(image));
      int index = images_.FindIndex(image);
      if (index == 0) {
        index = images_.Add(image);
        fusion.images.push_back({TopoDS::Face(image), {}});
      }
      fusion.images[index - 1].of.push_back(f);
    }
    const auto edges = shapes_of(face.face, TopAbs_EDGE);
    for (int i = 1; i <= edges.Extent(); ++i) perimeter += edge_length(TopoDS::Edge(edges(i)));
    return std::abs(area - face.area) <= area_share * face.area + tolerance * perimeter;
  }

  /// Whether two faces of one part have become one: it is thinner than the tolerance.
  bool is_squashed(const Fusion::Image& image) const {
    for (std::size_t i = 1; i < image.of.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        for (const FaceUse& use : face_of(image, i).uses)
          if (!work_.parts[use.part].is_loose && face_of(image, j).has_part(use.part)) return true;
    return false;
  }

  const WorkFace& face_of(const Fusion::Image& image, std::size_t i) const { return work_.faces[image.of[i]]; }

  void add_edges(BRepAlgoAPI_BuilderAlgo& builder, Fusion& fusion) const {
    TopTools_IndexedMapOfShape edges;
    for (const TopoDS_Shape& part : arguments_) TopExp::MapShapes(part, TopAbs_EDGE, edges);
    for (int i = 1; i <= edges.Extent(); ++i)
      for (const TopoDS_Shape& image : builder.Modified(edges(i)))
        if (!image.IsSame(edges(i))) fusion.edges.push_back({edges(i), image});
  }

  const Workpiece& work_;
  const std::vector<int>& parts_;
  TopTools_ListOfShape arguments_;
  TopTools_IndexedMapOfShape images_;
};

/// Pieces of different parts that lie along each other but are two: a surface and its approximation cross along many
/// lines, two planes of which one is turned by rounding along one, and the kernel keeps both.
class DoubledPieces {
 public:
  DoubledPieces(const Workpiece& work, const Fusion& fusion)
      : fusion_(fusion), diagonal_(work.diagonal), pieces_of_(work.faces.size(), 0) {
    for (const Fusion::Image& image : fusion.images) {
      std::set<int>& own = parts_.emplace_back();
      for (int f : image.of) {
        ++pieces_of_[f];
        for (const FaceUse& use : work.faces[f].uses) own.insert(use.part);
      }
    }
  }

  /// The largest distance between such pieces, or width of what is left beside common ones, mm; 0 where there are none.
  double gap(const Progress& progress) {
    double largest = 0;
    for (const auto& [pair, edges] : shared_edges()) {
      progress.check();
      const double found = gap_between(pair, edges);
      if (!(found > 0)) continue;
      largest = std::max(largest, found);
      for (int image : pair) {
        parts.insert(parts_[image].begin(), parts_[image].end());
        if (edges.size() > 1) in_lenses.insert(parts_[image].begin(), parts_[image].end());
      }
    }
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const Fusion::Image& image = fusion_.images[i];
      const double width = image.of.size() == 1 && pieces_of_[image.of[0]] > 1 ? sliver_width(image.face) : 0;
      if (!(width > 0)) continue;
      largest = std::max(largest, width);
      parts.insert(parts_[i].begin(), parts_[i].end());
    }
    return largest;
  }

  /// Pairs that have a vertex in common.
  std::set<std::array<int, 2>> touching() const {
    NCollection_IndexedDataMap<TopoDS_Shape, std::set<int>, TopTools_ShapeMapHasher> about;
    for (std::size_t i = 0; i < parts_.size(); ++i)
      for (TopExp_Explorer inner(fusion_.images[i].face, TopAbs_VERTEX); inner.More(); inner.Next())
        about.ChangeFromIndex(about.Add(inner.Current(), {})).insert(parts_[i].begin(), parts_[i].end());
    std::set<std::array<int, 2>> pairs;
    for (int v = 1; v <= about.Extent(); ++v)
      for (auto p = about(v).begin(); p != about(v).end(); ++p)
        for (auto q = std::next(p); q != about(v).end(); ++q) pairs.insert({*p, *q});
    return pairs;
  }

  std::set<int> parts;      ///< found by gap(): parts with such pieces
  std::set<int> in_lenses;  ///< likewise, along each other between two common edges

 private:
  using Pair = std::array<int, 2>;
  /// Distances by the mean width of the smaller piece up to which two are taken for one: with one common edge that is
  /// an angle of a quarter of a degree, with more a lens.
  static constexpr double flattest_wedge = 2e-3, flattest_lens = 2e-2;
  static constexpr double widest_sliver = 1e-5;  // of the diagonal
  static constexpr double most_sine = 0.1;       // between the normals at a common edge
  static constexpr double least_gap = 1e-7;      // mm: the kernel's own

  /// Of images of parts that have none in common.
  std::map<Pair, std::vector<TopoDS_Edge>> shared_edges() const {
    NCollection_IndexedDataMap<TopoDS_Shape, std::vector<int>, TopTools_ShapeMapHasher> images;
    for (std::size_t i = 0; i < fusion_.images.size(); ++i) {
      const auto edges = shapes_of(fusion_.images[i].face, TopAbs_EDGE);
      for (int e = 1; e <= edges.Extent(); ++e)
        images.ChangeFromIndex(images.Add(edges(e), {})).push_back(static_cast<int>(i));
    }
    std::map<Pair, std::vector<TopoDS_Edge>> shared;
    for (int e = 1; e <= images.Extent(); ++e) {
      const TopoDS_Edge edge = TopoDS::Edge(images.FindKey(e));
      if (BRep_Tool::Degenerated(edge)) continue;
      const std::vector<int>& about = images(e);
      for (std::size_t i = 0; i < about.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          if (!has_common_part(about[i], about[j])) shared[{about[j], about[i]}].push_back(edge);
    }
    return shared;
  }

  static double perimeter_of(const TopoDS_Face& piece) {
    double perimeter = 0;
    for (const TopoDS_Edge& edge : edges_of(piece)) perimeter += edge_length(edge);
    return perimeter;
  }

  bool has_common_part(int a, int b) const {
    return std::ranges::any_of(parts_[a], [&](int part) { return parts_[b].contains(part); });
  }

  /// Of what is left of a face beside the piece that another has as well, where their outlines are one but for
  /// rounding; else 0.
  double sliver_width(const TopoDS_Face& piece) const {
    const double perimeter = perimeter_of(piece);
    const double width = 2 * face_area(piece) / perimeter;
    return width <= std::min(widest_sliver * diagonal_, flattest_wedge * 0.5 * perimeter) ? std::max(width, least_gap)
                                                                                          : 0;
  }

  /// 0 where they are not along each other.
  double gap_between(Pair pair, const std::vector<TopoDS_Edge>& edges) const {
    TopoDS_Face one = fusion_.images[pair[0]].face, other = fusion_.images[pair[1]].face;
    if (!are_parallel(one, other, edges[0])) return 0;
    double area = face_area(one);
    if (const double other_area = face_area(other); other_area < area) std::swap(one, other), area = other_area;
    const double most = (edges.size() > 1 ? flattest_lens : flattest_wedge) * 2 * area / perimeter_of(one);
    gp_Pnt inside;
    gp_Pnt2d uv;
    if (!(most > 0) || BOPTools_AlgoTools3D::PointInFace(one, inside, uv, context_) != 0) return 0;
    const std::optional<double> middle = distance(inside, other);
    if (!middle || *middle > most) return 0;
    double gap = std::max(*middle, least_gap);
    for (const TopoDS_Edge& edge : edges_of(one))
      for (double share : {0.0, 0.5}) {
        CurveRange range;
        const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, range.first, range.last);
        if (curve.IsNull()) continue;
        const std::optional<double> found = distance(curve->Value(range.at(share)), other);
        if (found && *found <= 2 * most) gap = std::max(gap, *found);
      }
    return gap;
  }

  static bool are_parallel(const TopoDS_Face& one, const TopoDS_Face& other, const TopoDS_Edge& edge) {
    const gp_Vec a = normal_at(one, edge), b = normal_at(other, edge);
    return a.Crossed(b).Magnitude() <= most_sine * a.Magnitude() * b.Magnitude();
  }

  static gp_Vec normal_at(const TopoDS_Face& face, const TopoDS_Edge& edge) {
    const EdgeImage image = image_of(edge, face);
    if (image.curve.IsNull()) return {0, 0, 0};
    const gp_Pnt2d uv = image.uv(0.5);
    gp_Pnt at;
    gp_Vec u, v;
    BRep_Tool::Surface(face)->D1(uv.X(), uv.Y(), at, u, v);
    return u.Crossed(v);
  }

  /// Of a point from a face, where the foot lies on it.
  std::optional<double> distance(const gp_Pnt& point, const TopoDS_Face& face) const {
    GeomAPI_ProjectPointOnSurf& foot = context_->ProjPS(face);
    foot.Perform(point);
    if (!foot.IsDone() || foot.NbPoints() == 0) return std::nullopt;
    double u = 0, v = 0;
    foot.LowerDistanceParameters(u, v);
    if (!context_->IsPointInOnFace(face, {u, v})) return std::nullopt;
    return foot.LowerDistance();
  }

  const Fusion& fusion_;
  const double diagonal_;
  std::vector<int> pieces_of_;        // of each face
  std::vector<std::set<int>> parts_;  // of each image
  Handle(IntTools_Context) context_ = new IntTools_Context;
};

std::optional<Fusion> fuse_at(Fuser& fuser, std::initializer_list<double> tolerances, Progress& progress) {
  for (int order = 0; order < 2; ++order, fuser.reverse())
    for (double tolerance : tolerances) {
      try {
        if (auto fusion = fuser.run(tolerance, progress)) return fusion;
      } catch (const Standard_Failure&) {
        progress.check();  // the next tolerance may do
      }
    }
  return std::nullopt;
}

/// Notes doubled pieces of a fusion and fuses with a tolerance that makes them one; nothing where there are none, where
/// that is not to be tried (`is_last`) or fails, or where it connects what was apart.
std::optional<Fusion> fuse_wider(const Workpiece& work, Fuser& fuser, Fusion& fusion, bool is_last,
                                 Progress& progress) {
  constexpr double slack = 2;  // distances are samples
  DoubledPieces pieces(work, fusion);
  const double gap = pieces.gap(progress);
  fusion.doubled = pieces.in_lenses;
  if (!(gap > 0) || is_last) return std::nullopt;
  const double wider = std::max(slack * gap, 2 * fusion.tolerance);
  std::optional<Fusion> next = fuse_at(fuser, {wider, gap_factor * wider}, progress);
  if (!next || !std::ranges::includes(pieces.touching(), DoubledPieces(work, *next).touching())) return std::nullopt;
  next->merged = std::move(pieces.parts);
  next->merged.insert(fusion.merged.begin(), fusion.merged.end());
  next->gap = std::max(gap, fusion.gap);
  return next;
}

}  // namespace

std::optional<Fusion> fuse(const Workpiece& work, const std::vector<int>& parts, double tolerance, Progress& progress) {
  constexpr int most_tries = 3;
  Fuser fuser(work, parts);
  std::optional<Fusion> fusion = fuse_at(fuser, {tolerance, 0, gap_factor * tolerance}, progress);
  try {
    for (int i = 0; fusion && i <= most_tries; ++i) {
      std::optional<Fusion> next = fuse_wider(work, fuser, *fusion, i == most_tries, progress);
      if (!next) break;
      fusion = std::move(next);
    }
  } catch (const Standard_Failure&) {
    progress.check();  // it stays as it is
  }
  return fusion;
}

}  // namespace paver
