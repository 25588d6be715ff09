// Parts that match: all that they have in common are whole faces, edges and vertices, as of blocks in a grid. These
// need no fuse, which takes time that grows with the square of their number.
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <TopoDS_Iterator.hxx>
#include <algorithm>
#include <cmath>
#include <map>

#include "base/boxes/box_pairs.h"
#include "brep/connecting/connect_impl.h"
#include "brep/occt_impl.h"
#include "brep/occt_shapes_impl.h"

namespace paver {
namespace {

/// Of the tolerance: what is farther apart is apart for sure.
constexpr double clear_factor = 10;

/// A flat face with one convex loop of straight edges.
struct Polygon {
  int face = -1;             ///< of the work
  std::vector<int> corners;  ///< in the order of the loop
  std::vector<int> sides;    ///< the edge from each corner to the next one
  Vec3 normal;
  Box box;
};

/// The loop in order, of a face that may be a polygon; empty: it is none.
std::vector<TopoDS_Edge> loop_of(const TopoDS_Face& face) {
  const std::vector<TopoDS_Wire> wires = wires_of(face);
  if (wires.size() != 1 || Handle(Geom_Plane)::DownCast(untrimmed(BRep_Tool::Surface(face))).IsNull()) return {};
  std::vector<TopoDS_Edge> edges;
  for (TopoDS_Iterator it(wires[0]); it.More(); it.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(it.Value());
    if (!is_bounding(edge) || BRep_Tool::Degenerated(edge)) return {};
    double first = 0, last = 0;
    if (Handle(Geom_Line)::DownCast(untrimmed(BRep_Tool::Curve(edge, first, last))).IsNull()) return {};
    edges.push_back(edge);
  }
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const TopoDS_Vertex end = TopExp::LastVertex(edges[i], Standard_True);
    const auto next = std::find_if(edges.begin() + i + 1, edges.end(), [&](const TopoDS_Edge& edge) {
      return TopExp::FirstVertex(edge, Standard_True).IsSame(end);
    });
    if (next == edges.end()) return {};
    std::iter_swap(edges.begin() + i + 1, next);
  }
  if (edges.size() < 3 ||
      !TopExp::LastVertex(edges.back(), Standard_True).IsSame(TopExp::FirstVertex(edges[0], Standard_True)))
    return {};
  return edges;
}

class MatchingParts {
 public:
  MatchingParts(const Workpiece& work, const std::vector<int>& parts, double tolerance)
      : work_(work), parts_(parts), tolerance_(tolerance), clear_(clear_factor * tolerance) {}

  std::optional<Fusion> run(const std::vector<PartPair>& pairs, const Progress& progress) {
    if (!list_polygons() || !match_corners()) return std::nullopt;
    match_sides();
    for (const PartPair& pair : pairs) {
      progress.check();
      for (const int a : of_part_[pair[0]])
        for (const int b : of_part_[pair[1]])
          if (!match(polygons_[a], polygons_[b])) return std::nullopt;
    }
    return fusion();
  }

 private:
  bool list_polygons() {
    const std::vector<char> is_member = marked_parts(work_, parts_);
    for (const int part : parts_)
      if (work_.parts[part].is_loose) return false;
    if (std::ranges::any_of(work_.wires, [&](const WorkWire& wire) { return is_member[wire.part]; }) ||
        std::ranges::any_of(work_.points, [&](const WorkPoint& point) { return is_member[point.part]; }))
      return false;
    of_part_.resize(work_.parts.size());
    for (std::size_t f = 0; f < work_.faces.size(); ++f) {
      const WorkFace& face = work_.faces[f];
      if (!face.is_usable() || face.uses.empty() || !is_member[face.uses[0].part]) continue;
      if (face.uses.size() > 1 || !add_polygon(static_cast<int>(f))) return false;
    }
    return true;
  }

  bool add_polygon(int f) {
    const std::vector<TopoDS_Edge> loop = loop_of(work_.faces[f].face);
    Polygon polygon;
    polygon.face = f;
    std::vector<Vec3> points;
    for (const TopoDS_Edge& edge : loop) {
      const TopoDS_Vertex start = TopExp::FirstVertex(edge, Standard_True);
      if (std::max(BRep_Tool::Tolerance(edge), BRep_Tool::Tolerance(start)) > clear_) return false;
      polygon.corners.push_back(vertices_.Add(start) - 1);
      polygon.sides.push_back(edges_.Add(edge) - 1);
      points.push_back(to_vec(BRep_Tool::Pnt(start)));
      polygon.box.add(points.back());
    }
    const std::size_t count = points.size();
    if (count == 0) return false;
    for (std::size_t i = 1; i + 1 < count; ++i)
      polygon.normal = polygon.normal + cross(points[i] - points[0], points[i + 1] - points[0]);
    polygon.normal = unit(polygon.normal);
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 side = points[(i + 1) % count] - points[i];
      const Vec3 inwards = cross(polygon.normal, unit(side));
      for (const Vec3& point : points)
        if (!(dot(point - points[i], inwards) > -tolerance_)) return false;
    }
    of_part_[work_.faces[f].uses[0].part].push_back(static_cast<int>(polygons_.size()));
    polygons_.push_back(std::move(polygon));
    return true;
  }

