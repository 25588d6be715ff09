#include "quality/element_figures.h"

#include <algorithm>

#include "base/tasks/tasks.h"
#include "mesh/element_table.h"

namespace paver {
namespace {

using Nodes = std::array<Vec3, JacobianForm::max_nodes>;

/// What is not a number counts as 0, so that least values and sums do not depend on the order of elements.
double finite(double value) { return std::isfinite(value) ? value : 0; }

/// Elements of one kind, as many at a time as there are lanes.
class Gatherer {
 public:
  static constexpr std::size_t lanes = JacobianForm::lanes;
  const JacobianForm& form;
  JacobianForm::Lanes x[3 * JacobianForm::max_nodes];

  Gatherer(const SurfaceMesh& mesh, bool is_quad)
      : form(jacobian_form(is_quad ? ElementShape::quad : ElementShape::triangle, mesh.order)),
        mesh_(mesh),
        table_(mesh, is_quad) {}

  void gather(std::size_t first, std::size_t end) {
    for (std::size_t lane = 0; lane < lanes; ++lane) {  // the last one again where there are no more
      const int* element = table_.row(std::min(first + lane, end - 1));
      for (std::size_t k = 0; k < table_.stride; ++k) {
        Vec3 node = mesh_.nodes[element[k]];
        x[3 * k].of[lane] = node.x, x[3 * k + 1].of[lane] = node.y, x[3 * k + 2].of[lane] = node.z;
      }
    }
  }
  Nodes nodes(std::size_t element) const {
    Nodes result;
    for (std::size_t k = 0; k < table_.stride; ++k) result[k] = mesh_.nodes[table_.row(element)[k]];
    return result;
  }

 private:
  const SurfaceMesh& mesh_;
  const ElementTable table_;
};

}  // namespace

void measure_elements(const SurfaceMesh& mesh, bool is_quad, std::size_t begin, std::size_t end,
                      ElementFigures* figures) {
  Gatherer elements(mesh, is_quad);
  JacobianForm::LaneFigures of;
  for (std::size_t first = begin; first < end; first += Gatherer::lanes) {
    elements.gather(first, end);
    elements.form.measure_lanes(elements.x, of);
    for (std::size_t lane = 0; lane < std::min(Gatherer::lanes, end - first); ++lane) {
      JacobianBound bound{Validity::valid, of.low.of[lane]};
      if (!(bound.ratio >= JacobianForm::poor_ratio)) bound = elements.form.bound(elements.nodes(first + lane).data());
      *figures++ = {finite(of.sj.of[lane]), finite(of.area.of[lane]), bound.ratio, bound.validity};
    }
  }
}

std::vector<int> find_invalid(const SurfaceMesh& mesh, bool is_quad) {
  constexpr std::size_t block = 1024;
  const std::size_t count = ElementTable(mesh, is_quad).count();
  std::vector<std::vector<int>> found(count / block + 1);
  run_stretches(count, block, [&](std::size_t begin, std::size_t end) {
    Gatherer elements(mesh, is_quad);
    JacobianForm::Lanes low;
    for (std::size_t first = begin; first < end; first += Gatherer::lanes) {
      elements.gather(first, end);
      elements.form.bound_lanes(elements.x, low);
      for (std::size_t lane = 0; lane < std::min(Gatherer::lanes, end - first); ++lane)
        if (!(low.of[lane] > JacobianForm::flat_ratio) && !elements.form.is_valid(elements.nodes(first + lane).data()))
          found[begin / block].push_back(static_cast<int>(first + lane));
    }
  });
  std::vector<int> all;
  for (const std::vector<int>& some : found) all.insert(all.end(), some.begin(), some.end());
  return all;
}

}  // namespace paver
