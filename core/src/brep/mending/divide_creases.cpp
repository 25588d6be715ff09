// Divides faces along the creases of their surfaces: iso-lines where the surface is only C0 and its normal jumps.
// Elements across a crease would fold, so each crease becomes an ordinary edge between two pieces.
// 1. Find the creases: C0 parameters where the normal turns by more than crease_angle somewhere inside the face, and
//    ridges that turn too narrowly for elements to follow (find_ridges).
// 2. A periodic edge that is a crease ends as an ordinary edge once the face has two pieces around it; where no crease
//    lies inside, the face is cut half-way around.
// 3. Divide, with one memory of replaced edges: an edge shared with a neighbour is divided once. Rectangular faces by a
//    grid (divide_grid), which also leaves out strips of the surface that are pressed flat onto a line (a trailing edge
//    without thickness), others along each crease (divide_along); all along what is no iso-line, last: such a curve
//    ends at vertices that others have made nearby.
// 4. Faces take over the divided edges of their neighbours; every edge keeps the number of the one it came from.
// A face that cannot be divided stays whole.
#include <BRepAdaptor_Surface.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Builder.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>

#include "brep/connecting/workpiece_impl.h"
#include "brep/mending/divide_face_impl.h"
#include "brep/mending/find_ridges_impl.h"
#include "brep/occt_impl.h"
#include "brep/occt_shapes_impl.h"

namespace paver {
namespace {

/// A turn of the normal by more than this is a crease; smaller ones do not hurt elements.
constexpr double crease_angle = 15 * std::numbers::pi / 180;
constexpr int crease_samples = 64;
/// Normals at a crease are taken so far aside, as a share of the face's range.
constexpr double aside_share = 1e-6;
/// Creases nearer than this share of the range to the face's ends are its ends.
constexpr double end_share = 1e-6;
/// Local area, over the diagonal squared and per range in u and v, below which there is no normal.
constexpr double no_normal_share = 1e-9;
constexpr int strip_samples = 8;
/// Pieces that the kernel makes must have the area of their face up to this share; measured across creases it is some
/// parts in a thousand off.
constexpr double area_share = 1e-2;

/// Where to cut a face. `creases` counts those inside and the periodic edges that are creases.
struct Cuts {
  std::vector<double> u, v;
  std::array<std::vector<GridSpan>, 2> spans;   ///< between these, in u and in v
  std::array<std::vector<CutCurve>, 2> curves;  ///< across all rows in u and in v
  int creases = 0;
};

class CreaseFinder {
 public:
  CreaseFinder(const TopoDS_Face& face, double diagonal, double unresolved)
      : face_(face), surface_(face), unresolved_(unresolved) {
    least_normal_ = no_normal_share * diagonal * diagonal / (range(true) * range(false));
  }

  Cuts find() {
    Cuts cuts;
    if (!is_finite()) return cuts;
    used_twice_ = edges_used_twice();
    for (bool is_u : {true, false}) {
      std::vector<double>& values = is_u ? cuts.u : cuts.v;
      values = inner_creases(is_u);
      add_flat_ends(is_u, values);
      const Ridges ridges = find_ridges_of(is_u, values);
      values.insert(values.end(), ridges.iso_lines.begin(), ridges.iso_lines.end());
      std::ranges::sort(values);
      cuts.curves[is_u ? 0 : 1] = ridges.curves;
      cuts.creases += static_cast<int>(values.size() + ridges.curves.size());
      if (ridges.at_ends || has_sharp_closure(is_u)) {
        ++cuts.creases;
        if (values.empty() && ridges.curves.empty()) values.push_back(first(is_u) + 0.5 * range(is_u));
      }
      cuts.spans[is_u ? 0 : 1] = spans(is_u, values);
    }
    return cuts;
  }

 private:
  double first(bool is_u) const { return is_u ? surface_.FirstUParameter() : surface_.FirstVParameter(); }
  double last(bool is_u) const { return is_u ? surface_.LastUParameter() : surface_.LastVParameter(); }
  double range(bool is_u) const { return last(is_u) - first(is_u); }
  double aside(bool is_u) const { return aside_share * range(is_u); }

