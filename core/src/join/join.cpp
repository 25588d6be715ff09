// Joining is numbering: parts share nothing but nodes of the boundary stage and of the outlines between pieces.
#include "join/join.h"

#include <algorithm>

namespace paver {
namespace {

/// Corners in the order of the B-rep face, least number of distinct nodes checked.
void add_element(SurfaceMesh& mesh, const Element& e, const std::vector<int>& node_of, const Face& face, int index) {
  int n = e.corners(), v[4];
  for (int i = 0; i < n; ++i) v[i] = node_of[e.v[i]];
  if (face.is_reversed) std::reverse(v + 1, v + n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < i; ++j)
      if (v[i] == v[j])
        throw Error(ErrorCode::face_failed, "an element folds onto its own periodic edge; use a smaller size",
                    {"join", index, -1, mesh.nodes[v[i]]});
  auto& list = n == 4 ? mesh.quads : mesh.triangles;
  list.insert(list.end(), v, v + n);
  (n == 4 ? mesh.quad_face : mesh.triangle_face).push_back(index);
}

class Joiner {
 public:
  Joiner(const Model& model, const EdgeNodes& edges, const BoundaryUse& use, const std::vector<MeshPart>& parts,
         int outlines)
      : model_(model),
        edges_(edges),
        use_(use),
        parts_(parts),
        boundary_node_(edges.nodes.size(), -1),
        outline_node_(static_cast<std::size_t>(outlines), -1) {}

  JoinedMesh run() {
    reserve();
    add_boundary();
    add_lines();
    add_points();
    add_outlines();
    joined_.node_of.resize(parts_.size());
    joined_.sizes.resize(parts_.size());
    for (std::size_t i = 0; i < parts_.size(); ++i)
      if (parts_[i].mesh) add_part(i);
    return std::move(joined_);
  }

 private:
  std::size_t boundary() const { return edges_.nodes.size(); }

  void reserve() {
    std::size_t nodes = boundary(), elements = 0;
    for (const MeshPart& part : parts_)
      if (part.mesh) nodes += part.mesh->p.size(), elements += part.mesh->elements.size();
    SurfaceMesh& mesh = joined_.mesh;
    mesh.nodes.reserve(nodes), mesh.node_edge.reserve(nodes), mesh.node_target.reserve(nodes);
    mesh.quads.reserve(4 * elements), mesh.quad_face.reserve(elements);
  }

  void add_boundary() {
    for (std::size_t i = 0; i < boundary(); ++i)
      if (use_.nodes[i]) boundary_node_[i] = add_node(edges_.nodes[i], edges_.node_edge[i], edges_.node_target[i]);
    joined_.boundary_nodes = static_cast<long>(joined_.mesh.nodes.size());
  }

  void add_lines() {
    SurfaceMesh& mesh = joined_.mesh;
    for (std::size_t e = 0; e < edges_.edges.size(); ++e) {
      const EdgeDivision& d = edges_.edges[e];
      for (int i = 0; use_.edges[e] && i < d.intervals(); ++i) {
        mesh.lines.push_back(boundary_node_[d.node[i]]);
        mesh.lines.push_back(boundary_node_[d.node[i + 1]]);
        mesh.line_edge.push_back(static_cast<int>(e));
      }
    }
  }

  void add_points() {
    for (const PartPoint& point : model_.points) {
      const int node = edges_.node_of_vertex[point.vertex];
      joined_.mesh.points.push_back(node < 0 ? -1 : boundary_node_[node]);
    }
  }

  int add_node(Vec3 x, int edge, double target) {
    SurfaceMesh& mesh = joined_.mesh;
    mesh.nodes.push_back(x), mesh.node_edge.push_back(edge), mesh.node_target.push_back(target);
    return static_cast<int>(mesh.nodes.size()) - 1;
  }
  int add_node(const RegionMesh& region, int i) { return add_node(region.x[i], -1, region.h[i]); }

  int outline_of(const MeshPart& part, int i) const {
    return shared_node(part.mesh->global[i], part.outline, boundary()) - static_cast<int>(boundary());
  }

  // In the order of their numbers; all parts about one have it at the same place.
  void add_outlines() {
    std::vector<std::pair<int, int>> from(outline_node_.size(), {-1, -1});
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      if (!parts_[k].mesh) continue;
      const RegionMesh& region = *parts_[k].mesh;
      for (int i = 0; i < region.node_count(); ++i)
        if (region.global[i] >= static_cast<int>(boundary()) && region.star[i].size() > 0)
          from[outline_of(parts_[k], i)] = {static_cast<int>(k), i};
    }
    for (std::size_t o = 0; o < from.size(); ++o) {
      if (from[o].first < 0) continue;
      outline_node_[o] = add_node(*parts_[from[o].first].mesh, from[o].second);
      joined_.outline.push_back(static_cast<int>(o));
    }
  }

  void add_part(std::size_t i) {
    const MeshPart& part = parts_[i];
    const RegionMesh& region = *part.mesh;
    const int face = part.region->face;
    SurfaceMesh& mesh = joined_.mesh;
    std::vector<int>& node_of = joined_.node_of[i];
    const long nodes = static_cast<long>(mesh.nodes.size()), quads = static_cast<long>(mesh.quad_count()),
               triangles = static_cast<long>(mesh.triangle_count());
    node_of.assign(region.node_count(), -1);
    for (int v = 0; v < region.node_count(); ++v) {
      if (region.star[v].size() == 0) continue;
      const int global = region.global[v];
      if (global < 0)
        node_of[v] = add_node(region, v);
      else
        node_of[v] =
            global < static_cast<int>(boundary()) ? boundary_node_[global] : outline_node_[outline_of(part, v)];
    }
    for (const Element& element : region.elements)
      if (element.is_alive()) add_element(mesh, element, node_of, model_.faces[face], face);
    joined_.sizes[i] = {static_cast<long>(mesh.nodes.size()) - nodes, static_cast<long>(mesh.quad_count()) - quads,
                        static_cast<long>(mesh.triangle_count()) - triangles};
  }

  const Model& model_;
  const EdgeNodes& edges_;
  const BoundaryUse& use_;
  const std::vector<MeshPart>& parts_;
  std::vector<int> boundary_node_;  // per node of the boundary stage: its node in the mesh
  std::vector<int> outline_node_;   // per outline node: its node in the mesh
  JoinedMesh joined_;
};

}  // namespace

std::vector<PartRows> part_rows(const std::vector<PartSizes>& sizes, int node) {
  std::vector<PartRows> rows;
  PartRows next{node};
  for (const auto& [nodes, quads, triangles] : sizes) {
    rows.push_back(next);
    next.node += static_cast<int>(nodes);
    next.quad += static_cast<std::size_t>(quads);
    next.triangle += static_cast<std::size_t>(triangles);
  }
  return rows;
}

std::vector<double> part_costs(const std::vector<PartSizes>& sizes) {
  std::vector<double> costs;
  for (const PartSizes& part : sizes) costs.push_back(static_cast<double>(part.quads + part.triangles));
  return costs;
}

JoinedMesh join_regions(const Model& model, const EdgeNodes& edges, const BoundaryUse& use,
                        const std::vector<MeshPart>& parts, int outlines) {
  return Joiner(model, edges, use, parts, outlines).run();
}

}  // namespace paver
