// Divides faces along the creases of their surfaces: iso-lines where the surface is only C0 and its normal jumps.
// Elements across a crease would fold, so each crease becomes an ordinary edge between two pieces.
// 1. Find the creases: C0 parameters where the normal turns by more than crease_angle somewhere inside the face, and
//    ridges that turn too narrowly for elements to follow (find_ridges).
// 2. A periodic edge that is a crease ends as an ordinary edge once the face has two pieces around it; where no crease
//    lies inside, the face is cut half-way around.
// 3. Divide by the kernel, with one memory of replaced edges: an edge shared with a neighbour is divided once.
//    Rectangular faces go by our own grid, which also leaves out strips of the surface that are pressed flat onto a
//    line (a trailing edge without thickness): the kernel's division fails at these.
// 4. Faces take over the divided edges of their neighbours; every edge keeps the number of the one it came from.
// A face that the kernel cannot divide stays whole.
#include <BRepAdaptor_Surface.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Builder.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeFix_ComposeShell.hxx>
#include <ShapeUpgrade_SplitSurface.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_HSequenceOfReal.hxx>
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
#include "brep/mending/divide_grid_impl.h"
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
/// Of the diagonal: nearer than this to a crease an edge ends there. By the kernel's 1e-7 mm holes across a crease came
/// out with remnants of edges, and their pieces did not close.
constexpr double compose_share = 1e-6;
/// Images of edges that lie further off than this many ranges of the surface are damage: the kernel would cut them at
/// every period on the way, without end.
constexpr double most_turns = 8;

