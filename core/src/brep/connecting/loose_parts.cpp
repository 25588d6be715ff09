// Parts that touch themselves: sheets whose faces do elsewhere than along common edges, for which each pair of faces
// that may is given to the kernel, solids likewise where edges of theirs lie on one another, and wires whose edges do
// elsewhere than at common vertices.
#include <BRepAlgoAPI_BuilderAlgo.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "base/box.h"
#include "brep/connecting/connect_impl.h"
#include "brep/connecting/near/face_cells_impl.h"
#include "brep/occt_impl.h"
#include "brep/surfaces/evaluators_impl.h"

namespace paver {
namespace {

/// Pairs of faces of a sewn sheet that are looked at closely; files of more loose faces are skins drawn to fit.
constexpr int most_tries = 200;
/// Edges lie on one another where they are no farther apart than so many times what is sewn.
constexpr double doubled = 4;

using FacePair = std::pair<std::size_t, std::size_t>;

/// Whether faces have more in common than the edges and vertices they share, or edges than vertices.
bool change_when_fused(const TopTools_ListOfShape& arguments, double tolerance) {
  try {
    BRepAlgoAPI_BuilderAlgo builder;
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
  std::shared_ptr<const Curve> curve;
  Vec3 middle;
  Box box;

  SampledCurve line(int pieces) const {
    const auto [t0, t1] = range_of(edge);
    return sampled(curve, t0, t1, pieces);
  }
};

/// Those that have a length.
std::vector<SheetEdge> edges_of_sheet(const std::vector<const WorkFace*>& faces, double tolerance) {
  constexpr int pieces = 16;
  constexpr double bow = 0.05;  // of the edge, beyond these pieces
  TopTools_IndexedMapOfShape map;
  std::vector<SheetEdge> edges;
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (const TopoDS_Edge& edge : edges_of(faces[f]->face)) {
      const auto index = static_cast<std::size_t>(map.Add(edge)) - 1;
      if (index == edges.size()) edges.push_back({edge, {}, {}, {}, {}});
      edges[index].faces.push_back(f);
    }
  for (SheetEdge& one : edges) {
    if (BRep_Tool::Degenerated(one.edge) || !range_of(one.edge).is_finite()) continue;
    one.curve = make_curve(one.edge);
    if (!one.curve) continue;
    const auto [t0, t1] = range_of(one.edge);
    one.middle = one.curve->point(0.5 * (t0 + t1));
    for (Vec3 x : one.line(pieces).points) one.box.add(x);
    const double more = tolerance + bow * norm(one.box.high - one.box.low);
    one.box = one.box.grown(more);
  }
  std::erase_if(edges, [](const SheetEdge& one) { return !one.curve; });
  return edges;
}

bool comes_by(const SheetEdge& edge, Vec3 x, double tolerance) {
  constexpr int pieces = 32, steps = 6;
  return distance_to(edge.line(pieces), steps, x) <= tolerance;
}

/// Calls `visit` with every edge and each other one whose box holds its middle: a sweep along the longest way.
template <class Visit>
void for_near_edges(const std::vector<SheetEdge>& edges, Visit visit) {
  Box all;
  for (const SheetEdge& one : edges) all.add(one.box);
  const Vec3 size = all.high - all.low;
  auto along = [&](Vec3 x) { return size.x >= std::max(size.y, size.z) ? x.x : size.y >= size.z ? x.y : x.z; };
  std::vector<std::size_t> by_low(edges.size()), by_middle(edges.size()), open;
  std::iota(by_low.begin(), by_low.end(), std::size_t{0});
  by_middle = by_low;
  std::ranges::stable_sort(by_low, {}, [&](std::size_t e) { return along(edges[e].box.low); });
  std::ranges::stable_sort(by_middle, {}, [&](std::size_t e) { return along(edges[e].middle); });
  std::size_t next = 0;
  for (std::size_t e : by_middle) {
    const Vec3 x = edges[e].middle;
    while (next < by_low.size() && along(edges[by_low[next]].box.low) <= along(x)) open.push_back(by_low[next++]);
    std::erase_if(open, [&](std::size_t other) { return along(edges[other].box.high) < along(x); });
    for (std::size_t other : open)
      if (other != e && edges[other].box.meets({x, x})) visit(edges[e], edges[other]);
  }
}

/// Whether all that lies between the edges is a face no wider than the tolerance, or one of them is no longer.
bool are_at_sliver(const SheetEdge& one, const SheetEdge& other, const std::vector<const WorkFace*>& faces,
                   double tolerance) {
  const double width = 2 * tolerance, length = edge_length(one.edge);
  return length < width || std::ranges::any_of(one.faces, [&](std::size_t f) {
           return std::ranges::find(other.faces, f) != other.faces.end() && faces[f]->area < width * length;
         });
}

/// Pairs of faces with edges that lie on one another and are not one. Sewing joins edges two by two: where bodies touch
/// that come without their solids, more lie in one place, and what is joined may be one's edge and another's.
template <class IsWanted>
std::set<FacePair> pairs_at_doubled_edges(const std::vector<const WorkFace*>& faces, double tolerance,
                                          IsWanted is_wanted) {
  std::set<FacePair> pairs;
  for_near_edges(edges_of_sheet(faces, tolerance), [&](const SheetEdge& one, const SheetEdge& other) {
    if (!comes_by(other, one.middle, tolerance) || are_at_sliver(one, other, faces, tolerance)) return;
    for (std::size_t i : one.faces)
      for (std::size_t j : other.faces)
        if (i != j && is_wanted(*faces[i], *faces[j])) pairs.insert(std::minmax(i, j));
  });
  return pairs;
}

bool change_when_fused(const TopoDS_Face& one, const TopoDS_Face& other, double tolerance) {
  TopTools_ListOfShape both;
  both.Append(one);
  both.Append(other);
  return change_when_fused(both, tolerance);
}

/// The faces of pairs, and those that may lie on these.
std::set<std::size_t> with_level_faces(const std::vector<const WorkFace*>& faces, const std::set<FacePair>& pairs,
                                       double tolerance) {
  std::vector<PartPiece> pieces;
  for (const WorkFace* face : faces) pieces.emplace_back(face->face, 0.5 * tolerance);
  std::set<std::size_t> found;
  for (const auto& [i, j] : pairs) found.insert({i, j});
  std::vector<std::size_t> open(found.begin(), found.end());
  while (!open.empty()) {
    const std::size_t at = open.back();
    open.pop_back();
    for (std::size_t f = 0; f < faces.size(); ++f)
      if (!found.contains(f) && pieces[f].is_level_with(pieces[at]) && may_touch(pieces[f], pieces[at]))
        found.insert(f), open.push_back(f);
  }
  return found;
}

/// The faces of a solid that lie on one another from a common edge on, as the sides of tabs bent out of a sheet, and
/// those at edges that lie on one another: where pads touch at a corner, programs that know no edge of more than two
/// faces write it twice.
std::set<std::size_t> loose_faces_of_solid(const std::vector<const WorkFace*>& faces, double tolerance) {
  auto all = [](const WorkFace&, const WorkFace&) { return true; };
  std::set<FacePair> pairs = pairs_at_doubled_edges(faces, tolerance, all);
  pairs.merge(find_folds(faces));
  int tries = 0;
  auto is_changed = [&](const FacePair& pair) {
    return ++tries <= most_tries && change_when_fused(faces[pair.first]->face, faces[pair.second]->face, tolerance);
  };
  if (std::ranges::none_of(pairs, is_changed)) return {};
  return with_level_faces(faces, pairs, tolerance);
}

/// Whether a sheet sewn of several has faces of different ones that touch elsewhere than along the seams, or faces that
/// lie on one another from a common edge on. In closed skins only where edges lie on one another: all others are drawn
/// to fit, and the kernel would find no more than what sewing closed.
bool is_loose_sheet(const std::vector<const WorkFace*>& faces, double tolerance) {
  int tries = 0;
  auto is_changed = [&](const FacePair& pair) {
    return ++tries <= most_tries && change_when_fused(faces[pair.first]->face, faces[pair.second]->face, tolerance);
  };
  if (std::ranges::any_of(find_folds(faces), is_changed)) return true;
  auto is_sewn = [&](const WorkFace* face) { return face->read_sheet != faces[0]->read_sheet; };
  if (std::none_of(faces.begin(), faces.end(), is_sewn)) return false;
  const bool is_closed = are_closed(faces);
  auto are_sewn = [](const WorkFace& one, const WorkFace& other) { return one.read_sheet != other.read_sheet; };
  const std::set<FacePair> at_edges = pairs_at_doubled_edges(faces, doubled * tolerance, are_sewn);
  if (is_closed && at_edges.empty()) return false;
  std::vector<FacePair> pairs(at_edges.begin(), at_edges.end());
  std::vector<PartPiece> pieces;
  for (const WorkFace* face : faces) pieces.emplace_back(face->face, 0.5 * tolerance);
  if (!is_closed) {
    const std::vector<FacePair> more = pairs_that_touch(faces, pieces);
    pairs.insert(pairs.end(), more.begin(), more.end());
  }
  // All faces of a loose sheet are intersected with each other, the free-form ones, too. Beside such ones its flat and
  // round splines are ends of bodies.
  const bool is_free_form = !std::ranges::all_of(pieces, &PartPiece::is_elementary);
  auto is_plain = [&](std::size_t f) { return pieces[f].is_elementary() && !(is_free_form && faces[f]->converted); };
  std::erase_if(pairs, [&](const FacePair& pair) { return !is_plain(pair.first) && !is_plain(pair.second); });
  for (const FacePair& pair : pairs) {
    if (is_changed(pair)) return true;
    if (tries > most_tries) return false;
  }
  return false;
}

/// Whether edges of a wire touch elsewhere than at the vertices they share, as of a stub drawn in one go with its line.
/// Not where a vertex is so vague that the kernel would take other places for it.
bool is_loose_wire(const Workpiece& work, int part, double tolerance) {
  constexpr double vague = 1e-3;  // of the edge
  TopTools_ListOfShape edges;
  for (const WorkWire& wire : work.wires) {
    if (wire.part != part) continue;
    for (TopExp_Explorer end(wire.edge, TopAbs_VERTEX); end.More(); end.Next())
      if (BRep_Tool::Tolerance(TopoDS::Vertex(end.Current())) > std::max(tolerance, vague * edge_length(wire.edge)))
        return false;
    edges.Append(wire.edge);
  }
  return edges.Extent() > 1 && change_when_fused(edges, tolerance);
}

}  // namespace

void find_loose_parts(Workpiece& work, double tolerance) {
  std::vector<std::vector<const WorkFace*>> faces(work.parts.size());
  for (const WorkFace& face : work.faces)
    for (const FaceUse& use : face.uses)
      if (face.is_usable()) faces[use.part].push_back(&face);
  for (std::size_t p = 0; p < work.parts.size(); ++p) {
    WorkPart& part = work.parts[p];
    if (part.solid < 0) {
      part.is_loose = is_loose_sheet(faces[p], tolerance) || is_loose_wire(work, static_cast<int>(p), tolerance);
    } else {
      const std::set<std::size_t> loose = loose_faces_of_solid(faces[p], tolerance);
      part.is_loose = !loose.empty();
      for (const std::size_t f : loose) work.faces[faces[p][f] - work.faces.data()].is_loose = true;
    }
  }
}

}  // namespace paver
