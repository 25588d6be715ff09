// Which parts may touch: boxes of parts, then of faces, then boxes and slabs of the cells of a grid over each bent
// face, halved where they meet: a face within the bulge of another one, or along it, is not taken for touching it.
#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_BuilderAlgo.hxx>
#include <BRepBndLib.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Bnd_Box2d.hxx>
#include <Geom2d_Line.hxx>
#include <GeomLib_IsPlanarSurface.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "brep/connecting/connect_impl.h"
#include "brep/occt_shapes_impl.h"

namespace paver {
namespace {

/// Pairs of faces of a sewn sheet that are looked at closely; files of more loose faces are skins drawn to fit.
constexpr int most_tries = 200;

/// A part of a face between lines of its (u, v).
struct Cell {
  gp_Pnt2d lo, hi;
  std::array<gp_XYZ, 4> corners;
  gp_XYZ normal;   ///< of the corners' diagonals, of any length
  double sag = 0;  ///< how far it may bulge from its corners' hull, and half of what counts as touching
  Bnd_Box box;
};

/// The border of a face in (u, v), as chords.
class Border {
 public:
  Border() = default;
  explicit Border(const TopoDS_Face& face) {
    const TopoDS_Face plain = forward(face);
    const std::vector<TopoDS_Edge> edges = edges_of(plain);
    is_whole_ = edges.size() <= most_edges;
    const int chords = std::clamp(most_chords / std::max(static_cast<int>(edges.size()), 1), 8, 128);
    for (const TopoDS_Edge& edge : edges)
      if (is_whole_) add(image_of(edge, plain), chords);
    if (!is_closed()) chords_.clear();
  }

  /// Whether the face has nothing between two lines of u and two of v; never where its border does not tell.
  bool is_outside(const gp_Pnt2d& lo, const gp_Pnt2d& hi) const {
    if (chords_.empty()) return false;
    bool is_inside = false;
    const gp_Pnt2d middle(0.5 * (lo.XY() + hi.XY()));
    for (const Chord& chord : chords_) {
      if (comes_near(chord, lo, hi)) return false;
      const gp_Pnt2d &a = chord.a, &b = chord.b;
      if ((a.Y() > middle.Y()) != (b.Y() > middle.Y()) &&
          middle.X() < a.X() + (b.X() - a.X()) * (middle.Y() - a.Y()) / (b.Y() - a.Y()))
        is_inside = !is_inside;
    }
    return !is_inside;
  }

 private:
  static constexpr double open_share = 1e-3;  // of the face: ends that do not meet
  static constexpr std::size_t most_edges = 400;
  static constexpr int most_chords = 4096;  // as long as edges have eight

  struct Chord {
    gp_Pnt2d a, b;
    double bulge = 0;  // the border is no farther from it
  };

  /// Whether the border may reach between the lines along a chord.
  static bool comes_near(const Chord& chord, const gp_Pnt2d& lo, const gp_Pnt2d& hi) {
    const gp_XY way = chord.b.XY() - chord.a.XY(), to = 0.5 * (lo.XY() + hi.XY()) - chord.a.XY(),
                half = 0.5 * (hi.XY() - lo.XY()) + gp_XY(chord.bulge, chord.bulge);
    if (std::abs(to.X() - 0.5 * way.X()) > half.X() + 0.5 * std::abs(way.X()) ||
        std::abs(to.Y() - 0.5 * way.Y()) > half.Y() + 0.5 * std::abs(way.Y()))
      return false;
    return std::abs(way.Crossed(to)) <= std::abs(way.X()) * half.Y() + std::abs(way.Y()) * half.X();
  }

  void add(const EdgeImage& image, int chords) {
    if (image.curve.IsNull()) {
      is_whole_ = false;
      return;
    }
    const int count = Handle(Geom2d_Line)::DownCast(image.curve).IsNull() ? chords : 1;
    gp_Pnt2d last = image.uv(0);
    ends_.push_back(last);
    for (int i = 1; i <= count; ++i) {
      const gp_Pnt2d next = image.uv(static_cast<double>(i) / count), middle = image.uv((i - 0.5) / count);
      chords_.push_back({last, next, 2 * middle.Distance(gp_Pnt2d(0.5 * (last.XY() + next.XY())))});
      last = next;
    }
    ends_.push_back(last);
  }

  bool is_closed() const {
    if (!is_whole_) return false;
    Bnd_Box2d box;
    for (const gp_Pnt2d& end : ends_) box.Add(end);
    const double most = open_share * std::sqrt(box.SquareExtent());
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      bool has_other = false;
      for (std::size_t k = 0; k < ends_.size() && !has_other; ++k)
        has_other = k != i && ends_[i].Distance(ends_[k]) <= most;
      if (!has_other) return false;
    }
    return true;
  }

