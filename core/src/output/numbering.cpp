// Positions in the file by runs: what a rank holds of a table is a few stretches of consecutive numbers, so it is the
// stretches that ranks tell each other, and only where more than one rank has rows of a group.
#include <algorithm>
#include <array>
#include <compare>
#include <numeric>
#include <tuple>

#include "base/tasks/gather.h"
#include "mesh/element_table.h"
#include "output/numbering_impl.h"

namespace paver {
namespace {

/// As it goes from rank to rank.
struct RunRecord {
  long group, first, count;
  auto operator<=>(const RunRecord&) const = default;
};

/// Runs of own rows: no row of the group that another rank writes can lie within one. Between two neighbours of a run
/// this rank holds all numbers, or the run would end, and those of the same group would be in `held`, too. `is_own`:
/// per row; empty: all are.
std::vector<PlacedRun> own_runs(const Grouping& held, const RowNumbers& number, const std::vector<char>& is_own) {
  std::vector<PlacedRun> runs;
  for (std::size_t group = 0; group < held.count(); ++group) {
    bool is_open = false;
    for (std::size_t i = held.start[group]; i < held.start[group + 1]; ++i) {
      std::size_t row = static_cast<std::size_t>(held.rows[i]);
      if (!is_own.empty() && !is_own[row]) {
        is_open = false;
        continue;
      }
      if (is_open) {
        std::size_t last = static_cast<std::size_t>(held.rows[i - 1]);
        is_open = number[row] - number[last] == static_cast<long>(row - last);
      }
      if (!is_open) runs.push_back({static_cast<int>(group), 0, i, i});
      runs.back().end = i + 1;
      is_open = true;
    }
  }
  return runs;
}

/// Collective. Rows that several ranks share out. `group_of`: per row of this rank its group or -1; `number`: in the
/// whole. Groups that only one rank has cost no more than a sum.
PlacedRows place_rows(const std::vector<int>& group_of, int groups, const RowNumbers& number,
                      const std::vector<char>& is_own, Ranks& ranks) {
  PlacedRows placed;
  placed.held = group_rows(group_of, groups);
  placed.runs = own_runs(placed.held, number, is_own);
  std::size_t n = static_cast<std::size_t>(groups);
  std::vector<long> sums(2 * n, 0);  // rows, then ranks that have some
  for (const PlacedRun& run : placed.runs) sums[run.group] += static_cast<long>(run.end - run.begin);
  for (std::size_t group = 0; group < n; ++group) sums[n + group] = sums[group] > 0;
  ranks.add_up(sums);
  placed.size.assign(sums.begin(), sums.begin() + groups);

  auto is_common = [&](int group) { return sums[n + static_cast<std::size_t>(group)] > 1; };
  auto first_number = [&](const PlacedRun& run) { return number[placed.held.rows[run.begin]]; };
  std::vector<RunRecord> records;
  for (const PlacedRun& run : placed.runs) {
    if (is_common(run.group)) records.push_back({run.group, first_number(run), static_cast<long>(run.end - run.begin)});
  }
  std::vector<RunRecord> all = gather_all(records, ranks);
  std::sort(all.begin(), all.end());
  long position = 0;
  auto next = all.begin();
  for (PlacedRun* run = placed.runs.data(); run != placed.runs.data() + placed.runs.size(); ++run) {
    bool is_new_group = run == placed.runs.data() || run[-1].group != run->group;
    if (is_new_group) position = 0;
    if (!is_common(run->group)) {  // its runs follow each other
      run->position = position;
      position += static_cast<long>(run->end - run->begin);
      continue;
    }
    for (; next->group < run->group || next->first < first_number(*run); ++next)
      if (next->group == run->group) position += next->count;
    run->position = position;
  }
  return placed;
}

/// Collective. Of all ranks together.
void unite_edges_of_faces(std::vector<std::vector<int>>& face_edges, Ranks& ranks) {
  std::vector<std::array<int, 2>> sides;  // face and edge
  for (std::size_t face = 0; face < face_edges.size(); ++face)
    for (int edge : face_edges[face]) sides.push_back({static_cast<int>(face), edge});
  sides = gather_all(sides, ranks);
  std::sort(sides.begin(), sides.end());
  sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
  for (std::vector<int>& list : face_edges) list.clear();
  for (auto [face, edge] : sides) face_edges[face].push_back(edge);
}

/// Rows that every rank holds: groups are written in turn.
PlacedRows deal_groups(const std::vector<int>& group_of, int groups, const Ranks& ranks) {
  PlacedRows placed;
  placed.held = group_rows(group_of, groups);
  for (int group = 0; group < groups; ++group) {
    const auto g = static_cast<std::size_t>(group);
    placed.size.push_back(static_cast<long>(placed.held.size(g)));
    if (placed.size[g] > 0 && group % ranks.count() == ranks.rank())
      placed.runs.push_back({group, 0, placed.held.start[g], placed.held.start[g + 1]});
  }
  return placed;
}

}  // namespace

std::size_t PlacedRows::used_groups() const {
  return static_cast<std::size_t>(std::count_if(size.begin(), size.end(), [](long rows) { return rows > 0; }));
}

long PlacedRows::total() const { return std::accumulate(size.begin(), size.end(), 0L); }

NodeTags number_nodes(const ShareNumbers& numbers, const std::vector<char>& is_written, Ranks& ranks) {
  const RowNumbers& number = numbers.node_number;
  std::vector<RunRecord> own;  // of consecutive numbers
  for (std::size_t i = 0; i < is_written.size(); ++i) {
    if (!is_written[i] || !numbers.is_own(i)) continue;
    if (own.empty() || own.back().first + own.back().count != number[i]) own.push_back({0, number[i], 0});
    ++own.back().count;
  }
  std::vector<RunRecord> all = gather_all(own, ranks);
  std::sort(all.begin(), all.end());
  NodeTags tags;
  tags.of_node.assign(is_written.size(), 0);
  auto run = all.begin();
  for (std::size_t i = 0; i < is_written.size(); ++i) {
    if (!is_written[i]) continue;
    for (; run->first + run->count <= number[i]; ++run) tags.count += run->count;
    tags.of_node[i] = tags.count + number[i] - run->first + 1;
  }
  for (; run != all.end(); ++run) tags.count += run->count;
  return tags;
}

std::vector<int> faces_of_nodes(HeldMesh held, const std::vector<int>& curve, Ranks& ranks) {
  struct Record {
    long number, element, face;
  };
  const SurfaceMesh& mesh = held.result.mesh;
  const ShareNumbers& numbers = held.numbers;
  std::vector<int> face(mesh.nodes.size(), -1);
  std::vector<Record> records;  // of shared nodes; several of one node rise by element
  auto mark = [&](const ElementTable& table, const RowNumbers& element, long offset) {
    for (std::size_t row = 0; row < table.count(); ++row)
      for (std::size_t k = 0; k < table.stride; ++k) {
        const auto node = static_cast<std::size_t>(table.row(row)[k]);
        if (!curve.empty() && curve[node] >= 0) continue;
        face[node] = table.face[row];
        if (numbers.is_shared(node))
          records.push_back({numbers.node_number[node], offset + element[row], table.face[row]});
      }
  };
  mark({mesh, false}, numbers.triangle_number, 0);
  mark({mesh, true}, numbers.quad_number, numbers.triangles);

  auto reduce = [](std::vector<Record>& list) {  // the last element of each node
    auto key = [](const Record& r) { return std::tie(r.number, r.element); };
    std::ranges::sort(list, {}, key);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < list.size(); ++i)
      if (i + 1 == list.size() || list[i + 1].number != list[i].number) list[kept++] = list[i];
    list.resize(kept);
  };
  reduce(records);
  std::vector<Record> all = gather_all(records, ranks);
  reduce(all);
  for (const Record& record : all)
    if (int node = numbers.node_number.row_of(record.number); node >= 0) face[node] = static_cast<int>(record.face);
  return face;
}

