// Sheets whose faces touch elsewhere than along common edges: each pair of faces that may is given to the kernel.
#include <BRepAlgoAPI_BuilderAlgo.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "base/segment.h"
#include "brep/connecting/connect_impl.h"
#include "brep/connecting/face_cells_impl.h"
#include "brep/occt_impl.h"
#include "brep/surfaces/evaluators_impl.h"

namespace paver {
namespace {

/// Pairs of faces of a sewn sheet that are looked at closely; files of more loose faces are skins drawn to fit.
constexpr int most_tries = 200;
/// Edges lie on one another where they are no farther apart than so many times what is sewn.
constexpr double doubled = 4;

using FacePair = std::pair<std::size_t, std::size_t>;

/// Whether two faces have more in common than the edges and vertices they share.
bool changes_when_fused(const TopoDS_Face& one, const TopoDS_Face& two, double tolerance) {
  try {
    BRepAlgoAPI_BuilderAlgo builder;
    TopTools_ListOfShape arguments;
    arguments.Append(one);
    arguments.Append(two);
    builder.SetArguments(arguments);
    builder.SetNonDestructive(Standard_True);
    builder.SetRunParallel(Standard_False);
    builder.SetFuzzyValue(tolerance);
    builder.Build();
    return !builder.HasErrors() && builder.HasModified();
  } catch (const Standard_Failure&) {
    return false;
  }
}

/// From the middle of an edge into a FORWARD face that has it, of length 1; nothing where that cannot be told.
std::optional<gp_Vec> way_in(const TopoDS_Edge& edge, const TopoDS_Face& face, const BRepAdaptor_Surface& surface) {
  const EdgeImage image = image_of(edge, face);
  if (image.curve.IsNull()) return std::nullopt;
  gp_Pnt2d uv;
  gp_Vec2d along;
  image.curve->D1(0.5 * (image.first + image.last), uv, along);
  gp_Pnt x;
  gp_Vec xu, xv;
  surface.D1(uv.X(), uv.Y(), x, xu, xv);
  gp_Vec way = xu.Crossed(xv).Crossed(along.X() * xu + along.Y() * xv);
  if (edge.Orientation() == TopAbs_REVERSED) way.Reverse();
  return way.Magnitude() > 0 ? std::optional(way.Normalized()) : std::nullopt;
}

/// Pairs of faces that leave a common edge the same way: one may lie on the other.
std::set<FacePair> find_folds(const std::vector<const WorkFace*>& faces) {
  constexpr double alike = 0.9998;  // cosine of a degree
  struct Use {
    std::size_t face;
    gp_Vec way;
  };
  TopTools_IndexedMapOfShape edges;
  std::vector<std::vector<Use>> uses(1);
  std::set<FacePair> folds;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const TopoDS_Face plain = forward(faces[f]->face);
    const BRepAdaptor_Surface surface(plain, Standard_False);
    for (const TopoDS_Edge& edge : edges_of(plain)) {
      if (BRep_Tool::Degenerated(edge)) continue;
      const auto way = way_in(edge, plain, surface);
      const auto index = static_cast<std::size_t>(edges.Add(edge));
      if (index == uses.size()) uses.emplace_back();
      if (!way) continue;
      for (const Use& use : uses[index])
        if (use.face != f && use.way.Dot(*way) > alike) folds.insert({use.face, f});
      uses[index].push_back({f, *way});
    }
  }
  return folds;
}

/// Whether each edge of some faces is in two of them, or twice in one.
bool are_closed(const std::vector<const WorkFace*>& faces) {
  TopTools_IndexedDataMapOfShapeListOfShape uses;
  for (const WorkFace* face : faces) TopExp::MapShapesAndAncestors(face->face, TopAbs_EDGE, TopAbs_FACE, uses);
  for (int e = 1; e <= uses.Extent(); ++e)
    if (!BRep_Tool::Degenerated(TopoDS::Edge(uses.FindKey(e))) && uses(e).Extent() != 2) return false;
  return true;
}

/// Pairs of faces from different sheets as read that may touch, the likeliest first: those in one plane, then those
/// without a common edge; with one they are what sewing made of neighbours.
std::vector<FacePair> pairs_that_touch(const std::vector<const WorkFace*>& faces, std::vector<PartPiece>& pieces) {
  std::vector<std::set<int>> edges(faces.size());
  TopTools_IndexedMapOfShape all;
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (const TopoDS_Edge& edge : edges_of(faces[f]->face)) edges[f].insert(all.Add(edge));
  std::array<std::vector<FacePair>, 3> by_rank;
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (std::size_t j = i + 1; j < faces.size(); ++j) {
      if (faces[i]->read_sheet == faces[j]->read_sheet || !may_touch(pieces[i], pieces[j])) continue;
      const bool share = std::ranges::any_of(edges[i], [&](int edge) { return edges[j].contains(edge); });
      by_rank[pieces[i].is_level_with(pieces[j]) ? 0 : share ? 2 : 1].push_back({i, j});
    }
  for (std::size_t rank : {1, 2}) by_rank[0].insert(by_rank[0].end(), by_rank[rank].begin(), by_rank[rank].end());
  return by_rank[0];
}

struct SheetEdge {
  TopoDS_Edge edge;
  std::vector<std::size_t> faces;
  SampledCurve line;
  Bnd_Box box;
};

/// Those that are no poles, by the low ends of their boxes along x.
std::vector<SheetEdge> edges_of_sheet(const std::vector<const WorkFace*>& faces, double tolerance) {
  constexpr int pieces = 32;
  TopTools_IndexedMapOfShape map;
  std::vector<SheetEdge> edges;
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (const TopoDS_Edge& edge : edges_of(faces[f]->face)) {
      const auto index = static_cast<std::size_t>(map.Add(edge)) - 1;
      if (index == edges.size()) edges.push_back({edge, {}, {}, {}});
      edges[index].faces.push_back(f);
    }
  for (SheetEdge& one : edges) {
    const auto curve = BRep_Tool::Degenerated(one.edge) ? nullptr : make_curve(one.edge);
    const auto [t0, t1] = range_of(one.edge);
    if (!curve || !range_of(one.edge).is_finite()) continue;
    one.line = sampled(curve, t0, t1, pieces);
    for (Vec3 x : one.line.points) one.box.Add(to_point(x));
    one.box.Enlarge(tolerance + 0.01 * std::sqrt(one.box.SquareExtent()));  // bows of its pieces
  }
  std::erase_if(edges, [](const SheetEdge& one) { return one.box.IsVoid(); });
  std::ranges::stable_sort(edges, {}, [](const SheetEdge& one) { return one.box.CornerMin().X(); });
  return edges;
}

bool comes_by(const SheetEdge& edge, Vec3 x, double tolerance) {
  if (edge.box.IsOut(to_point(x))) return false;
  const auto& [curve, t, points] = edge.line;
  std::size_t nearest = 1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k < points.size(); ++k)
    if (const double off = distance_to_segment(x, points[k - 1], points[k]); off < least) least = off, nearest = k;
  constexpr int steps = 6;
  return distance_near(edge.line, nearest, 0.5 * (t[nearest - 1] + t[nearest]), steps, x) <= tolerance;
}

