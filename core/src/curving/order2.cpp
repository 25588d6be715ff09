// Middle nodes of a mesh of order 2.
// In: straight mesh, divided edges. Out: mesh of order 2 in Gmsh's node order.
// Steps: middles of the lines; all element sides sorted by (face, node pair), so that equal sides share one node;
// numbers by first use; elements written; positions.
#include "curving/order2.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace paver {
namespace {

struct Line {
  int a, b;  // a < b
  int edge;
  int node;
};

bool operator<(const Line& one, const Line& other) {
  return std::tie(one.a, one.b, one.edge) < std::tie(other.a, other.b, other.edge);
}

struct Side {
  int face, a, b;  // a < b
  int place;       // among all element sides
};

bool is_same(const Side& one, const Side& other) {
  return one.face == other.face && one.a == other.a && one.b == other.b;
}

// Sides of all elements in order: quads, then triangles.
std::vector<Side> element_sides(const SurfaceMesh& linear) {
  std::vector<Side> sides;
  sides.reserve(linear.quads.size() + linear.triangles.size());
  auto add = [&sides](const std::vector<int>& nodes, const std::vector<int>& faces, std::size_t corners) {
    for (std::size_t i = 0; i < faces.size(); ++i) {
      for (std::size_t c = 0; c < corners; ++c) {
        auto [a, b] = std::minmax({nodes[i * corners + c], nodes[i * corners + (c + 1) % corners]});
        sides.push_back({faces[i], a, b, static_cast<int>(sides.size())});
      }
    }
  };
  add(linear.quads, linear.quad_face, 4);
  add(linear.triangles, linear.triangle_face, 3);
  return sides;
}

int add_node(SurfaceMesh& mesh, Vec3 x, int edge) {
  mesh.nodes.push_back(x);
  mesh.node_edge.push_back(edge);
  mesh.node_target.push_back(0);
  return static_cast<int>(mesh.nodes.size()) - 1;
}

// Middles of the lines, placed as the edges are divided; gives the lines sorted by their ends.
std::vector<Line> number_lines(const SurfaceMesh& linear, const EdgeNodes& edges, SurfaceMesh& mesh) {
  std::vector<std::size_t> interval_of_edge(edges.edges.size(), 0);
  std::vector<Line> lines;
  for (std::size_t i = 0; i < linear.line_edge.size(); ++i) {
    const int edge = linear.line_edge[i];
    const EdgeDivision& division = edges.edges[static_cast<std::size_t>(edge)];
    const std::size_t interval = interval_of_edge[static_cast<std::size_t>(edge)]++;
    const int first = linear.lines[2 * i], second = linear.lines[2 * i + 1];
    const int node = add_node(mesh, division.x.at(2 * interval + 1), edge);
    mesh.lines.insert(mesh.lines.end(), {first, second, node});
    lines.push_back({std::min(first, second), std::max(first, second), edge, node});
  }
  std::sort(lines.begin(), lines.end());
  return lines;
}

// Middle of the line a side lies on, or -1.
int line_node(const std::vector<Line>& lines, const Side& side, const Model& model) {
  auto line = std::lower_bound(lines.begin(), lines.end(), Line{side.a, side.b, -1, -1});
  for (; line != lines.end() && line->a == side.a && line->b == side.b; ++line) {
    const std::vector<int>& faces = model.edges[static_cast<std::size_t>(line->edge)].faces;
    if (std::find(faces.begin(), faces.end(), side.face) != faces.end()) return line->node;
  }
  return -1;
}

// Middle node per element side; adds the interior ones to the mesh and to `interior`.
std::vector<int> number_sides(const std::vector<Side>& sides, const std::vector<Line>& lines, const Model& model,
                              OrderTwoMesh& result) {
  // Sides from each node in their order: few, so the first that is the same is found by looking at them all.
  std::vector<int> start(result.mesh.nodes.size() + 1, 0), places(sides.size());
  for (const Side& side : sides) ++start[static_cast<std::size_t>(side.a) + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<int> end(start.begin(), start.end() - 1);
  for (const Side& side : sides) places[static_cast<std::size_t>(end[static_cast<std::size_t>(side.a)]++)] = side.place;
  auto first_place = [&](const Side& side) {
    const int* place = &places[static_cast<std::size_t>(start[static_cast<std::size_t>(side.a)])];
    while (!is_same(sides[static_cast<std::size_t>(*place)], side)) ++place;
    return static_cast<std::size_t>(*place);
  };
  std::vector<int> node_of_side(sides.size());
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (const std::size_t first = first_place(sides[i]); first != i) {
      node_of_side[i] = node_of_side[first];
      continue;
    }
    node_of_side[i] = line_node(lines, sides[i], model);
    if (node_of_side[i] >= 0) continue;
    node_of_side[i] = add_node(result.mesh, {}, -1);
    result.sides.push_back({sides[i].face, sides[i].a, sides[i].b, node_of_side[i]});
  }
  return node_of_side;
}

}  // namespace

