// Where a model asks for shorter lengths: tips, sharp edges, gaps, small holes.
#pragma once

#include <functional>
#include <vector>

#include "sizing/parts/size_source.h"
#include "topology/model.h"

namespace paver {

/// A vertex where a closed surface comes to a point, and the longest edge that ends there.
struct Tip {
  int vertex = -1;
  double room = 0;         ///< mm
  std::vector<int> faces;  ///< that meet there
};

/// Vertices about which the angles of the faces sum up to less than pi: the apex of a cone of less than 30 degrees from
/// its axis is one, the corner of a box (3/2 pi) is none. Not where the surface ends or more than two faces meet.
std::vector<Tip> find_tips(const Model& model);

/// Per edge of the model, whether currents are singular at it: the surface ends there, or has a corner of more than 40
/// degrees that is outside of its solid; of sheets either way.
std::vector<bool> find_sharp_edges(const Model& model);

/// A piece of a gap: from a place on one edge straight across to one on the other, and where that is one step on.
struct GapPiece {
  Vec3 from, to;            ///< mm
  Vec3 next_from, next_to;  ///< the same as from and to where the gap ends
  double width = 0;         ///< mm: the lesser one
};

/// Where faces are narrower than 0.7 of their target length, `length(face)`: between edges of one face that run within
/// 30 degrees of each other's direction. Looked for every quarter of the target length.
std::vector<GapPiece> find_gaps(const Model& model, const std::function<double(int face)>& length);

/// Pieces of borders that are divided far more finely than another border of their face is near them, each with the
/// mean interval of its border: lengths that grow from there by the gradation reach the other one at less than a share
/// of its intervals. A border is what hangs together of the edges about a face; `interval(edge, t)`: about how long
/// intervals are there.
std::vector<SizeSource> find_fine_borders(const Model& model,
                                          const std::function<double(const Edge&, double t)>& interval,
                                          double gradation);

}  // namespace paver
