// In: banks of a face, limits. Out: places.
// Steps: per bank that bends those near it; least distances between points of the one and the other, made exact.
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "base/search/golden_section.h"
#include "sizing/gaps/gap_places.h"

namespace paver {
namespace {

constexpr double nearest_neck = 0.02;    // target lengths: in wider ones nodes need not face each other
constexpr double shortest_piece = 0.05;  // the same, or of an edge

class Necks {
 public:
  Necks(const FaceBanks& faced, const MergeLimits& limits) : faced_(faced), limits_(limits) {}

  /// Banks that a bent one may come nearest to, of those that are as bent the ones behind it.
  std::set<int> beside(int b) const {
    const Bank& bank = faced_[b];
    std::set<int> others;
    if (bank.is_straight()) return others;
    const double reach =
        std::min(nearest_neck * limits_.length(bank.edge), faced_.edge(bank).length / (2 * gap_slenderness));
    for (std::size_t i = 0; i + 1 < bank.points.size(); ++i)
      for (const int o : faced_.meeting(FaceBanks::box_of(bank, i).grown(reach)))
        if ((o > b || faced_[o].is_straight()) && !faced_.meet(bank, faced_[o])) others.insert(o);
    return others;
  }

  /// Where two banks that bend away from each other are nearest, places on both.
  void add_necks(const Bank& bank, const Bank& other, std::vector<GapPlace>& found) const {
    std::vector<double> away;
    for (const Vec3 x : bank.points) away.push_back(faced_.foot_on(other, x).distance);
    for (std::size_t k = 1; k + 1 < away.size(); ++k) {
      if (away[k] > away[k - 1] || away[k] >= away[k + 1]) continue;
      const double h = std::min(limits_.length(bank.edge), limits_.length(other.edge));
      const double around =
          std::max(norm(bank.points[k] - bank.points[k - 1]), norm(bank.points[k + 1] - bank.points[k]));
      if (away[k] > nearest_neck * h + around + bank.bulge) continue;
      const double t = nearest_parameter(bank, other, bank.t[k - 1], bank.t[k + 1]);
      const Vec3 x = faced_.edge(bank).curve->point(t);
      const BankFoot there = faced_.foot_on(other, x), here = faced_.foot_on(bank, x);
      const double shorter = std::min(faced_.edge(bank).length, faced_.edge(other).length),
                   piece = std::max(gap_slenderness * there.distance, shortest_piece * std::min(h, shorter));
      if (there.distance >= nearest_neck * h ||
          std::min({here.before, here.behind, there.before, there.behind}) < piece || !faces(bank, t, other, there.t) ||
          !widens(bank, here, other, there, h))
        continue;
      found.push_back({bank.edge, t, here.before, here.behind, there.distance, piece});
      found.push_back({other.edge, there.t, there.before, there.behind, there.distance, piece});
    }
  }

 private:
  /// Between two parameters.
  double nearest_parameter(const Bank& bank, const Bank& other, double low, double high) const {
    constexpr int rounds = 40;
    const Curve& curve = *faced_.edge(bank).curve;
    const auto away = [&](double t) { return faced_.foot_on(other, curve.point(t)).distance; };
    return golden_section(low, high, rounds, away).middle();
  }

  /// Whether the face lies between two places.
  bool faces(const Bank& bank, double t, const Bank& other, double at) const {
    const Vec3 across = unit(faced_.edge(other).curve->point(at) - faced_.edge(bank).curve->point(t));
    return dot(across, unit(faced_.inward(bank, t))) > straight_across &&
           -dot(across, unit(faced_.inward(other, at))) > straight_across;
  }

  /// Whether the banks are clearly farther apart some way before and behind.
  bool widens(const Bank& bank, const BankFoot& here, const Bank& other, const BankFoot& there, double way) const {
    const Edge& edge = faced_.edge(bank);
    return std::ranges::all_of(std::array{-1.0, 1.0}, [&](double side) {
      const double share = std::clamp((here.before + side * way) / edge.length, 0.0, 1.0);
      return faced_.foot_on(other, edge.curve->point(edge.parameter(share))).distance > most_widening * there.distance;
    });
  }

  const FaceBanks& faced_;
  const MergeLimits& limits_;
};

}  // namespace

void find_necks(const FaceBanks& banks, const MergeLimits& limits, std::vector<GapPlace>& found) {
  const Necks necks(banks, limits);
  for (int b = 0; b < banks.size(); ++b)
    for (const int other : necks.beside(b)) necks.add_necks(banks[b], banks[other], found);
}

}  // namespace paver
