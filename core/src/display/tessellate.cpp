// Cuts elements along a lattice in their own parameters, face by face.
//   1. elements in the order of their faces
//   2. per element: its points, new or shared with a neighbour on the same face; normals are summed at shared points
//   3. triangles; mesh edges that no element before had
#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "display/cut.h"
#include "display/edge_table.h"
#include "display/shape_table.h"
#include "mesh/element_table.h"
#include "paver/display.h"
#include "paver/error.h"

namespace paver {
namespace {

/// Points inside a mesh edge on one face: consecutive, from `start` on.
struct SidePoints {
  int face, start, first;
};

/// One element as it is cut.
struct Element {
  bool is_quad;
  int number, face;
  const int* nodes;
};

class Tessellator {
 public:
  Tessellator(const SurfaceMesh& mesh, int n)
      : mesh_(mesh),
        n_(n),
        quad_(ElementShape::quad, mesh.order, n),
        triangle_(ElementShape::triangle, mesh.order, n),
        sides_(2 * mesh.quad_count() + 3 * mesh.triangle_count() / 2),
        lines_(mesh.line_edge.size()),
        point_of_node_(mesh.nodes.size(), {-1, -1}) {
    result_.subdivision = n;
  }

  Cut run() {
    reserve();
    index_lines();
    for (int e : in_face_order()) cut(element(e));
    scale_normals();
    return {std::move(result_), std::move(element_points_)};
  }

 private:
  void reserve() {
    std::size_t quads = mesh_.quad_count(), triangles = mesh_.triangle_count();
    std::size_t pieces = (2 * quads + triangles) * static_cast<std::size_t>(n_) * n_;
    result_.triangles.reserve(4 * pieces);
    result_.triangle_element.reserve(pieces);
    std::size_t points = pieces / 2 + pieces / 16;  // about one per two triangles, and those at the faces' edges
    result_.points.reserve(3 * points);
    normals_.reserve(points);
    element_points_.resize(quads * quad_.point_count() + triangles * triangle_.point_count());
  }

  void index_lines() {
    for (std::size_t i = 0; i < mesh_.line_edge.size(); ++i) {
      const int* line = mesh_.line(i).data();
      if (lines_.number(edge_key(line[0], line[1], line + 2, mesh_.order)).second)
        edge_of_line_.push_back(mesh_.line_edge[i]);
    }
  }

  int face_of(int e) const {
    int quads = static_cast<int>(mesh_.quad_count());
    return e < quads ? mesh_.quad_face[e] : mesh_.triangle_face[e - quads];
  }

  std::vector<int> in_face_order() const {
    std::vector<int> order(mesh_.quad_count() + mesh_.triangle_count());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return face_of(a) < face_of(b); });
    return order;
  }

  Element element(int e) const {
    int quads = static_cast<int>(mesh_.quad_count());
    bool is_quad = e < quads;
    std::size_t row = static_cast<std::size_t>(is_quad ? e : e - quads);
    return {is_quad, e, face_of(e), ElementTable(mesh_, is_quad).row(row)};
  }

  void cut(const Element& e) {
    const ShapeTable& table = e.is_quad ? quad_ : triangle_;
    x_.resize(static_cast<std::size_t>(table.node_count()));
    for (int k = 0; k < table.node_count(); ++k) x_[k] = mesh_.nodes[e.nodes[k]];
    local_.assign(static_cast<std::size_t>(table.point_count()), -1);
    place_corners_and_sides(e, table);
    for (int& point : local_)
      if (point < 0) point = new_point(table.position(x_.data(), static_cast<int>(&point - local_.data())));
    add_normals(table);
    for_triangles(n_, e.is_quad, [&](int a, int b, int c) {
      result_.triangles.insert(result_.triangles.end(), {local_[a], local_[b], local_[c], -1});
      result_.triangle_element.push_back(e.number);
    });
    std::copy(local_.begin(), local_.end(), element_points_.begin() + first_point(e.number));
  }

  /// Where the points of an element start in element_points_.
  std::ptrdiff_t first_point(int e) const {
    auto quads = static_cast<std::ptrdiff_t>(mesh_.quad_count());
    return e < quads ? e * std::ptrdiff_t(quad_.point_count())
                     : quads * quad_.point_count() + (e - quads) * triangle_.point_count();
  }