  bool is_finite() const {
    for (bool is_u : {true, false})
      if (Precision::IsInfinite(first(is_u)) || Precision::IsInfinite(last(is_u))) return false;
    return true;
  }

  std::vector<GridSpan> spans(bool is_u, const std::vector<double>& values) const {
    std::vector<GridSpan> result;
    double low = first(is_u);
    for (double value : values) {
      result.push_back({low, value, is_flat_strip(is_u, low, value)});
      low = value;
    }
    result.push_back({low, last(is_u), is_flat_strip(is_u, low, last(is_u))});
    return result;
  }

  static double coordinate(bool is_u, const gp_Pnt2d& uv) { return is_u ? uv.X() : uv.Y(); }

  /// `along` in the direction asked for, `other` in the other one. Nothing at poles.
  std::optional<gp_Vec> normal(bool is_u, double along, double other) const {
    gp_Pnt point;
    gp_Vec xu, xv;
    surface_.D1(is_u ? along : other, is_u ? other : along, point, xu, xv);
    const gp_Vec across = xu.Crossed(xv);
    if (across.Magnitude() <= least_normal_) return std::nullopt;
    return across;
  }

  static bool is_jump(const std::optional<gp_Vec>& a, const std::optional<gp_Vec>& b) {
    return a && b && a->Angle(*b) > crease_angle;
  }

  std::vector<double> inner_creases(bool is_u) {
    int count = is_u ? surface_.NbUIntervals(GeomAbs_C1) : surface_.NbVIntervals(GeomAbs_C1);
    if (count < 2) return {};
    TColStd_Array1OfReal ends(1, count + 1);
    if (is_u) {
      surface_.UIntervals(ends, GeomAbs_C1);
    } else {
      surface_.VIntervals(ends, GeomAbs_C1);
    }
    std::vector<bool> is_strip(static_cast<std::size_t>(count) + 1, false);
    for (int i = 1; i <= count; ++i) is_strip[i] = is_flat_strip(is_u, ends(i), ends(i + 1));
    std::vector<double> creases;
    for (int i = 2; i <= count; ++i) {
      double margin = end_share * range(is_u);
      bool is_inside = ends(i) > first(is_u) + margin && ends(i) < last(is_u) - margin;
      bool is_strip_end = is_strip[i - 1] != is_strip[i];
      if (is_inside && (is_strip_end || is_crease(is_u, ends(i)))) creases.push_back(ends(i));
    }
    if (std::find(is_strip.begin() + 1, is_strip.end(), false) != is_strip.end())
      divide_between_strips(ends, is_strip, creases);
    return creases;
  }

  /// A face closed by flat strips at both ends needs two pieces between them, for their common edge to be ordinary.
  void divide_between_strips(const TColStd_Array1OfReal& ends, const std::vector<bool>& is_strip,
                             std::vector<double>& creases) const {
    if (creases.empty() || (!is_strip[1] && !is_strip.back())) return;
    double low = is_strip[1] ? creases.front() : ends(1);
    double high = is_strip.back() ? creases.back() : ends(ends.Upper());
    bool is_divided = std::any_of(creases.begin(), creases.end(), [&](double c) { return c > low && c < high; });
    if (!is_divided)
      creases.insert(std::lower_bound(creases.begin(), creases.end(), 0.5 * (low + high)), 0.5 * (low + high));
  }

  bool is_flat_strip(bool is_u, double low, double high) const {
    for (int i = 0; i < strip_samples; ++i) {
      for (int j = 0; j < strip_samples; ++j) {
        double along = low + (high - low) * (i + 0.5) / strip_samples;
        if (normal(is_u, along, first(!is_u) + range(!is_u) * (j + 0.5) / strip_samples)) return false;
      }
    }
    return true;
  }