OrderTwoMesh number_order_2(const SurfaceMesh& linear, const EdgeNodes& edges, const Model& model) {
  OrderTwoMesh result;
  SurfaceMesh& mesh = result.mesh;
  mesh.order = 2;
  mesh.nodes = linear.nodes;
  mesh.node_edge = linear.node_edge;
  mesh.node_target = linear.node_target;
  mesh.quad_face = linear.quad_face;
  mesh.triangle_face = linear.triangle_face;
  mesh.line_edge = linear.line_edge;
  const std::vector<Line> lines = number_lines(linear, edges, mesh);
  const std::vector<int> node_of_side = number_sides(element_sides(linear), lines, model, result);

  auto side_node = node_of_side.begin();
  for (std::size_t q = 0; q < linear.quad_count(); ++q) {
    auto corners = linear.quads.begin() + static_cast<std::ptrdiff_t>(4 * q);
    mesh.quads.insert(mesh.quads.end(), corners, corners + 4);
    mesh.quads.insert(mesh.quads.end(), side_node, side_node + 4);
    mesh.quads.push_back(add_node(mesh, {}, -1));
    side_node += 4;
  }
  for (std::size_t i = 0; i < linear.triangle_count(); ++i) {
    auto corners = linear.triangles.begin() + static_cast<std::ptrdiff_t>(3 * i);
    mesh.triangles.insert(mesh.triangles.end(), corners, corners + 3);
    mesh.triangles.insert(mesh.triangles.end(), side_node, side_node + 3);
    side_node += 3;
  }
  return result;
}

Vec3 blended_centre(const SurfaceMesh& mesh, int quad) {
  const int* nodes = &mesh.quads[9 * static_cast<std::size_t>(quad)];
  Vec3 corners, middles;
  for (int i = 0; i < 4; ++i) {
    corners += mesh.nodes[static_cast<std::size_t>(nodes[i])];
    middles += mesh.nodes[static_cast<std::size_t>(nodes[4 + i])];
  }
  return 0.5 * middles - 0.25 * corners;
}

SurfaceMesh raise_to_order_2(const SurfaceMesh& linear, const EdgeNodes& edges, const Model& model,
                             const MidpointFn& midpoint, const CentreFn& centre) {
  OrderTwoMesh raised = number_order_2(linear, edges, model);
  SurfaceMesh& mesh = raised.mesh;
  for (const InteriorSide& side : raised.sides) {
    mesh.nodes[static_cast<std::size_t>(side.node)] = midpoint(side.face, side.a, side.b);
  }
  for (std::size_t q = 0; q < mesh.quad_count(); ++q) {
    Vec3 blend = blended_centre(mesh, static_cast<int>(q));
    mesh.nodes[static_cast<std::size_t>(mesh.quads[9 * q + 8])] = centre ? centre(static_cast<int>(q), blend) : blend;
  }
  return std::move(mesh);
}

}  // namespace paver