  /// Lattice coordinates of step i along a side, from corner `side` to the next.
  std::pair<int, int> on_side(bool is_quad, int side, int i) const {
    if (side == 0) return {i, 0};
    if (!is_quad) return side == 1 ? std::pair(n_ - i, i) : std::pair(0, n_ - i);
    if (side == 1) return {n_, i};
    return side == 2 ? std::pair(n_ - i, n_) : std::pair(0, n_ - i);
  }

  void place_corners_and_sides(const Element& e, const ShapeTable& table) {
    int corners = e.is_quad ? 4 : 3;
    auto local = [&](int side, int i) {
      auto [a, b] = on_side(e.is_quad, side, i);
      return table.index(a, b);
    };
    for (int k = 0; k < corners; ++k) {
      auto& [face, point] = point_of_node_[e.nodes[k]];
      if (face != e.face) face = e.face, point = new_point(mesh_.nodes[e.nodes[k]]);
      local_[local(k, 0)] = point;
    }
    for (int side = 0; side < corners; ++side) {
      int a = e.nodes[side], b = e.nodes[(side + 1) % corners];
      EdgeKey key = edge_key(a, b, e.nodes + corners + side * (mesh_.order - 1), mesh_.order);
      auto [number, is_new] = sides_.number(key);
      if (is_new) side_points_.push_back({-1, -1, -1});
      SidePoints& points = side_points_[number];
      if (points.face != e.face) {
        points = {e.face, a, static_cast<int>(result_.points.size() / 3)};
        for (int i = 1; i < n_; ++i) new_point(table.position(x_.data(), local(side, i)));
      }
      for (int i = 1; i < n_; ++i) local_[local(side, i)] = points.first + (points.start == a ? i - 1 : n_ - 1 - i);
      if (!is_new) {
        ++result_.outline_elements[number];
        continue;
      }
      for (int i = 0; i <= n_; ++i) result_.outlines.push_back(local_[local(side, i)]);
      result_.outlines.push_back(-1);
      int line = lines_.find(key);
      result_.outline_edge.push_back(line < 0 ? -1 : edge_of_line_[line]);
      result_.outline_elements.push_back(1);
    }
  }

  int new_point(Vec3 x) {
    for (double c : {x.x, x.y, x.z}) result_.points.push_back(static_cast<float>(c));
    normals_.push_back({});
    return static_cast<int>(normals_.size()) - 1;
  }

  void add_normals(const ShapeTable& table) {
    Vec3 mean;
    for (int i = 0; i < table.point_count(); ++i) {
      Vec3 n = table.normal(x_.data(), i);
      mean += n;
      normals_[local_[i]] += unit(n);
    }
    // Where a side shrinks to a point the element's own normal must do.
    for (int point : local_)
      if (norm(normals_[point]) == 0) normals_[point] += unit(mean);
  }

  void scale_normals() {
    result_.normals.reserve(3 * normals_.size());
    for (Vec3 n : normals_) {
      n = unit(n);
      for (double c : {n.x, n.y, n.z}) result_.normals.push_back(static_cast<float>(c));
    }
  }

  const SurfaceMesh& mesh_;
  int n_;
  ShapeTable quad_, triangle_;
  EdgeTable sides_, lines_;
  std::vector<std::pair<int, int>> point_of_node_;  ///< (face, point) of each corner node, on the face it was last met
  std::vector<SidePoints> side_points_;             ///< per side, on the face it was last met
  std::vector<int> edge_of_line_;                   ///< per line
  std::vector<Vec3> normals_;                       ///< sums, per point
  std::vector<Vec3> x_;                             ///< nodes of the element in hand
  std::vector<int> local_;                          ///< its points
  std::vector<int> element_points_;                 ///< those of all elements
  Tessellation result_;
};

}  // namespace

Cut cut_mesh(const SurfaceMesh& mesh, int subdivision) {
  if (subdivision < 1 || subdivision > most_subdivisions) {
    throw Error(ErrorCode::bad_option,
                fmt::format("subdivision is {}; it must be from 1 to {}.", subdivision, most_subdivisions));
  }
  return Tessellator(mesh, subdivision).run();
}

Tessellation tessellate(const SurfaceMesh& mesh, int subdivision) { return cut_mesh(mesh, subdivision).shared; }

}  // namespace paver
