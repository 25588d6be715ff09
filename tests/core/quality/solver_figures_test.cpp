// Unknowns, lengths in wavelengths, and what may trouble a solver.
#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>

#include "core/brep/shape_files.h"
#include "paver/mesher.h"
#include "paver/solver.h"
#include "support/report_of.h"

namespace paver {
namespace {

TEST(SolverFigures, CountUnknownsByEdgesAndMeasureInTheDensestMedium) {
  Options options;
  options.frequency = 3e9;
  options.media = {{"Dense", {"Solid1"}, 4.0}};
  const TopoDS_Shape boxes = test::compound({BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), 20, 20, 20).Shape(),
                                             BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 20), 20, 20, 20).Shape()});
  const MeshResult result = test::mesh_of(boxes, options);
  const SolverFigures figures = solver_figures(result.report);
  const QualityReport& quality = result.report.quality;
  ASSERT_EQ(quality.triangles, 0);
  // By Euler's number of the surface with its inner face: nodes - edges + elements = 3.
  const long corners = 3 + quality.edges - quality.quads;
  EXPECT_GT(corners, 0);
  EXPECT_EQ(figures.unknowns, 4 * quality.quads - quality.edges);
  EXPECT_NEAR(*figures.wavelength, 0.5 * *wavelength(options), 1e-9);
  EXPECT_LE(figures.longest_edge, 1.5 * target_length(options));
  EXPECT_GE(figures.shortest_edge, 0.3 * target_length(options) / 2);
  EXPECT_GT(figures.junction_edges, 0);
  for (const FaceReport& face : result.report.faces)
    if (face.quads > 0) {
      const bool is_dense = face.back_medium == "Dense" || face.front_medium == "Dense";
      EXPECT_NEAR(*face.wavelength, *wavelength(options) * (is_dense ? 0.5 : 1), 1e-9) << face.name;
    }
}

TEST(SolverFigures, HintsAreThereWhereLimitsAreExceeded) {
  SolverFigures figures;
  figures.shortest_edge = 5, figures.longest_edge = 10, figures.wavelength = 100;
  EXPECT_TRUE(solver_hints(figures).empty());
  figures.longest_edge = 25;
  EXPECT_EQ(solver_hints(figures).size(), 1u);
  figures.longest_edge = 10, figures.shortest_edge = 0.05;
  EXPECT_EQ(solver_hints(figures).size(), 1u);
  figures.shortest_edge = 0.005;
  EXPECT_EQ(solver_hints(figures).size(), 2u);
  figures.shortest_edge = 5, figures.least_segment = 3, figures.junction_edges = 2;
  EXPECT_EQ(solver_hints(figures).size(), 2u);
  figures.wavelength.reset(), figures.least_segment.reset(), figures.junction_edges = 0;
  EXPECT_TRUE(solver_hints(figures).empty()) << "without a frequency only ratios count";
}

TEST(SolverFigures, SegmentsAreMeasuredByTheRadiusOfTheirWire) {
  Options options;
  options.size = 2;
  options.wires = {{"Rim", {"Edge1"}, 1.0}};
  const MeshResult result = test::mesh_of(BRepPrimAPI_MakeBox(10, 10, 10).Shape(), options);
  EXPECT_NEAR(*solver_figures(result.report).least_segment, 2, 1e-9);
}

}  // namespace
}  // namespace paver
