// Holes of a few facets tell rows nothing, and rows that go round them meet others at odd places. So the region is
// paved without them, and only what lies about a hole gives way for it.
// In: region, mesh without the holes, or with them where what is about some of them is to be another one. Out: mesh
// with voids, front. Steps: target lengths about the hole fall to those of its nodes; elements near it go; their
// outline and the hole are the loops of the void.
#include "paving/small_holes.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/boxes/box_tree.h"
#include "base/boxes/nearest_segment.h"
#include "base/segment.h"
#include "paving/closing/hole_rings.h"

namespace paver {
namespace {

constexpr std::size_t most_facets = 48;
constexpr double clearance = 2;     // of the target length there, to other loops
constexpr double slack = 1 + 1e-9;  // for rounding

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

/// Each loop a group.
NearestSegment nodes_of(const Region& region) {
  std::vector<std::vector<Segment>> nodes(region.loops.size());
  for (std::size_t l = 0; l < region.loops.size(); ++l)
    for (const LoopNode& node : region.loops[l]) nodes[l].push_back({node.x, node.x});
  return {nodes, 1};
}

bool is_clear(const Region& region, const NearestSegment& nodes, std::size_t hole) {
  const std::vector<LoopNode>& loop = region.loops[hole];
  const Vec3 middle = middle_of(loop);
  const double room = radius_of(loop, middle) + clearance * region.size.given_at(middle);
  return !(nodes.least_of_others(middle, room, hole) < room);
}

bool is_of_ring(const HoleLoops& holes, std::size_t element) {
  return element >= holes.first_element && element - holes.first_element < holes.elements;
}

/// Makes room for a hole, or the outermost ring about it.
class Cutter {
 public:
  Cutter(Front& front, const HoleLoops& holes, std::size_t hole, double width)
      : front_(front), mesh_(front.mesh), holes_(holes), hole_(holes.nodes[hole]) {
    for (int node : hole_) middle_ += (1.0 / static_cast<double>(hole_.size())) * mesh_.x[node];
    for (int node : hole_) radius_ = std::max(radius_, norm(mesh_.x[node] - middle_));
    limit_ = width * front_.region.size.given_at(middle_);
  }

  const std::vector<int>& hole() const { return hole_; }

  /// What goes is in it.
  Box box() const {
    Box box;
    box.add(middle_);
    return box.grown(slack * (radius_ + limit_));
  }

