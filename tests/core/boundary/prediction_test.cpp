// Predictions against meshes.
#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeCylinder.hxx>
#include <cmath>
#include <gp.hxx>
#include <gp_Ax2.hxx>
#include <numeric>
#include <string>

#include "paver/mesher.h"
#include "support/folders.h"
#include "support/report_of.h"

namespace paver {
namespace {

class Predict : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Examples, Predict,
                         testing::Values("box_cylinder", "conesphere", "plate_nine_holes", "torus", "wing"));

TEST_P(Predict, ComesNearTheMesh) {
  Progress progress;
  CadModel model = read_file(test::examples_folder() / (GetParam() + std::string(".step")), progress);
  for (Elements kind : {Elements::quad_dominant, Elements::all_triangle}) {
    Options options;
    options.size = 6;
    options.elements = kind;
    options.max_elements = 1;  // no limit for a prediction
    Prediction prediction = predict(model, options, progress);
    options.max_elements = 100'000;
    MeshResult result = mesh_model(model, options, progress);
    double elements = static_cast<double>(result.mesh.quad_count() + result.mesh.triangle_count());
    EXPECT_GT(elements, 0.7 * prediction.elements);
    EXPECT_LT(elements, 1.5 * prediction.elements);
    EXPECT_EQ(prediction.target_length, 6);
    ASSERT_EQ(prediction.face_elements.size(), result.report.faces.size());
    EXPECT_NEAR(std::accumulate(prediction.face_elements.begin(), prediction.face_elements.end(), 0.0),
                prediction.elements, 1e-6 * elements);
  }
}

// Edges across a bend have as many intervals as it takes elements: these do not count again for them.
TEST(Predict, ShortBendsCountOnce) {
  for (double radius : {0.3, 0.5, 1.0})
    for (double length : {2.0, 4.0, 9.0}) {
      SCOPED_TRACE(testing::Message() << radius << " by " << length);
      const TopoDS_Shape half = BRepPrimAPI_MakeCylinder(gp_Ax2(gp::Origin(), gp::DZ()), radius, length, M_PI).Face();
      const QualityReport quality = test::report_of(half, 1).quality;
      EXPECT_NEAR(static_cast<double>(quality.quads + quality.triangles) / quality.metric.predicted, 1, 0.25);
    }
}

TEST(Predict, MemoryGrowsWithElementsAndOrder) {
  Progress progress;
  CadModel model = read_file(test::examples_folder() / "box.step", progress);
  Options options;
  options.size = 1;
  double fine = predict(model, options, progress).memory_mib;
  options.order = 1;
  EXPECT_LT(predict(model, options, progress).memory_mib, fine);
  options.order = 2;
  options.size = 5;
  EXPECT_LT(predict(model, options, progress).memory_mib, fine);
  options.size = -1;
  EXPECT_THROW(predict(model, options, progress), Error);
}

}  // namespace
}  // namespace paver
