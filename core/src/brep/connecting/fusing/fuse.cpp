// The kernel's general fuse of several parts, with what every face and edge became.
// Steps: fuse; where pieces of different parts lie along each other without being one, again with the distance between
// them as the tolerance.
#include <BRepAlgoAPI_BuilderAlgo.hxx>
#include <BRep_Builder.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <cmath>
#include <initializer_list>
#include <optional>

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
  Fuser(const Workpiece& work, const std::vector<int>& parts, const std::vector<TopoDS_Vertex>& points)
      : work_(work), shapes_(work.parts.size()), is_member_(marked_parts(work, parts)) {
    list_shapes();
    for (int part : parts) add_arguments(part);
    for (const TopoDS_Vertex& point : points) arguments_.Append(point);
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
    return face.is_usable() && std::ranges::any_of(face.uses, [&](const FaceUse& use) { return is_member_[use.part]; });
  }

  void list_shapes() {
    for (const WorkFace& face : work_.faces)
      for (const FaceUse& use : face.uses)
        if (face.is_usable() && is_member_[use.part]) {
          shapes_[use.part].Append(face.face);
          if (face.is_loose && work_.parts[use.part].is_loose) loose_.Add(face.face);
        }
    for (const WorkWire& wire : work_.wires)
      if (is_member_[wire.part]) shapes_[wire.part].Append(wire.edge);
    for (const WorkPoint& point : work_.points)
      if (is_member_[point.part] && !point.is_end) shapes_[point.part].Append(point.vertex);
  }

  /// One argument, but each shape of a loose part, or each loose face of a solid: the kernel looks for nothing between
  /// the faces, or edges, of one.
  void add_arguments(int part) {
    TopTools_ListOfShape& shapes = shapes_[part];
    const bool is_solid = work_.parts[part].solid >= 0;
    if (work_.parts[part].is_loose && !is_solid) return arguments_.Append(shapes);
    BRep_Builder builder;
    TopoDS_Compound whole;
    builder.MakeCompound(whole);
    for (const TopoDS_Shape& shape : shapes)
      if (loose_.Contains(shape)) {
        arguments_.Append(shape);
      } else {
        builder.Add(whole, shape);
      }
    arguments_.Append(whole);
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
  std::vector<TopTools_ListOfShape> shapes_;  // of each part that is fused
  std::vector<char> is_member_;               // per part
  TopTools_MapOfShape loose_;                 // faces of solids
  TopTools_ListOfShape arguments_;
  TopTools_IndexedMapOfShape images_;
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
/// that is not to be tried (`is_last`) or fails, or where it connects what was apart by more than parts are misplaced.
std::optional<Fusion> fuse_wider(const Workpiece& work, Fuser& fuser, Fusion& fusion, bool is_last,
                                 Progress& progress) {
  constexpr double slack = 2;  // distances are samples
  const DoubledPieces pieces = find_doubled_pieces(work, fusion, progress);
  fusion.doubled = pieces.in_lenses;
  if (!(pieces.gap > 0) || is_last) return std::nullopt;
  const double wider = std::max(slack * pieces.gap, 2 * fusion.tolerance);
  std::optional<Fusion> next = fuse_at(fuser, {wider, gap_factor * wider}, progress);
  if (!next) return std::nullopt;
  if (next->tolerance > most_misfit * work.diagonal &&
      !std::ranges::includes(touching_parts(work, fusion), touching_parts(work, *next)))
    return std::nullopt;
  next->merged = {pieces.parts, pieces.gap};
  next->merged.add(fusion.merged);
  return next;
}

}  // namespace

std::optional<Fusion> fuse(const Workpiece& work, const std::vector<int>& parts, double tolerance, Progress& progress,
                           const std::vector<TopoDS_Vertex>& points) {
  constexpr int most_tries = 3;
  Fuser fuser(work, parts, points);
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
