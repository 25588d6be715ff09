// In: facets with middles. Out: those to be divided.
// Pairs whose boxes meet; sides of order 2 as chains of chords.
#include "regions/bulging_facets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "base/boxes/box_pairs.h"
#include "base/segment.h"
#include "regions/curves_apart.h"

namespace paver {
namespace {

constexpr int pieces = 8;
constexpr double straight = 0.002;  // bulge by chord

using Chain = std::array<Vec2, pieces + 1>;

Chain side_of(const CurvedFacet& f) {
  Chain chain;
  for (int i = 0; i <= pieces; ++i) {
    const double t = static_cast<double>(i) / pieces;
    chain[i] = (1 - t) * (1 - 2 * t) * f.start + 4 * t * (1 - t) * f.middle + t * (2 * t - 1) * f.end;
  }
  return chain;
}

double bulge(const CurvedFacet& f) { return norm(f.middle - 0.5 * (f.start + f.end)); }
bool is_bulging(const CurvedFacet& f) { return bulge(f) > straight * norm(f.end - f.start); }

bool crosses(const Chain& chain, Vec2 c, Vec2 d) {
  for (int i = 0; i < pieces; ++i)
    if (do_cross(chain[i], chain[i + 1], c, d)) return true;
  return false;
}

class CrowdedFacets {
 public:
  explicit CrowdedFacets(const std::vector<CurvedFacet>& facets) : facets_(facets) {
    for (const CurvedFacet& facet : facets) {
      sides_.push_back(side_of(facet));
      boxes_.emplace_back();
      for (const Vec2 p : sides_.back()) boxes_.back().add(p);
    }
  }

  std::vector<int> find() {
    // Of two that bulge alike the one farther right is divided.
    auto place = [&](int f) { return std::pair(boxes_[f].low.x, f); };
    for_meeting(boxes_, [&](int i, int j) {
      if (place(i) < place(j)) std::swap(i, j);
      judge(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
      return true;
    });
    return {found_.begin(), found_.end()};
  }

 private:
  void judge(std::size_t f, std::size_t g) {
    const CurvedFacet &one = facets_[f], &other = facets_[g];
    const bool bulges[2] = {is_bulging(one), is_bulging(other)};
    if (!bulges[0] && !bulges[1]) return;
    if (one.first == other.first || one.first == other.last || one.last == other.first || one.last == other.last)
      return;
    for (int i = 0; i < pieces; ++i)
      if (crosses(sides_[f], sides_[g][i], sides_[g][i + 1])) {
        found_.insert(static_cast<int>(bulge(one) >= bulge(other) ? f : g));
        return;
      }
    const bool is_other_crowded = bulges[1] && (crosses(sides_[f], other.start, other.end) || comes_near(one, other));
    const bool is_one_crowded = bulges[0] && (crosses(sides_[g], one.start, one.end) || comes_near(other, one));
    if ((!is_other_crowded && !is_one_crowded) || face_each_other(one, other)) return;
    if (is_other_crowded) found_.insert(static_cast<int>(g));
    if (is_one_crowded) found_.insert(static_cast<int>(f));
  }

  /// Whether a facet starts next to the chord of another one, and the gap there is that of the bulge.
  static bool comes_near(const CurvedFacet& one, const CurvedFacet& other) {
    constexpr double near = 0.4;  // of the bulge
    constexpr double end = 0.03;  // share of the chord that counts as its end
    const double share = nearest_share(one.start, other.start, other.end);
    const Vec2 foot = other.start + share * (other.end - other.start);
    return share > end && share < 1 - end && norm(one.start - foot) < near * bulge(other);
  }

  /// Whether the ends of each are the nearest nodes of the other's.
  bool face_each_other(const CurvedFacet& one, const CurvedFacet& other) const {
    auto are_nearest = [&](Vec2 p, int node, Vec2 q) {
      const double distance = norm(q - p);
      return std::ranges::none_of(
          facets_, [&](const CurvedFacet& facet) { return facet.first != node && norm(facet.start - p) < distance; });
    };
    return are_nearest(one.start, one.first, other.end) && are_nearest(one.end, one.last, other.start) &&
           are_nearest(other.start, other.first, one.end) && are_nearest(other.end, other.last, one.start);
  }

  const std::vector<CurvedFacet>& facets_;
  std::vector<Chain> sides_;
  std::vector<Box> boxes_;
  std::set<int> found_;
};

}  // namespace

std::vector<int> crowded_facets(const std::vector<CurvedFacet>& facets) { return CrowdedFacets(facets).find(); }

}  // namespace paver
