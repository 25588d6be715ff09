// Lines along which a face turns over within a small part of its width, as the noses of thin blades; step of
// divide_creases.
#pragma once

#include <BRepAdaptor_Surface.hxx>
#include <vector>

#include "brep/mending/divide_face_impl.h"

namespace paver {

struct Ridges {
  std::vector<double> iso_lines;  ///< ascending
  std::vector<CutCurve> curves;   ///< where no iso-line fits
  bool at_ends = false;           ///< rows that close on themselves turn over where they start
};

/// Ridges of all rows that run in u, or in v, over the face's range: each turns there by a right angle within a small
/// part of its length, and at least one within `unresolved` mm. Not those with one of the `creases` in them. An
/// iso-line goes through one of `preferred`, places in that direction, where one lies in the turn.
Ridges find_ridges(const BRepAdaptor_Surface& surface, bool is_u, double unresolved, const std::vector<double>& creases,
                   const std::vector<double>& preferred);

}  // namespace paver
