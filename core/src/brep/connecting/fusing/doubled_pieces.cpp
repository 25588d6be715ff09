#include <BOPTools_AlgoTools3D.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <algorithm>

#include "brep/connecting/fusing/doubled_pieces_impl.h"
#include "brep/occt_shapes_impl.h"

namespace paver {
namespace {

/// Distances by the mean width of the smaller piece up to which two are taken for one: with one common edge that is an
/// angle of a thousandth, as placements rounded to three digits make, with more a lens.
constexpr double flattest_wedge = 5e-4, flattest_lens = 2e-2;
constexpr double widest_sliver = 1e-5;  // of the diagonal
constexpr double most_sine = 0.1;       // between the normals at a common edge
constexpr double least_gap = 1e-7;      // mm: the kernel's own

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

}  // namespace

DoubledPieces::DoubledPieces(const Workpiece& work, const Fusion& fusion)
    : fusion_(fusion), diagonal_(work.diagonal), pieces_of_(work.faces.size(), 0) {
  for (const Fusion::Image& image : fusion.images) {
    std::set<int>& own = parts_.emplace_back();
    for (int f : image.of) {
      ++pieces_of_[f];
      for (const FaceUse& use : work.faces[f].uses) own.insert(use.part);
    }
  }
}

double DoubledPieces::gap(const Progress& progress) {
  double largest = 0;
  for (const auto& [pair, edges] : shared_edges()) {
    progress.check();
    const double found = gap_between(pair, edges);
    if (!(found > 0)) continue;
    largest = std::max(largest, found);
    for (int image : pair) {
      note(image, doubled_);
      if (edges.size() > 1) note(image, in_lenses_);
    }
  }
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const Fusion::Image& image = fusion_.images[i];
    const double width = image.of.size() == 1 && pieces_of_[image.of[0]] > 1 ? sliver_width(image.face) : 0;
    if (width > 0) note(static_cast<int>(i), doubled_);
    largest = std::max(largest, width);
  }
  return largest;
}

std::set<std::array<int, 2>> DoubledPieces::touching() const {
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

/// Of images of parts that have none in common.
std::map<DoubledPieces::Pair, std::vector<TopoDS_Edge>> DoubledPieces::shared_edges() const {
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

bool DoubledPieces::has_common_part(int a, int b) const {
  return std::ranges::any_of(parts_[a], [&](int part) { return parts_[b].contains(part); });
}

/// Of what is left of a face beside the piece that another has as well, where their outlines are one but for rounding;
/// else 0.
double DoubledPieces::sliver_width(const TopoDS_Face& piece) const {
  const double perimeter = perimeter_of(piece);
  const double width = 2 * face_area(piece) / perimeter;
  return width <= std::min(widest_sliver * diagonal_, flattest_wedge * 0.5 * perimeter) ? std::max(width, least_gap)
                                                                                        : 0;
}

/// 0 where they are not along each other.
double DoubledPieces::gap_between(Pair pair, const std::vector<TopoDS_Edge>& edges) const {
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

/// Of a point from a face, where the foot lies on it.
std::optional<double> DoubledPieces::distance(const gp_Pnt& point, const TopoDS_Face& face) const {
  GeomAPI_ProjectPointOnSurf& foot = context_->ProjPS(face);
  foot.Perform(point);
  if (!foot.IsDone() || foot.NbPoints() == 0) return std::nullopt;
  double u = 0, v = 0;
  foot.LowerDistanceParameters(u, v);
  if (!context_->IsPointInOnFace(face, {u, v})) return std::nullopt;
  return foot.LowerDistance();
}

}  // namespace paver