  std::vector<Chord> chords_;
  std::vector<gp_Pnt2d> ends_;  // of edges
  bool is_whole_ = true;
};

/// A face, wire or point of a part. Wires and points are boxes.
class Piece {
 public:
  Piece(const TopoDS_Shape& shape, double margin) : shape_(shape), margin_(margin) {
    BRepBndLib::Add(shape, box_, Standard_False);
    box_.Enlarge(margin);
    if (shape.ShapeType() != TopAbs_FACE) return;
    surface_.Initialize(TopoDS::Face(shape), Standard_False);
    is_free_form_ = !is_simple();
  }

  const Bnd_Box& box() const { return box_; }
  bool is_free_form() const { return is_free_form_; }
  /// As far as boxes tell: the kernel finds copies by their edges, whatever their surface.
  bool may_be_copy_of(const Piece& other) const {
    constexpr double alike = 1e-3;
    if (box_.IsVoid() || other.box_.IsVoid()) return false;
    const double most = alike * std::sqrt(box_.SquareExtent());
    return box_.CornerMin().Distance(other.box_.CornerMin()) <= most &&
           box_.CornerMax().Distance(other.box_.CornerMax()) <= most;
  }
  bool is_face() const { return shape_.ShapeType() == TopAbs_FACE; }

  const std::vector<Cell>& cells() {
    if (!cells_.empty()) return cells_;
    border_ = Border(TopoDS::Face(shape_));
    double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
    BRepTools::UVBounds(TopoDS::Face(shape_), u0, u1, v0, v1);
    const auto [along_u, along_v] = divisions({u0, v0}, {u1, v1});
    const double du = (u1 - u0) / along_u, dv = (v1 - v0) / along_v;
    for (int i = 0; i < along_u; ++i)
      for (int j = 0; j < along_v; ++j)
        cells_.push_back(cell({u0 + i * du, v0 + j * dv}, {u0 + (i + 1) * du, v0 + (j + 1) * dv}));
    return cells_;
  }

  /// Whether the cell lies beside the face.
  bool is_outside(const Cell& cell) const { return border_.is_outside(cell.lo, cell.hi); }

  /// Across the way in which it is longer.
  std::array<Cell, 2> halves(const Cell& whole) const {
    const auto& [a, b, c, d] = whole.corners;
    const gp_Pnt2d &lo = whole.lo, &hi = whole.hi, middle(0.5 * (lo.XY() + hi.XY()));
    if ((b - a).Modulus() + (c - d).Modulus() > (d - a).Modulus() + (c - b).Modulus())
      return {cell(lo, {middle.X(), hi.Y()}), cell({middle.X(), lo.Y()}, hi)};
    return {cell(lo, {hi.X(), middle.Y()}), cell({lo.X(), middle.Y()}, hi)};
  }

 private:
  /// Elementary, or one that a file has as a swept surface or a flat spline.
  bool is_simple() const {
    const GeomAbs_SurfaceType type = surface_.GetType();
    if (type == GeomAbs_SurfaceOfRevolution || type == GeomAbs_SurfaceOfExtrusion)
      return surface_.BasisCurve()->GetType() <= GeomAbs_Circle;
    return type <= GeomAbs_Torus ||
           GeomLib_IsPlanarSurface(BRep_Tool::Surface(TopoDS::Face(shape_)), Precision::Confusion()).IsPlanar();
  }

  /// So many that bulges of cells can be told, and fewer across a strip.
  std::array<int, 2> divisions(const gp_Pnt2d& lo, const gp_Pnt2d& hi) const {
    constexpr int most = 16, least = 4;
    if (surface_.GetType() == GeomAbs_Plane) return {1, 1};
    auto at = [&](int i, int j) {
      return surface_.Value(lo.X() + i * (hi.X() - lo.X()) / most, lo.Y() + j * (hi.Y() - lo.Y()) / most);
    };
    double along_u = 0, along_v = 0;
    for (int i = 0; i < most; ++i) {
      along_u += at(i, most / 2).Distance(at(i + 1, most / 2));
      along_v += at(most / 2, i).Distance(at(most / 2, i + 1));
    }
    auto share = [&](double one, double other) {
      return one < other ? std::max(least, static_cast<int>(std::ceil(most * one / other))) : most;
    };
    return {share(along_u, along_v), share(along_v, along_u)};
  }

  Cell cell(gp_Pnt2d lo, gp_Pnt2d hi) const {
    constexpr double sag_factor = 2;  // of how far the middle is from the corners' mean
    std::array<gp_XYZ, 9> x;
    Cell cell{lo, hi, {}, {}, 0, {}};
    for (std::size_t k = 0; k < 9; ++k) {
      const double i = 0.5 * static_cast<double>(k % 3), j = 0.5 * static_cast<double>(k / 3);
      x[k] = surface_.Value(lo.X() + i * (hi.X() - lo.X()), lo.Y() + j * (hi.Y() - lo.Y())).XYZ();
      cell.box.Add(gp_Pnt(x[k]));
    }
    cell.corners = {x[0], x[2], x[8], x[6]};
    cell.normal = (x[8] - x[0]).Crossed(x[6] - x[2]);
    cell.sag = margin_ + sag_factor * (x[4] - 0.25 * (x[0] + x[2] + x[8] + x[6])).Modulus();
    cell.box.Enlarge(cell.sag);
    return cell;
  }

