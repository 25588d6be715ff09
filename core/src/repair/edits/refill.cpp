// Dynamic programming over the chords of the outline, as for triangulations of polygons (Klincsek 1980): what is on one
// side of a chord does not depend on the other. With quads, the element at a chord has one or two further nodes.
#include "repair/edits/refill.h"

#include <algorithm>

namespace paver {
namespace {

constexpr double triangle_price = 0.02;

/// What the elements of a filling must exceed to be better than one that is there, if any.
double value_needed(double worst, double merit, int triangles) {
  return worst > 0 ? std::max(merit + triangle_price * triangles, 0.0) : 0;
}

class Outline {
 public:
  Outline(std::span<const int> nodes, ElementKinds kinds, const ElementValue& value,
          const std::function<bool(int, int)>& is_taken)
      : nodes_(nodes),
        kinds_(kinds),
        value_(value),
        n_(static_cast<int>(nodes.size())),
        chords_(nodes.size() * nodes.size()) {
    for (int i = 0; i < n_; ++i)
      for (int j = i + 2; j < n_; ++j) chord(i, j).is_taken = (i > 0 || j < n_ - 1) && is_taken(nodes[i], nodes[j]);
  }

  Filling run() {
    for (int length = 2; length < n_; ++length)
      for (int i = 0; i + length < n_; ++i) solve(i, i + length);
    Filling filling;
    const Best& whole = chord(0, n_ - 1).best;
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

  struct Chord {
    Best best;
    bool is_taken = false;
  };
  Chord& chord(int i, int j) { return chords_[i * n_ + j]; }
  const Chord& chord(int i, int j) const { return chords_[i * n_ + j]; }
  bool is_open(int i, int j) const { return j - i < 2 || (!chord(i, j).is_taken && chord(i, j).best.worst > 0); }

  void solve(int i, int j) {
    Best& best = chord(i, j).best;
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
      found.worst = std::min(found.worst, chord(a, b).best.worst);
      found.triangles += chord(a, b).best.triangles;
    }
    if (found.merit() <= best.merit()) return;
    const double floor = value_needed(best.worst, best.merit(), found.triangles);
    found.worst = std::min(found.worst, value_(corners, floor));
    if (found.worst > 0 && found.merit() > best.merit()) best = found;
  }

  void collect(int i, int j, std::vector<Corners>& elements) const {
    if (j - i < 2) return;
    const Best& best = chord(i, j).best;
    elements.push_back(
        {nodes_[i], nodes_[best.k], best.l == best.k ? nodes_[j] : nodes_[best.l], best.l == best.k ? -1 : nodes_[j]});
    collect(i, best.k, elements);
    collect(best.k, best.l, elements);
    collect(best.l, j, elements);
  }

  std::span<const int> nodes_;
  const ElementKinds kinds_;
  const ElementValue& value_;
  const int n_;
  std::vector<Chord> chords_;  // per pair of nodes, the first before the second
};

}  // namespace

double merit(double worst, int triangles) { return std::min(worst, fair) - triangle_price * triangles; }

Filling fill_outline(std::span<const int> outline, ElementKinds kinds, const ElementValue& value,
                     const std::function<bool(int, int)>& is_taken, std::size_t most_nodes) {
  if (outline.size() < 3 || outline.size() > most_nodes) return {};
  return Outline(outline, kinds, value, is_taken).run();
}

Filling fill_outline(std::span<const int> outline, ElementKinds kinds, const ElementJudge& judge) {
  return fill_outline(
      outline, kinds, [&](const Corners& v, double floor) { return judge.value(v, floor); },
      [](int, int) { return false; });
}

Filling fill_about(int centre, std::span<const int> outline, ElementKinds kinds, const ElementValue& value) {
  const auto n = outline.size();
  auto at = [&](std::size_t i) { return outline[i % n]; };
  Filling best;
  auto improve = [&](std::size_t start, std::size_t quads) {
    Filling found{1, static_cast<int>(n - 2 * quads), {}};
    const double floor = value_needed(best.worst, merit(best.worst, best.triangles), found.triangles);
    for (std::size_t i = start; i < start + n;) {
      const bool is_quad = i < start + 2 * quads;
      found.elements.push_back(is_quad ? Corners{centre, at(i), at(i + 1), at(i + 2)}
                                       : Corners{centre, at(i), at(i + 1), -1});
      i += is_quad ? 2 : 1;
      found.worst = std::min(found.worst, value(found.elements.back(), floor));
      if (found.worst <= floor) return;
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
