// Regular grids over faces without a border: a cube's six patches on a sphere, one grid around a torus.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "paver/progress.h"
#include "regions/chart.h"
#include "sizing/size_field.h"

namespace paver {

/// One piece of a closed grid, flat in its own chart: a region whose mesh is known.
struct GridPatch {
  std::shared_ptr<const Chart> chart;
  std::vector<int> node;                  ///< per patch node: node of the whole grid, on a cut more than once
  std::vector<Vec2> uv;                   ///< per patch node, without jumps inside the patch
  std::vector<std::array<int, 4>> quads;  ///< patch nodes, counter-clockwise in the chart
  std::vector<int> outline;               ///< patch nodes, counter-clockwise
};

/// Grid of a whole face, smoothed as if there were no cuts.
struct ClosedGrid {
  std::vector<double> h;  ///< per node: target length
  std::vector<GridPatch> patches;
};

/// A closed face to be covered: `box` as its layout has it, `period` of the direction that goes round.
struct ClosedFace {
  const Surface& surface;
  const FaceSize& size;
  ParameterBox box;
  double period = 0;        ///< of box.x
  double other_period = 0;  ///< of box.y; 0 between two poles
  double turn_limit = 0;    ///< radians per element edge
};

/// Six patches, eight nodes of valence 3, all others of valence 4; for a face that goes round between two smooth poles.
/// Null where elements would come out too uneven (long thin bodies).
std::shared_ptr<const ClosedGrid> make_cube_grid(const ClosedFace& face, const Progress& progress);

/// One patch without irregular nodes; for a face that goes round both ways. Rows run along the parameters or, where
/// that gives the lower energy, diagonally: edges then even out what the inner side of a tube is shorter than the
/// outer. Null where elements would come out too uneven.
std::shared_ptr<const ClosedGrid> make_torus_grid(const ClosedFace& face, const Progress& progress);

}  // namespace paver
