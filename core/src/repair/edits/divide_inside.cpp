#include "repair/edits/divide_inside.h"

#include <algorithm>
#include <map>

#include "curving/near_surface.h"
#include "repair/edits/patch.h"

namespace paver {
namespace {

// Cosine between the normals at a side's ends; at order 1 chords of less miss the surface.
constexpr double bend = 0.5, bend_of_chords = 0.8;
constexpr std::size_t most_elements = 40;

class BendDivider {
 public:
  BendDivider(const ElementJudge& judge, ElementKinds kinds, RegionMesh& mesh)
      : judge_(judge), kinds_(kinds), mesh_(mesh) {}

  int run(int element) {
    collect(element);
    add_nodes();
    if (nodes_.empty()) return 0;
    long before = 0, after = 0;
    std::vector<Corners> old;
    for (int e : touched_) {
      before += judge_.value(e) <= 0;
      old.push_back(mesh_.elements[e].v);
    }
    const int first = static_cast<int>(mesh_.elements.size());
    for (int e : touched_) refill(e);
    const int last = static_cast<int>(mesh_.elements.size());
    for (int e = first; e < last; ++e) after += judge_.value(e) <= 0;
    if (after < before) return static_cast<int>(nodes_.size());
    for (int e = first; e < last; ++e) mesh_.remove_element(e);
    for (std::size_t i = 0; i < touched_.size(); ++i) mesh_.restore_element(touched_[i], old[i]);
    return 0;
  }

 private:
  /// Bad elements that hang together.
  void collect(int element) {
    bad_ = {element};
    for (std::size_t i = 0; i < bad_.size() && bad_.size() < most_elements; ++i)
      for (int e : ring_about(mesh_, bad_[i]))
        if (std::find(bad_.begin(), bad_.end(), e) == bad_.end() && judge_.value(e) <= 0) bad_.push_back(e);
  }

  void add_nodes() {
    for (int e : bad_) {
      const Element element = mesh_.elements[e];
      for (int k = 0, n = element.corners(); k < n; ++k) {
        const int a = element.v[k], b = element.v[(k + 1) % n], other = mesh_.across(a, b);
        if (other < 0 || nodes_.contains(std::minmax(a, b)) ||
            dot(mesh_.normal(a), mesh_.normal(b)) > (judge_.order() == 1 ? bend_of_chords : bend) ||
            is_too_short(mesh_, a, b))
          continue;
        nodes_[std::minmax(a, b)] = add_node_between(judge_.region(), a, b, mesh_);
        touched_.push_back(e);
        touched_.push_back(other);
      }
    }
    std::sort(touched_.begin(), touched_.end());
    touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
  }

  void refill(int e) {
    const std::vector<int> outline = with_nodes_between(mesh_.elements[e], [&](int a, int b) {
      const auto at = nodes_.find(std::minmax(a, b));
      return at == nodes_.end() ? -1 : at->second;
    });
    Filling filling = fill_outline(
        outline, kinds_, [&](const Corners& v, double floor) { return judge_.value(v, floor); },
        [&](int a, int b) { return is_side_outside(mesh_, {e}, a, b); });
    if (filling.elements.empty())  // what the others gain may be worth it
      filling = fill_outline(
          outline, kinds_, [&](const Corners& v, double) { return 2 + judge_.value(v); },
          [](int, int) { return false; });
    mesh_.remove_element(e);
    for (const Corners& corners : filling.elements) mesh_.add_element(corners);
  }

  const ElementJudge& judge_;
  const ElementKinds kinds_;
  RegionMesh& mesh_;
  ElementSet bad_, touched_;
  std::map<std::pair<int, int>, int> nodes_;  // per side divided
};

}  // namespace

bool is_too_short(const RegionMesh& mesh, int a, int b) {
  constexpr double shortest = 0.12;  // of the target length
  return norm(mesh.x[b] - mesh.x[a]) < shortest * std::min(mesh.h[a], mesh.h[b]);
}

int add_node_between(const Region& region, int a, int b, RegionMesh& mesh) {
  constexpr int bisections = 12;
  constexpr double alike = 0.9;
  const Vec3 from = mesh.normal(a), to = mesh.normal(b);
  Vec2 p = guess_middle(region, mesh, a, b, {});
  if (dot(from, to) > alike) {
    nearest_point(region, p, 0.5 * (mesh.x[a] + mesh.x[b]), norm(mesh.x[b] - mesh.x[a]));
  } else {
    const Vec2 way = region.chart->step_to(mesh.p[a], mesh.p[b]);
    double low = 0, high = 1;
    for (int i = 0; i < bisections; ++i) {
      const double s = 0.5 * (low + high);
      p = region.chart->walk(mesh.p[a], s * way);
      const auto [x, xp, xq] = region.slope(p);
      (dot(cross(xp, xq), from - to) > 0 ? low : high) = s;
    }
  }
  return mesh.add_node(region.place(p), 0.5 * (mesh.h[a] + mesh.h[b]));
}

int divide_bend(const ElementJudge& judge, int element, ElementKinds kinds, RegionMesh& mesh) {
  return BendDivider(judge, kinds, mesh).run(element);
}

}  // namespace paver
