#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "core/quality/wavy_mesh.h"
#include "paver/quality.h"
#include "quality/jacobian/jacobian.h"
#include "quality/metrics.h"
#include "support/measure_quality.h"

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

TEST(ElementQuality, IsBitForBitThatOfOneElementAtATime) {
  for (int order = 1; order <= 4; ++order) {
    SurfaceMesh mesh = fake::WavyMesh(order, 15, 2.5 / order).result().mesh;
    ElementQuality q = element_quality(mesh);
    for (bool is_quad : {true, false}) {
      const JacobianForm& form = jacobian_form(is_quad ? ElementShape::quad : ElementShape::triangle, order);
      const std::vector<int>& table = is_quad ? mesh.quads : mesh.triangles;
      std::size_t stride = static_cast<std::size_t>(form.node_count()), first = is_quad ? 0 : mesh.quad_count();
      for (std::size_t i = 0; i < table.size() / stride; ++i) {
        std::vector<Vec3> x;
        for (std::size_t k = 0; k < stride; ++k)
          x.push_back(mesh.nodes[static_cast<std::size_t>(table[i * stride + k])]);
        JacobianBound bound = form.bound(x.data());
        ASSERT_EQ(q.area[first + i], form.area(x.data()));
        ASSERT_EQ(q.jacobian_ratio[first + i], bound.ratio);
        ASSERT_EQ(q.validity[first + i], static_cast<std::int8_t>(bound.validity));
        ASSERT_EQ(q.sj[first + i],
                  is_quad ? scaled_jacobian(x[0], x[1], x[2], x[3]) : scaled_jacobian(x[0], x[1], x[2]));
      }
    }
  }
}

}  // namespace
}  // namespace paver
