// Regions of few elements meshed in other ways than paving.
#pragma once

#include <optional>

#include "paver/progress.h"
#include "paving/pave_region.h"
#include "repair/mend_region.h"

namespace paver {

/// At the same size as paving, for what repair alone cannot make good. References are kept.
class OtherWays {
 public:
  OtherWays(const Region& region, const Face& face, const BoundarySides& sides, const Options& options,
            const Progress& progress)
      : region_(region), face_(face), sides_(sides), options_(options), progress_(progress) {}

  /// Whether there is something to look at in a mesh without bad elements and twin sides.
  bool can_help(const RegionMesh& mesh) const;

  /// Where elements are left that are not valid or far too long, or the face is not whole, takes the first of a dome or
  /// tube, of paving that counts no turns, of either paving by the other rule for rows, and of a dome of many rows
  /// that, mended, leaves nothing. Where a few elements, some of them triangles, are worse than a grid of about as
  /// many or the rows of a tube, takes these.
  void improve(Mended& mended, PavedRegion& paved) const;

 private:
  bool is_sound(const RegionMesh& mesh) const;
  bool has_long_side(const RegionMesh& mesh) const;
  bool can_be_whole(const RegionMesh& mesh) const;
  bool is_coarse_and_mixed(const RegionMesh& mesh) const;
  bool make_whole(Mended& mended, PavedRegion& paved) const;
  bool make_regular(Mended& mended, PavedRegion& paved) const;
  bool take_grid(std::optional<RegionMesh> grid, Mended& mended, PavedRegion& paved) const;
  bool take_rows(std::optional<RegionMesh> rows, Mended& mended, PavedRegion& paved) const;
  bool pave_without_turns(Mended& mended, PavedRegion& paved) const;
  bool pave_by_other_rule(const Region& region, Mended& mended, PavedRegion& paved) const;
  template <class Pave>
  bool take_paved(const Region& region, Pave pave, Mended& mended, PavedRegion& paved) const;
  bool take(const Region& region, PavedRegion second, Mended& mended, PavedRegion& paved) const;

  const Region& region_;
  const Face& face_;
  const BoundarySides& sides_;
  const Options& options_;
  const Progress& progress_;
};

}  // namespace paver
