#include "paving/inner_sides.h"

#include <algorithm>
#include <optional>

namespace paver {
namespace {

using Corners = std::array<int, 4>;

class SideDivider {
 public:
  SideDivider(const Region& region, RegionMesh& mesh) : region_(region), mesh_(mesh) {}

  void divide(int a, int b) const {
    const int e = element_with(a, b), other = element_with(b, a);
    if (e >= 0 && other >= 0) divide(e, other, a, b);
  }

 private:
  int element_with(int a, int b) const {
    for (int e : mesh_.star[a])
      if (mesh_.elements[e].after(a) == b) return e;
    return -1;
  }

  void divide(int e, int other, int a, int b) const {
    const Vec2 p = 0.5 * (mesh_.p[a] + mesh_.p[b]);
    Vec3 x, xp, xq;
    region_.evaluate(p, x, xp, xq);
    const int middle = mesh_.add_node(p, x, xp, xq, 0.5 * (mesh_.h[a] + mesh_.h[b]));
    const auto here = best_of(mesh_.elements[e], a, b, middle), there = best_of(mesh_.elements[other], b, a, middle);
    if (!here || !there) {
      mesh_.drop_last_node();
      return;
    }
    mesh_.remove_element(e);
    mesh_.remove_element(other);
    for (const auto& elements : {*here, *there})
      for (const Corners& corners : elements) mesh_.add_element(corners);
  }

  /// The element with a node between its corners a and b: the better of two ways, if one has positive elements only.
  std::optional<std::array<Corners, 2>> best_of(const Element& e, int a, int b, int middle) const {
    std::optional<std::array<Corners, 2>> best;
    double most = 0;
    const int c = e.after(b), d = e.before(a);
    std::array<std::array<Corners, 2>, 2> ways{
        {{{{a, middle, d, -1}, {middle, b, c, d}}}, {{{middle, b, c, -1}, {a, middle, c, d}}}}};
    if (e.corners() == 3)
      ways = {{{{{a, middle, c, -1}, {middle, b, c, -1}}}, {{{a, middle, c, -1}, {middle, b, c, -1}}}}};
    for (const auto& way : ways) {
      double worst = 1;
      for (const Corners& corners : way)
        worst = std::min(worst, is_positive(mesh_, {corners}) ? scaled_jacobian(mesh_, {corners}) : -1);
      if (worst > most) most = worst, best = way;
    }
    return best;
  }

  const Region& region_;
  RegionMesh& mesh_;
};

}  // namespace

void divide_inner_sides(const Region& region, const std::vector<std::pair<int, int>>& sides, RegionMesh& mesh) {
  const SideDivider divider(region, mesh);
  for (auto [a, b] : sides) divider.divide(a, b);
}

}  // namespace paver
