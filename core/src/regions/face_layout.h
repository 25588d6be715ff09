// How each face is laid out in the plane: which chart, and which of its periodic edges disappear.
#pragma once

#include <vector>

#include "charts/chart.h"
#include "structured/closed_layout.h"
#include "topology/model.h"

namespace paver {

enum class LayoutKind {
  row,        ///< one region, row chart; periodic edges, if any, are cuts
  polar,      ///< one region that goes round: polar chart, periodic edge gone, a pole inside or none
  sector,     ///< one region that goes most of the way round a pole at its border: polar chart
  two_polar,  ///< goes round with a pole at either end: cut into two polar regions along a row
  closed,     ///< no border at all: regions are parts of a structured layout
};

struct FaceLayout {
  LayoutKind kind = LayoutKind::row;
  ParameterBox box;
  double period = 0;                           ///< of the direction that goes round
  double cut = 0;                              ///< two_polar: where (along the meridian)
  std::shared_ptr<const ClosedLayout> closed;  ///< of the whole face
  std::vector<std::vector<bool>> dropped;      ///< per loop and coedge: periodic edge that disappears
  std::vector<int> slits;  ///< periodic edges that others have: both sides lie on one line of the chart
};

/// Whether closed faces get their layouts, or are taken to have one: that is all that counts of intervals depend on.
enum class ClosedLayouts { made, assumed };

/// One layout per face, from topology; those of closed faces from their target length.
std::vector<FaceLayout> plan_layouts(const Model& model, const SizeField& size, ClosedLayouts closed,
                                     const Progress& progress);

/// Edges that no region needs get no intervals; closed edges that stay as cuts get an even number.
void settle_counts(const Model& model, const std::vector<FaceLayout>& layouts, std::vector<int>& counts);

}  // namespace paver
