// In: joined straight mesh, divided edges, cuts. Out: mesh of order 2 in Gmsh's node order, inner nodes not placed.
// Steps: each part numbers its sides by itself; its border sides find the middles of lines and cuts; nodes; elements.
#include "curving/order2.h"

#include <algorithm>
#include <compare>
#include <utility>

#include "base/tasks/tasks.h"

namespace paver {
namespace {

struct Line {
  int a, b;  // a < b
  int edge;
  int node;
  auto operator<=>(const Line&) const = default;
};

class Raiser {
 public:
  Raiser(SurfaceMesh&& linear, const CurvingTask& task)
      : task_(task), parts_(task.parts), cost_(part_costs(task.sizes)) {
    mesh() = std::move(linear);
    mesh().order = 2;
    lines_of_two_.swap(mesh().lines);
    quads_of_four_.swap(mesh().quads);
    triangles_of_three_.swap(mesh().triangles);
  }

  OrderTwoMesh run() {
    number_lines();
    number_parts();
    number_nodes();
    fill_elements();
    return std::move(result_);
  }

 private:
  SurfaceMesh& mesh() { return result_.mesh; }

  void number_lines() {
    std::vector<std::size_t> interval_of_edge(task_.edges.edges.size(), 0);
    for (std::size_t i = 0; i < mesh().line_edge.size(); ++i) {
      const int edge = mesh().line_edge[i];
      const std::size_t interval = interval_of_edge[edge]++;
      const int a = lines_of_two_[2 * i], b = lines_of_two_[2 * i + 1];
      const int node = static_cast<int>(mesh().nodes.size());
      mesh().nodes.push_back(task_.edges.edges[edge].x.at(2 * interval + 1));
      mesh().node_edge.push_back(edge);
      mesh().lines.insert(mesh().lines.end(), {a, b, node});
      lines_.push_back({std::min(a, b), std::max(a, b), edge, node});
    }
    std::sort(lines_.begin(), lines_.end());
  }

  void number_parts() {
    result_.sides.resize(parts_.size());
    run_tasks(task_.threads, cost_, [&](int i) {
      if (parts_[i].mesh) result_.sides[i] = number_sides(*parts_[i].mesh);
    });
  }

  // Middle of the line between two joined nodes that bounds the face, or -1.
  int line_node(int one, int other, int face) const {
    auto [a, b] = std::minmax(one, other);
    auto line = std::lower_bound(lines_.begin(), lines_.end(), Line{a, b, -1, -1});
    for (; line != lines_.end() && line->a == a && line->b == b; ++line) {
      const std::vector<int>& faces = task_.model.edges[line->edge].faces;
      if (std::find(faces.begin(), faces.end(), face) != faces.end()) return line->node;
    }
    return -1;
  }

  int cut_of(const MeshPart& part, int v, int w) const {
    const std::vector<int>& global = part.mesh->global;
    if (global[v] < 0 || global[w] < 0) return -1;
    const std::size_t boundary = task_.edges.nodes.size();
    return task_.cuts.find(part.region->face, shared_node(global[v], part.outline, boundary),
                           shared_node(global[w], part.outline, boundary));
  }

  // Cuts that are used get their nodes first; border sides on neither line nor cut count as the part's own.
  void number_nodes() {
    result_.cut_node.assign(task_.cuts.sides().size(), -1);
    constexpr int is_used = 0;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      PartSides& sides = result_.sides[i];
      for (auto [v, w] : sides.border) {
        const std::vector<int>& node_of = *parts_[i].node_of;
        const int node = line_node(node_of[v], node_of[w], parts_[i].region->face);
        const int cut = node < 0 ? cut_of(parts_[i], v, w) : -1;
        if (cut >= 0) result_.cut_node[cut] = is_used;
        sides.border_cut.push_back(cut);
        sides.border_node.push_back(node);
      }
    }
    int next = static_cast<int>(mesh().nodes.size());
    for (int& node : result_.cut_node)
      if (node == is_used) node = next++;
    result_.first_inside = next;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      PartSides& sides = result_.sides[i];
      sides.first_own = next;
      for (std::size_t k = 0; k < sides.border.size(); ++k) {
        int& node = sides.border_node[k];
        if (sides.border_cut[k] >= 0) node = result_.cut_node[sides.border_cut[k]];
        if (node >= 0) continue;
        node = next + static_cast<int>(sides.inside.size());
        sides.inside.push_back(sides.border[k]);
      }
      const long own = static_cast<long>(sides.inside.size()) + task_.sizes[i].quads;
      result_.own_nodes.push_back(own);
      next += static_cast<int>(own);
    }
    mesh().nodes.resize(static_cast<std::size_t>(next));
    mesh().node_edge.resize(static_cast<std::size_t>(next), -1);
    mesh().node_target.resize(static_cast<std::size_t>(next), 0);
  }

