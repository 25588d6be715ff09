// Chords come from closures in narrow ends, as in a round end divided finely for its turn:
//
//      2---3              2---3
//     /     |            /     |
//    1-------4    ->    1---c---4        1 4 was a chord, c is new
//    |       |          |  /    |
//    0-------5          0-------5
//
// Outlines of two quads have three diagonals and two stars; those of a triangle and a quad, or of two triangles, only
// diagonals.
#include "paving/cleanup/chords.h"

#include <algorithm>
#include <tuple>

namespace paver {
namespace {

constexpr double towards_nodes[] = {0.2, 0.4, 0.6};  // shares of the way that a node inside a hexagon tries

/// An edge longer than this share of its chord bulges too far to be mistaken for it.
constexpr double longest_arc = 1.6;
constexpr double fair = 0.1;  // least scaled Jacobian of a new division, unless the old one was below
constexpr int passes = 3;

class ChordRemover {
 public:
  explicit ChordRemover(Front& front) : front_(front), mesh_(front.mesh) {
    facets_from_.resize(static_cast<std::size_t>(mesh_.node_count()));
    for (std::size_t f = 0; f < front.boundary.size(); ++f)
      facets_from_[front.boundary[f].a].push_back(static_cast<int>(f));
  }

  // Shortest first: what lies inside a narrow end opens the way to its mouth.
  int run() {
    int removed = 0;
    for (int pass = 0; pass < passes; ++pass) {
      int before = removed;
      for (auto [length, a, b] : chords()) {
        int one = mesh_.across(b, a), other = mesh_.across(a, b);
        if (one >= 0 && other >= 0) removed += divide(one, other, a, b);
      }
      if (removed == before) break;
    }
    return removed;
  }

 private:
  struct Division {
    double worst = -1;
    std::vector<Corners> elements;
  };

  std::vector<std::tuple<double, int, int>> chords() const {
    std::vector<std::tuple<double, int, int>> found;
    for (const Element& e : mesh_.elements)
      for (int i = 0; e.is_alive() && i < e.corners(); ++i) {
        int a = e.v[i], b = e.v[(i + 1) % e.corners()];
        if (a < b && is_chord(a, b)) found.emplace_back(norm(mesh_.x[b] - mesh_.x[a]), a, b);
      }
    std::sort(found.begin(), found.end());
    return found;
  }

  bool is_chord(int a, int b) const { return runs_beside(a, b) || runs_beside(b, a); }

  /// Whether the boundary leads from a to b along one B-rep edge, over other nodes, and not by far a detour.
  bool runs_beside(int a, int b) const {
    if (!is_boundary(a) || !is_boundary(b)) return false;
    double limit = longest_arc * norm(mesh_.x[b] - mesh_.x[a]);
    for (int first : facets_from_[a]) {
      double length = 0;
      int count = 0;
      const int edge = front_.boundary[first].edge;
      for (int f = first; edge >= 0 && front_.boundary[f].edge == edge; ++count) {
        int end = front_.boundary[f].b;
        length += norm(mesh_.x[end] - mesh_.x[front_.boundary[f].a]);
        if (length > limit) break;
        if (end == b) return count > 0;
        if (facets_from_[end].size() != 1) break;
        f = facets_from_[end][0];
      }
    }
    return false;
  }

  bool is_boundary(int node) const {
    return node < static_cast<int>(facets_from_.size()) && !facets_from_[node].empty();
  }

  bool divide(int one, int other, int a, int b) {
    const std::vector<int> outline = outline_of(one, other, a, b);
    const double old =
        std::min(scaled_jacobian(mesh_, mesh_.elements[one]), scaled_jacobian(mesh_, mesh_.elements[other]));
    Division best = by_diagonal(outline);
    bool is_star = false;
    if (outline.size() == 6) {
      Division star = about_centre(outline);
      is_star = star.worst > best.worst;
      if (is_star) best = star;
    }
    bool is_good = best.worst > 0 && best.worst >= std::min(fair, old);
    if (outline.size() == 6 && !(is_star && is_good)) front_.drop_last_node();
    if (!is_good) return false;
    mesh_.remove_element(one);
    mesh_.remove_element(other);
    for (const Corners& corners : best.elements) mesh_.add_element(corners);
    return true;
  }

  /// The nodes about both elements, counter-clockwise.
  std::vector<int> outline_of(int one, int other, int a, int b) const {
    std::vector<int> outline;
    for (int v = b; v != a; v = mesh_.elements[one].after(v)) outline.push_back(v);
    for (int v = a; v != b; v = mesh_.elements[other].after(v)) outline.push_back(v);
    return outline;
  }

  Division by_diagonal(const std::vector<int>& v) const {
    Division best;
    const int n = static_cast<int>(v.size());
    auto at = [&](int i) { return v[static_cast<std::size_t>(i % n)]; };
    for (int i = 0; i < n; ++i) {
      int span = n == 6 ? 3 : 2;  // facets that the diagonal from i cuts off
      if (is_chord(at(i), at(i + span))) continue;
      Corners cut{at(i), at(i + 1), at(i + 2), span == 3 ? at(i + 3) : -1};
      Corners rest{at(i), at(i + span), at(i + span + 1), n - span == 3 ? at(i + span + 2) : -1};
      keep_better({cut, rest}, best);
    }
    return best;
  }

  /// Adds the node: near the middle, drawn towards one of the outline's nodes where that is better.
  Division about_centre(const std::vector<int>& v) {
    Vec2 middle{0, 0};
    double h = 1e300;
    for (int node : v) {
      middle = middle + (1.0 / 6) * mesh_.p[node];
      h = std::min(h, mesh_.h[node]);
    }
    const int centre = front_.add_node(middle);
    mesh_.h[centre] = std::min(h, mesh_.h[centre]);
    Division best = stars(centre, v);
    Vec2 place = middle;
    for (double share : towards_nodes)
      for (int node : v) {
        Vec2 p = middle + share * (mesh_.p[node] - middle);
        move(centre, p);
        Division star = stars(centre, v);
        if (star.worst > best.worst) best = star, place = p;
      }
    move(centre, place);
    return best;
  }

  void move(int node, Vec2 p) { mesh_.put(node, front_.region.place(p)); }

  Division stars(int centre, const std::vector<int>& v) const {
    Division best;
    for (std::size_t first : {0U, 1U}) {
      std::vector<Corners> quads;
      for (std::size_t i = first; i < first + 6; i += 2)
        quads.push_back({centre, v[i % 6], v[(i + 1) % 6], v[(i + 2) % 6]});
      keep_better(quads, best);
    }
    return best;
  }

  void keep_better(const std::vector<Corners>& elements, Division& best) const {
    double worst = 1;
    for (const Corners& corners : elements) worst = std::min(worst, positive_jacobian(mesh_, corners));
    if (worst > best.worst) best = {worst, elements};
  }

  Front& front_;
  RegionMesh& mesh_;
  std::vector<std::vector<int>> facets_from_;
};

}  // namespace

int remove_chords(Front& front) { return ChordRemover(front).run(); }

}  // namespace paver