  bool is_crease(bool is_u, double value) {
    for (int i = 0; i < crease_samples; ++i) {
      double other = first(!is_u) + range(!is_u) * (i + 0.5) / crease_samples;
      auto below = normal(is_u, value - aside(is_u), other), above = normal(is_u, value + aside(is_u), other);
      if (!is_jump(below, above)) continue;
      gp_Pnt2d uv = is_u ? gp_Pnt2d(value, other) : gp_Pnt2d(other, value);
      if (!inside_) inside_.emplace(face_, Precision::PConfusion());  // dear, and few faces have anything to ask
      if (inside_->Perform(uv) != TopAbs_OUT) return true;
    }
    return false;
  }

  /// Where an end is pressed flat, the face is divided so that each piece has an edge there once, and for that at the
  /// place where the border starts: the kernel connects nothing to a face that has an edge twice on one side.
  void add_flat_ends(bool is_u, std::vector<double>& values) const {
    const double margin = end_share * range(is_u);
    auto add = [&](const gp_Pnt2d& uv) {
      const double value = coordinate(is_u, uv);
      const bool is_end = value < first(is_u) + margin || value > last(is_u) - margin;
      const bool is_known = std::ranges::any_of(values, [&](double v) { return std::abs(v - value) <= margin; });
      if (!is_end && !is_known) values.push_back(value);
    };
    for (const TopoDS_Edge& edge : used_twice_) {
      const auto images = both_images(edge);
      if (!images || !lies_on_one_end(!is_u, *images)) continue;
      for (const EdgeImage& image : *images)
        for (const double share : {0.0, 1.0}) add(image.uv(share));
    }
    std::ranges::sort(values);
  }

  /// Elements that lie across a ridge leave the surface. Faces without a border are laid as a whole.
  Ridges find_ridges_of(bool is_u, const std::vector<double>& creases) const {
    if (surface_.GetType() < GeomAbs_BezierSurface || !has_border()) return {};
    std::vector<double> vertices;
    for (const TopoDS_Edge& edge : edges_of(face_)) {
      const EdgeImage image = image_of(edge, face_);
      if (image.curve.IsNull()) continue;
      for (const double share : {0.0, 1.0}) vertices.push_back(coordinate(is_u, image.uv(share)));
    }
    return find_ridges(surface_, is_u, unresolved_, creases, vertices);
  }

  bool has_border() const {
    return std::ranges::any_of(edges_of(face_), [&](const TopoDS_Edge& edge) {
      return !BRep_Tool::Degenerated(edge) &&
             std::ranges::none_of(used_twice_, [&](const TopoDS_Edge& twice) { return twice.IsSame(edge); });
    });
  }

  /// On both sides of an edge that the face uses twice; nothing where one is missing.
  std::optional<std::array<EdgeImage, 2>> both_images(const TopoDS_Edge& edge) const {
    std::array images{image_of(forward(edge), face_), image_of(TopoDS::Edge(edge.Oriented(TopAbs_REVERSED)), face_)};
    if (images[0].curve.IsNull() || images[1].curve.IsNull()) return std::nullopt;
    return images;
  }

  bool lies_on_one_end(bool is_u, const std::array<EdgeImage, 2>& images) const {
    return std::ranges::any_of(std::array{first(is_u), last(is_u)}, [&](double end) {
      return std::ranges::all_of(images, [&](const EdgeImage& image) {
        return std::ranges::all_of(std::array{0.0, 0.5, 1.0}, [&](double share) {
          return std::abs(coordinate(is_u, image.uv(share)) - end) <= end_share * range(is_u);
        });
      });
    });
  }

  /// Whether the face closes on itself in this direction, along a periodic edge that is a crease.
  bool has_sharp_closure(bool is_u) const {
    return std::ranges::any_of(used_twice_, [&](const TopoDS_Edge& edge) {
      // A piece of a face that goes round keeps both images of the periodic edge, but has it on one side only.
      return BRep_Tool::IsClosed(edge, face_) && is_sharp_closure(edge, is_u);
    });
  }

