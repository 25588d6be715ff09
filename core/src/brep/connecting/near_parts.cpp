// Which parts may touch: boxes of parts, then of faces, then of the cells of a grid over each bent face, so that a face
// within the bulge of another one is not taken for touching it.
#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_BuilderAlgo.hxx>
#include <BRepBndLib.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>

#include "brep/connecting/connect_impl.h"

namespace paver {
namespace {

constexpr int cells = 16;  // per direction
/// Pairs of faces of a sewn sheet that are looked at closely; files of more loose faces are skins drawn to fit.
constexpr int most_tries = 200;
constexpr double sag_factor = 2;  // what a cell's box grows by, of how far its middle is from its corners' mean

/// A face, wire or point of a part.
class Piece {
 public:
  Piece(const TopoDS_Shape& shape, double margin) : shape_(shape), margin_(margin) {
    BRepBndLib::Add(shape, box_, Standard_False);
    box_.Enlarge(margin);
    if (shape.ShapeType() != TopAbs_FACE) return;
    BRepAdaptor_Surface surface(TopoDS::Face(shape), Standard_False);
    is_flat_ = surface.GetType() == GeomAbs_Plane;
    is_free_form_ = surface.GetType() > GeomAbs_Torus;
  }

  const Bnd_Box& box() const { return box_; }
  bool is_free_form() const { return is_free_form_; }

  bool may_touch(Piece& other) {
    if (box_.IsOut(other.box_)) return false;
    for (const Bnd_Box& one : fine_boxes())
      if (!one.IsOut(other.box_))
        for (const Bnd_Box& two : other.fine_boxes())
          if (!one.IsOut(two)) return true;
    return false;
  }

 private:
  const std::vector<Bnd_Box>& fine_boxes() {
    if (!fine_.empty()) return fine_;
    if (is_flat_ || shape_.ShapeType() != TopAbs_FACE) {
      fine_.push_back(box_);
    } else {
      add_cells();
    }
    return fine_;
  }

  void add_cells() {
    const TopoDS_Face face = TopoDS::Face(shape_);
    BRepAdaptor_Surface surface(face, Standard_False);
    double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
    BRepTools::UVBounds(face, u0, u1, v0, v1);
    auto at = [&](double i, double j) { return surface.Value(u0 + (u1 - u0) * i / cells, v0 + (v1 - v0) * j / cells); };
    for (int i = 0; i < cells; ++i)
      for (int j = 0; j < cells; ++j) {
        Bnd_Box& box = fine_.emplace_back();
        gp_XYZ mean(0, 0, 0);
        for (double di : {0.0, 0.5, 1.0})
          for (double dj : {0.0, 0.5, 1.0}) {
            gp_Pnt point = at(i + di, j + dj);
            box.Add(point);
            if (di != 0.5 && dj != 0.5) mean += 0.25 * point.XYZ();
          }
        box.Enlarge(margin_ + sag_factor * (at(i + 0.5, j + 0.5).XYZ() - mean).Modulus());
      }
  }

  TopoDS_Shape shape_;
  double margin_;
  Bnd_Box box_;
  bool is_flat_ = false, is_free_form_ = false;
  std::vector<Bnd_Box> fine_;
};

enum class Nearness { apart, near, free_form };

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

/// Whether each edge of some faces is in two of them, or twice in one.
bool are_closed(const std::vector<const WorkFace*>& faces) {
  TopTools_IndexedDataMapOfShapeListOfShape uses;
  for (const WorkFace* face : faces) TopExp::MapShapesAndAncestors(face->face, TopAbs_EDGE, TopAbs_FACE, uses);
  for (int e = 1; e <= uses.Extent(); ++e)
    if (!BRep_Tool::Degenerated(TopoDS::Edge(uses.FindKey(e))) && uses(e).Extent() < 2) return false;
  return true;
}

/// Whether a sheet sewn of several has faces of different ones that touch elsewhere than along the seams. Closed skins
/// are drawn to fit: there the kernel would find no more than what sewing closed.
bool is_loose(const Workpiece& work, int part, double tolerance) {
  std::vector<const WorkFace*> faces;
  for (const WorkFace& face : work.faces)
    if (face.is_usable() && face.has_part(part)) faces.push_back(&face);
  auto is_sewn = [&](const WorkFace* face) { return face->read_sheet != faces[0]->read_sheet; };
  if (std::none_of(faces.begin(), faces.end(), is_sewn) || are_closed(faces)) return false;
  std::vector<Piece> pieces;
  for (const WorkFace* face : faces) pieces.emplace_back(face->face, 0.5 * tolerance);
  int tries = 0;
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (std::size_t j = i + 1; j < faces.size(); ++j) {
      if (faces[i]->read_sheet == faces[j]->read_sheet || !pieces[i].may_touch(pieces[j])) continue;
      if (pieces[i].is_free_form() && pieces[j].is_free_form()) continue;
      if (++tries > most_tries) return false;
      if (changes_when_fused(faces[i]->face, faces[j]->face, tolerance)) return true;
    }
  return false;
}

}  // namespace

void find_loose_sheets(Workpiece& work, double tolerance) {
  for (std::size_t p = 0; p < work.parts.size(); ++p)
    if (work.parts[p].solid < 0) work.parts[p].is_loose = is_loose(work, static_cast<int>(p), tolerance);
}

NearParts find_near_parts(const Workpiece& work, double tolerance) {
  std::vector<Bnd_Box> whole(work.parts.size());
  std::vector<std::vector<Piece>> pieces(work.parts.size());
  auto add = [&](const TopoDS_Shape& shape, int part) {
    pieces[static_cast<std::size_t>(part)].emplace_back(shape, 0.5 * tolerance);
    whole[static_cast<std::size_t>(part)].Add(pieces[static_cast<std::size_t>(part)].back().box());
  };
  for (const WorkFace& face : work.faces)
    if (face.is_usable())
      for (const FaceUse& use : face.uses) add(face.face, use.part);
  for (const WorkWire& wire : work.wires) add(wire.edge, wire.part);
  for (const WorkPoint& point : work.points)
    if (!point.is_end) add(point.vertex, point.part);
  auto nearness = [&](std::size_t a, std::size_t b) {
    if (whole[a].IsVoid() || whole[b].IsVoid() || whole[a].IsOut(whole[b])) return Nearness::apart;
    const bool are_solids = work.parts[a].solid >= 0 && work.parts[b].solid >= 0;
    Nearness found = Nearness::apart;
    for (Piece& one : pieces[a]) {
      if (one.box().IsOut(whole[b])) continue;
      for (Piece& two : pieces[b]) {
        const bool is_hard = !are_solids && one.is_free_form() && two.is_free_form();
        if (found == Nearness::near && !is_hard) continue;
        if (!one.may_touch(two)) continue;
        if (is_hard) return Nearness::free_form;
        found = Nearness::near;
      }
    }
    return found;
  };
  NearParts near;
  for (std::size_t a = 0; a < work.parts.size(); ++a)
    for (std::size_t b = a + 1; b < work.parts.size(); ++b) {
      const Nearness found = nearness(a, b);
      if (found == Nearness::apart) continue;
      (found == Nearness::near ? near.pairs : near.free_form).push_back({static_cast<int>(a), static_cast<int>(b)});
    }
  return near;
}

}  // namespace paver
