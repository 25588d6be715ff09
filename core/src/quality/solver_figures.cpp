// Counts and limits; nothing here looks at the mesh again.
#include <fmt/format.h>

#include <algorithm>

#include "paver/solver.h"

namespace paver {
namespace {

constexpr double bytes_of_entry = 16, mib = 1024 * 1024;
constexpr double longest_for_first_order = 0.2;  // wavelengths: a tenth is usual [Rao82, Burke81]
constexpr double shortest_for_condition = 1e-3;  // wavelengths [Burke81]
constexpr double most_ratio = 1000;              // of the longest edge to the shortest
constexpr double least_segment = 8;              // radii: thin-wire kernels [Burke81]

}  // namespace

SolverFigures solver_figures(const RunReport& report) {
  const QualityReport& quality = report.quality;
  SolverFigures figures;
  figures.unknowns = 4 * quality.quads + 3 * quality.triangles - quality.edges;
  const auto n = static_cast<double>(figures.unknowns);
  figures.matrix_mib = n * n * bytes_of_entry / mib;
  figures.shortest_edge = quality.shortest_edge;
  figures.longest_edge = quality.longest_edge;
  figures.junction_edges = quality.nonmanifold_edges;
  figures.wavelength = report.wavelength;
  for (const FaceReport& face : report.faces)
    if (face.quads + face.triangles > 0 && face.wavelength && figures.wavelength)
      figures.wavelength = std::min(*figures.wavelength, *face.wavelength);
  figures.least_segment = report.least_segment;
  return figures;
}

std::vector<std::string> solver_hints(const SolverFigures& figures) {
  std::vector<std::string> hints;
  if (figures.wavelength && figures.longest_edge > longest_for_first_order * *figures.wavelength)
    hints.push_back(fmt::format(
        "The longest edge is {:.3g} wavelengths; functions of first order want about a tenth and at most a fifth.",
        figures.longest_edge / *figures.wavelength));
  if (figures.wavelength && figures.shortest_edge > 0 &&
      figures.shortest_edge < shortest_for_condition * *figures.wavelength)
    hints.push_back(
        fmt::format("The shortest edge is {:.2g} wavelengths; below a thousandth the matrix is badly conditioned in "
                    "many solvers.",
                    figures.shortest_edge / *figures.wavelength));
  if (figures.shortest_edge > 0 && figures.longest_edge > most_ratio * figures.shortest_edge)
    hints.push_back(fmt::format("The longest edge is {:.0f} times the shortest, which the matrix's condition feels.",
                                figures.longest_edge / figures.shortest_edge));
  if (figures.least_segment && *figures.least_segment < least_segment)
    hints.push_back(fmt::format("Lines of a wire are down to {:.2g} of its radii long; thin-wire kernels want 8.",
                                *figures.least_segment));
  if (figures.junction_edges > 0)
    hints.push_back(fmt::format("{} mesh edges have more than two elements: the solver must know such junctions.",
                                figures.junction_edges));
  return hints;
}

}  // namespace paver
