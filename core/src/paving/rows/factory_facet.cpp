// One quad on one facet.
#include "paving/rows/factory_facet.h"

namespace paver {

bool lay_quad(Front& front, int f, const Wish* left, const Wish* right, int level, std::vector<int>& new_nodes) {
  const Facet facet = front.facets[f];
  int a = facet.a, b = facet.b;
  int before = front.facets[facet.prev].a, after = front.facets[facet.next].b;
  auto start = [&] { return front.empty.facet_side(f).triangle; };
  Granted d{before, false}, c{after, false};
  if (left) d = grant(front, *left, start(), b, right ? after : -1);
  if (d.node < 0) return false;
  if (right) c = grant(front, *right, start(), a, left ? d.node : -1);
  auto put = [&](const Granted& g, int base) {
    return !g.is_new || front.empty.insert(g.node, front.empty.walk(start(), base, front.mesh.p[g.node]));
  };
  bool is_laid = false;
  if (c.node >= 0 && c.node != d.node) {
    const Element quad{{a, b, c.node, d.node}};
    constexpr double least_of_new = 0.05, least_of_old = 1e-3;  // scaled Jacobian
    bool is_fit = is_positive(front.mesh, quad) &&
                  scaled_jacobian(front.mesh, quad) > (d.is_new || c.is_new ? least_of_new : least_of_old);
    if (is_fit && put(d, a)) {
      if (put(c, b)) {
        is_laid = front.form_element(f, c.node, d.node, level);
        if (!is_laid && c.is_new) front.empty.erase(c.node, start(), b);
      }
      if (!is_laid && d.is_new) front.empty.erase(d.node, start(), a);
    }
  }
  if (is_laid) {
    if (d.is_new) new_nodes.push_back(d.node);
    if (c.is_new) new_nodes.push_back(c.node);
    return true;
  }
  if (c.node >= 0 && c.is_new) front.drop_last_node();
  if (d.is_new) front.drop_last_node();
  return false;
}

}  // namespace paver
