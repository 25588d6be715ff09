// What a mesh comes to for a solver of integral equations by the Method of Moments.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "paver/result.h"

namespace paver {

/// Lengths in mm.
struct SolverFigures {
  long unknowns = 0;      ///< with functions of first order on a conductor: m - 1 for a mesh edge with m elements
  double matrix_mib = 0;  ///< of their full matrix of complex numbers in double precision
  double shortest_edge = 0, longest_edge = 0;
  long junction_edges = 0;              ///< mesh edges with more than two elements
  std::optional<double> wavelength;     ///< the shortest of the media; none without a frequency
  std::optional<double> least_segment;  ///< of the lines of wires with a radius: length by radius
};

SolverFigures solver_figures(const RunReport& report);

/// What may trouble a solver, one sentence each, by limits that solvers document (core/docs/quality.md).
std::vector<std::string> solver_hints(const SolverFigures& figures);

}  // namespace paver
