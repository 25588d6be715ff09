// Numbers of a share in the whole mesh. Nodes of the whole, in this order: boundary stage, outlines, each part's own;
// at order 2 the middles of the lines, of the cuts, then each part's middles and centres. Elements: part by part.
#include "assemble/assembler.h"
#include "base/tasks/gather.h"

namespace paver {
namespace {

struct PartRow : PartSizes {
  long part = 0, own_nodes = 0;
};

using Count = long PartRow::*;  ///< of what is numbered

/// Things that several ranks may have: each belongs to the first that has it, and counts once.
struct Shared {
  std::vector<int> owner;    ///< per thing: rank, -1 where none has it
  std::vector<long> number;  ///< per thing that some rank has: its place among those
  long count = 0;

  Shared(const std::vector<int>& mine, std::size_t things, Ranks& ranks) : owner(things, -1), number(things, -1) {
    const std::vector<std::string> all = ranks.gather(pack(mine));
    for (int rank = 0; rank < ranks.count(); ++rank)
      for (int thing : unpack<std::vector<int>>(all[rank]))
        if (owner[thing] < 0) owner[thing] = rank;
    for (std::size_t i = 0; i < things; ++i)
      if (owner[i] >= 0) number[i] = count++;
  }
};

class Numberer {
 public:
  Numberer(ShareNumbers& share, Ranks& ranks) : share_(share), ranks_(ranks) {}

  void add_run(long first, long count, bool is_own, bool is_shared) {
    for (long i = 0; i < count; ++i) share_.node_number.list.push_back(first + i);
    share_.is_own_node.insert(share_.is_own_node.end(), static_cast<std::size_t>(count), is_own);
    share_.is_shared_node.insert(share_.is_shared_node.end(), static_cast<std::size_t>(count), is_shared);
  }
  void add_common(long first, long count) { add_run(first, count, ranks_.rank() == 0, true); }
  void add_private(long first, long count) { add_run(first, count, true, false); }

  void add_shared(long first, const std::vector<int>& mine, const Shared& shared) {
    for (int thing : mine) {
      share_.node_number.list.push_back(first + shared.number[thing]);
      share_.is_own_node.push_back(shared.owner[thing] == ranks_.rank());
      share_.is_shared_node.push_back(true);
    }
  }

  // Of each part's rows the first number, and what comes after the last.
  static std::vector<long> firsts(const std::vector<PartRow>& rows, Count count, long first) {
    std::vector<long> result{first};
    for (const PartRow& row : rows) result.push_back(result.back() + row.*count);
    return result;
  }

 private:
  ShareNumbers& share_;
  Ranks& ranks_;
};

std::vector<PartRow> gather_rows(const std::vector<PartRow>& mine, Ranks& ranks) {
  std::vector<PartRow> all(mine.size());
  std::vector<PartRow> here;
  for (const PartRow& row : mine)
    if (row.nodes + row.quads + row.triangles > 0) here.push_back(row);
  for (const PartRow& row : gather_all(here, ranks)) all[row.part] = row;
  return all;
}

void number_elements(const std::vector<PartRow>& mine, const std::vector<long>& first, Count count,
                     RowNumbers& numbers) {
  for (std::size_t i = 0; i < mine.size(); ++i)
    for (long k = 0; k < mine[i].*count; ++k) numbers.list.push_back(first[i] + k);
}

}  // namespace

void Assembler::number() {
  ShareNumbers& share = share_;
  share = ranks_.count() == 1 ? whole_numbers(mesh_) : ShareNumbers{};
  if (ranks_.count() == 1) return;
  std::vector<PartRow> mine;
  for (std::size_t i = 0; i < parts_.size(); ++i)
    mine.push_back({joined_.sizes[i], static_cast<long>(i), options_.order > 1 ? curved_.own_nodes[i] : 0});
  const std::vector<PartRow> all = gather_rows(mine, ranks_);
  const Shared outlines(joined_.outline, static_cast<std::size_t>(paver_.outline_nodes()), ranks_);
  Numberer numberer(share, ranks_);
  const long boundary = joined_.boundary_nodes;
  numberer.add_common(0, boundary);
  numberer.add_shared(boundary, joined_.outline, outlines);
  std::vector<long> first = Numberer::firsts(all, &PartRow::nodes, boundary + outlines.count);
  for (std::size_t i = 0; i < mine.size(); ++i) numberer.add_private(first[i], mine[i].nodes);
  share.nodes = first.back();
  if (options_.order > 1) {
    const Shared cuts(curved_.cuts, cuts_->sides().size(), ranks_);
    const long lines = static_cast<long>(mesh_.line_edge.size());
    numberer.add_common(share.nodes, lines);
    numberer.add_shared(share.nodes + lines, curved_.cuts, cuts);
    first = Numberer::firsts(all, &PartRow::own_nodes, share.nodes + lines + cuts.count);
    for (std::size_t i = 0; i < mine.size(); ++i) numberer.add_private(first[i], mine[i].own_nodes);
    share.nodes = first.back();
  }
  const std::vector<long> quads = Numberer::firsts(all, &PartRow::quads, 0),
                          triangles = Numberer::firsts(all, &PartRow::triangles, 0);
  number_elements(mine, quads, &PartRow::quads, share.quad_number);
  number_elements(mine, triangles, &PartRow::triangles, share.triangle_number);
  share.quads = quads.back();
  share.triangles = triangles.back();
}

}  // namespace paver
