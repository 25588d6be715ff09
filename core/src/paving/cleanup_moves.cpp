// Elementary changes.
//
//   doublet    two elements sharing two edges become one
//   collapse   a quad's opposite corners a, c merge:   b          b
//                                                     / \         |
//                                                    a   c  ->    ac
//                                                     \ /         |
//                                                      d          d
//   pair       the outline of two elements with a common edge, of four, five or
//   six nodes, is divided otherwise opening    a node with many elements
//   becomes two with a quad between, the inverse of a collapse
#include "paving/cleanup_moves.h"

#include <algorithm>

namespace paver {

bool Moves::make_doublet(int node) {
  if (mesh_.is_fixed[node] || mesh_.star[node].size() != 2) return false;
  int e = *mesh_.star[node].begin(), f = *(mesh_.star[node].begin() + 1);
  const Element &one = mesh_.elements[e], &other = mesh_.elements[f];
  change_.clear();
  change_.gone = {e, f};
  int a = one.after(node), b = one.before(node);
  int x = one.corners() == 4 ? one.after(a) : -1, y = other.corners() == 4 ? other.after(b) : -1;
  if (x < 0 && y < 0) return false;
  if (x < 0)
    change_.made.push_back({a, b, y, -1});
  else if (y < 0)
    change_.made.push_back({a, x, b, -1});
  else
    change_.made.push_back({a, x, b, y});
  return true;
}

// Merges corners k and k + 2 of a quad.
bool Moves::make_collapse(int e, int k) {
  if (mesh_.elements[e].corners() != 4) return false;
  int keep = mesh_.elements[e].v[k], lost = mesh_.elements[e].v[k + 2];
  if (mesh_.is_fixed[lost]) std::swap(keep, lost);
  if (mesh_.is_fixed[lost]) return false;
  change_.clear();
  for (int g : mesh_.star[lost]) {
    change_.gone.push_back(g);
    if (g == e) continue;
    auto v = mesh_.elements[g].v;
    v[mesh_.elements[g].corner_of(lost)] = keep;
    change_.made.push_back(v);
  }
  if (!mesh_.is_fixed[keep]) change_.moved = keep, change_.place = 0.5 * (mesh_.p[keep] + mesh_.p[lost]);
  return true;
}

// The turn-th other division of e and its neighbour across the k-th edge from
// `node`.
bool Moves::make_pair(int e, int node, int k, int turn) {
  const Element& one = mesh_.elements[e];
  int n = one.corners(), at = one.corner_of(node);
  int a = one.v[(at + k) % n], b = one.v[(at + k + 1) % n];
  int f = edit_.across(e, a, b);
  if (f < 0) return false;
  const Element& other = mesh_.elements[f];
  int outline[6], count = 0;
  for (int v = b; v != a; v = one.after(v)) outline[count++] = v;
  for (int v = a; v != b; v = other.after(v)) {
    outline[count++] = v;
    if (count > 6) return false;
  }
  auto v = [&](int i) { return outline[i % count]; };
  change_.clear();
  change_.gone = {e, f};
  if (count == 4) {
    if (turn > 0) return false;
    change_.made.push_back({v(0), v(1), v(2), v(3)});
  } else if (count == 5) {
    if (turn > 4) return false;
    change_.made.push_back({v(turn), v(turn + 1), v(turn + 2), -1});
    change_.made.push_back({v(turn + 2), v(turn + 3), v(turn + 4), v(turn)});
  } else {
    return make_hexagon(outline, turn);
  }
  return true;
}

// The ways to divide a hexagon: two quads (three ways less the present one),
// three about a node, four about an edge.
bool Moves::make_hexagon(const int* outline, int turn) {
  auto v = [&](int i) { return outline[i % 6]; };
  int m = mesh_.node_count(), n = m + 1, t = turn;
  auto middle = [&](int i, int j) { return 0.5 * (mesh_.p[v(i)] + mesh_.p[v(j)]); };
  if (turn < 2) {
    change_.made = {{v(t + 1), v(t + 2), v(t + 3), v(t + 4)}, {v(t + 4), v(t + 5), v(t), v(t + 1)}};
  } else if (turn < 4) {
    change_.made = {{m, v(t), v(t + 1), v(t + 2)}, {m, v(t + 2), v(t + 3), v(t + 4)}, {m, v(t + 4), v(t + 5), v(t)}};
    change_.fresh = {(1.0 / 3) * (middle(0, 3) + middle(1, 4) + middle(2, 5))};
  } else if (turn < 7) {
    change_.made = {{v(t), v(t + 1), n, m},
                    {v(t + 1), v(t + 2), v(t + 3), n},
                    {m, n, v(t + 3), v(t + 4)},
                    {v(t), m, v(t + 4), v(t + 5)}};
    Vec2 left = middle(t, t + 4), right = middle(t + 1, t + 3);
    change_.fresh = {(2.0 / 3) * left + (1.0 / 3) * right, (1.0 / 3) * left + (2.0 / 3) * right};
  } else {
    return false;
  }
  return true;
}

bool Moves::collect_ring(int node) {
  ring_.clear();
  const Star& star = mesh_.star[node];
  if (star.size() < 4 || edit_.energy(node, -1) > edit_.energy(node) + 1) return false;  // has too few already
  int first = *star.begin(), size = star.size();
  for (int guard = 0; guard < size; ++guard) {  // back to the border, where there is one
    int before = edit_.across(first, node, mesh_.elements[first].after(node));
    if (before < 0 || before == *star.begin()) break;
    first = before;
  }
  for (int e = first; e >= 0 && static_cast<int>(ring_.size()) < size;) {
    ring_.push_back(e);
    int next = -1, last = mesh_.elements[e].before(node);
    for (int g : star)
      if (g != e && mesh_.elements[g].after(node) == last) next = g;
    e = next;
  }
  is_closed_ = size > 1 && mesh_.elements[ring_.back()].before(node) == mesh_.elements[ring_[0]].after(node);
  return static_cast<int>(ring_.size()) == size;
}

// A new node takes the ring's elements from, ..., from + count - 1.
bool Moves::make_opening(int node, int from, int count) {
  int n = static_cast<int>(ring_.size());
  if (is_closed_ ? count > n - 2 : from + count > n) return false;
  int fresh = mesh_.node_count();
  change_.clear();
  Vec2 mean{0, 0};
  for (int i = 0; i < count; ++i) {
    int e = ring_[(from + i) % n];
    auto v = mesh_.elements[e].v;
    v[mesh_.elements[e].corner_of(node)] = fresh;
    change_.gone.push_back(e);
    change_.made.push_back(v);
    for (int corner : mesh_.elements[e].v)
      if (corner >= 0) mean = mean + mesh_.p[corner] - mesh_.p[node];
  }
  int first = mesh_.elements[ring_[from]].after(node),
      last = mesh_.elements[ring_[(from + count - 1) % n]].before(node);
  change_.made.push_back({node, first, fresh, last});
  mean = (1.0 / (4 * count)) * mean;
  change_.fresh.push_back(mesh_.p[node] + mean);
  if (!mesh_.is_fixed[node]) change_.moved = node, change_.place = mesh_.p[node] - 0.5 * mean;
  return true;
}

}  // namespace paver
