#include <BRepBndLib.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box2d.hxx>
#include <Geom2d_Line.hxx>
#include <GeomLib_IsPlanarSurface.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>

#include "brep/connecting/near/face_cells_impl.h"

namespace paver {
namespace {

constexpr double open_share = 1e-3;   // of the face: ends of its border that do not meet
constexpr double vague_share = 1e-4;  // of the face
constexpr std::size_t most_edges = 400;
constexpr int most_chords = 4096;  // as long as edges have eight
constexpr int fewest_of_edge = 8, usual_of_edge = 128, most_of_edge = 1024;

/// How faces meet as far as boxes and slabs of their cells tell, which are halved where these meet.
class Meeting {
 public:
  Meeting(const PartPiece& one, const PartPiece& two) : one_(one), two_(two) {}

  bool may_be(const FaceCell& a, const FaceCell& b, int depth = 0) {
    if (are_apart(a, b)) return false;
    if (depth == deepest || ++divided_ > most_divided) return true;
    return any_half(a, b, [&](const FaceCell& c, const FaceCell& d) { return may_be(c, d, depth + 1); });
  }

  /// Whether the cells may run along each other where they meet.
  bool may_be_flat(const FaceCell& a, const FaceCell& b, int depth = 0) {
    if (are_apart(a, b)) return false;
    if (depth == deepest_flat) return sine(a.normal, b.normal) <= flat_sine;
    if (++divided_ > most_divided) return true;
    return any_half(a, b, [&](const FaceCell& c, const FaceCell& d) { return may_be_flat(c, d, depth + 1); });
  }

 private:
  static constexpr int deepest = 40;           // halvings of both together
  static constexpr int deepest_flat = 10;      // cells are flat by then, and there are not many
  static constexpr int most_divided = 100000;  // cells of a pair of faces
  static constexpr double flat_sine = 0.1;

  template <class Test>
  bool any_half(const FaceCell& a, const FaceCell& b, Test test) {
    if (a.box.SquareExtent() > b.box.SquareExtent())
      return std::ranges::any_of(one_.halves(a), [&](const FaceCell& part) { return test(part, b); });
    return std::ranges::any_of(two_.halves(b), [&](const FaceCell& part) { return test(a, part); });
  }

  bool are_apart(const FaceCell& a, const FaceCell& b) const {
    return a.box.IsOut(b.box) || lies_beside(a, b) || lies_beside(b, a) || one_.is_outside(a) || two_.is_outside(b);
  }

