// Breadth-first search for the nearest other triangle, then
//
//     +----+----+           +----+----+
//    /|    |    |\         /  \   \    \       the strip's outline stays as it is
//   + |    |    | +  ->   +    \   \    +
//    \|    |    |/         \    \   \  /
//     +----+----+           +----+----+
#include "paving/cleanup/triangle_pairs.h"

#include <algorithm>

namespace paver {

bool TrianglePairs::search(int triangle, int nearer) {
  stamp_.resize(std::max(stamp_.size(), mesh_.elements.size()), 0);
  parent_.resize(stamp_.size());
  ++run_;
  queue_.assign(1, triangle);
  stamp_[triangle] = run_;
  parent_[triangle] = -1;
  for (std::size_t i = 0; i < queue_.size() && i < most_visited; ++i) {
    const Element& e = mesh_.elements[queue_[i]];
    if (i > 0 && e.corners() == 3) {
      if (nearer-- > 0) continue;
      path_.clear();
      for (int at = queue_[i]; at >= 0; at = parent_[at]) path_.push_back(at);
      return true;
    }
    for (int k = 0, n = e.corners(); k < n; ++k) {
      int g = mesh_.across(e.v[k], e.v[(k + 1) % n]);
      if (g < 0 || stamp_[g] == run_) continue;
      stamp_[g] = run_;
      parent_[g] = queue_[i];
      queue_.push_back(g);
    }
  }
  return false;
}

bool TrianglePairs::make(Change& change) const {
  change.clear();
  change.gone = path_;
  // The corner of element e, counted in its own order, where the side it shares
  // with g starts.
  auto shared = [&](int e, int g) {
    const Element &one = mesh_.elements[e], &other = mesh_.elements[g];
    for (int k = 0, n = one.corners(); k < n; ++k) {
      int a = one.v[k], b = one.v[(k + 1) % n], at = other.corner_of(b);
      if (at >= 0 && other.after(b) == a) return k;
    }
    return -1;
  };
  int side = shared(path_[0], path_[1]);
  if (side < 0) return false;
  int apex = mesh_.elements[path_[0]].v[(side + 2) % 3];  // of the half triangle behind the side about to be crossed
  for (std::size_t i = 1; i < path_.size(); ++i) {
    const Element& e = mesh_.elements[path_[i]];
    int in = shared(path_[i], path_[i - 1]), n = e.corners();
    if (in < 0) return false;
    auto v = [&](int k) { return e.v[(in + k) % n]; };
    auto joined = [&](int far) { return Corners{v(0), apex, v(1), far}; };
    if (n == 3) {
      change.made.push_back(joined(v(2)));
      return i + 1 == path_.size();
    }
    int out = shared(path_[i], path_[i + 1]);
    if (out < 0) return false;
    out = (out + 4 - in) % 4;
    auto worth = [&](int far) { return scaled_jacobian(mesh_, Element{joined(far)}); };
    bool from_first = out == 3 || (out == 2 && worth(v(2)) >= worth(v(3)));  // cut from v(0) to v(2)
    change.made.push_back(joined(from_first ? v(2) : v(3)));
    // The other half's node that is not on the side crossed next.
    apex = from_first ? (out == 3 ? v(2) : v(0)) : (out == 1 ? v(3) : v(1));
  }
  return false;
}

bool TrianglePairs::find(int triangle, Change& change, int nearer) { return search(triangle, nearer) && make(change); }

}  // namespace paver
