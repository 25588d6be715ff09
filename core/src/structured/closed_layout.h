// Structured layouts of faces without a border: the sides of a cube or a prism on a sphere, columns around
// a torus.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "paver/progress.h"
#include "sizing/size_field.h"
#include "structured/block_grid.h"
#include "structured/mapped_fill.h"

namespace paver {

/// A closed face to be covered: `box` as its layout has it, `period` of the direction that goes round.
struct ClosedFace {
  const Surface& surface;
  const FaceSize& size;
  ParameterBox box;
  double period = 0;        ///< of box.x
  double other_period = 0;  ///< of box.y; 0 between two poles
  double turn_limit = 0;    ///< radians per element edge

  Vec2 periods() const { return box.uv({period, other_period}); }
};

/// The whole face, its blocks ready to be filled.
struct ClosedLayout {
  BlockLayout layout;
  std::vector<std::shared_ptr<const MappedBlock>> blocks;
};

/// Six blocks, eight nodes of valence 3, all others of valence 4; for a face that goes round between two smooth poles;
/// where its counts are far off a prism. Null where elements would come out too uneven (long thin bodies).
std::shared_ptr<const ClosedLayout> lay_cube(const ClosedFace& face, const Progress& progress);

/// The same by a prism's sides: n blocks of three to five about each pole, rings between them. Of few elements, where
/// no cube has about as many as are asked for. Null where no such prism is nearer than `most_off` of these, or all come
/// out too uneven.
std::shared_ptr<const ClosedLayout> lay_prism(const ClosedFace& face, double most_off, const Progress& progress);

/// Columns around a face that goes round both ways: no irregular node where these are about equally wide everywhere,
/// else more columns on the outer side than on the inner, with a few pairs of valence 3 and 5 between. Null where
/// elements would come out too uneven.
std::shared_ptr<const ClosedLayout> lay_torus(const ClosedFace& face, const Progress& progress);

// What these have in common.

/// Places along the way between two poles, by length.
class Meridian {
 public:
  explicit Meridian(const ClosedFace& face);
  /// (u, v) at `turns` of the way round and `share` of the way from the low pole.
  Vec2 uv(double turns, double share) const;

 private:
  const ClosedFace& face_;
  std::vector<double> arc_;
};

/// Chart of the parameters themselves, times `scale`, for nodes away from poles.
std::shared_ptr<const Chart> make_plain_chart(Vec2 scale = {1, 1});

/// Mean scales of a closed face.
struct FaceExtent {
  double elements = 0;         ///< integral of 1/h^2 over the area
  double round = 0, tall = 0;  ///< mean length along box.x and along box.y, mm
  double girth = 0;            ///< greatest length along box.x, mm
};
FaceExtent measure_extent(const ClosedFace& face);

/// Whether the elements are sound, turn little with the surface and vary in length by no more than `most_uneven`.
bool is_good(const GridFigures& figures, double most_uneven, double most_turn);

/// Quads up to which a grid is smoothed itself: a finer one bends so little between the places of such a one that these
/// do.
constexpr long most_placed = 2000;

/// A grid of the layout on the face, of about `most` quads where the layout has more.
BlockGrid placed_grid(const ClosedFace& face, const BlockLayout& layout, const BlockGrid::Places& places, long most,
                      const Progress& progress);

/// Null where a quad is not positive in its block's chart, or where `turn` (of GridFigures) is large and the quads,
/// curved, do not follow the surface.
std::shared_ptr<const ClosedLayout> mapped(const ClosedFace& face, const BlockLayout& layout, const BlockGrid& grid,
                                           double turn);

}  // namespace paver