  /// Whether one is all on one side of the other's slab.
  static bool lies_beside(const FaceCell& slab, const FaceCell& other) {
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

  static double sine(const gp_XYZ& a, const gp_XYZ& b) {
    const double product = a.Modulus() * b.Modulus();
    return product > 0 ? a.CrossMagnitude(b) / product : 0;
  }

  const PartPiece &one_, &two_;
  int divided_ = 0;
};

/// Whether a test holds for some cell of the one and some of the other.
template <class Test>
bool any_cells(PartPiece& one, PartPiece& two, Test test) {
  return std::ranges::any_of(one.cells(), [&](const FaceCell& a) {
    return !a.box.IsOut(two.box()) && std::ranges::any_of(two.cells(), [&](const FaceCell& b) { return test(a, b); });
  });
}

}  // namespace

FaceBorder::FaceBorder(const TopoDS_Face& face) {
  const TopoDS_Face plain = forward(face);
  const std::vector<TopoDS_Edge> edges = edges_of(plain);
  is_whole_ = edges.size() <= most_edges;
  const int chords =
      std::clamp(most_chords / std::max(static_cast<int>(edges.size()), 1), fewest_of_edge, most_of_edge);
  for (const TopoDS_Edge& edge : edges)
    if (is_whole_) add(image_of(edge, plain), chords);
  if (!is_closed()) chords_.clear();
}

bool FaceBorder::is_outside(const gp_Pnt2d& lo, const gp_Pnt2d& hi) const {
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

// Whether the border may reach between the lines along a chord.
bool FaceBorder::comes_near(const Chord& chord, const gp_Pnt2d& lo, const gp_Pnt2d& hi) {
  const gp_XY way = chord.b.XY() - chord.a.XY(), to = 0.5 * (lo.XY() + hi.XY()) - chord.a.XY(),
              half = 0.5 * (hi.XY() - lo.XY()) + gp_XY(chord.bulge, chord.bulge);
  if (std::abs(to.X() - 0.5 * way.X()) > half.X() + 0.5 * std::abs(way.X()) ||
      std::abs(to.Y() - 0.5 * way.Y()) > half.Y() + 0.5 * std::abs(way.Y()))
    return false;
  return std::abs(way.Crossed(to)) <= std::abs(way.X()) * half.Y() + std::abs(way.Y()) * half.X();
}

// Twice as many chords until bulges are small against the edge: turns of a spiral lie beside one another.
void FaceBorder::add(const EdgeImage& image, int most) {
  if (image.curve.IsNull()) {
    is_whole_ = false;
    return;
  }
  int count = Handle(Geom2d_Line)::DownCast(image.curve).IsNull() ? std::min(most, usual_of_edge) : 1;
  std::vector<Chord> line = chords_of(image, count);
  for (; count > 1 && 2 * count <= most && !are_flat(line); line = chords_of(image, count)) count *= 2;
  chords_.insert(chords_.end(), line.begin(), line.end());
  ends_.push_back(line.front().a);
  ends_.push_back(line.back().b);
}

std::vector<FaceBorder::Chord> FaceBorder::chords_of(const EdgeImage& image, int count) {
  std::vector<Chord> line;
  gp_Pnt2d last = image.uv(0);
  for (int i = 1; i <= count; ++i) {
    const gp_Pnt2d next = image.uv(static_cast<double>(i) / count), middle = image.uv((i - 0.5) / count);
    line.push_back({last, next, 2 * middle.Distance(gp_Pnt2d(0.5 * (last.XY() + next.XY())))});
    last = next;
  }
  return line;
}

bool FaceBorder::are_flat(const std::vector<Chord>& line) {
  constexpr double flat = 1e-3;  // of the box about them
  Bnd_Box2d box;
  for (const Chord& chord : line) box.Add(chord.a), box.Add(chord.b);
  const double most = flat * std::sqrt(box.SquareExtent());
  return std::ranges::all_of(line, [&](const Chord& chord) { return chord.bulge <= most; });
}

bool FaceBorder::is_closed() const {
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

PartPiece::PartPiece(const TopoDS_Shape& shape, double margin) : shape_(shape), margin_(margin) {
  BRepBndLib::Add(shape, box_, Standard_False);
  box_.Enlarge(margin);
  if (shape.ShapeType() != TopAbs_FACE) return;
  surface_.Initialize(TopoDS::Face(shape), Standard_False);
  is_free_form_ = !is_simple();
  const double extent = std::sqrt(box_.SquareExtent());
  is_vague_ = std::ranges::any_of(
      edges_of(shape), [&](const TopoDS_Edge& edge) { return BRep_Tool::Tolerance(edge) > vague_share * extent; });
}

bool PartPiece::is_level_with(const PartPiece& other) const {
  if (surface_.GetType() != GeomAbs_Plane || other.surface_.GetType() != GeomAbs_Plane) return false;
  const gp_Pln plane = surface_.Plane(), second = other.surface_.Plane();
  const double extent = std::sqrt(std::max(box_.SquareExtent(), other.box_.SquareExtent()));
  return plane.Axis().Direction().IsParallel(second.Axis().Direction(), 2 * margin_ / extent) &&
         plane.Distance(gp_Pnt(0.5 * (other.box_.CornerMin().XYZ() + other.box_.CornerMax().XYZ()))) <= 2 * margin_;
}

bool PartPiece::may_be_copy_of(const PartPiece& other) const {
  constexpr double alike = 1e-3;
  if (box_.IsVoid() || other.box_.IsVoid()) return false;
  const double most = alike * std::sqrt(box_.SquareExtent());
  return box_.CornerMin().Distance(other.box_.CornerMin()) <= most &&
         box_.CornerMax().Distance(other.box_.CornerMax()) <= most;
}

bool PartPiece::is_on_surface_of(const PartPiece& other) const {
  constexpr int samples = 5;
  constexpr double slack = 1e-9;  // of ranges that follow each other at a crease
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0, s0 = 0, s1 = 0, t0 = 0, t1 = 0;
  BRepTools::UVBounds(TopoDS::Face(shape_), u0, u1, v0, v1);
  BRepTools::UVBounds(TopoDS::Face(other.shape_), s0, s1, t0, t1);
  u0 = std::max(u0, s0), u1 = std::min(u1, s1), v0 = std::max(v0, t0), v1 = std::min(v1, t1);
  if (u0 > u1 + slack * (s1 - s0) || v0 > v1 + slack * (t1 - t0)) return false;
  for (int i = 0; i < samples; ++i)
    for (int j = 0; j < samples; ++j) {
      const double u = u0 + (u1 - u0) * (i + 0.5) / samples, v = v0 + (v1 - v0) * (j + 0.5) / samples;
      if (surface_.Value(u, v).Distance(other.surface_.Value(u, v)) > margin_ + other.margin_) return false;
    }
  return true;
}

const std::vector<FaceCell>& PartPiece::cells() {
  if (!cells_.empty()) return cells_;
  border_ = FaceBorder(TopoDS::Face(shape_));
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  BRepTools::UVBounds(TopoDS::Face(shape_), u0, u1, v0, v1);
  const auto [along_u, along_v] = divisions({u0, v0}, {u1, v1});
  const double du = (u1 - u0) / along_u, dv = (v1 - v0) / along_v;
  for (int i = 0; i < along_u; ++i)
    for (int j = 0; j < along_v; ++j)
      cells_.push_back(cell({u0 + i * du, v0 + j * dv}, {u0 + (i + 1) * du, v0 + (j + 1) * dv}));
  return cells_;
}

std::array<FaceCell, 2> PartPiece::halves(const FaceCell& whole) const {
  const auto& [a, b, c, d] = whole.corners;
  const gp_Pnt2d &lo = whole.lo, &hi = whole.hi, middle(0.5 * (lo.XY() + hi.XY()));
  if ((b - a).Modulus() + (c - d).Modulus() > (d - a).Modulus() + (c - b).Modulus())
    return {cell(lo, {middle.X(), hi.Y()}), cell({middle.X(), lo.Y()}, hi)};
  return {cell(lo, {hi.X(), middle.Y()}), cell({lo.X(), middle.Y()}, hi)};
}

// Elementary, or one that a file has as a swept surface or a flat spline.
bool PartPiece::is_simple() const {
  const GeomAbs_SurfaceType type = surface_.GetType();
  if (type == GeomAbs_SurfaceOfRevolution || type == GeomAbs_SurfaceOfExtrusion)
    return surface_.BasisCurve()->GetType() <= GeomAbs_Circle;
  if (type <= GeomAbs_Torus) return true;
  try {
    return GeomLib_IsPlanarSurface(BRep_Tool::Surface(TopoDS::Face(shape_)), Precision::Confusion()).IsPlanar();
  } catch (const Standard_Failure&) {  // its normals cancel out: a ruled surface twisted by half a turn
    return false;
  }
}

// So many that bulges of cells can be told, and fewer across a strip.
std::array<int, 2> PartPiece::divisions(const gp_Pnt2d& lo, const gp_Pnt2d& hi) const {
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

FaceCell PartPiece::cell(gp_Pnt2d lo, gp_Pnt2d hi) const {
  constexpr double sag_factor = 2;  // of how far the middle is from the corners' mean
  std::array<gp_XYZ, 9> x;
  FaceCell cell{lo, hi, {}, {}, 0, {}};
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

bool crosses(PartPiece& one, PartPiece& two) {
  Meeting meeting(one, two);
  return !any_cells(one, two, [&](const FaceCell& a, const FaceCell& b) { return meeting.may_be_flat(a, b); });
}

bool may_touch(PartPiece& one, PartPiece& two) {
  if (one.box().IsOut(two.box())) return false;
  if (!one.is_face() || !two.is_face()) {
    PartPiece &face = one.is_face() ? one : two, &other = one.is_face() ? two : one;
    return !face.is_face() ||
           std::ranges::any_of(face.cells(), [&](const FaceCell& cell) { return !cell.box.IsOut(other.box()); });
  }
  Meeting meeting(one, two);
  return any_cells(one, two, [&](const FaceCell& a, const FaceCell& b) { return meeting.may_be(a, b); });
}

}  // namespace paver