Numbering::Numbering(HeldMesh held, Ranks& ranks) {
  const SurfaceMesh& mesh = held.result.mesh;
  const ShareNumbers& numbers = held.numbers;
  const int faces = static_cast<int>(greatest(face_count(held.result), ranks));
  const int edges = mesh.line_edge.empty() ? 0 : 1 + *std::max_element(mesh.line_edge.begin(), mesh.line_edge.end());
  quads = place_rows(mesh.quad_face, faces, numbers.quad_number, {}, ranks);
  triangles = place_rows(mesh.triangle_face, faces, numbers.triangle_number, {}, ranks);
  lines = deal_groups(mesh.line_edge, edges, ranks);
  std::vector<int> itself(mesh.points.size());
  std::iota(itself.begin(), itself.end(), 0);
  points = deal_groups(itself, static_cast<int>(itself.size()), ranks);
  const std::vector<int> curve = curve_of_nodes(mesh, lines.held), face = faces_of_nodes(held, curve, ranks);
  curve_nodes = deal_groups(curve, edges, ranks);
  surface_nodes = place_rows(face, faces, numbers.node_number, numbers.is_own_node, ranks);
  std::vector<char> is_written(curve.size());
  for (std::size_t node = 0; node < curve.size(); ++node) is_written[node] = curve[node] >= 0 || face[node] >= 0;
  tags = number_nodes(numbers, is_written, ranks);
  std::vector<char> has_elements;
  for (std::size_t f = 0; f < quads.size.size(); ++f) has_elements.push_back(quads.size[f] + triangles.size[f] > 0);
  groups = find_groups(held.result, has_elements);
  face_edges = edges_of_faces(mesh, curve, faces);
  unite_edges_of_faces(face_edges, ranks);
}

}  // namespace paver