  /// Either use of them.
  std::vector<TopoDS_Edge> edges_used_twice() const {
    std::vector<TopoDS_Edge> edges = edges_of(face_);
    TopTools_DataMapOfShapeInteger uses;
    for (const TopoDS_Edge& edge : edges)
      if (!uses.Bind(edge, 1)) ++uses.ChangeFind(edge);
    std::erase_if(edges, [&](const TopoDS_Edge& edge) { return BRep_Tool::Degenerated(edge) || uses(edge) != 2; });
    return edges;
  }

  bool is_sharp_closure(const TopoDS_Edge& edge, bool is_u) const {
    const auto images = both_images(edge);
    if (!images) return false;
    const auto& [one, two] = *images;
    for (int i = 0; i < crease_samples; ++i) {
      double t = two.first + (two.last - two.first) * (i + 0.5) / crease_samples;
      gp_Pnt2d a = one.curve->Value(t), b = two.curve->Value(t);
      if (coordinate(is_u, b) < coordinate(is_u, a)) std::swap(a, b);
      const double low = coordinate(is_u, a), high = coordinate(is_u, b);
      if (!(high - low > 0.5 * range(is_u))) continue;
      if (is_jump(normal(is_u, low + aside(is_u), coordinate(!is_u, a)),
                  normal(is_u, high - aside(is_u), coordinate(!is_u, b))))
        return true;
    }
    return false;
  }

  const TopoDS_Face& face_;
  BRepAdaptor_Surface surface_;
  double unresolved_;
  std::vector<TopoDS_Edge> used_twice_;
  std::optional<BRepTopAdaptor_FClass2d> inside_;
  double least_normal_ = 0;
};

class CreaseDivider {
 public:
  CreaseDivider(Workpiece& work, double unresolved)
      : work_(work), unresolved_(unresolved), context_(new ShapeBuild_ReShape) {}

  std::vector<DividedFace> run() {
    std::vector<Cuts> cuts = find_cuts();
    if (std::all_of(cuts.begin(), cuts.end(), [](const Cuts& c) { return c.creases == 0; })) return {};
    copy_shape(work_);
    TopTools_IndexedMapOfShape edges = edge_map(work_);
    std::vector<DividedFace> divided;
    std::vector<bool> is_divided(cuts.size());
    for (const bool at_curves : {false, true})
      for (std::size_t i = 0; i < cuts.size(); ++i)
        if (cuts[i].creases > 0 && divide(work_.faces[i], cuts[i], at_curves)) is_divided[i] = true;
    for (std::size_t i = 0; i < cuts.size(); ++i)
      if (is_divided[i]) divided.push_back({work_.faces[i].origin, cuts[i].creases});
    if (divided.empty()) return {};
    replace_faces();
    note_divided_edges(edges);
    work_.is_rebuilt = true;
    return divided;
  }

 private:
  std::vector<Cuts> find_cuts() const {
    std::vector<Cuts> cuts;
    for (const WorkFace& face : work_.faces) {
      cuts.emplace_back();
      if (!face.is_usable()) continue;
      try {
        cuts.back() = CreaseFinder(forward(face.face), work_.diagonal, unresolved_).find();
      } catch (const Standard_Failure&) {
        // Surfaces that cannot be evaluated are reported later, as a fault.
      }
    }
    return cuts;
  }

  /// False where the kernel fails; the face then stays whole.
  bool divide(const WorkFace& work, const Cuts& cuts, bool at_curves) {
    bool is_divided = false;
    try {
      // Neighbours divided before may have divided edges of this face.
      for (const TopoDS_Face& face : faces_of(context_->Apply(forward(work.face))))
        is_divided |= at_curves ? divide_at_curves(face, cuts.curves) : divide_at_values(face, cuts);
    } catch (const Standard_Failure&) {
    }
    return is_divided;
  }