/// Pairs of faces with edges that lie on one another and are not one. Sewing joins edges two by two: where bodies touch
/// that come without their solids, more lie in one place, and what is joined may be one's edge and another's.
std::vector<FacePair> pairs_at_doubled_edges(const std::vector<const WorkFace*>& faces, double tolerance) {
  std::vector<FacePair> pairs;
  const std::vector<SheetEdge> edges = edges_of_sheet(faces, tolerance);
  for (const SheetEdge& one : edges) {
    const Vec3 middle = one.line.curve->point(one.line.t[one.line.t.size() / 2]);
    for (const SheetEdge& other : edges) {
      if (other.box.CornerMin().X() > middle.x) break;
      if (&other == &one || !comes_by(other, middle, tolerance)) continue;
      for (std::size_t i : one.faces)
        for (std::size_t j : other.faces)
          if (i != j && faces[i]->read_sheet != faces[j]->read_sheet) pairs.push_back(std::minmax(i, j));
    }
  }
  return pairs;
}

/// Whether a sheet sewn of several has faces of different ones that touch elsewhere than along the seams, or faces that
/// lie on one another from a common edge on. In closed skins only where edges lie on one another: all others are drawn
/// to fit, and the kernel would find no more than what sewing closed.
bool is_loose(const Workpiece& work, int part, double tolerance) {
  std::vector<const WorkFace*> faces;
  for (const WorkFace& face : work.faces)
    if (face.is_usable() && face.has_part(part)) faces.push_back(&face);
  int tries = 0;
  auto is_changed = [&](const FacePair& pair) {
    return ++tries <= most_tries && changes_when_fused(faces[pair.first]->face, faces[pair.second]->face, tolerance);
  };
  if (std::ranges::any_of(find_folds(faces), is_changed)) return true;
  auto is_sewn = [&](const WorkFace* face) { return face->read_sheet != faces[0]->read_sheet; };
  if (std::none_of(faces.begin(), faces.end(), is_sewn)) return false;
  std::vector<PartPiece> pieces;
  for (const WorkFace* face : faces) pieces.emplace_back(face->face, 0.5 * tolerance);
  std::vector<FacePair> pairs = pairs_at_doubled_edges(faces, doubled * tolerance);
  if (!are_closed(faces)) {
    const std::vector<FacePair> more = pairs_that_touch(faces, pieces);
    pairs.insert(pairs.end(), more.begin(), more.end());
  }
  // All faces of a loose sheet are intersected with each other, the free-form ones, too.
  std::erase_if(pairs, [&](const FacePair& pair) {
    return !pieces[pair.first].is_elementary() && !pieces[pair.second].is_elementary();
  });
  for (const FacePair& pair : pairs) {
    if (is_changed(pair)) return true;
    if (tries > most_tries) return false;
  }
  return false;
}

}  // namespace

void find_loose_sheets(Workpiece& work, double tolerance) {
  for (std::size_t p = 0; p < work.parts.size(); ++p)
    if (work.parts[p].solid < 0) work.parts[p].is_loose = is_loose(work, static_cast<int>(p), tolerance);
}

}  // namespace paver
