// Positions in the file by runs: what a rank holds of a table is a few stretches of consecutive numbers, so it is the
// stretches that ranks tell each other, and only where more than one rank has rows of a group.
#include <algorithm>
#include <tuple>

#include "output/share_numbering_impl.h"

namespace paver {
namespace {

/// As it goes from rank to rank.
struct RunRecord {
  long group, first, count;
};

bool operator<(const RunRecord& a, const RunRecord& b) {
  return std::tie(a.group, a.first) < std::tie(b.group, b.first);
}

/// Runs of own rows: no row of the group that another rank writes can lie within one. Between two neighbours of a run
/// this rank holds all numbers, or the run would end, and those of the same group would be in `held`, too.
std::vector<PlacedRun> own_runs(const Grouping& held, const std::vector<long>& number,
                                const std::vector<char>* is_own) {
  std::vector<PlacedRun> runs;
  for (std::size_t group = 0; group < held.count(); ++group) {
    bool is_open = false;
    for (std::size_t i = held.start[group]; i < held.start[group + 1]; ++i) {
      std::size_t row = static_cast<std::size_t>(held.rows[i]);
      if (is_own && !(*is_own)[row]) {
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

}  // namespace

PlacedRows place_rows(const std::vector<int>& group_of, int groups, const std::vector<long>& number,
                      const std::vector<char>* is_own, Ranks& ranks) {
  PlacedRows placed;
  placed.held = group_rows(group_of, groups);
  placed.runs = own_runs(placed.held, number, is_own);
  std::size_t n = static_cast<std::size_t>(groups);
  std::vector<long> sums(2 * n, 0);  // rows, then ranks that have some
  for (const PlacedRun& run : placed.runs)
    sums[static_cast<std::size_t>(run.group)] += static_cast<long>(run.end - run.begin);
  for (std::size_t group = 0; group < n; ++group) sums[n + group] = sums[group] > 0;
  ranks.add_up(sums);
  placed.size.assign(sums.begin(), sums.begin() + groups);

  auto is_common = [&](int group) { return sums[n + static_cast<std::size_t>(group)] > 1; };
  auto first_number = [&](const PlacedRun& run) {
    return number[static_cast<std::size_t>(placed.held.rows[run.begin])];
  };
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

NodeTags number_nodes(const MeshShare& share, const std::vector<char>& is_written, Ranks& ranks) {
  const std::vector<long>& number = share.node_number;
  std::vector<RunRecord> own;  // of consecutive numbers
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (!is_written[i] || !share.is_own_node[i]) continue;
    if (own.empty() || own.back().first + own.back().count != number[i]) own.push_back({0, number[i], 0});
    ++own.back().count;
  }
  std::vector<RunRecord> all = gather_all(own, ranks);
  std::sort(all.begin(), all.end());
  NodeTags tags;
  tags.of_node.assign(number.size(), 0);
  auto run = all.begin();
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (!is_written[i]) continue;
    for (; run->first + run->count <= number[i]; ++run) tags.count += run->count;
    tags.of_node[i] = tags.count + number[i] - run->first + 1;
  }
  for (; run != all.end(); ++run) tags.count += run->count;
  return tags;
}

std::vector<int> faces_of_nodes(const MeshShare& share, const std::vector<char>& leaves_out, Ranks& ranks) {
  struct Record {
    long number, element, face;
  };
  const SurfaceMesh& mesh = share.result.mesh;
  std::vector<int> face(mesh.nodes.size(), -1);
  std::vector<Record> records;  // of shared nodes; several of one node rise by element
  auto mark = [&](const std::vector<int>& table, const std::vector<int>& face_of, const std::vector<long>& element,
                  long offset, std::size_t stride) {
    for (std::size_t i = 0; i < table.size(); ++i) {
      std::size_t node = static_cast<std::size_t>(table[i]), row = i / stride;
      if (leaves_out[node]) continue;
      face[node] = face_of[row];
      if (share.is_shared_node[node]) records.push_back({share.node_number[node], offset + element[row], face_of[row]});
    }
  };
  mark(mesh.triangles, mesh.triangle_face, share.triangle_number, 0,
       static_cast<std::size_t>(mesh.nodes_per_triangle()));
  mark(mesh.quads, mesh.quad_face, share.quad_number, share.triangles, static_cast<std::size_t>(mesh.nodes_per_quad()));

  auto reduce = [](std::vector<Record>& list) {  // the last element of each node
    auto key = [](const Record& r) { return std::tie(r.number, r.element); };
    std::sort(list.begin(), list.end(), [&](const Record& a, const Record& b) { return key(a) < key(b); });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < list.size(); ++i)
      if (i + 1 == list.size() || list[i + 1].number != list[i].number) list[kept++] = list[i];
    list.resize(kept);
  };
  reduce(records);
  std::vector<Record> all = gather_all(records, ranks);
  reduce(all);
  auto at = all.begin();
  for (std::size_t node = 0; node < face.size(); ++node) {
    if (!share.is_shared_node[node]) continue;
    while (at != all.end() && at->number < share.node_number[node]) ++at;
    if (at != all.end() && at->number == share.node_number[node]) face[node] = static_cast<int>(at->face);
  }
  return face;
}

}  // namespace paver
