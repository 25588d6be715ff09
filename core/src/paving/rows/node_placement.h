// New nodes of a row: where they should go, and which node the front really gives there.
#pragma once

#include "paving/front/front.h"

namespace paver {

/// A wished node: at `length` from `base` in direction `angle`, counter-clockwise from the outgoing facet.
struct Wish {
  int base = -1;
  MetricVec direction;     ///< unit tangent vector at base
  double length = 0;       ///< mm
  double width = 0;        ///< mm, the longer facet at base: how near a front node may lie beside the wished one
  bool is_turned = false;  ///< beside a side that leans
};

/// Direction at the end node of facet f, `angle` radians counter-clockwise from its next facet.
Wish make_wish(const Front& front, int f, double angle, double length);

/// Direction square to the front at the end node of facet f, taken over a stretch of about `length`: where facets are
/// much shorter than the row is high, bisectors of single corners would cross.
Wish make_wide_wish(const Front& front, int f, double length);

/// Node for a wish: one of the front where that is close, else a new one, which is not yet in the void.
/// -1 when nothing fits. `start` is a triangle of the sector at the wish's base; `avoid_*` are nodes not to be taken.
struct Granted {
  int node = -1;
  bool is_new = false;
};
Granted grant(Front& front, const Wish& wish, int start, int avoid_a, int avoid_b);

}  // namespace paver
