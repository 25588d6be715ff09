// Dynamic programming over the chords of the outline, as for triangulations of polygons (Klincsek 1980): what is on one
// side of a chord does not depend on the other. With quads, the element at a chord has one or two further nodes.
#include "repair/edits/refill.h"

#include <algorithm>
#include <array>

namespace paver {
namespace {

constexpr double triangle_price = 0.02;

class Outline {
 public:
  Outline(std::span<const int> nodes, ElementKinds kinds, const std::function<double(const Corners&)>& value,
          const std::function<bool(int, int)>& is_taken)
      : nodes_(nodes), kinds_(kinds), value_(value), n_(static_cast<int>(nodes.size())) {
    for (int i = 0; i < n_; ++i)
      for (int j = i + 2; j < n_; ++j) taken_[i][j] = (i > 0 || j < n_ - 1) && is_taken(nodes[i], nodes[j]);
  }

  Filling run() {
    for (int length = 2; length < n_; ++length)
      for (int i = 0; i + length < n_; ++i) solve(i, i + length);
    Filling filling;
    const Best& whole = best_[0][n_ - 1];
    filling.worst = whole.worst, filling.triangles = whole.triangles;
    if (whole.worst > 0) collect(0, n_ - 1, filling.elements);
    return filling;
  }

 private:
  /// Of the nodes i to j, and the element at the chord from j to i: its corners between, the same twice for a triangle.
  struct Best {
    double worst = -1;
    int triangles = 0, k = -1, l = -1;
    double merit() const { return paver::merit(worst, triangles); }
  };

  bool is_open(int i, int j) const { return j - i < 2 || (!taken_[i][j] && best_[i][j].worst > 0); }

  void solve(int i, int j) {
    Best& best = best_[i][j];
    for (int k = i + 1; k < j; ++k) {
      if (!is_open(i, k)) continue;
      if (kinds_.triangles) improve(best, i, j, k, k, {nodes_[i], nodes_[k], nodes_[j], -1});
      for (int l = k + 1; kinds_.quads && l < j; ++l)
        improve(best, i, j, k, l, {nodes_[i], nodes_[k], nodes_[l], nodes_[j]});
    }
  }

  void improve(Best& best, int i, int j, int k, int l, const Corners& corners) {
    if (!is_open(i, k) || !is_open(k, l) || !is_open(l, j)) return;
    Best found{1, k == l, k, l};
    for (auto [a, b] : {std::pair(i, k), std::pair(k, l), std::pair(l, j)}) {
      if (b - a < 2) continue;
      found.worst = std::min(found.worst, best_[a][b].worst);
      found.triangles += best_[a][b].triangles;
    }
    if (found.merit() <= best.merit()) return;
    found.worst = std::min(found.worst, value_(corners));
    if (found.worst > 0 && found.merit() > best.merit()) best = found;
  }

  void collect(int i, int j, std::vector<Corners>& elements) const {
    if (j - i < 2) return;
    const Best& best = best_[i][j];
    elements.push_back(
        {nodes_[i], nodes_[best.k], best.l == best.k ? nodes_[j] : nodes_[best.l], best.l == best.k ? -1 : nodes_[j]});
    collect(i, best.k, elements);
    collect(best.k, best.l, elements);
    collect(best.l, j, elements);
  }

  std::span<const int> nodes_;
  const ElementKinds kinds_;
  const std::function<double(const Corners&)>& value_;
  const int n_;
  std::array<std::array<Best, most_outline>, most_outline> best_;
  std::array<std::array<bool, most_outline>, most_outline> taken_{};
};

}  // namespace

double merit(double worst, int triangles) { return std::min(worst, good_enough) - triangle_price * triangles; }

Filling fill_outline(std::span<const int> outline, ElementKinds kinds,
                     const std::function<double(const Corners&)>& value,
                     const std::function<bool(int, int)>& is_taken) {
  if (outline.size() < 3 || outline.size() > most_outline) return {};
  return Outline(outline, kinds, value, is_taken).run();
}

Filling fill_about(int centre, std::span<const int> outline, ElementKinds kinds,
                   const std::function<double(const Corners&)>& value) {
  const auto n = outline.size();
  auto at = [&](std::size_t i) { return outline[i % n]; };
  Filling best;
  auto improve = [&](std::size_t start, std::size_t quads) {
    Filling found{1, static_cast<int>(n - 2 * quads), {}};
    for (std::size_t i = start; i < start + n;) {
      const bool is_quad = i < start + 2 * quads;
      found.elements.push_back(is_quad ? Corners{centre, at(i), at(i + 1), at(i + 2)}
                                       : Corners{centre, at(i), at(i + 1), -1});
      i += is_quad ? 2 : 1;
      found.worst = std::min(found.worst, value(found.elements.back()));
      if (found.worst <= 0) return;
    }
    if (best.worst <= 0 || merit(found.worst, found.triangles) > merit(best.worst, best.triangles))
      best = std::move(found);
  };
  if (n < 3 || n > most_outline) return {};
  if (kinds.quads && n > 3 && (kinds.triangles || n % 2 == 0))
    for (std::size_t start = 0; start < (n % 2 == 0 ? 2 : n); ++start) improve(start, n / 2);
  if (kinds.triangles) improve(0, 0);
  return best;
}

}  // namespace paver
