// Places at which edges of a face are to be divided.
#pragma once

#include <vector>

#include "sizing/gaps/banks.h"
#include "sizing/merging/merge_limits.h"

namespace paver {

struct GapPlace {
  int edge = -1;
  double t = 0, before = 0, behind = 0, distance = 0, apart = 0;  // apart: mm, from others
};

/// Gaps are as many times as long as wide at least.
constexpr double gap_slenderness = 5;
/// Cosine between the way across and that into the face.
constexpr double straight_across = 0.9;
/// Of the width, as far from its end as a gap is long at least: what widens by more is none.
constexpr double most_widening = 1.5;

/// Opposite the ends of edges that run along other ones.
void find_gap_ends(const FaceBanks& banks, const MergeLimits& limits, std::vector<GapPlace>& found);

/// Where edges that bend away from each other are nearest, on both.
void find_necks(const FaceBanks& banks, const MergeLimits& limits, std::vector<GapPlace>& found);

}  // namespace paver
