// Edges and vertices of a model, named as in the shape.
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>
#include <cmath>

#include "base/union_find.h"
#include "brep/occt_impl.h"
#include "brep/occt_shapes_impl.h"
#include "brep/surfaces/evaluators_impl.h"
#include "topology/build_parts_impl.h"

namespace paver {
namespace {

/// Edges and vertices in the making.
class EdgeBuilder {
 public:
  EdgeBuilder(const Workpiece& work, Model& model) : work_(work), model_(model) {}

  EdgeIndex build() {
    index_.map = edge_map(work_);
    TopTools_IndexedMapOfShape used = used_edges();
    index_.edge.assign(static_cast<std::size_t>(index_.map.Extent()) + 1, -1);
    for (int position = 1; position <= index_.map.Extent(); ++position) {
      if (!used.Contains(index_.map(position))) continue;
      index_.edge[position] = static_cast<int>(model_.edges.size());
      add_edge(forward(TopoDS::Edge(index_.map(position))));
    }
    for (const WorkPoint& point : work_.points) add_point(point.vertex);
    add_touching_points();
    number_vertices();
    return std::move(index_);
  }

 private:
  std::string name(const std::vector<int>& origins) {
    return origins.empty() ? "Added" + std::to_string(++added_) : "Edge" + std::to_string(origins.front() + 1);
  }

  TopTools_IndexedMapOfShape used_edges() const {
    TopTools_IndexedMapOfShape used;
    for (const WorkFace& face : work_.faces) {
      if (!face.has_area) continue;
      for (const TopoDS_Edge& edge : edges_of(face.face))
        if (edge.Orientation() != TopAbs_EXTERNAL) used.Add(edge);
    }
    for (const WorkWire& wire : work_.wires) used.Add(wire.edge);
    return used;
  }

  void add_edge(const TopoDS_Edge& shape) {
    Edge edge;
    edge.origins = edge_origins(work_, shape);
    edge.name = name(edge.origins);
    const CurveRange range = range_of(shape);
    edge.t0 = range.first, edge.t1 = range.last;
    const bool is_endless = !range.is_finite();
    edge.length = is_endless ? 0 : edge_length(shape);
    edge.is_degenerate = !is_endless && (BRep_Tool::Degenerated(shape) || edge.length < point_share * work_.diagonal);
    // An endless edge keeps a null curve without being degenerate: its faces get a fault for it.
    if (!edge.is_degenerate && !is_endless) edge.curve = make_curve(shape);
    if (edge.is_degenerate) edge.length = 0;
    TopoDS_Vertex first, last;
    TopExp::Vertices(shape, first, last);
    edge.start = vertex(first, edge, edge.t0);
    edge.end = last.IsNull() && is_closed(edge) ? edge.start : vertex(last, edge, edge.t1);
    if (edge.is_degenerate) merger_.merge(edge.start, edge.end);
    model_.edges.push_back(std::move(edge));
  }

  /// Ends of a curve without vertices coincide.
  bool is_closed(const Edge& edge) const {
    return edge.curve && norm(edge.curve->point(edge.t0) - edge.curve->point(edge.t1)) < point_share * work_.diagonal;
  }

  /// Number of a vertex, or of a new one at the curve's end where the edge has none.
  int vertex(const TopoDS_Vertex& shape, const Edge& edge, double t) {
    if (shape.IsNull()) {
      points_.push_back(edge.curve ? edge.curve->point(t) : Vec3{});
      return merger_.add();
    }
    return add_point(shape);
  }

  int add_point(const TopoDS_Vertex& shape) {
    if (const int known = index_.find_vertex(shape); known >= 0) return known;
    index_.vertex_map.Add(shape);
    points_.push_back(to_vec(BRep_Tool::Pnt(shape)));
    index_.vertex.push_back(merger_.add());
    return index_.vertex.back();
  }

  /// Points inside two faces or more, as where a ball lies on a plate, are on no edge.
  void add_touching_points() {
    TopTools_IndexedMapOfShape known;
    for (const WorkFace& face : work_.faces) {
      if (!face.has_area) continue;
      for (TopoDS_Iterator parts(face.face); parts.More(); parts.Next()) {
        if (parts.Value().ShapeType() != TopAbs_VERTEX) continue;
        const int before = known.Extent();
        if (known.Add(parts.Value()) <= before) add_point(TopoDS::Vertex(parts.Value()));
      }
    }
  }

  void number_vertices() {
    std::vector<int> number(points_.size(), -1);
    auto numbered = [&](int v) {
      int root = merger_.find(v);
      int& n = number[root];
      if (n < 0) {
        n = static_cast<int>(model_.vertices.size());
        model_.vertices.push_back(points_[root]);
      }
      return n;
    };
    for (Edge& edge : model_.edges) {
      edge.start = numbered(edge.start);
      edge.end = numbered(edge.end);
    }
    for (std::size_t i = 1; i < index_.vertex.size(); ++i) index_.vertex[i] = numbered(index_.vertex[i]);
  }

  const Workpiece& work_;
  Model& model_;
  EdgeIndex index_;
  std::vector<Vec3> points_;
  UnionFind merger_;  ///< which vertices are one
  int added_ = 0;
};

}  // namespace

EdgeIndex build_edges(const Workpiece& work, Model& model) { return EdgeBuilder(work, model).build(); }

}  // namespace paver
