#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "core/quality/wavy_mesh.h"
#include "paver/quality.h"
#include "quality/report.h"

namespace paver {
namespace {

TEST(ElementQuality, AgreesWithTheReportOfTheWholeMesh) {
  for (int order : {1, 2}) {
    MeshResult result = fake::WavyMesh(order, 12, 1.5).result();
    Progress progress;
    QualityReport report = measure_quality(result.mesh, 10, std::vector<bool>(5, false), result.report.faces, progress);
    ElementQuality each = element_quality(result.mesh);
    std::size_t count = result.mesh.quad_count() + result.mesh.triangle_count();
    ASSERT_EQ(each.sj.size(), count);
    ASSERT_EQ(each.validity.size(), count);
    EXPECT_EQ(*std::min_element(each.sj.begin(), each.sj.end()), report.sj_all.min);
    EXPECT_EQ(*std::min_element(each.sj.begin(), each.sj.begin() + report.quads), report.sj_quads.min);
    EXPECT_EQ(*std::min_element(each.jacobian_ratio.begin(), each.jacobian_ratio.end()), report.min_jacobian_ratio);
    EXPECT_NEAR(std::accumulate(each.area.begin(), each.area.end(), 0.0), report.mesh_area, 1e-9 * report.mesh_area);
    EXPECT_EQ(std::count(each.validity.begin(), each.validity.end(), 1), report.inverted);
    EXPECT_EQ(std::count(each.validity.begin(), each.validity.end(), 2), report.undecided);
  }
}

}  // namespace
}  // namespace paver
