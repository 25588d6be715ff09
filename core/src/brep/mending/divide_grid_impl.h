// A rectangular B-spline or swept face to the cells of a grid; step of divide_creases.
#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Wire.hxx>
#include <array>
#include <utility>
#include <vector>

namespace paver {

/// Between two lines of the grid. A flat one is pressed onto a line or point: it has no area and becomes no cell.
struct GridSpan {
  double low = 0, high = 0;
  bool is_flat = false;
};

struct GridCells {
  TopoDS_Shape cells;                                              ///< null: the face is none that fits a grid
  std::vector<std::pair<TopoDS_Edge, TopoDS_Wire>> divided_edges;  ///< of the face, with what replaces them elsewhere
};

/// The cells of `face`, which must be FORWARD and stays as it is. `spans` follow each other in u and in v over the
/// face's whole range. A face fits when it is a B-spline or swept surface, bounded by the sides
/// of its range.
GridCells divide_grid(const TopoDS_Face& face, const std::array<std::vector<GridSpan>, 2>& spans, double diagonal);

}  // namespace paver