  /// Vertices in one place become the first of these; false where it cannot be told whether they are.
  bool match_corners() {
    std::vector<Box> boxes;
    for (int i = 1; i <= vertices_.Extent(); ++i) {
      points_.push_back(to_vec(BRep_Tool::Pnt(TopoDS::Vertex(vertices_(i)))));
      boxes.emplace_back().add(points_.back());
      boxes.back() = boxes.back().grown(clear_);
    }
    UnionFind together(points_.size());
    bool is_clear = true;
    for_meeting(boxes, [&](int i, int j) {
      const double distance = norm(points_[i] - points_[j]);
      if (distance <= tolerance_) together.merge(i, j);
      is_clear = distance <= tolerance_ || distance > clear_;
      return is_clear;
    });
    for (std::size_t i = 0; i < points_.size(); ++i) {
      first_vertex_.push_back(together.find(static_cast<int>(i)));
      is_clear = is_clear && norm(points_[i] - points_[first_vertex_[i]]) <= tolerance_;
    }
    for (Polygon& polygon : polygons_) {
      for (int& corner : polygon.corners) corner = first_vertex_[corner];
      std::vector<int> known = polygon.corners;
      std::ranges::sort(known);
      is_clear = is_clear && std::ranges::adjacent_find(known) == known.end();
    }
    return is_clear;
  }

  /// Straight edges between the same vertices become the first of these, polygons of the same edges likewise.
  void match_sides() {
    std::map<std::array<int, 2>, int> by_ends;
    first_edge_.assign(edges_.Extent(), -1);
    for (Polygon& polygon : polygons_)
      for (std::size_t i = 0; i < polygon.sides.size(); ++i) {
        const auto [low, high] = std::minmax(polygon.corners[i], polygon.corners[(i + 1) % polygon.corners.size()]);
        const int edge = polygon.sides[i];
        polygon.sides[i] = first_edge_[edge] = by_ends.insert({{low, high}, edge}).first->second;
      }
    std::map<std::vector<int>, int> by_sides;
    for (std::size_t p = 0; p < polygons_.size(); ++p) {
      std::vector<int> sides = polygons_[p].sides;
      std::ranges::sort(sides);
      first_polygon_.push_back(by_sides.insert({std::move(sides), static_cast<int>(p)}).first->second);
    }
  }

  /// Whether the two are one, or have nothing in common but one edge or vertex of both.
  bool match(const Polygon& a, const Polygon& b) {
    if (!a.box.grown(clear_).meets(b.box) || first_of(a) == first_of(b)) return true;
    axes_.clear();
    for (const Polygon* polygon : {&a, &b}) {
      axes_.push_back(polygon->normal);
      for (std::size_t i = 0; i < polygon->corners.size(); ++i) {
        axes_.push_back(side(*polygon, i));
        axes_.push_back(cross(polygon->normal, side(*polygon, i)));
      }
    }
    for (std::size_t i = 0; i < a.corners.size(); ++i)
      for (std::size_t j = 0; j < b.corners.size(); ++j) {
        constexpr double parallel = 1e-6;
        const Vec3 across = cross(side(a, i), side(b, j));
        if (norm(across) > parallel) axes_.push_back(unit(across));
      }
    return meet_in_common(a.corners, b.corners);
  }

  int first_of(const Polygon& polygon) const { return first_polygon_[&polygon - polygons_.data()]; }

  Vec3 side(const Polygon& polygon, std::size_t i) const {
    return unit(points_[polygon.corners[(i + 1) % polygon.corners.size()]] - points_[polygon.corners[i]]);
  }

  /// Of convex pieces of two polygons, by their corners: whether planes at right angles to the axes have one on each
  /// side, and what lies in them is one corner, or the same corners.
  bool meet_in_common(const std::vector<int>& a, const std::vector<int>& b) const {
    if (a.size() == 1) return has(b, a[0]);
    if (b.size() == 1) return has(a, b[0]);
    if (std::ranges::is_permutation(a, b)) return true;
    return std::ranges::any_of(axes_, [&](const Vec3& axis) { return part(axis, a, b) || part(axis, b, a); });
  }

  static bool has(const std::vector<int>& corners, int corner) {
    return std::ranges::find(corners, corner) != corners.end();
  }