  /// The void's outline; none where it would be no ring. `nodes`: all that may go or have a target length that falls.
  std::vector<int> run(const std::vector<int>& nodes) {
    lower_targets(nodes);
    find_near(nodes);
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

  void lower_targets(const std::vector<int>& nodes) {
    double h = 0;
    for (int node : hole_) h = std::max<double>(h, mesh_.h[node]);
    for (int v : nodes) {
      double away = std::max(0.0, norm(mesh_.x[v] - middle_) - radius_);
      if (!mesh_.is_fixed[v]) mesh_.h[v] = std::min(mesh_.h[v], h + front_.region.gradation * away);
    }
  }

  bool is_near(Vec3 x) const {
    const double away = norm(x - middle_);
    return away < radius_ || (away < radius_ + limit_ && distance(x) < limit_);
  }

  // With a corner near the hole.
  void find_near(const std::vector<int>& nodes) {
    for (int v : nodes)
      if (is_near(mesh_.x[v]))
        for (int e : mesh_.star[v])
          if (!is_of_ring(holes_, e)) near_.push_back(e);
    std::ranges::sort(near_);
    near_.erase(std::unique(near_.begin(), near_.end()), near_.end());
  }

  // Empty where the elements have no single simple outline or reach the boundary.
  std::vector<int> outline_of_near() const {
    std::map<int, int> next;
    std::map<std::pair<int, int>, int> sides;
    for (int e : near_)
      for (int k = 0, n = mesh_.elements[e].corners(); k < n; ++k)
        ++sides[{mesh_.elements[e].v[k], mesh_.elements[e].v[(k + 1) % n]}];
    for (const auto& [side, count] : sides) {
      if (count > 1) return {};
      if (sides.count({side.second, side.first}) || (is_of_hole(side.first) && is_of_hole(side.second))) continue;
      if (mesh_.is_fixed[side.first]) return {};
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

  bool is_of_hole(int node) const { return std::ranges::find(hole_, node) != hole_.end(); }

  Front& front_;
  RegionMesh& mesh_;
  const HoleLoops& holes_;
  const std::vector<int>& hole_;
  Vec3 middle_;
  double radius_ = 0;
  double limit_ = 0;  // distance of what goes
  std::vector<int> near_;
};

/// Per hole: nodes near enough to go, or to have a target length that the gradation lets fall from there.
std::vector<std::vector<int>> nodes_about(const RegionMesh& mesh, double gradation,
                                          const std::vector<Cutter>& cutters) {
  std::vector<Box> boxes;
  for (const Cutter& cutter : cutters) boxes.push_back(cutter.box());
  const BoxTree holes(std::move(boxes));
  std::vector<std::vector<int>> nodes(cutters.size());
  for (int v = 0; v < mesh.node_count(); ++v) {
    const Box reach = Box{mesh.x[v], mesh.x[v]}.grown(slack * mesh.h[v] / gradation);
    holes.each_meeting(reach, [&](int i) { nodes[i].push_back(v); });
  }
  return nodes;
}

}  // namespace

std::vector<std::size_t> small_holes(const Region& region) {
  std::vector<std::size_t> holes;
  if (region.loops.size() < 2) return holes;
  for (std::size_t l = 0; l < region.loops.size(); ++l) {
    const std::vector<LoopNode>& loop = region.loops[l];
    bool is_small = loop.size() <= most_facets && loop.size() % 2 == 0;
    bool is_hole = chart_area(loop) < 0 && !(region.goes_round && holds_origin(loop));
    if (is_small && is_hole) holes.push_back(l);
  }
  if (holes.empty()) return holes;
  const NearestSegment nodes = nodes_of(region);
  std::erase_if(holes, [&](std::size_t hole) { return !is_clear(region, nodes, hole); });
  return holes;
}

Region without_holes(const Region& region, const std::vector<std::size_t>& holes) {
  Region whole = region;
  for (std::size_t hole : holes) whole.loops[hole].clear();
  std::erase_if(whole.loops, [](const auto& loop) { return loop.empty(); });
  return whole;
}

HoleLoops add_holes(const Region& region, RegionMesh& mesh, const std::vector<std::size_t>& holes) {
  Front front(region, mesh);
  std::vector<std::vector<int>> loops = find_loop_nodes(region, mesh);
  for (std::size_t hole : holes)
    for (std::size_t i = 0; i < loops[hole].size(); ++i)
      loops[hole][i] = front.add_boundary_node(region.loops[hole], i);
  HoleLoops added{{}, mesh.elements.size(), 0};
  lay_hole_rings(region, mesh, loops, holes);
  added.elements = mesh.elements.size() - added.first_element;
  for (std::size_t hole : holes) added.nodes.push_back(std::move(loops[hole]));
  return added;
}

bool cut_about(Front& front, const HoleLoops& holes, const std::vector<char>& is_wanted, double width) {
  std::vector<Cutter> cutters;
  for (std::size_t i = 0; i < holes.nodes.size(); ++i)
    if (is_wanted[i]) cutters.emplace_back(front, holes, i, width);
  const std::vector<std::vector<int>> nodes = nodes_about(front.mesh, front.region.gradation, cutters);
  std::vector<std::vector<int>> of_void;
  for (std::size_t i = 0; i < cutters.size(); ++i) {
    std::vector<int> outline = cutters[i].run(nodes[i]);
    if (outline.empty()) return false;
    of_void.push_back(std::move(outline));
    of_void.push_back(cutters[i].hole());
  }
  return !front.start_at(of_void);
}

std::vector<char> are_at_triangles(const Region& region, const RegionMesh& mesh, const HoleLoops& holes) {
  std::vector<Box> boxes;
  for (const std::vector<int>& loop : holes.nodes) {
    Box box;
    for (int node : loop) box.add(mesh.x[node]);
    boxes.push_back(box.grown(clearance * region.size.given_at(mesh.x[loop[0]])));
  }
  const BoxTree tree(std::move(boxes));
  std::vector<char> are_at(holes.nodes.size(), false);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const Element& element = mesh.elements[e];
    if (!element.is_alive() || element.corners() == 4 || is_of_ring(holes, e)) continue;
    const Vec3 x = mesh.x[element.v[0]];
    tree.each_meeting(Box{x, x}, [&](int i) { are_at[i] = true; });
  }
  return are_at;
}

}  // namespace paver
