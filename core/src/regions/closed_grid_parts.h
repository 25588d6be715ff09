// What the grids of closed faces have in common.
#pragma once

#include "regions/closed_grid.h"
#include "regions/grid_smoothing.h"

namespace paver {

/// Chart of the parameters themselves, times `scale`, for nodes away from poles.
std::shared_ptr<const Chart> make_plain_chart(Vec2 scale = {1, 1});

/// Mean scales of a closed face.
struct FaceExtent {
  double elements = 0;         ///< integral of 1/h^2 over the area
  double round = 0, tall = 0;  ///< mean length along box.x and along box.y, mm
  double girth = 0;            ///< greatest length along box.x, mm
};
FaceExtent measure_extent(const ClosedFace& face);

/// (u, v) of a place in the box, whose axes may be swapped.
inline Vec2 box_uv(const ParameterBox& box, Vec2 place) { return box.is_swapped ? Vec2{place.y, place.x} : place; }

/// Whether the elements are sound, turn little with the surface and vary in length by no more than `most_uneven`.
bool is_good(const GridFigures& figures, double most_uneven, double most_turn);

/// Turns all quads counter-clockwise in the patch's chart and finds its outline; false where a quad is not positive.
bool finish_patch(GridPatch& patch);

}  // namespace paver