  TopoDS_Shape shape_;
  double margin_;
  Bnd_Box box_;
  BRepAdaptor_Surface surface_;
  bool is_free_form_ = false;
  std::vector<Cell> cells_;
  Border border_;
};

/// Whether faces touch as far as boxes and slabs of their cells tell, which are halved where these meet.
class Meeting {
 public:
  Meeting(const Piece& one, const Piece& two) : one_(one), two_(two) {}

  bool may_be(const Cell& a, const Cell& b, int depth = 0) {
    if (a.box.IsOut(b.box) || lies_beside(a, b) || lies_beside(b, a) || one_.is_outside(a) || two_.is_outside(b))
      return false;
    if (depth == deepest || ++divided_ > most_divided) return true;
    if (a.box.SquareExtent() > b.box.SquareExtent())
      return std::ranges::any_of(one_.halves(a), [&](const Cell& part) { return may_be(part, b, depth + 1); });
    return std::ranges::any_of(two_.halves(b), [&](const Cell& part) { return may_be(a, part, depth + 1); });
  }

 private:
  static constexpr int deepest = 40;           // halvings of both together
  static constexpr int most_divided = 100000;  // cells of a pair of faces

  /// Whether one is all on one side of the other's slab.
  static bool lies_beside(const Cell& slab, const Cell& other) {
    const double length = slab.normal.Modulus();
    if (!(length > 0)) return false;
    double lo = INFINITY, hi = -INFINITY, other_lo = INFINITY, other_hi = -INFINITY;
    for (std::size_t k = 0; k < 4; ++k) {
      const double at = slab.normal.Dot(slab.corners[k]) / length, there = slab.normal.Dot(other.corners[k]) / length;
      lo = std::min(lo, at), hi = std::max(hi, at);
      other_lo = std::min(other_lo, there), other_hi = std::max(other_hi, there);
    }
    const double between = std::max(other_lo - hi, lo - other_hi);
    return between > slab.sag + other.sag;
  }

  const Piece &one_, &two_;
  int divided_ = 0;
};

bool may_touch(Piece& one, Piece& two) {
  if (one.box().IsOut(two.box())) return false;
  if (!one.is_face() || !two.is_face()) {
    Piece &face = one.is_face() ? one : two, &other = one.is_face() ? two : one;
    return !face.is_face() ||
           std::ranges::any_of(face.cells(), [&](const Cell& cell) { return !cell.box.IsOut(other.box()); });
  }
  Meeting meeting(one, two);
  for (const Cell& a : one.cells())
    if (!a.box.IsOut(two.box()))
      for (const Cell& b : two.cells())
        if (meeting.may_be(a, b)) return true;
  return false;
}

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

/// From the middle of an edge into a FORWARD face that has it, of length 1; nothing where that cannot be told.
std::optional<gp_Vec> way_in(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  const EdgeImage image = image_of(edge, face);
  if (image.curve.IsNull()) return std::nullopt;
  gp_Pnt2d uv;
  gp_Vec2d along;
  image.curve->D1(0.5 * (image.first + image.last), uv, along);
  gp_Pnt x;
  gp_Vec xu, xv;
  BRepAdaptor_Surface(face, Standard_False).D1(uv.X(), uv.Y(), x, xu, xv);
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
    for (const TopoDS_Edge& edge : edges_of(plain)) {
      if (BRep_Tool::Degenerated(edge)) continue;
      const auto way = way_in(edge, plain);
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
  std::vector<Piece> pieces;
  for (const WorkFace* face : faces) pieces.emplace_back(face->face, 0.5 * tolerance);
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (std::size_t j = i + 1; j < faces.size(); ++j) {
      if (faces[i]->read_sheet == faces[j]->read_sheet || !may_touch(pieces[i], pieces[j])) continue;
      if (pieces[i].is_free_form() && pieces[j].is_free_form()) continue;
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
  auto has_copy = [](const Piece& piece, const std::vector<Piece>& others) {
    return std::ranges::any_of(others, [&](const Piece& other) { return piece.may_be_copy_of(other); });
  };
  auto nearness = [&](std::size_t a, std::size_t b) {
    if (whole[a].IsVoid() || whole[b].IsVoid() || whole[a].IsOut(whole[b])) return Nearness::apart;
    const bool are_solids = work.parts[a].solid >= 0 && work.parts[b].solid >= 0;
    Nearness found = Nearness::apart;
    for (Piece& one : pieces[a]) {
      if (one.box().IsOut(whole[b])) continue;
      for (Piece& two : pieces[b]) {
        const bool is_hard = !are_solids && one.is_free_form() && two.is_free_form() && !has_copy(one, pieces[b]) &&
                             !has_copy(two, pieces[a]);
        if (found == Nearness::near && !is_hard) continue;
        if (!may_touch(one, two)) continue;
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
