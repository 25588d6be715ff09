#include "quality/element_figures.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace paver {
namespace {

JacobianBound bound_of(const JacobianForm& form, const SurfaceMesh& mesh, const int* element) {
  std::array<Vec3, JacobianForm::max_nodes> x;
  for (int k = 0; k < form.node_count(); ++k) x[k] = mesh.nodes[element[k]];
  return form.bound(x.data());
}

/// What is not a number counts as 0, so that least values and sums do not depend on the order of elements.
double finite(double value) { return std::isfinite(value) ? value : 0; }

}  // namespace

void measure_elements(const SurfaceMesh& mesh, bool is_quad, std::size_t begin, std::size_t end,
                      ElementFigures* figures) {
  constexpr std::size_t lanes = JacobianForm::lanes;
  const JacobianForm& form = jacobian_form(is_quad ? ElementShape::quad : ElementShape::triangle, mesh.order);
  std::size_t stride = static_cast<std::size_t>(form.node_count());
  const int* table = (is_quad ? mesh.quads : mesh.triangles).data();
  JacobianForm::Lanes x[3 * JacobianForm::max_nodes];
  JacobianForm::LaneFigures of;
  for (std::size_t first = begin; first < end; first += lanes) {
    for (std::size_t lane = 0; lane < lanes; ++lane) {  // the last one again where there are no more
      const int* element = table + std::min(first + lane, end - 1) * stride;
      for (std::size_t k = 0; k < stride; ++k) {
        Vec3 node = mesh.nodes[static_cast<std::size_t>(element[k])];
        x[3 * k].of[lane] = node.x, x[3 * k + 1].of[lane] = node.y, x[3 * k + 2].of[lane] = node.z;
      }
    }
    form.measure_lanes(x, of);
    for (std::size_t lane = 0; lane < std::min(lanes, end - first); ++lane) {
      JacobianBound bound{Validity::valid, of.low.of[lane]};
      if (!(bound.ratio >= JacobianForm::poor_ratio)) bound = bound_of(form, mesh, table + (first + lane) * stride);
      *figures++ = {finite(of.sj.of[lane]), finite(of.area.of[lane]), bound.ratio, bound.validity};
    }
  }
}

std::vector<int> find_invalid(const SurfaceMesh& mesh, bool is_quad) {
  constexpr std::size_t block = 1024;
  const std::size_t count = is_quad ? mesh.quad_count() : mesh.triangle_count(), blocks = (count + block - 1) / block;
  std::vector<std::vector<int>> found(blocks);
  tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t b) {
    ElementFigures figures[block];
    const std::size_t begin = b * block, end = std::min(begin + block, count);
    measure_elements(mesh, is_quad, begin, end, figures);
    for (std::size_t i = begin; i < end; ++i)
      if (figures[i - begin].validity != Validity::valid) found[b].push_back(static_cast<int>(i));
  });
  std::vector<int> all;
  for (const std::vector<int>& some : found) all.insert(all.end(), some.begin(), some.end());
  return all;
}

}  // namespace paver
