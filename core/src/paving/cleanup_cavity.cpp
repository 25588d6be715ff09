// Cavities: grow a disk of elements, see which of its outline nodes want one
// element inside (corners) and which two, and fill it with grids.
//
//   four corners: one grid              three or five: a node inside joined to
//   one node of each side
//     c3------c2                              c2
//     |  |  |  |                             /  \       side i from corner i to
//     i + 1 has L(i-1) + L(i+1) edges,
//     +--+--+--+                           m1    m2     L(i) the edges from the
//     side's middle node to the centre |  |  |  |                           /
//     `+'  \                            [Bunin08, templates of Verma and
//     Suresh] c0------c1                         c0---m0---c1
#include "paving/cleanup_cavity.h"

#include <algorithm>

namespace paver {

void Cavity::start(int node) {
  elements_.clear();
  loop_.clear();
  stamp_.resize(mesh_.elements.size() + 1024, 0);
  ++run_;
  absorb_star(node);
}

void Cavity::absorb_star(int node) {
  for (int e : mesh_.star[node]) {
    if (stamp_[e] == run_) continue;
    stamp_[e] = run_;
    elements_.push_back(e);
  }
}

// The outline, counter-clockwise; false when it is not one simple loop.
bool Cavity::trace_outline() {
  ++trace_;
  if (next_.size() < mesh_.p.size()) next_.resize(mesh_.p.size() + 1024, -1), next_run_.resize(next_.size(), 0);
  int count = 0, first = -1;
  for (int e : elements_) {
    const Element& element = mesh_.elements[e];
    for (int i = 0, n = element.corners(); i < n; ++i) {
      int a = element.v[i], b = element.v[(i + 1) % n], g = edit_.across(e, a, b);
      if (g >= 0 && stamp_[g] == run_) continue;
      if (next_run_[a] == trace_) return false;
      next_run_[a] = trace_;
      next_[a] = b;
      first = a;
      ++count;
    }
  }
  loop_.clear();
  if (first < 0) return false;
  int a = first;
  do {
    loop_.push_back(a);
    a = next_[a];
  } while (a != first && static_cast<int>(loop_.size()) <= count);
  return static_cast<int>(loop_.size()) == count;
}

// What each outline node costs as a corner and as a flat node, and how many
// elements it would like inside.
bool Cavity::weigh_corners() {
  bool is_convex = true;
  std::size_t n = loop_.size();
  wanted_.resize(n), as_flat_.resize(n), as_corner_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    int v = loop_[i], inside = 0;
    for (int e : mesh_.star[v]) inside += stamp_[e] == run_;
    as_corner_[i] = edit_.energy(v, 1 - inside);
    as_flat_[i] = edit_.energy(v, 2 - inside);
    wanted_[i] = as_corner_[i] < as_flat_[i] ? 1 : edit_.energy(v, 3 - inside) < as_flat_[i] ? 3 : 2;
    if (wanted_[i] == 3 && inside < mesh_.star[v].size()) is_convex = false;
  }
  return is_convex;
}

bool Cavity::make_convex(int most_elements) {
  while (trace_outline()) {
    if (static_cast<int>(elements_.size()) > most_elements) return false;
    if (weigh_corners()) return true;
    std::size_t count = elements_.size();
    for (std::size_t i = 0; i < loop_.size(); ++i)
      if (wanted_[i] == 3) absorb_star(loop_[i]);
    if (elements_.size() == count) return false;
  }
  return false;
}

bool Cavity::grow(int most_elements) {
  std::size_t before = elements_.size();
  for (int v : loop_)
    if (edit_.is_irregular(v)) absorb_star(v);
  if (elements_.size() == before)
    for (int v : loop_) absorb_star(v);
  return make_convex(most_elements);
}

std::size_t Cavity::outline_key() const {
  std::size_t key = 0;
  for (int v : loop_) {
    std::size_t z = static_cast<std::size_t>(v) * 0x9E3779B97F4A7C15u;
    key += (z ^ (z >> 29)) * 0xBF58476D1CE4E5B9u;
  }
  return key;
}

double Cavity::energy_now() const {
  double sum = 0, corners = 0;
  for (int v : loop_) sum += edit_.energy(v);
  for (int e : elements_) {
    const Element& element = mesh_.elements[e];
    if (element.corners() == 3) sum += MeshEdit::triangle_energy;
    for (int v : element.v) {
      if (v < 0 || next_run_[v] == trace_) continue;
      if (mesh_.is_fixed[v]) return -1;  // a hard point inside stays
      corners += edit_.energy(v) / mesh_.star[v].size();
    }
  }
  return sum + corners;
}

// Spoke lengths for three or five corners; for four only whether opposite sides
// agree.
bool Cavity::is_fillable(const std::vector<int>& corners) {
  int k = static_cast<int>(corners.size()), n = static_cast<int>(loop_.size());
  auto side = [&](int i) { return (corners[(i + 1) % k] - corners[i % k] + n) % n; };
  if (k == 4) return side(0) == side(2) && side(1) == side(3) && side(0) < 64 && side(1) < 64;
  if (k != 3 && k != 5) return false;
  spokes_.assign(k, 0);
  int twice = 0;
  for (int step = 0; step < k; ++step) twice = side(2 * step + 1) - twice;
  if (twice % 2 != 0) return false;
  int length = twice / 2;
  for (int step = 0; step < k; ++step) {
    if (length < 1 || length > 62) return false;
    spokes_[(2 * step) % k] = length;
    length = side(2 * step + 1) - length;
  }
  return true;
}