  bool part(const Vec3& axis, const std::vector<int>& below, const std::vector<int>& above) const {
    double top = -INFINITY, bottom = INFINITY;
    for (const int corner : below) top = std::max(top, dot(axis, points_[corner]));
    for (const int corner : above) bottom = std::min(bottom, dot(axis, points_[corner]));
    if (bottom - top > clear_) return true;
    if (top - bottom > tolerance_) return false;
    auto in_plane = [&](const std::vector<int>& corners, double level) {
      std::vector<int> in;
      for (const int corner : corners)
        if (std::abs(dot(axis, points_[corner]) - level) <= clear_) in.push_back(corner);
      return in;
    };
    const std::vector<int> one = in_plane(below, top), other = in_plane(above, bottom);
    return (one.size() < below.size() || other.size() < above.size()) && meet_in_common(one, other);
  }

  Fusion fusion() {
    Fusion made;
    made.tolerance = tolerance_;
    make_edges(made);
    std::vector<int> image_of_polygon(polygons_.size(), -1);
    for (std::size_t p = 0; p < polygons_.size(); ++p) {
      int& image = image_of_polygon[first_polygon_[p]];
      if (image < 0) {
        image = static_cast<int>(made.images.size());
        made.images.push_back({with_first_edges(work_.faces[polygons_[p].face].face), {}});
      }
      made.images[image].of.push_back(polygons_[p].face);
    }
    return made;
  }

  void make_edges(Fusion& made) {
    BRep_Builder builder;
    for (int i = 0; i < static_cast<int>(points_.size()); ++i) {
      const TopoDS_Vertex first = TopoDS::Vertex(vertices_(first_vertex_[i] + 1));
      const double apart = norm(points_[i] - points_[first_vertex_[i]]);
      if (apart > 0) builder.UpdateVertex(first, apart + BRep_Tool::Tolerance(TopoDS::Vertex(vertices_(i + 1))));
    }
    images_.resize(edges_.Extent());
    for (int e = 0; e < edges_.Extent(); ++e) {
      if (first_edge_[e] != e) continue;
      const TopoDS_Edge edge = forward(TopoDS::Edge(edges_(e + 1)));
      TopoDS_Edge image = edge;
      if (!is_first(TopExp::FirstVertex(edge)) || !is_first(TopExp::LastVertex(edge))) {
        image = TopoDS::Edge(edge.EmptyCopied());
        builder.Add(image, first_of(TopExp::FirstVertex(edge)).Oriented(TopAbs_FORWARD));
        builder.Add(image, first_of(TopExp::LastVertex(edge)).Oriented(TopAbs_REVERSED));
      }
      images_[e] = image;
    }
    for (int e = 0; e < edges_.Extent(); ++e)
      if (const TopoDS_Edge& image = images_[first_edge_[e]]; !edges_(e + 1).IsSame(image))
        made.edges.push_back({edges_(e + 1), image});
  }

  bool is_first(const TopoDS_Vertex& vertex) const { return first_of(vertex).IsSame(vertex); }
  TopoDS_Vertex first_of(const TopoDS_Vertex& vertex) const {
    return TopoDS::Vertex(vertices_(first_vertex_[vertices_.FindIndex(vertex) - 1] + 1));
  }

  TopoDS_Face with_first_edges(const TopoDS_Face& face) const {
    BRep_Builder builder;
    bool is_same = true;
    TopoDS_Face image = TopoDS::Face(face.EmptyCopied().Oriented(TopAbs_FORWARD));
    for (const TopoDS_Wire& wire : wires_of(forward(face))) {
      TopoDS_Shape loop = wire.EmptyCopied().Oriented(TopAbs_FORWARD);
      for (TopoDS_Iterator it(wire.Oriented(TopAbs_FORWARD)); it.More(); it.Next()) {
        const TopoDS_Edge edge = TopoDS::Edge(it.Value());
        TopoDS_Edge first = images_[first_edge_[edges_.FindIndex(edge) - 1]];
        if (!first_of(TopExp::FirstVertex(edge, Standard_True)).IsSame(TopExp::FirstVertex(first))) first.Reverse();
        is_same = is_same && first.IsSame(edge);
        builder.Add(loop, first);
      }
      loop.Closed(true);
      builder.Add(image, loop.Oriented(wire.Orientation()));
    }
    return is_same ? face : TopoDS::Face(image.Oriented(face.Orientation()));
  }

  const Workpiece& work_;
  const std::vector<int>& parts_;
  double tolerance_, clear_;
  TopTools_IndexedMapOfShape vertices_, edges_;
  std::vector<Polygon> polygons_;
  std::vector<std::vector<int>> of_part_;                       // polygons
  std::vector<Vec3> points_;                                    // of vertices
  std::vector<Vec3> axes_;                                      // of two polygons
  std::vector<int> first_vertex_, first_edge_, first_polygon_;  // of those in one place, per each
  std::vector<TopoDS_Edge> images_;                             // of first edges
};

}  // namespace

std::optional<Fusion> match_parts(const Workpiece& work, const std::vector<int>& parts,
                                  const std::vector<PartPair>& pairs, double tolerance, const Progress& progress) {
  return MatchingParts(work, parts, tolerance).run(pairs, progress);
}

}  // namespace paver
