// Elementary changes.
//
//   doublet    two elements sharing two edges become one
//   collapse   a quad's opposite corners a, c merge:    b          b
//                                                      / \         |
//                                                     a   c  ->    ac
//                                                      \ /         |
//                                                       d          d
//   pair       the outline of two elements with a common edge, of four, five or six nodes, is divided otherwise
//   opening    a node with many elements becomes two with a quad between, the inverse of a collapse
#include "paving/cleanup/moves.h"

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
  change_.made.push_back(x < 0 ? Corners{a, b, y, -1} : Corners{a, x, b, y});
  return true;
}

// Corners k and k + 2 of a quad.
bool Moves::find_collapse(int e, int k) {
  if (mesh_.elements[e].corners() != 4) return false;
  const auto& v = mesh_.elements[e].v;
  keep_ = v[k], lost_ = v[k + 2];
  if (mesh_.is_fixed[lost_]) std::swap(keep_, lost_);
  if (mesh_.is_fixed[lost_]) return false;
  gain_ = edit_.step(keep_, mesh_.star[lost_].size() - 2) - edit_.energy(lost_) + edit_.step(v[1 - k], -1) +
          edit_.step(v[3 - k], -1);
  return true;
}

void Moves::make_collapse(int e) {
  change_.clear();
  for (int g : mesh_.star[lost_]) {
    change_.gone.push_back(g);
    if (g == e) continue;
    auto v = mesh_.elements[g].v;
    v[mesh_.elements[g].corner_of(lost_)] = keep_;
    change_.made.push_back(v);
  }
  if (!mesh_.is_fixed[keep_]) change_.moved = keep_, change_.place = 0.5 * (mesh_.p[keep_] + mesh_.p[lost_]);
}

// e and its neighbour across the k-th edge from `node`.
bool Moves::find_pair(int e, int node, int k) {
  const Element& one = mesh_.elements[e];
  int n = one.corners(), at = one.corner_of(node);
  int a = one.v[(at + k) % n], b = one.v[(at + k + 1) % n];
  int f = mesh_.across(a, b);
  if (f < 0) return false;
  const Element& other = mesh_.elements[f];
  int count = 0;
  for (int v = b; v != a; v = one.after(v)) outline_[count++] = v;
  for (int v = a; v != b; v = other.after(v)) {
    if (count == 6) return false;
    outline_[count++] = v;
  }
  pair_ = {e, f};
  outline_size_ = count;
  return true;
}

// The turn-th division of the outline of two triangles or of a triangle and a quad.
bool Moves::make_small_division(int turn) {
  auto v = [&](int i) { return outline_[i % outline_size_]; };
  if (turn >= (outline_size_ == 4 ? 1 : 5)) return false;
  change_.clear();
  change_.gone.assign(pair_.begin(), pair_.end());
  if (outline_size_ == 4) {
    change_.made.push_back({v(0), v(1), v(2), v(3)});
  } else {
    change_.made.push_back({v(turn), v(turn + 1), v(turn + 2), -1});
    change_.made.push_back({v(turn + 2), v(turn + 3), v(turn + 4), v(turn)});
  }
  return true;
}

// The two quads meet in the edge from outline node 0 to 3.
void Moves::weigh_outline() {
  for (int i = 0; i < 6; ++i) less_[i] = edit_.step(outline_[i], -1), more_[i] = edit_.step(outline_[i], 1);
}

// The ways to divide a hexagon: two quads (three ways less the present one), three about a node, four about an edge.
double Moves::division_gain(int turn) const {
  constexpr double regular_less_one = 1;  // energy of a new node with three elements
  if (turn < 2) return less_[0] + less_[3] + more_[turn + 1] + more_[turn + 4];
  if (turn == 2) return regular_less_one + less_[3] + more_[2] + more_[4];
  if (turn == 3) return regular_less_one + less_[0] + more_[1] + more_[5];
  double gain = 2 * regular_less_one;
  int one = (turn + 2) % 6, other = (turn + 5) % 6;  // these two have one element, all others two
  for (int i = 0; i < 6; ++i) {
    bool had_two = i == 0 || i == 3, has_two = i != one && i != other;
    if (had_two != has_two) gain += has_two ? more_[i] : less_[i];
  }
  return gain;
}

void Moves::make_hexagon(int turn) {
  auto v = [&](int i) { return outline_[i % 6]; };
  int m = mesh_.node_count(), n = m + 1, t = turn;
  auto middle = [&](int i, int j) { return 0.5 * (mesh_.p[v(i)] + mesh_.p[v(j)]); };
  change_.clear();
  change_.gone.assign(pair_.begin(), pair_.end());
  if (turn < 2) {
    change_.made = {{v(t + 1), v(t + 2), v(t + 3), v(t + 4)}, {v(t + 4), v(t + 5), v(t), v(t + 1)}};
  } else if (turn < 4) {
    change_.made = {{m, v(t), v(t + 1), v(t + 2)}, {m, v(t + 2), v(t + 3), v(t + 4)}, {m, v(t + 4), v(t + 5), v(t)}};
    change_.fresh = {(1.0 / 3) * (middle(0, 3) + middle(1, 4) + middle(2, 5))};
  } else {
    change_.made = {{v(t), v(t + 1), n, m},
                    {v(t + 1), v(t + 2), v(t + 3), n},
                    {m, n, v(t + 3), v(t + 4)},
                    {v(t), m, v(t + 4), v(t + 5)}};
    Vec2 left = middle(t, t + 4), right = middle(t + 1, t + 3);
    change_.fresh = {(2.0 / 3) * left + (1.0 / 3) * right, (1.0 / 3) * left + (2.0 / 3) * right};
  }
}

bool Moves::collect_ring(int node) {
  ring_.clear();
  const Star& star = mesh_.star[node];
  if (star.size() < 4 || edit_.energy(node, -1) > edit_.energy(node) + 1) return false;  // has too few already
  int first = *star.begin(), size = star.size();
  for (int guard = 0; guard < size; ++guard) {  // back to the border, where there is one
    int before = mesh_.across(node, mesh_.elements[first].after(node));
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
bool Moves::find_opening(int node, int from, int count) {
  int n = static_cast<int>(ring_.size());
  if (is_closed_ ? count > n - 2 : from + count > n) return false;
  taken_.clear();
  for (int i = 0; i < count; ++i) taken_.push_back(ring_[(from + i) % n]);
  int first = mesh_.elements[taken_.front()].after(node), last = mesh_.elements[taken_.back()].before(node);
  gain_ = edit_.step(node, 1 - count) + edit_.energy_of_new(count + 1) + edit_.step(first, 1) + edit_.step(last, 1);
  return true;
}

void Moves::make_opening(int node) {
  int fresh = mesh_.node_count(), count = static_cast<int>(taken_.size());
  change_.clear();
  Vec2 mean{0, 0};
  for (int e : taken_) {
    auto v = mesh_.elements[e].v;
    v[mesh_.elements[e].corner_of(node)] = fresh;
    change_.gone.push_back(e);
    change_.made.push_back(v);
    for (int corner : mesh_.elements[e].nodes()) mean = mean + mesh_.p[corner] - mesh_.p[node];
  }
  int first = mesh_.elements[taken_.front()].after(node), last = mesh_.elements[taken_.back()].before(node);
  change_.made.push_back({node, first, fresh, last});
  mean = (1.0 / (4 * count)) * mean;
  change_.fresh.push_back(mesh_.p[node] + mean);
  if (!mesh_.is_fixed[node]) change_.moved = node, change_.place = mesh_.p[node] - 0.5 * mean;
}

}  // namespace paver