// The corners of least energy below the limit, with up to two nodes that do not
// get what they want.
double Cavity::best_corners(double limit) {
  int n = static_cast<int>(loop_.size()), base_count = 0;
  double base = 0;
  for (int i = 0; i < n; ++i) {
    base += wanted_[i] == 1 ? as_corner_[i] : as_flat_[i];
    base_count += wanted_[i] == 1;
  }
  double best = limit;
  auto price = [&](int i) { return i < 0 ? 0 : std::fabs(as_corner_[i] - as_flat_[i]); };
  auto change = [&](int i) { return i < 0 ? 0 : wanted_[i] == 1 ? -1 : 1; };
  auto consider = [&](int i, int j) {
    int count = base_count + change(i) + change(j);
    double cost = base + price(i) + price(j) + (count == 4 ? 0 : 1);
    if (count < 3 || count > 5 || cost >= best) return;
    trial_.clear();
    for (int k = 0; k < n; ++k)
      if ((wanted_[k] == 1) != (k == i || k == j)) trial_.push_back(k);
    if (!is_fillable(trial_)) return;
    best = cost;
    corners_ = trial_;
  };
  consider(-1, -1);
  for (int i = 0; i < n; ++i) {
    if (base + price(i) >= best) continue;
    consider(i, -1);
    for (int j = 0; j < i; ++j) consider(i, j);
  }
  return best;
}

Vec2 Cavity::place(int node, const Change& fill) const {
  int old = mesh_.node_count();
  return node < old ? mesh_.p[node] : fill.fresh[node - old];
}

// Fills the grid, whose border is given, with new nodes (bilinear between
// opposite sides) and quads.
void Cavity::make_grid(int a, int b, Change& fill) {
  auto at = [&](int s, int t) { return place(grid(s, t), fill); };
  for (int s = 1; s < a; ++s)
    for (int t = 1; t < b; ++t) {
      double x = static_cast<double>(s) / a, y = static_cast<double>(t) / b;
      Vec2 p = (1 - x) * at(0, t) + x * at(a, t) + (1 - y) * at(s, 0) + y * at(s, b);
      p = p - (1 - x) * (1 - y) * at(0, 0) - x * (1 - y) * at(a, 0) - x * y * at(a, b) - (1 - x) * y * at(0, b);
      grid(s, t) = mesh_.node_count() + static_cast<int>(fill.fresh.size());
      fill.fresh.push_back(p);
    }
  for (int s = 0; s < a; ++s)
    for (int t = 0; t < b; ++t) fill.made.push_back({grid(s, t), grid(s + 1, t), grid(s + 1, t + 1), grid(s, t + 1)});
}

void Cavity::make_fill(Change& fill) {
  fill.clear();
  fill.gone = elements_;
  grid_.resize(64 * 64);
  int k = static_cast<int>(corners_.size()), n = static_cast<int>(loop_.size());
  auto side = [&](int i) { return (corners_[(i + 1) % k] - corners_[i] + n) % n; };
  if (k == 4) {
    int a = side(0), b = side(1);
    for (int s = 0; s <= a; ++s) grid(s, 0) = around(corners_[0] + s), grid(s, b) = around(corners_[3] - s);
    for (int t = 0; t <= b; ++t) grid(a, t) = around(corners_[1] + t), grid(0, t) = around(corners_[0] - t);
    make_grid(a, b, fill);
    return;
  }
  // Spoke i: from the middle of side i to the centre, as node numbers.
  std::vector<std::vector<int>> spoke(k);
  Vec2 centre{0, 0};
  auto middle = [&](int i) { return corners_[i] + spokes_[(i + k - 1) % k]; };
  for (int i = 0; i < k; ++i) centre = centre + (1.0 / k) * mesh_.p[around(middle(i))];
  int hub = mesh_.node_count();
  fill.fresh.push_back(centre);
  for (int i = 0; i < k; ++i) {
    int length = spokes_[i], foot = around(middle(i));
    spoke[i].push_back(foot);
    for (int t = 1; t < length; ++t) {
      spoke[i].push_back(mesh_.node_count() + static_cast<int>(fill.fresh.size()));
      fill.fresh.push_back(mesh_.p[foot] + (static_cast<double>(t) / length) * (centre - mesh_.p[foot]));
    }
    spoke[i].push_back(hub);
  }
  for (int i = 0; i < k; ++i) {
    int before = (i + k - 1) % k, a = spokes_[before], b = spokes_[i];
    for (int s = 0; s <= a; ++s) grid(s, 0) = around(corners_[i] + s), grid(s, b) = spoke[before][s];
    for (int t = 0; t <= b; ++t) grid(a, t) = spoke[i][t], grid(0, t) = around(corners_[i] - t);
    make_grid(a, b, fill);
  }
}

bool Cavity::find_fill(double least, Change& fill) {
  if (loop_.size() % 2 == 1) return false;
  double now = energy_now();
  if (now < least || best_corners(now - least + 1e-9) > now - least) return false;
  make_fill(fill);
  return true;
}

}  // namespace paver
