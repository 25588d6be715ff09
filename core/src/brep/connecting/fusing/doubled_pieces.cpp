#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <algorithm>
#include <map>

#include "brep/connecting/connect_impl.h"
#include "brep/occt_shapes_impl.h"

namespace paver {
namespace {

/// Distances by the mean width of the smaller piece up to which two are taken for one: with one common edge that is an
/// angle of a thousandth, as placements rounded to three digits make, with more a lens.
constexpr double flattest_wedge = 5e-4, flattest_lens = 2e-2;
constexpr double most_sine = 0.1;   // between the normals at a common edge
constexpr double least_gap = 1e-7;  // mm: the kernel's own

double perimeter_of(const TopoDS_Face& piece) {
  double perimeter = 0;
  for (const TopoDS_Edge& edge : edges_of(piece)) perimeter += edge_length(edge);
  return perimeter;
}

gp_Vec normal_at(const TopoDS_Face& face, const TopoDS_Edge& edge) {
  const EdgeImage image = image_of(edge, face);
  if (image.curve.IsNull()) return {0, 0, 0};
  const gp_Pnt2d uv = image.uv(0.5);
  gp_Pnt at;
  gp_Vec u, v;
  BRep_Tool::Surface(face)->D1(uv.X(), uv.Y(), at, u, v);
  return u.Crossed(v);
}

bool are_parallel(const TopoDS_Face& one, const TopoDS_Face& other, const TopoDS_Edge& edge) {
  const gp_Vec a = normal_at(one, edge), b = normal_at(other, edge);
  return a.Crossed(b).Magnitude() <= most_sine * a.Magnitude() * b.Magnitude();
}

/// The parts of each image.
std::vector<std::set<int>> parts_of_images(const Workpiece& work, const Fusion& fusion) {
  std::vector<std::set<int>> parts;
  for (const Fusion::Image& image : fusion.images) {
    std::set<int>& own = parts.emplace_back();
    for (int f : image.of)
      for (const FaceUse& use : work.faces[f].uses) own.insert(use.part);
  }
  return parts;
}

class Finder {
 public:
  Finder(const Workpiece& work, const Fusion& fusion)
      : fusion_(fusion),
        diagonal_(work.diagonal),
        pieces_of_(work.faces.size(), 0),
        parts_(parts_of_images(work, fusion)) {
    for (const Fusion::Image& image : fusion.images)
      for (int f : image.of) ++pieces_of_[f];
  }

  DoubledPieces run(const Progress& progress) {
    for (const auto& [pair, edges] : shared_edges()) {
      progress.check();
      const double gap = gap_between(pair, edges);
      if (!(gap > 0)) continue;
      found_.gap = std::max(found_.gap, gap);
      for (int image : pair) {
        note(image, found_.parts);
        if (edges.size() > 1) note(image, found_.in_lenses);
      }
    }
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const Fusion::Image& image = fusion_.images[i];
      const bool is_cut_off = std::ranges::all_of(image.of, [&](int f) { return pieces_of_[f] > 1; });
      const double width = is_cut_off ? sliver_width(image.face) : 0;
      if (width > 0) note(static_cast<int>(i), found_.parts);
      found_.gap = std::max(found_.gap, width);
    }
    return std::move(found_);
  }

 private:
  void note(int image, std::set<int>& parts) const { parts.insert(parts_[image].begin(), parts_[image].end()); }

  /// Of images of parts that have none in common.
  std::map<PartPair, std::vector<TopoDS_Edge>> shared_edges() const {
    NCollection_IndexedDataMap<TopoDS_Shape, std::vector<int>, TopTools_ShapeMapHasher> images;
    for (std::size_t i = 0; i < fusion_.images.size(); ++i) {
      const auto edges = shapes_of(fusion_.images[i].face, TopAbs_EDGE);
      for (int e = 1; e <= edges.Extent(); ++e)
        images.ChangeFromIndex(images.Add(edges(e), {})).push_back(static_cast<int>(i));
    }
    std::map<PartPair, std::vector<TopoDS_Edge>> shared;
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

  bool has_common_part(int a, int b) const {
    return std::ranges::any_of(parts_[a], [&](int part) { return parts_[b].contains(part); });
  }

  /// Of what is left of a face beside the piece that another has as well, where their outlines are one but for
  /// rounding; else 0.
  double sliver_width(const TopoDS_Face& piece) const {
    const double perimeter = perimeter_of(piece);
    const double width = 2 * face_area(piece) / perimeter;
    return width <= std::min(most_misfit * diagonal_, flattest_wedge * 0.5 * perimeter) ? std::max(width, least_gap)
                                                                                        : 0;
  }

  /// 0 where they are not along each other.
  double gap_between(PartPair pair, const std::vector<TopoDS_Edge>& edges) const {
    TopoDS_Face one = fusion_.images[pair[0]].face, other = fusion_.images[pair[1]].face;
    if (!are_parallel(one, other, edges[0])) return 0;
    double area = face_area(one);
    if (const double other_area = face_area(other); other_area < area) std::swap(one, other), area = other_area;
    const double most = (edges.size() > 1 ? flattest_lens : flattest_wedge) * 2 * area / perimeter_of(one);
    const std::optional<gp_Pnt> inside = most > 0 ? point_inside(one, context_) : std::nullopt;
    const std::optional<double> middle = inside ? distance(*inside, other) : std::nullopt;
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
  std::vector<int> pieces_of_;              // of each face
  const std::vector<std::set<int>> parts_;  // of each image
  DoubledPieces found_;
  Handle(IntTools_Context) context_ = new IntTools_Context;
};

}  // namespace

DoubledPieces find_doubled_pieces(const Workpiece& work, const Fusion& fusion, const Progress& progress) {
  return Finder(work, fusion).run(progress);
}

std::set<PartPair> touching_parts(const Workpiece& work, const Fusion& fusion) {
  const std::vector<std::set<int>> parts = parts_of_images(work, fusion);
  NCollection_IndexedDataMap<TopoDS_Shape, std::set<int>, TopTools_ShapeMapHasher> about;
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (TopExp_Explorer inner(fusion.images[i].face, TopAbs_VERTEX); inner.More(); inner.Next())
      about.ChangeFromIndex(about.Add(inner.Current(), {})).insert(parts[i].begin(), parts[i].end());
  std::set<PartPair> pairs;
  for (const std::set<int>& there : about)
    for (auto p = there.begin(); p != there.end(); ++p)
      for (auto q = std::next(p); q != there.end(); ++q) pairs.insert({*p, *q});
  return pairs;
}

}  // namespace paver