  bool divide_at_values(const TopoDS_Face& face, const Cuts& cuts) {
    if (cuts.u.empty() && cuts.v.empty()) return false;
    const Division grid = divide_grid(face, cuts.spans, work_.diagonal);
    if (faces_of(grid.pieces).size() > 1) {
      replace(face, grid);
      return true;
    }
    return divide_at_curves(face, {iso_lines(face, true, cuts.u), iso_lines(face, false, cuts.v)});
  }

  bool divide_at_curves(const TopoDS_Face& face, const std::array<std::vector<CutCurve>, 2>& curves) {
    bool is_divided = false;
    for (const bool is_u : {true, false})
      for (const TopoDS_Face& piece : faces_of(context_->Apply(face)))
        is_divided |= divide_at_curves(piece, is_u, curves[is_u ? 0 : 1]);
    return is_divided;
  }

  static std::vector<CutCurve> iso_lines(const TopoDS_Face& face, bool is_u, const std::vector<double>& values) {
    const BRepAdaptor_Surface range(face);
    const double first = is_u ? range.FirstVParameter() : range.FirstUParameter();
    const double last = is_u ? range.LastVParameter() : range.LastUParameter();
    std::vector<CutCurve> lines;
    for (const double value : values) lines.push_back({{{first, value}, {last, value}}, 0});
    return lines;
  }

  bool divide_at_curves(const TopoDS_Face& face, bool is_u, const std::vector<CutCurve>& curves) {
    if (curves.empty()) return false;
    const Division division = divide_along(face, is_u, curves, work_.diagonal);
    const std::vector<double> areas = areas_of(division.pieces);
    if (!is_sound(areas, face_area(face))) return false;
    const std::vector<TopoDS_Face> pieces = faces_of(division.pieces);
    for (std::size_t i = 0; i < pieces.size(); ++i) areas_[pieces[i].TShape().get()] = areas[i];
    replace(face, division);
    return true;
  }

  void replace(const TopoDS_Face& face, const Division& division) {
    for (const auto& [edge, wire] : division.divided_edges) context_->Replace(edge, wire);
    context_->Replace(face, division.pieces);
  }

  static std::vector<double> areas_of(const TopoDS_Shape& pieces) {
    std::vector<double> areas;
    for (const TopoDS_Face& piece : faces_of(pieces)) areas.push_back(face_area(piece));
    return areas;
  }

  static bool is_sound(const std::vector<double>& areas, double area) {
    const double sum = std::accumulate(areas.begin(), areas.end(), 0.0);
    return areas.size() > 1 && std::abs(sum - area) <= area_share * area;
  }

  void replace_faces() {
    std::vector<WorkFace> replaced;
    for (WorkFace& face : work_.faces) {
      bool is_reversed = face.face.Orientation() == TopAbs_REVERSED;
      std::vector<TopoDS_Face> pieces = faces_of(context_->Apply(forward(face.face)));
      for (TopoDS_Face& piece : pieces) {
        WorkFace part = face;
        if (is_reversed) piece.Reverse();
        part.face = piece;
        if (pieces.size() > 1) {
          const auto known = areas_.find(piece.TShape().get());
          part.area = known != areas_.end() ? known->second : face_area(piece);
          part.has_area = work_.is_area(part.area);
        }
        replaced.push_back(std::move(part));
      }
      if (pieces.empty()) replaced.push_back(face);
    }
    work_.faces = std::move(replaced);
  }

  void note_divided_edges(const TopTools_IndexedMapOfShape& edges) {
    for (int i = 1; i <= edges.Extent(); ++i) {
      TopoDS_Shape image = context_->Apply(edges(i).Oriented(TopAbs_FORWARD));
      if (!image.IsNull() && !image.IsSame(edges(i))) add_edge_origins(work_, image, edges(i));
    }
  }

  Workpiece& work_;
  double unresolved_;
  Handle(ShapeBuild_ReShape) context_;
  std::map<const TopoDS_TShape*, double> areas_;  // of pieces, as far as they were measured: that takes the most time
};

}  // namespace

std::vector<DividedFace> divide_creases(Workpiece& work, double unresolved) {
  return CreaseDivider(work, unresolved).run();
}

}  // namespace paver