/// Where to cut a face. `creases` counts those inside and the periodic edges that are creases.
struct Cuts {
  std::vector<double> u, v;
  std::array<std::vector<GridSpan>, 2> spans;  ///< between the cuts, in u and in v
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
      const bool closes_in_ridge = add_ridges(is_u, values);
      cuts.creases += static_cast<int>(values.size());
      if (closes_in_ridge || has_sharp_closure(is_u)) {
        ++cuts.creases;
        if (values.empty()) values.push_back(first(is_u) + 0.5 * range(is_u));
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

  /// Elements that lie across a ridge leave the surface. Whether the face closes on itself in one. Faces without a
  /// border are laid as a whole.
  bool add_ridges(bool is_u, std::vector<double>& values) const {
    if (surface_.GetType() < GeomAbs_BezierSurface || !has_border()) return false;
    std::vector<double> vertices;
    for (const TopoDS_Edge& edge : edges_of(face_)) {
      const EdgeImage image = image_of(edge, face_);
      if (image.curve.IsNull()) continue;
      for (const double share : {0.0, 1.0}) vertices.push_back(coordinate(is_u, image.uv(share)));
    }
    const Ridges ridges = find_ridges(surface_, is_u, unresolved_, values, vertices);
    values.insert(values.end(), ridges.inside.begin(), ridges.inside.end());
    std::ranges::sort(values);
    return ridges.at_ends;
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
    give_own_surfaces(cuts);
    TopTools_IndexedMapOfShape edges = edge_map(work_);
    std::vector<DividedFace> divided;
    for (std::size_t i = 0; i < cuts.size(); ++i)
      if (cuts[i].creases > 0 && divide(work_.faces[i], cuts[i]))
        divided.push_back({work_.faces[i].origin, cuts[i].creases});
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

  /// The kernel takes the images on a divided face's surface away from its edges, also from a neighbour on the same
  /// surface, as faces are that were one before something crossed them.
  void give_own_surfaces(const std::vector<Cuts>& cuts) {
    std::map<Handle(Geom_Surface), int> uses;
    auto surface_of = [](const WorkFace& face) {
      TopLoc_Location location;  // where it is asked for, the surface is the one itself and no moved copy
      return BRep_Tool::Surface(face.face, location);
    };
    for (const WorkFace& face : work_.faces) ++uses[surface_of(face)];
    for (std::size_t i = 0; i < cuts.size(); ++i)
      if (cuts[i].creases > 0 && uses[surface_of(work_.faces[i])]-- > 1) give_own_surface(forward(work_.faces[i].face));
  }

  static void give_own_surface(const TopoDS_Face& face) {
    TopLoc_Location location;
    const Handle(Geom_Surface) shared = BRep_Tool::Surface(face, location);
    const auto own = Handle(Geom_Surface)::DownCast(shared->Copy());
    const TopTools_IndexedMapOfShape edges = shapes_of(face, TopAbs_EDGE);
    BRep_Builder builder;
    for (int i = 1; i <= edges.Extent(); ++i) {
      const TopoDS_Edge edge = forward(TopoDS::Edge(edges(i)));
      double first = 0, last = 0;
      const Handle(Geom2d_Curve) image = BRep_Tool::CurveOnSurface(edge, shared, location, first, last);
      if (image.IsNull()) continue;
      const double tolerance = BRep_Tool::Tolerance(edge);
      if (BRep_Tool::IsClosed(edge, shared, location)) {
        const auto reversed = TopoDS::Edge(edge.Reversed());
        const Handle(Geom2d_Curve) other = BRep_Tool::CurveOnSurface(reversed, shared, location, first, last);
        builder.UpdateEdge(edge, image, other, own, location, tolerance);
      } else {
        builder.UpdateEdge(edge, image, own, location, tolerance);
      }
      builder.Range(edge, own, location, first, last);
    }
    builder.UpdateFace(face, own, location, BRep_Tool::Tolerance(face));
  }

  /// False where the kernel fails; the face then stays whole.
  bool divide(const WorkFace& work, const Cuts& cuts) {
    const TopoDS_Face plain = forward(work.face);
    try {
      // Neighbours divided before may have divided edges of this face.
      std::vector<TopoDS_Face> current = faces_of(context_->Apply(plain));
      if (current.size() != 1) return false;
      GridCells grid = divide_grid(current[0], cuts.spans, work_.diagonal);
      if (faces_of(grid.cells).size() > 1) {
        for (const auto& [edge, wire] : grid.divided_edges) context_->Replace(edge, wire);
        context_->Replace(current[0], grid.cells);
        return true;
      }
      if (!has_near_images(current[0])) return false;
      // A trial first: the kernel records divided edges even where it fails.
      Handle(ShapeBuild_ReShape) trial = new ShapeBuild_ReShape;
      const std::vector<double> areas = areas_of(compose(current[0], cuts, work_.diagonal, trial));
      if (!is_sound(areas, work.area)) return false;
      const TopoDS_Shape divided = compose(current[0], cuts, work_.diagonal, context_);
      const std::vector<TopoDS_Face> pieces = faces_of(divided);
      for (std::size_t i = 0; i < std::min(pieces.size(), areas.size()); ++i)
        areas_[pieces[i].TShape().get()] = areas[i];
      context_->Replace(current[0], divided);
      return true;
    } catch (const Standard_Failure&) {
      return false;
    }
  }

  static bool has_near_images(const TopoDS_Face& face) {
    TopLoc_Location location;
    double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
    BRep_Tool::Surface(face, location)->Bounds(u0, u1, v0, v1);
    const double far_u = most_turns * (u1 - u0), far_v = most_turns * (v1 - v0);
    for (const TopoDS_Edge& edge : edges_of(face)) {
      const EdgeImage image = image_of(edge, face);
      if (image.curve.IsNull()) continue;
      for (double t : {image.first, 0.5 * (image.first + image.last), image.last}) {
        const gp_Pnt2d uv = image.curve->Value(t);
        if (std::abs(uv.X() - u0) > far_u || std::abs(uv.Y() - v0) > far_v) return false;
      }
    }
    return true;
  }

  static TopoDS_Shape compose(const TopoDS_Face& face, const Cuts& cuts, double diagonal,
                              const Handle(ShapeBuild_ReShape) & context) {
    TopLoc_Location location;
    Handle(Geom_Surface) surface = BRep_Tool::Surface(face, location);
    double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
    BRepAdaptor_Surface bounds(face);
    surface->Bounds(u0, u1, v0, v1);
    if (Precision::IsInfinite(u0) || Precision::IsInfinite(u1))
      u0 = bounds.FirstUParameter(), u1 = bounds.LastUParameter();
    if (Precision::IsInfinite(v0) || Precision::IsInfinite(v1))
      v0 = bounds.FirstVParameter(), v1 = bounds.LastVParameter();
    ShapeUpgrade_SplitSurface splitter;
    splitter.Init(surface, u0, u1, v0, v1);
    splitter.SetUSplitValues(within(cuts.u, u0, u1));
    splitter.SetVSplitValues(within(cuts.v, v0, v1));
    splitter.Perform(Standard_True);
    ShapeFix_ComposeShell composer;
    composer.Init(splitter.ResSurfaces(), location, face, std::max(Precision::Confusion(), compose_share * diagonal));
    composer.SetContext(context);
    return composer.Perform() ? composer.Result() : TopoDS_Shape();
  }

  /// Values of a periodic surface brought into its own period.
  static Handle(TColStd_HSequenceOfReal) within(const std::vector<double>& values, double low, double high) {
    std::vector<double> moved;
    for (double value : values) moved.push_back(value - (high - low) * std::floor((value - low) / (high - low)));
    std::sort(moved.begin(), moved.end());
    Handle(TColStd_HSequenceOfReal) result = new TColStd_HSequenceOfReal;
    for (double value : moved) result->Append(value);
    return result;
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
