// How a coarse mesh divides its region: all that the fine mesh needs, so that its pieces can be made anywhere.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "multilevel/coarse/coarse_net.h"
#include "paving/front/front.h"

namespace paver {

/// The region falls into pieces, which share the fine nodes on the coarse edges between them: outline nodes.
struct LevelPlan {
  RegionMesh mesh;  ///< the coarse one
  CoarseNet net;
  std::vector<std::vector<int>> at;      ///< as CoarseRegion's
  std::vector<int> counts;               ///< per coarse edge: fine ones
  std::vector<char> is_paved;            ///< per coarse element: not divided but paved, neighbours together
  long closed_by_triangulation = 0;      ///< as PavedRegion's, of the coarse mesh
  int multilevel = 0;                    ///< as asked for (Options::multilevel): large patches have levels, too
  int boundary_nodes = 0;                ///< outline node i is shared node boundary_nodes + i (RegionMesh::global)
  std::vector<std::vector<int>> pieces;  ///< coarse elements of each, rising

  // From the above, by number_outlines():
  int outline_nodes = 0;
  std::vector<std::array<int, 2>> place_on_loop;  ///< per coarse node: loop and place in it, -1 inside
  std::vector<int> outline_of_node;               ///< per coarse node: its outline node, or -1
  std::vector<int> outline_of_edge;               ///< per coarse edge: its first outline node between the ends, or -1
  std::vector<std::array<int, 2>> outline_sides;  ///< shared nodes of every fine side on an outline
};

/// Fills in what follows from the pieces.
void number_outlines(LevelPlan& plan);

/// A plan as bytes, for other ranks; they know the region.
std::string pack(const LevelPlan& plan);
LevelPlan unpack_plan(std::string_view bytes);

}  // namespace paver
