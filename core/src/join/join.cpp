// Joining is numbering: parts share nothing but nodes of the boundary stage and of the outlines between pieces.
#include "join/join.h"

#include <algorithm>
#include <functional>

#include "base/tasks/tasks.h"

namespace paver {
namespace {

/// Corners in the order of the B-rep face; false where two of them are the same node.
bool put_corners(const Element& e, const std::vector<int>& node_of, bool is_reversed, int* v) {
  const int n = e.corners();
  for (int i = 0; i < n; ++i) v[i] = node_of[e.v[i]];
  if (is_reversed) std::reverse(v + 1, v + n);
  for (int i = 0; i < n; ++i)
    if (std::find(v, v + i, v[i]) != v + i) return false;
  return true;
}

class Joiner {
 public:
  Joiner(const Model& model, const EdgeNodes& edges, const BoundaryUse& use, const std::vector<MeshPart>& parts,
         const JoinOptions& options)
      : model_(model),
        edges_(edges),
        use_(use),
        parts_(parts),
        options_(options),
        boundary_node_(edges.nodes.size(), -1),
        outline_node_(static_cast<std::size_t>(options.outlines), -1) {}

  JoinedMesh run() {
    joined_.node_of.resize(parts_.size());
    joined_.sizes.resize(parts_.size());
    on_parts([this](std::size_t i) { joined_.sizes[i] = count(*parts_[i].mesh); });
    reserve();
    add_boundary();
    add_lines();
    add_points();
    add_outlines();
    add_parts();
    return std::move(joined_);
  }

 private:
  std::size_t boundary() const { return edges_.nodes.size(); }

  void on_parts(const std::function<void(std::size_t)>& work) const {
    std::vector<double> cost;
    for (const MeshPart& part : parts_) cost.push_back(part.mesh ? static_cast<double>(part.mesh->elements.size()) : 0);
    run_tasks(options_.threads, cost, [&](int i) {
      if (parts_[i].mesh) work(static_cast<std::size_t>(i));
    });
  }

  static PartSizes count(const RegionMesh& region) {
    PartSizes sizes;
    for (int v = 0; v < region.node_count(); ++v) sizes.nodes += region.global[v] < 0 && region.star[v].size() > 0;
    for (const Element& element : region.elements)
      if (element.is_alive()) ++(element.corners() == 4 ? sizes.quads : sizes.triangles);
    return sizes;
  }

  // Room for the nodes of order 2 as well, so that no large array is copied to have more: a middle per side, a centre
  // per quad.
  void reserve() {
    for (const PartSizes& part : joined_.sizes)
      own_.nodes += part.nodes, own_.quads += part.quads, own_.triangles += part.triangles;
    std::size_t nodes = boundary() + outline_node_.size() + static_cast<std::size_t>(own_.nodes);
    if (options_.order > 1) nodes += 2 * nodes + static_cast<std::size_t>(own_.quads + own_.triangles);
    SurfaceMesh& mesh = joined_.mesh;
    mesh.nodes.reserve(nodes), mesh.node_edge.reserve(nodes), mesh.node_target.reserve(nodes);
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

  void add_parts() {
    SurfaceMesh& mesh = joined_.mesh;
    const std::vector<PartRows> first = part_rows(joined_.sizes, static_cast<int>(mesh.nodes.size()));
    const std::size_t nodes = mesh.nodes.size() + static_cast<std::size_t>(own_.nodes);
    const auto quads = static_cast<std::size_t>(own_.quads), triangles = static_cast<std::size_t>(own_.triangles);
    mesh.nodes.resize(nodes), mesh.node_edge.resize(nodes, -1), mesh.node_target.resize(nodes);
    mesh.quads.resize(4 * quads), mesh.quad_face.resize(quads);
    mesh.triangles.resize(3 * triangles), mesh.triangle_face.resize(triangles);
    std::vector<const Element*> folded(parts_.size(), nullptr);
    on_parts([&](std::size_t i) {
      add_nodes(i, first[i].node);
      folded[i] = add_elements(i, first[i]);
    });
    for (std::size_t i = 0; i < parts_.size(); ++i)
      if (folded[i])
        throw Error(ErrorCode::face_failed, "an element folds onto its own periodic edge; use a smaller size",
                    {"join", parts_[i].region->face, -1, parts_[i].mesh->x[folded[i]->v[0]]});
  }

  void add_nodes(std::size_t i, int node) {
    const MeshPart& part = parts_[i];
    const RegionMesh& region = *part.mesh;
    std::vector<int>& node_of = joined_.node_of[i];
    node_of.assign(region.node_count(), -1);
    for (int v = 0; v < region.node_count(); ++v) {
      if (region.star[v].size() == 0) continue;
      const int global = region.global[v];
      if (global < 0) {
        joined_.mesh.nodes[node] = region.x[v], joined_.mesh.node_target[node] = region.h[v];
        node_of[v] = node++;
      } else {
        node_of[v] =
            global < static_cast<int>(boundary()) ? boundary_node_[global] : outline_node_[outline_of(part, v)];
      }
    }
  }

  /// The first element that uses a node twice, else null.
  const Element* add_elements(std::size_t i, PartRows to) {
    const int face = parts_[i].region->face;
    SurfaceMesh& mesh = joined_.mesh;
    for (const Element& element : parts_[i].mesh->elements) {
      if (!element.is_alive()) continue;
      const bool is_quad = element.corners() == 4;
      int* v = is_quad ? &mesh.quads[4 * to.quad] : &mesh.triangles[3 * to.triangle];
      if (!put_corners(element, joined_.node_of[i], model_.faces[face].is_reversed, v)) return &element;
      (is_quad ? mesh.quad_face[to.quad++] : mesh.triangle_face[to.triangle++]) = face;
    }
    return nullptr;
  }

  const Model& model_;
  const EdgeNodes& edges_;
  const BoundaryUse& use_;
  const std::vector<MeshPart>& parts_;
  const JoinOptions options_;
  PartSizes own_;                   // of all parts
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
                        const std::vector<MeshPart>& parts, const JoinOptions& options) {
  return Joiner(model, edges, use, parts, options).run();
}

}  // namespace paver
