// A tessellation whose elements share no points: the shared one, copied out element by element.
#include <cstddef>

#include "display/cut.h"

namespace paver {
namespace {

void copy_point(const std::vector<float>& from, int point, std::vector<float>& to) {
  auto begin = from.begin() + 3 * std::ptrdiff_t(point);
  to.insert(to.end(), begin, begin + 3);
}

}  // namespace

Tessellation tessellate_apart(const SurfaceMesh& mesh, int n) {
  Cut cut = cut_mesh(mesh, n);
  Tessellation result;
  result.subdivision = n;
  result.points.reserve(3 * cut.element_points.size());
  result.normals.reserve(3 * cut.element_points.size());
  for (int point : cut.element_points) {
    copy_point(cut.shared.points, point, result.points);
    copy_point(cut.shared.normals, point, result.normals);
  }
  std::size_t pieces = cut.shared.triangle_element.size();
  result.triangles.reserve(4 * pieces);
  result.triangle_element.reserve(pieces);
  int quads = static_cast<int>(mesh.quad_count()), elements = quads + static_cast<int>(mesh.triangle_count());
  for (int e = 0, first = 0; e < elements; ++e) {
    for_triangles(n, e < quads, [&](int a, int b, int c) {
      result.triangles.insert(result.triangles.end(), {first + a, first + b, first + c, -1});
      result.triangle_element.push_back(e);
    });
    first += e < quads ? (n + 1) * (n + 1) : (n + 1) * (n + 2) / 2;
  }
  std::vector<int> copy_of(cut.shared.points.size() / 3);  // any copy: all lie in one place
  for (std::size_t i = 0; i < cut.element_points.size(); ++i) copy_of[cut.element_points[i]] = static_cast<int>(i);
  result.outlines = std::move(cut.shared.outlines);
  for (int& point : result.outlines)
    if (point >= 0) point = copy_of[point];
  result.outline_edge = std::move(cut.shared.outline_edge);
  result.outline_elements = std::move(cut.shared.outline_elements);
  return result;
}

}  // namespace paver
