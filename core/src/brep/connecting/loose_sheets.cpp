// Sheets whose faces touch elsewhere than along common edges: each pair of faces that may is given to the kernel.
#include <BRepAlgoAPI_BuilderAlgo.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "brep/connecting/connect_impl.h"
#include "brep/connecting/face_cells_impl.h"

namespace paver {
namespace {

/// Pairs of faces of a sewn sheet that are looked at closely; files of more loose faces are skins drawn to fit.
constexpr int most_tries = 200;

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
std::set<std::pair<std::size_t, std::size_t>> find_folds(const std::vector<const WorkFace*>& faces) {
  constexpr double alike = 0.9998;  // cosine of a degree
  struct Use {
    std::size_t face;
    gp_Vec way;
  };
  TopTools_IndexedMapOfShape edges;
  std::vector<std::vector<Use>> uses(1);
  std::set<std::pair<std::size_t, std::size_t>> folds;
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

/// Whether a sheet sewn of several has faces of different ones that touch elsewhere than along the seams, or faces that
/// lie on one another from a common edge on. Closed skins are drawn to fit: there the kernel would find no more than
/// what sewing closed.
bool is_loose(const Workpiece& work, int part, double tolerance) {
  std::vector<const WorkFace*> faces;
  for (const WorkFace& face : work.faces)
    if (face.is_usable() && face.has_part(part)) faces.push_back(&face);
  int tries = 0;
  auto is_changed = [&](std::size_t i, std::size_t j) {
    return ++tries <= most_tries && changes_when_fused(faces[i]->face, faces[j]->face, tolerance);
  };
  for (const auto& [i, j] : find_folds(faces))
    if (is_changed(i, j)) return true;
  auto is_sewn = [&](const WorkFace* face) { return face->read_sheet != faces[0]->read_sheet; };
  if (std::none_of(faces.begin(), faces.end(), is_sewn) || are_closed(faces)) return false;
  std::vector<PartPiece> pieces;
  for (const WorkFace* face : faces) pieces.emplace_back(face->face, 0.5 * tolerance);
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (std::size_t j = i + 1; j < faces.size(); ++j) {
      if (faces[i]->read_sheet == faces[j]->read_sheet || !may_touch(pieces[i], pieces[j])) continue;
      // All faces of a loose sheet are intersected with each other, the free-form ones, too.
      if (!pieces[i].is_elementary() && !pieces[j].is_elementary()) continue;
      if (is_changed(i, j)) return true;
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
