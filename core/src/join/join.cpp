// Joining is numbering: regions share nothing but the nodes of the boundary stage.
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

void add_lines(const EdgeNodes& edges, SurfaceMesh& mesh) {
  for (std::size_t e = 0; e < edges.edges.size(); ++e) {
    const EdgeDivision& d = edges.edges[e];
    for (int i = 0; i < d.intervals(); ++i) {
      mesh.lines.push_back(d.node[i]);
      mesh.lines.push_back(d.node[i + 1]);
      mesh.line_edge.push_back(static_cast<int>(e));
    }
  }
}

}  // namespace

JoinedMesh join_regions(const Model& model, const EdgeNodes& edges, const std::vector<JoinPart>& parts) {
  JoinedMesh joined;
  SurfaceMesh& mesh = joined.mesh;
  mesh.nodes = edges.nodes;
  mesh.node_edge = edges.node_edge;
  mesh.node_target = edges.node_target;
  add_lines(edges, mesh);
  for (const JoinPart& part : parts) {
    std::vector<int>& node_of = joined.node_of.emplace_back();
    if (!part.mesh) continue;
    const RegionMesh& region = *part.mesh;
    node_of.assign(region.node_count(), -1);
    for (int i = 0; i < region.node_count(); ++i) {
      if (region.star[i].size() == 0) continue;
      if (region.global[i] >= 0) {
        node_of[i] = region.global[i];
        continue;
      }
      node_of[i] = static_cast<int>(mesh.nodes.size());
      mesh.nodes.push_back(region.x[i]);
      mesh.node_edge.push_back(-1);
      mesh.node_target.push_back(region.h[i]);
    }
    for (std::size_t e = 0; e < region.elements.size(); ++e) {
      const Element& element = region.elements[e];
      if (!element.is_alive()) continue;
      add_element(mesh, element, node_of, model.faces[part.face], part.face);
      if (element.corners() == 4)
        joined.quad_source.push_back({static_cast<int>(&part - parts.data()), static_cast<int>(e)});
    }
  }
  return joined;
}

}  // namespace paver
