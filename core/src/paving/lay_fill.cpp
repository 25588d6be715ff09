// In: region with its loop. Out: the loop's nodes on the outline of a grid, one surface evaluation for each one inside.
#include "paving/lay_fill.h"

#include <algorithm>

namespace paver {

std::optional<RegionMesh> lay_fill(const Region& region) {
  if (!region.fill) return std::nullopt;
  const MappedFill& fill = *region.fill;
  const int columns = fill.columns(), rows = fill.rows();
  RegionMesh mesh;
  std::vector<int> nodes(static_cast<std::size_t>(columns + 1) * (rows + 1), -1);  // row by row
  auto at = [&](int i, int j) -> int& { return nodes[static_cast<std::size_t>(j) * (columns + 1) + i]; };
  mesh.reserve(nodes.size());
  const std::vector<LoopNode>& loop = region.loops[0];
  const auto outline = fill.outline();
  for (std::size_t k = 0; k < loop.size(); ++k)
    at(outline[k][0] - fill.first[0], outline[k][1] - fill.first[1]) = add_node(region, loop[k], mesh);
  for (int j = 1; j < rows; ++j)
    for (int i = 1; i < columns; ++i)
      at(i, j) = add_node(region, fill.block->place(fill.first[0] + i, fill.first[1] + j), mesh);
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      Corners quad{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
      if (fill.block->is_clockwise) std::swap(quad[1], quad[3]);
      mesh.add_element(quad);
    }
  if (!are_all_positive(mesh)) return std::nullopt;
  return mesh;
}

}  // namespace paver
