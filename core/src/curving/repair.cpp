// Repair of folded order-2 elements.
// In: mesh, validity test. Out: mesh with some inner nodes moved, list of what remains.
// Steps: invalid elements in order; for each the blended centre, then its interior side middles towards their chords,
// with neighbours that suffer from it following; a second pass for elements whose neighbours have been mended
// meanwhile.
#include "curving/repair.h"

#include <algorithm>
#include <array>

#include "curving/order2.h"
#include "mesh/element_table.h"

namespace paver {
namespace {

constexpr std::array<double, 5> straightening = {0.1, 0.25, 0.5, 0.75, 1.0};
constexpr double least_inside = 0.5;  // sides inside faces are off nothing
constexpr int passes = 2;
// A straightened element may ask its neighbours, and these theirs, to follow; further where nothing else is left.
constexpr int most_depth = 2, most_depth_at_edges = 8;

struct Element {
  bool is_quad = true;
  int index = -1;
  bool operator==(const Element&) const = default;
};

class Repairer {
 public:
  Repairer(SurfaceMesh& mesh, const IsValidFn& is_valid, bool moves_edges, int first_inside)
      : mesh_(mesh), is_valid_(is_valid), moves_edges_(moves_edges), first_inside_(first_inside) {}

  RepairResult run(const std::vector<int>& quads, const std::vector<int>& triangles) {
    std::vector<Element> invalid;
    for (int quad : quads) invalid.push_back({true, quad});
    for (int triangle : triangles) invalid.push_back({false, triangle});
    if (!invalid.empty()) list_neighbours();
    for (int pass = 0; pass < passes && !invalid.empty(); ++pass) {
      if (std::erase_if(invalid, [&](const Element& element) { return is_valid(element) || mend(element); }) == 0)
        break;
    }
    for (const Element& element : invalid) {
      (element.is_quad ? result_.invalid_quads : result_.invalid_triangles).push_back(element.index);
    }
    std::sort(result_.moved.begin(), result_.moved.end());
    result_.moved.erase(std::unique(result_.moved.begin(), result_.moved.end()), result_.moved.end());
    return std::move(result_);
  }

 private:
  struct Moved {
    int node;
    Vec3 from;
  };

  bool is_valid(const Element& element) const { return is_valid_(mesh_, element.is_quad, element.index); }
  Vec3& position(int node) { return mesh_.nodes[node]; }

  const int* nodes_of(const Element& element) const {
    return ElementTable(mesh_, element.is_quad).row(static_cast<std::size_t>(element.index));
  }
  static int corner_count(const Element& element) { return element.is_quad ? 4 : 3; }

  // Elements at each side middle.
  void list_neighbours() {
    elements_at_.resize(mesh_.nodes.size());
    for (bool is_quad : {true, false}) {
      const ElementTable table(mesh_, is_quad);
      for (std::size_t i = 0; i < table.count(); ++i)
        for (int c = table.corners; c < 2 * table.corners; ++c)
          elements_at_[table.row(i)[c]].push_back({is_quad, static_cast<int>(i)});
    }
  }

  bool mend(const Element& element) {
    moved_.clear();
    if (element.is_quad) recentre(element);
    if (!is_valid(element)) {
      roll_back(0);
      if (!straighten(element, 0)) return false;
    }
    ++result_.straightened;
    for (const Moved& entry : moved_) {
      result_.moved.push_back(entry.node);
      if (mesh_.node_edge[entry.node] >= 0)
        result_.off_edge = std::max(result_.off_edge, norm(position(entry.node) - entry.from));
    }
    return true;
  }

  bool is_kept(int middle) const { return !moves_edges_ && (middle < first_inside_ || mesh_.node_edge[middle] >= 0); }

  bool straighten(const Element& element, int depth) {
    return std::any_of(straightening.begin(), straightening.end(), [&](double share) {
      return (moves_edges_ || share >= least_inside) && straighten_by(share, element, depth);
    });
  }

  // Moves the middles of the sides; true when the element is valid and no neighbour has become invalid.
  bool straighten_by(double share, const Element& element, int depth) {
    const std::size_t mark = moved_.size();
    const std::vector<Element> neighbours = valid_neighbours(element);
    const int* nodes = nodes_of(element);
    const int corners = corner_count(element);
    for (int c = 0; c < corners; ++c) {
      int middle = nodes[corners + c];
      if (is_kept(middle)) continue;
      Vec3 chord = 0.5 * (position(nodes[c]) + position(nodes[(c + 1) % corners]));
      move(middle, (1 - share) * position(middle) + share * chord);
    }
    if (element.is_quad) recentre(element);
    if (is_valid(element) && keep_valid(neighbours, depth)) return true;
    roll_back(mark);
    return false;
  }

  // Elements beside the sides that straightening moves, as far as they are valid now.
  std::vector<Element> valid_neighbours(const Element& element) const {
    std::vector<Element> neighbours;
    const int* nodes = nodes_of(element);
    const int corners = corner_count(element);
    for (int c = 0; c < corners; ++c) {
      int middle = nodes[corners + c];
      if (is_kept(middle)) continue;
      for (const Element& other : elements_at_[middle])
        if (other != element && is_valid(other)) neighbours.push_back(other);
    }
    return neighbours;
  }

  // Gives a neighbour that has become invalid a blended centre, or straightens it in its turn; its own neighbours stay
  // valid then. False when that is not enough.
  bool keep_valid(const std::vector<Element>& neighbours, int depth) {
    for (const Element& other : neighbours) {
      if (is_valid(other)) continue;
      if (other.is_quad) recentre(other);
      if (!is_valid(other) &&
          (depth == (moves_edges_ ? most_depth_at_edges : most_depth) || !straighten(other, depth + 1)))
        return false;
    }
    return true;
  }

  void recentre(const Element& quad) { move(nodes_of(quad)[8], blended_centre(mesh_, quad.index)); }
  void move(int node, Vec3 to) {
    moved_.push_back({node, position(node)});
    position(node) = to;
  }
  void roll_back(std::size_t mark) {
    for (; moved_.size() > mark; moved_.pop_back()) position(moved_.back().node) = moved_.back().from;
  }

  SurfaceMesh& mesh_;
  const IsValidFn& is_valid_;
  bool moves_edges_;
  int first_inside_;
  std::vector<std::vector<Element>> elements_at_;
  std::vector<Moved> moved_;  // for the element being mended, in order
  RepairResult result_;
};

}  // namespace

RepairResult repair_elements(SurfaceMesh& mesh, const IsValidFn& is_valid, const std::vector<int>& invalid_quads,
                             const std::vector<int>& invalid_triangles, int first_inside) {
  return Repairer(mesh, is_valid, false, first_inside).run(invalid_quads, invalid_triangles);
}

RepairResult straighten_at_edges(SurfaceMesh& mesh, const IsValidFn& is_valid, const std::vector<int>& invalid_quads,
                                 const std::vector<int>& invalid_triangles) {
  return Repairer(mesh, is_valid, true, 0).run(invalid_quads, invalid_triangles);
}

}  // namespace paver
