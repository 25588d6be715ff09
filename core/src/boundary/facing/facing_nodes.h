// Nodes of one side of a narrow face opposite the vertices of the other one.
#pragma once

#include <functional>
#include <vector>

#include "boundary/facing/opposite_sides.h"
#include "topology/model.h"

namespace paver {

/// Per edge: arc lengths of its nodes from its start, mm; empty where it is not divided.
using NodeLengths = std::vector<std::vector<double>>;

/// New lengths of one edge's nodes.
struct MovedNodes {
  int edge = -1;
  std::vector<double> lengths;
};

/// Whether an edge may be divided so: what would face one that may not stays where it is.
using MayMove = std::function<bool(const MovedNodes&)>;

/// The point of an edge at an arc length from its start, mm.
using EdgePoint = std::function<Vec3(int edge, double length)>;

/// Where a face between four corners is narrower than its intervals, has equally many on both sides and vertices
/// between the ends of one side or both: nodes that face these, as far as they are needed to be at most half a width
/// from what they face. Likewise between the rims of a ring, from two vertices that face each other on, or each from
/// the other's vertices where none do. Nodes of the longer side of a crescent face the vertices of the shorter one,
/// whose nodes are where those of the longer one are nearest: by equal shares the first chords would lie on one
/// another. Edges that face such an edge across another narrow face follow it. At most one entry per edge; an edge that
/// leads an entry comes before it. `pairs`: of find_opposite_sides; `is_placed`: per edge, whether its nodes stay and
/// are followed.
std::vector<MovedNodes> face_vertices(const Model& model, const std::vector<OppositeSides>& pairs, NodeLengths lengths,
                                      std::vector<bool> is_placed, const MayMove& may_move, const EdgePoint& point);

}  // namespace paver
