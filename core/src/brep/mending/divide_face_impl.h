// Divisions of a face; steps of divide_creases.
#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Wire.hxx>
#include <array>
#include <map>
#include <utility>
#include <vector>

namespace paver {

/// Between two lines of the grid. A flat one is pressed onto a line or point: it has no area and becomes no cell.
struct GridSpan {
  double low = 0, high = 0;
  bool is_flat = false;
};

struct Division {
  TopoDS_Shape pieces;                                             ///< null: the face cannot be divided so
  std::vector<std::pair<TopoDS_Edge, TopoDS_Wire>> divided_edges;  ///< of the face, with what replaces them elsewhere
};

/// The cells of `face`, which must be FORWARD and stays as it is. `spans` follow each other in u and in v over the
/// face's whole range. A face fits when it is a B-spline or swept surface, bounded by the sides of its range.
Division divide_grid(const TopoDS_Face& face, const std::array<std::vector<GridSpan>, 2>& spans, double diagonal);

/// Across all rows in u or in v of a face.
struct CutCurve {
  std::map<double, double> places;  ///< on the rows, by the rows' parameter; monotone between them
  double near = 0;                  ///< mm; it ends at a vertex that is not farther aside
};

/// The pieces of `face`, which must be FORWARD and stays as it is, between curves across its rows in u (`is_u`) or in
/// v.
Division divide_along(const TopoDS_Face& face, bool is_u, const std::vector<CutCurve>& curves, double diagonal);

}  // namespace paver