  void fill_elements() {
    mesh().quads.resize(9 * mesh().quad_count());
    mesh().triangles.resize(6 * mesh().triangle_count());
    const std::vector<PartRows> first = part_rows(task_.sizes);
    run_tasks(task_.threads, cost_, [&](int i) {
      if (parts_[i].mesh) fill_part(static_cast<std::size_t>(i), first[i].quad, first[i].triangle);
    });
  }

  void fill_part(std::size_t i, std::size_t quad, std::size_t triangle) {
    const PartSides& sides = result_.sides[i];
    int centre = sides.first_own + static_cast<int>(sides.inside.size());
    const bool is_reversed = task_.model.faces[parts_[i].region->face].is_reversed;
    const std::vector<Element>& elements = parts_[i].mesh->elements;
    for (std::size_t e = 0; e < elements.size(); ++e) {
      if (!elements[e].is_alive()) continue;
      const int n = elements[e].corners();
      int* to = n == 4 ? &mesh().quads[9 * quad] : &mesh().triangles[6 * triangle];
      const int* from = n == 4 ? &quads_of_four_[4 * quad++] : &triangles_of_three_[3 * triangle++];
      for (int k = 0; k < n; ++k) {
        const int side = sides.of_element[e][is_reversed ? n - 1 - k : k];
        to[k] = from[k];
        to[n + k] = side >= 0 ? sides.first_own + side : sides.border_node[-1 - side];
      }
      if (n == 4) to[8] = centre++;
    }
  }

  const CurvingTask& task_;
  const std::vector<MeshPart>& parts_;
  const std::vector<double> cost_;
  std::vector<int> lines_of_two_, quads_of_four_, triangles_of_three_;  // as joined
  std::vector<Line> lines_;
  OrderTwoMesh result_;
};

}  // namespace

PartSides number_sides(const RegionMesh& mesh) {
  PartSides sides;
  sides.of_element.resize(mesh.elements.size());
  sides.inside.reserve(2 * mesh.elements.size());
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const Element& element = mesh.elements[e];
    if (!element.is_alive()) continue;
    for (int k = 0, n = element.corners(); k < n; ++k) {
      const int a = element.v[k], b = element.v[(k + 1) % n], other = mesh.across(a, b);
      int& side = sides.of_element[e][k];
      if (other < 0) {
        side = -1 - static_cast<int>(sides.border.size());
        sides.border.push_back({a, b});
      } else if (other < static_cast<int>(e)) {
        side = sides.of_element[other][mesh.elements[other].corner_of(b)];
      } else {
        side = static_cast<int>(sides.inside.size());
        sides.inside.push_back({a, b});
      }
    }
  }
  return sides;
}

OrderTwoMesh number_order_2(SurfaceMesh linear, const CurvingTask& task) {
  return Raiser(std::move(linear), task).run();
}

Vec3 blended_centre(const SurfaceMesh& mesh, int quad) {
  const int* nodes = &mesh.quads[9 * static_cast<std::size_t>(quad)];
  Vec3 corners, middles;
  for (int i = 0; i < 4; ++i) {
    corners += mesh.nodes[nodes[i]];
    middles += mesh.nodes[nodes[4 + i]];
  }
  return 0.5 * middles - 0.25 * corners;
}

}  // namespace paver
