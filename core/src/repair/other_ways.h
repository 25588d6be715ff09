// Regions of few elements meshed in other ways than paving.
#pragma once

#include "paver/progress.h"
#include "paving/pave_region.h"
#include "repair/mend_region.h"

namespace paver {

/// For what repair alone cannot make good. References are kept.
struct OtherWays {
  const Region& region;
  const Face& face;
  const BoundarySides& sides;
  const Options& options;
  const Progress& progress;

  /// Whether there is something to look at in a mesh without bad elements and twin sides.
  bool can_help(const RegionMesh& mesh) const;

  /// Where elements are left that are not valid or far too long, or the face is not whole, takes the first of a dome or
  /// tube, of paving that counts no turns, of either paving by the other rule for rows, of a dome of many rows, and of
  /// paving with smaller elements that, mended, leaves nothing; the same where a few elements are too coarse for the
  /// shape, if these follow it better. Where a few elements, some of them triangles, are worse than a grid of about as
  /// many or the rows of a tube, takes these; else paving without triangles, or with elements about as long as the
  /// facets, where that leaves fewer triangles and no worse elements.
  void improve(Mended& mended, PavedRegion& paved) const;

  // Of a mesh of the region.
  bool is_sound(const RegionMesh& mesh) const;
  bool has_long_side(const RegionMesh& mesh) const;
  bool can_be_whole(const RegionMesh& mesh) const;
  /// Share of the region's area, where that can be told: what elements that are too coarse for its shape cut off.
  double lacking(const RegionMesh& mesh) const;
  bool is_too_coarse(const RegionMesh& mesh) const;
  bool is_coarse_and_mixed(const RegionMesh& mesh) const;

 private:
  bool has_known_area() const;
  ElementArea area_of(const RegionMesh& mesh) const;
};

}  // namespace paver
