// Holes of a few facets tell rows nothing, and rows that go round them meet others at odd places. So the region is
// paved without them, and only what lies about a hole gives way for it.
// In: region, mesh without the holes. Out: mesh with voids, front.
// Steps: target lengths about the hole fall to those of its nodes; elements near it go; their outline and the hole are
// the loops of the void.
#include "paving/small_holes.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/segment.h"
#include "paving/closing/hole_rings.h"

namespace paver {
namespace {

constexpr std::size_t most_facets = 12;
constexpr double clearance = 2.5;  // of the target length there, to other loops

double chart_area(const std::vector<LoopNode>& loop) {
  double area = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) area += cross(loop[i].p, loop[(i + 1) % loop.size()].p);
  return 0.5 * area;
}

bool holds_origin(const std::vector<LoopNode>& loop) {
  return goes_round_origin(loop.size(), [&](std::size_t i) { return loop[i].p; });
}

Vec3 middle_of(const std::vector<LoopNode>& loop) {
  Vec3 sum{0, 0, 0};
  for (const LoopNode& node : loop) sum += node.x;
  return (1.0 / static_cast<double>(loop.size())) * sum;
}

double radius_of(const std::vector<LoopNode>& loop, Vec3 middle) {
  double radius = 0;
  for (const LoopNode& node : loop) radius = std::max(radius, norm(node.x - middle));
  return radius;
}

bool is_clear(const Region& region, std::size_t hole) {
  const std::vector<LoopNode>& loop = region.loops[hole];
  const Vec3 middle = middle_of(loop);
  const double room = radius_of(loop, middle) + clearance * region.size.given_at(middle);
  for (std::size_t l = 0; l < region.loops.size(); ++l)
    for (const LoopNode& node : region.loops[l])
      if (l != hole && norm(node.x - middle) < room) return false;
  return true;
}

/// Makes room for a hole, or the outermost ring about it, in the first `elements` of the mesh.
class Cutter {
 public:
  Cutter(Front& front, const std::vector<int>& hole, int elements, double width)
      : front_(front), mesh_(front.mesh), hole_(hole), elements_(elements), width_(width) {
    for (int node : hole) middle_ += (1.0 / static_cast<double>(hole.size())) * mesh_.x[node];
    for (int node : hole) radius_ = std::max(radius_, norm(mesh_.x[node] - middle_));
  }

  /// The void's outline; none where it would be no ring.
  std::vector<int> run() {
    lower_targets();
    for (int e = 0; e < elements_; ++e)
      if (mesh_.elements[e].is_alive() && is_near(mesh_.elements[e])) near_.push_back(e);
    if (near_.empty()) return {};
    std::vector<int> outline = outline_of_near();
    if (!outline.empty())
      for (int e : near_) mesh_.remove_element(e);
    return outline;
  }

 private:
  double distance(Vec3 x) const {
    double least = 1e300;
    for (std::size_t i = 0; i < hole_.size(); ++i)
      least = std::min(least, distance_to_segment(x, mesh_.x[hole_[i]], mesh_.x[hole_[(i + 1) % hole_.size()]]));
    return least;
  }

  void lower_targets() {
    double h = 0;
    for (int node : hole_) h = std::max<double>(h, mesh_.h[node]);
    for (int v = 0; v < mesh_.node_count(); ++v) {
      double away = std::max(0.0, norm(mesh_.x[v] - middle_) - radius_);
      if (!mesh_.is_fixed[v]) mesh_.h[v] = std::min(mesh_.h[v], h + front_.region.gradation * away);
    }
  }

  bool is_near(const Element& e) const {
    for (int k = 0; k < e.corners(); ++k) {
      Vec3 x = mesh_.x[e.v[k]];
      double limit = width_ * front_.region.size.given_at(middle_), away = norm(x - middle_);
      if (away < radius_) return true;
      if (away < radius_ + limit && distance(x) < limit) return true;
    }
    return false;
  }

  // Empty where the elements have no single simple outline or reach the boundary.
  std::vector<int> outline_of_near() const {
    std::map<int, int> next;
    std::map<std::pair<int, int>, int> sides;
    for (int e : near_)
      for (int k = 0, n = mesh_.elements[e].corners(); k < n; ++k)
        ++sides[{mesh_.elements[e].v[k], mesh_.elements[e].v[(k + 1) % n]}];
    for (const auto& [side, count] : sides) {
      if (mesh_.is_fixed[side.first] || count > 1) return {};
      if (sides.count({side.second, side.first})) continue;
      if (!next.emplace(side).second) return {};
    }
    std::vector<int> outline;
    int first = next.begin()->first, node = first;
    do {
      outline.push_back(node);
      node = next.at(node);
    } while (node != first);
    return outline.size() == next.size() ? outline : std::vector<int>{};
  }

  Front& front_;
  RegionMesh& mesh_;
  const std::vector<int>& hole_;
  const int elements_;
  const double width_;
  Vec3 middle_;
  double radius_ = 0;
  std::vector<int> near_;
};

}  // namespace

std::vector<std::size_t> small_holes(const Region& region) {
  std::vector<std::size_t> holes;
  if (region.loops.size() < 2) return holes;
  for (std::size_t l = 0; l < region.loops.size(); ++l) {
    const std::vector<LoopNode>& loop = region.loops[l];
    bool is_small = loop.size() <= most_facets && loop.size() % 2 == 0;
    bool is_hole = chart_area(loop) < 0 && !(region.goes_round && holds_origin(loop));
    if (is_small && is_hole && is_clear(region, l)) holes.push_back(l);
  }
  return holes;
}

Region without_holes(const Region& region, const std::vector<std::size_t>& holes) {
  Region whole = region;
  for (std::size_t i = holes.size(); i-- > 0;) whole.loops.erase(whole.loops.begin() + static_cast<long>(holes[i]));
  return whole;
}

bool cut_holes(Front& front, const std::vector<std::size_t>& holes, double width) {
  const int elements = static_cast<int>(front.mesh.elements.size());
  std::vector<std::vector<int>> loops = find_loop_nodes(front.region, front.mesh);
  for (std::size_t hole : holes)
    for (std::size_t i = 0; i < loops[hole].size(); ++i)
      loops[hole][i] = front.add_boundary_node(front.region.loops[hole], i);
  for (std::size_t hole : holes) loops[hole] = lay_hole_rings(front.region, front.mesh, loops, hole);
  std::vector<std::vector<int>> of_void;
  for (std::size_t hole : holes) {
    std::vector<int> outline = Cutter(front, loops[hole], elements, width).run();
    if (outline.empty()) return false;
    of_void.push_back(std::move(outline));
    of_void.push_back(loops[hole]);
  }
  return !front.start_at(of_void);
}

}  // namespace paver
