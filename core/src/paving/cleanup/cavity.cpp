// Cavities: grow a disk of elements, see which of its outline nodes want one element inside (corners) and which two,
// and fill it with grids [Bunin06]; templates after [Verma15].
//
//   four corners: one grid        three or five: a node inside, joined to one node of each side
//     c3---------c2                         c2
//     |  |  |  |  |                        /  \         Side i runs from corner i to corner i + 1 and has
//     |--+--+--+--|                      m2    m1       L(i - 1) + L(i + 1) edges, L(i) the edges of the spoke
//     |  |  |  |  |                     /  `..'  \      from the side's middle node to the centre.
//     c0---------c1                   c0----m0----c1
#include "paving/cleanup/cavity.h"

#include <algorithm>

namespace paver {
namespace {

// One irregular node, or two with one element too many or too few, cannot go: the outline has their turn.
constexpr double least_unsettled = 2.2;

}  // namespace

void Cavity::start(int node) {
  elements_.clear(), nodes_.clear(), loop_.clear();
  if (stamp_.size() < mesh_.elements.size()) stamp_.resize(mesh_.elements.size() + 1024, 0);
  if (rim_.size() < mesh_.p.size()) rim_.resize(mesh_.p.size() + 1024);
  ++run_;
  sides_ = 0, doubled_ = 0, energy_ = 0, is_knot_ = false;
  first_ = 0;
  absorb_star(node);
}

void Cavity::absorb_star(int node) {
  for (int e : mesh_.star[node])
    if (stamp_[e] != run_) absorb(e);
}

void Cavity::absorb(int e) {
  stamp_[e] = run_;
  elements_.push_back(e);
  const Element& element = mesh_.elements[e];
  int n = element.corners();
  if (n == 3) energy_ += MeshEdit::triangle_energy;
  for (int i = 0; i < n; ++i) add_node(element.v[i]);
  for (int i = 0; i < n; ++i) cut_side(element.v[i], element.v[i + 1 < n ? i + 1 : 0]);
}

void Cavity::add_node(int node) {
  Rim& rim = rim_[node];
  if (rim.run != run_) {
    rim = {run_, 0, {-1, -1}};
    nodes_.push_back(node);
    energy_ += edit_.energy(node);
  }
  ++rim.inside;
}

// A side a -> b of an element taken in cancels against the outline's side b -> a.
void Cavity::cut_side(int a, int b) {
  auto& behind = rim_[b].next;
  for (int& next : behind)
    if (next == a) {
      if (behind[0] >= 0 && behind[1] >= 0) --doubled_;
      next = -1;
      --sides_;
      return;
    }
  auto& ahead = rim_[a].next;
  for (int& next : ahead)
    if (next < 0) {
      next = b;
      if (ahead[0] >= 0 && ahead[1] >= 0) ++doubled_;
      ++sides_;
      return;
    }
  is_knot_ = true;
}

// The outline, counter-clockwise; false when it is not one simple loop.
bool Cavity::trace_outline() {
  loop_.clear();
  if (is_knot_ || sides_ == 0 || doubled_ > 0) return false;
  auto is_inside = [&](int node) { return rim_[node].next[0] < 0 && rim_[node].next[1] < 0; };
  while (is_inside(nodes_[first_])) ++first_;  // and stays inside
  const int first = nodes_[first_];
  int a = first;
  do {
    loop_.push_back(a);
    a = std::max(rim_[a].next[0], rim_[a].next[1]);
  } while (a != first && static_cast<int>(loop_.size()) < sides_);
  return a == first && static_cast<int>(loop_.size()) == sides_;
}

// What each outline node costs as a corner and as a flat node, and how many
// elements it would like inside.
bool Cavity::weigh_corners() {
  bool is_convex = true;
  std::size_t n = loop_.size();
  wanted_.resize(n), as_flat_.resize(n), as_corner_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    int v = loop_[i], inside = rim_[v].inside;
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

// A hard point inside stays.
bool Cavity::has_fixed_inside() const {
  for (int v : nodes_)
    if (mesh_.is_fixed[v] && rim_[v].next[0] < 0 && rim_[v].next[1] < 0) return true;
  return false;
}

// Also finds the lengths of the trial's spokes, for three or five corners; for four only whether opposite sides agree.
bool Cavity::is_fillable(const std::vector<int>& corners) {
  int k = static_cast<int>(corners.size()), n = static_cast<int>(loop_.size());
  auto side = [&](int i) { return (corners[(i + 1) % k] - corners[i % k] + n) % n; };
  if (k == 4) return side(0) == side(2) && side(1) == side(3) && side(0) < 64 && side(1) < 64;
  if (k != 3 && k != 5) return false;
  trial_spokes_.assign(k, 0);
  int twice = 0;
  for (int step = 0; step < k; ++step) twice = side(2 * step + 1) - twice;
  if (twice % 2 != 0) return false;
  int length = twice / 2;
  for (int step = 0; step < k; ++step) {
    if (length < 1 || length > 62) return false;
    trial_spokes_[(2 * step) % k] = length;
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
    spokes_ = trial_spokes_;
  };
  consider(-1, -1);
  cheap_.clear();
  for (int i = 0; i < n; ++i) {
    if (base + price(i) >= best) continue;
    consider(i, -1);
    for (int j : cheap_) consider(i, j);
    cheap_.push_back(i);
  }
  return best;
}

Vec2 Cavity::chart_place(int node, const Change& fill) const {
  int old = mesh_.node_count();
  return node < old ? mesh_.p[node] : fill.fresh[node - old];
}

MetricVec Cavity::place(int node) const {
  int old = mesh_.node_count();
  return node < old ? mesh_.point(node) : fresh_x_[node - old];
}

int Cavity::add_fresh(Vec2 p, const MetricVec& x, Change& fill) {
  fill.fresh.push_back(p);
  fresh_x_.push_back(x);
  return mesh_.node_count() + static_cast<int>(fill.fresh.size()) - 1;
}

// Of a grid's side, as often as its elements have it: inner sides lie in two.
double Cavity::side_spread(int a, int b, bool is_outer) const {
  const int old = mesh_.node_count();
  if (a < old && b < old && edit_.is_border(a, b)) return 0;
  const double wished = 0.5 * ((a < old ? mesh_.h[a] : fresh_h_) + (b < old ? mesh_.h[b] : fresh_h_));
  return (is_outer ? 1 : 2) * MeshEdit::spread(norm(mesh_.step(place(a), place(b), wished)) / wished);
}

// Fills the grid, whose border is given, with new nodes (bilinear between
// opposite sides) and quads.
bool Cavity::make_grid(int a, int b, Change& fill) {
  for (int s = 0; s <= a; ++s) {
    for (int t = 1; t < b && s > 0 && s < a; ++t) {
      double x = static_cast<double>(s) / a, y = static_cast<double>(t) / b;
      auto blend = [&](auto at) {
        auto sides = (1 - x) * at(0, t) + x * at(a, t) + (1 - y) * at(s, 0) + y * at(s, b);
        return sides - (1 - x) * (1 - y) * at(0, 0) - x * (1 - y) * at(a, 0) - x * y * at(a, b) -
               (1 - x) * y * at(0, b);
      };
      Vec2 p = blend([&](int i, int j) { return chart_place(grid(i, j), fill); });
      grid(s, t) = add_fresh(p, blend([&](int i, int j) { return place(grid(i, j)); }), fill);
    }
    for (int t = 0; t < b; ++t) spread_left_ -= side_spread(grid(s, t), grid(s, t + 1), s == 0 || s == a);
    for (int t = 0; t <= b && s > 0; ++t) spread_left_ -= side_spread(grid(s - 1, t), grid(s, t), t == 0 || t == b);
    if (spread_left_ < 0) return false;
    for (int t = 0; t < b && s > 0; ++t)
      fill.made.push_back({grid(s - 1, t), grid(s, t), grid(s, t + 1), grid(s - 1, t + 1)});
  }
  return true;
}

bool Cavity::make_fill(Change& fill, double most_spread) {
  fill.clear();
  fresh_x_.clear();
  fill.gone = elements_;
  grid_.resize(64 * 64);
  fresh_h_ = 0;
  for (int v : loop_) fresh_h_ += mesh_.h[v] / static_cast<double>(loop_.size());
  spread_left_ = most_spread;
  for (int e : elements_) spread_left_ += edit_.spread_of(e);
  if (corners_.size() != 4) return make_star(fill);
  const int n = static_cast<int>(loop_.size()), a = (corners_[1] - corners_[0] + n) % n,
            b = (corners_[2] - corners_[1] + n) % n;
  for (int s = 0; s <= a; ++s) grid(s, 0) = around(corners_[0] + s), grid(s, b) = around(corners_[3] - s);
  for (int t = 0; t <= b; ++t) grid(a, t) = around(corners_[1] + t), grid(0, t) = around(corners_[0] - t);
  return make_grid(a, b, fill);
}

// Three or five grids about a node.
bool Cavity::make_star(Change& fill) {
  const int k = static_cast<int>(corners_.size());
  // Spoke i: from the middle of side i to the centre, as node numbers.
  std::vector<std::vector<int>> spoke(k);
  Vec2 centre{0, 0};
  MetricVec centre_x;
  auto middle = [&](int i) { return corners_[i] + spokes_[(i + k - 1) % k]; };
  for (int i = 0; i < k; ++i) {
    centre = centre + (1.0 / k) * mesh_.p[around(middle(i))];
    centre_x += (1.0 / k) * mesh_.point(around(middle(i)));
  }
  int hub = add_fresh(centre, centre_x, fill);
  for (int i = 0; i < k; ++i) {
    int length = spokes_[i], foot = around(middle(i));
    spoke[i].push_back(foot);
    for (int t = 1; t < length; ++t) {
      double share = static_cast<double>(t) / length;
      const MetricVec x = mesh_.point(foot) + share * (centre_x - mesh_.point(foot));
      spoke[i].push_back(add_fresh(mesh_.p[foot] + share * (centre - mesh_.p[foot]), x, fill));
    }
    spoke[i].push_back(hub);
  }
  for (int i = 0; i < k; ++i) {
    int before = (i + k - 1) % k, a = spokes_[before], b = spokes_[i];
    for (int s = 0; s <= a; ++s) grid(s, 0) = around(corners_[i] + s), grid(s, b) = spoke[before][s];
    for (int t = 0; t <= b; ++t) grid(a, t) = spoke[i][t], grid(0, t) = around(corners_[i] - t);
    if (!make_grid(a, b, fill)) return false;
  }
  return true;
}

std::optional<double> Cavity::find_fill(double least) {
  if (loop_.size() % 2 == 1 || (least > 0 && energy_ < std::max(least, least_unsettled)) || has_fixed_inside())
    return {};
  const double energy = best_corners(energy_ - least + 1e-9);
  if (energy > energy_ - least) return {};
  return energy - energy_;
}

}  // namespace paver
