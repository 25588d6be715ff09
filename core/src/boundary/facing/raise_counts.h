// Larger counts on edges, for the sake of the faces beside them.
#pragma once

#include <vector>

#include "boundary/facing/opposite_sides.h"
#include "boundary/parity.h"
#include "sizing/size_field.h"
#include "topology/model.h"

namespace paver {

// `loops[f]`: linked_loops of face f without periodic edges.

/// Gives two intervals to the edges of faces with two or three sides, of which all but one have one interval each: a
/// quad there would have two sides on the other one, and no angle between them. Not where one of these edges is short
/// against the target length.
void divide_few_sides(const Model& model, const std::vector<std::vector<Loop>>& loops, std::vector<EdgeCount>& counts);

/// Gives three intervals to both edges of a face between two, as between two meridians of a spindle, that turns too far
/// from one to the other for one element: two columns of quads end in its tips then, where there is room for triangles
/// only between fewer nodes.
void divide_lunes(const Model& model, double turn_limit, const std::vector<std::vector<Loop>>& loops,
                  std::vector<EdgeCount>& counts);

/// Where a face is at most three target lengths across, and a gap between its two loops is narrower than 0.7 of them,
/// the loop of fewer intervals gets as many as the other one: both some more so that its edges get equally many, or
/// each what suits the nodes that it faces; but only where one row of quads across the gap is good with these.
void match_gaps(const Model& model, const SizeField& size, const std::vector<std::vector<Loop>>& loops,
                std::vector<EdgeCount>& counts);

/// Of a face far narrower than its intervals with vertices on both of its sides, that are more than its width from
/// those of the other side: edges get as many intervals as it takes for a node opposite each vertex.
void match_vertices(const Model& model, const std::vector<OppositeSides>& pairs, std::vector<EdgeCount>& counts);

/// Of a face between four corners whose long sides bulge from the chords of their intervals by more than half of its
/// width the side of fewer intervals gets as many as the other: chords of unequal ones would cross.
void match_bent_strips(const Model& model, const std::vector<OppositeSides>& pairs, std::vector<EdgeCount>& counts);

}  // namespace paver
