// How the parts of a mesh that several ranks hold are numbered and placed in one file.
#pragma once

#include "base/tasks/gather.h"
#include "output/numbering_impl.h"
#include "paver/mesher.h"

namespace paver {

/// Rows of one group that follow each other in the file.
struct PlacedRun {
  int group;
  long position;           ///< of the first one, among all rows of the group
  std::size_t begin, end;  ///< in PlacedRows::held.rows
};

/// The rows of one table that all ranks hold together, dealt into groups and in each group in the order of the whole.
struct PlacedRows {
  Grouping held;                ///< rows of this rank; for nodes also those that other ranks own
  std::vector<long> size;       ///< per group: rows of all ranks
  std::vector<PlacedRun> runs;  ///< of this rank's own rows, by group and position
};

/// Collective. `group_of`: per row of this rank its group or -1; `number`: its number in the whole, rising; `is_own`:
/// whether this rank writes it, or null: all. Groups that only one rank has cost no more than a sum.
PlacedRows place_rows(const std::vector<int>& group_of, int groups, const std::vector<long>& number,
                      const std::vector<char>* is_own, Ranks& ranks);

/// Tags of nodes: 1, 2, ... in the order of the whole for all that are written.
struct NodeTags {
  std::vector<long> of_node;  ///< per node of this rank; 0: not written
  long count = 0;             ///< of the whole
};

/// Collective. `is_written`: per node of this rank, the same on all that hold it.
NodeTags number_nodes(const MeshShare& share, const std::vector<char>& is_written, Ranks& ranks);

/// Collective. Per node of this rank: the face of the last element, of all ranks, that uses it (triangles before
/// quads); -1: none, or the node is left out. `leaves_out`: per node, the same on all ranks that hold it.
std::vector<int> faces_of_nodes(const MeshShare& share, const std::vector<char>& leaves_out, Ranks& ranks);

}  // namespace paver
