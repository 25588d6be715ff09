// Steps: rings of marks on nodes and elements, with the marks of shared nodes told to all; marked elements with their
// nodes to all; sorted by their numbers in the whole mesh.
#include "assemble/neighbourhood.h"

#include <algorithm>

#include "base/tasks/gather.h"
#include "mesh/element_table.h"

namespace paver {
namespace {

struct NodeRow {
  long number = -1;
  Vec3 x;
  int edge = -1;
};

struct ElementRow {
  long number = -1;
  int face = -1;
  bool is_invalid = false;
  std::array<long, 9> nodes{};
};

/// One kind of element of a share.
struct Table : ElementTable {
  const RowNumbers& number;
  std::vector<char> is_marked, is_invalid;

  Table(const MeshShare& share, bool is_quad, const std::vector<int>& invalid)
      : ElementTable(share.result.mesh, is_quad),
        number(is_quad ? share.quad_number : share.triangle_number),
        is_marked(count(), 0),
        is_invalid(count(), 0) {
    for (int e : invalid) is_marked[e] = is_invalid[e] = 1;
  }
};

class Gatherer {
 public:
  Gatherer(const MeshShare& share, const std::vector<int>& quads, const std::vector<int>& triangles, Ranks& ranks)
      : share_(share),
        mesh_(share.result.mesh),
        ranks_(ranks),
        quads_(share, true, quads),
        triangles_(share, false, triangles),
        is_marked_(mesh_.nodes.size(), 0) {}

  Neighbourhood run(int rings) {
    for (int ring = 0; ring < rings; ++ring) {
      mark_nodes();
      share_marks();
      for (Table* table : {&quads_, &triangles_}) mark_elements(*table);
    }
    add_elements(quads_, result_.mesh.quads, result_.mesh.quad_face, result_.quad_number, result_.invalid_quads);
    add_elements(triangles_, result_.mesh.triangles, result_.mesh.triangle_face, result_.triangle_number,
                 result_.invalid_triangles);
    add_nodes();
    return std::move(result_);
  }

 private:
  void mark_nodes() {
    for (const Table* table : {&quads_, &triangles_})
      for (std::size_t e = 0; e < table->count(); ++e)
        for (int k = 0; table->is_marked[e] && k < table->corners; ++k) is_marked_[table->row(e)[k]] = 1;
  }

  void share_marks() {
    std::vector<long> mine;
    for (std::size_t v = 0; v < is_marked_.size(); ++v)
      if (is_marked_[v] && share_.is_shared(v)) mine.push_back(share_.node_number[v]);
    for (long number : gather_all(mine, ranks_))
      if (int v = share_.node_number.row_of(number); v >= 0) is_marked_[v] = 1;
  }

  void mark_elements(Table& table) {
    for (std::size_t e = 0; e < table.count(); ++e)
      for (int k = 0; k < table.corners; ++k) table.is_marked[e] |= is_marked_[table.row(e)[k]];
  }

  void add_elements(const Table& table, std::vector<int>& nodes, std::vector<int>& face, std::vector<long>& number,
                    std::vector<int>& invalid) {
    std::vector<ElementRow> mine, all;
    for (std::size_t e = 0; e < table.count(); ++e) {
      if (!table.is_marked[e]) continue;
      ElementRow& row = mine.emplace_back();
      row.number = table.number[e], row.face = table.face[e], row.is_invalid = table.is_invalid[e] != 0;
      for (std::size_t k = 0; k < table.stride; ++k) {
        row.nodes[k] = share_.node_number[table.row(e)[k]];
        add_node(table.row(e)[k]);
      }
    }
    all = gather_all(mine, ranks_);
    std::sort(all.begin(), all.end(), [](const ElementRow& a, const ElementRow& b) { return a.number < b.number; });
    for (const ElementRow& row : all) {
      if (row.is_invalid) invalid.push_back(static_cast<int>(face.size()));
      face.push_back(row.face);
      number.push_back(row.number);
      // Numbers of the whole until the nodes are known; they fit, as they do where one rank has the whole mesh.
      for (std::size_t k = 0; k < table.stride; ++k) nodes.push_back(static_cast<int>(row.nodes[k]));
    }
  }

  void add_node(int v) { mine_.push_back({share_.node_number[v], mesh_.nodes[v], mesh_.node_edge[v]}); }

  void add_nodes() {
    std::vector<NodeRow> all = gather_all(mine_, ranks_);
    std::stable_sort(all.begin(), all.end(), [](const NodeRow& a, const NodeRow& b) { return a.number < b.number; });
    SurfaceMesh& mesh = result_.mesh;
    mesh.order = mesh_.order;
    for (const NodeRow& row : all) {
      if (!result_.node_number.empty() && result_.node_number.back() == row.number) continue;
      result_.node_number.push_back(row.number);
      mesh.nodes.push_back(row.x);
      mesh.node_edge.push_back(row.edge);
    }
    mesh.node_target.assign(mesh.nodes.size(), 0);
    for (std::vector<int>* nodes : {&mesh.quads, &mesh.triangles})
      for (int& node : *nodes)
        node = static_cast<int>(std::lower_bound(result_.node_number.begin(), result_.node_number.end(), node) -
                                result_.node_number.begin());
  }

  const MeshShare& share_;
  const SurfaceMesh& mesh_;
  Ranks& ranks_;
  Table quads_, triangles_;
  std::vector<char> is_marked_;  // per node
  std::vector<NodeRow> mine_;
  Neighbourhood result_;
};

}  // namespace

Neighbourhood gather_neighbourhood(const MeshShare& share, const std::vector<int>& invalid_quads,
                                   const std::vector<int>& invalid_triangles, int rings, Ranks& ranks) {
  return Gatherer(share, invalid_quads, invalid_triangles, ranks).run(rings);
}

void put_nodes_back(const Neighbourhood& from, MeshShare& share) {
  for (std::size_t i = 0; i < from.node_number.size(); ++i)
    if (int v = share.node_number.row_of(from.node_number[i]); v >= 0) share.result.mesh.nodes[v] = from.mesh.nodes[i];
}

std::vector<int> rows_here(const std::vector<int>& rows, const std::vector<long>& numbers,
                           const RowNumbers& numbers_here) {
  std::vector<int> here;
  for (int row : rows)
    if (int at = numbers_here.row_of(numbers[row]); at >= 0) here.push_back(at);
  return here;
}

}  // namespace paver
