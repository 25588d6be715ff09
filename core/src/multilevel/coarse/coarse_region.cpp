// Loops are cut at their corners into sides; each side keeps as many nodes as its facets by the ratio, more where it
// turns. Fans about poles grow with the target length.
#include "multilevel/coarse/coarse_region.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace paver {
namespace {

constexpr double corner_turn = 0.4;    // radians at one node from which on it is a corner
constexpr double largest_turn = 1.05;  // radians between the ends of a coarse facet
constexpr int fewest_facets = 4;       // of a coarse loop
constexpr double leeway = 0.06;        // of the number of facets, for the sake of equal ones
constexpr double uneven_weight = 0.5;
constexpr double fan_room = 0.45;  // of the way to the nearest loop that a fan may take

struct Side {
  int first = 0, fine = 0, coarse = 0;
  int least = 1;  // coarse facets that its turn asks for
};

class Coarsener {
 public:
  Coarsener(const Region& region, int ratio) : region_(region), ratio_(ratio) { find_touching(); }

  std::optional<CoarseRegion> run() {
    copy_task();
    for (std::size_t l = 0; l < region_.loops.size(); ++l)
      if (!add_loop(l)) return std::nullopt;
    for (const Fan& fan : region_.fans) add_fan(fan);
    return std::move(result_);
  }

 private:
  void copy_task() {
    Region& coarse = result_.region;
    coarse = task_of(region_);
    coarse.size = region_.size.scaled(ratio_);
    coarse.h = ratio_ * region_.h;
  }

  // Nodes that the loops share or pass twice at one place in the chart.
  void find_touching() {
    std::map<int, std::vector<Vec2>> places;
    for (const auto& loop : region_.loops)
      for (const LoopNode& node : loop) places[node.global].push_back(node.p);
    for (const auto& loop : region_.loops) {
      std::vector<char>& touches = touches_.emplace_back();
      for (const LoopNode& node : loop) {
        const std::vector<Vec2>& all = places[node.global];
        auto is_here = [&](Vec2 p) { return norm(p - node.p) <= 1e-9 * (1 + norm(p)); };
        touches.push_back(std::count_if(all.begin(), all.end(), is_here) > 1);
      }
    }
  }

  double chord_turn(const std::vector<LoopNode>& loop, int i) const {
    const int n = static_cast<int>(loop.size());
    Vec3 here = loop[i % n].x, in = unit(here - loop[(i + n - 1) % n].x), out = unit(loop[(i + 1) % n].x - here);
    return std::acos(std::clamp(dot(in, out), -1.0, 1.0));
  }

  bool is_corner(std::size_t l, int i) const {
    const LoopNode& node = region_.loops[l][i];
    double turn = node.angle >= 0 ? std::fabs(node.angle - M_PI) : chord_turn(region_.loops[l], i);
    return turn > corner_turn || touches_[l][i];
  }

  std::vector<Side> sides_of(std::size_t l) const {
    const int n = static_cast<int>(region_.loops[l].size());
    std::vector<int> corners;
    for (int i = 0; i < n; ++i)
      if (is_corner(l, i)) corners.push_back(i);
    if (corners.empty()) corners.push_back(0);
    std::vector<Side> sides;
    for (std::size_t c = 0; c < corners.size(); ++c) {
      int next = c + 1 < corners.size() ? corners[c + 1] : corners[0] + n;
      sides.push_back({corners[c], next - corners[c]});
    }
    return sides;
  }

  // How badly a side falls into so many facets: they should be as long as wished, and equal.
  double misfit(const Side& side, int coarse) const {
    double each = static_cast<double>(side.fine) / coarse;
    return std::fabs(ratio_ / each - 1) + uneven_weight * std::fabs(each - std::round(each));
  }

  void choose_facets(const std::vector<LoopNode>& loop, Side& side) const {
    double turn = 0;
    for (int i = 1; i < side.fine; ++i) turn += chord_turn(loop, side.first + i);
    side.least = std::clamp(static_cast<int>(std::ceil(turn / largest_turn - 1e-6)), 1, side.fine);
    const double wish = static_cast<double>(side.fine) / ratio_;
    side.coarse = std::clamp(static_cast<int>(std::lround(wish)), side.least, side.fine);
    for (int m = static_cast<int>(wish * (1 - leeway)); m <= static_cast<int>(wish * (1 + leeway)); ++m)
      if (m >= side.least && m <= side.fine && misfit(side, m) < misfit(side, side.coarse)) side.coarse = m;
  }

  // One facet more, or less where that is enough, on the side that it suits best.
  bool change_one(std::vector<Side>& sides, bool may_take) const {
    Side* best = nullptr;
    int by = 0;
    double least = INFINITY;
    for (Side& s : sides)
      for (int change : {1, -1}) {
        int coarse = s.coarse + change;
        if (coarse < s.least || coarse > s.fine || (change < 0 && !may_take)) continue;
        double worse = misfit(s, coarse) - misfit(s, s.coarse);
        if (worse < least) least = worse, best = &s, by = change;
      }
    if (best) best->coarse += by;
    return best != nullptr;
  }

  // Facets of a side are equally long, so that opposite sides match and rows between them are even: in general a node
  // lies between two of the fine ones. It goes to one of them once the counts are known.
  static LoopNode coarse_node(const std::vector<LoopNode>& loop, const Side& side, int k) {
    const long all = static_cast<long>(side.fine) * k, rest = all % side.coarse;
    const std::size_t i = static_cast<std::size_t>(side.first + all / side.coarse);
    const LoopNode &before = loop[i % loop.size()], &after = loop[(i + 1) % loop.size()];
    LoopNode node = 2 * rest < side.coarse ? before : after;
    if (rest > 0) {
      const double t = static_cast<double>(rest) / side.coarse;
      node.p = (1 - t) * before.p + t * after.p;
      node.x = (1 - t) * before.x + t * after.x;
    }
    node.h *= static_cast<double>(side.fine) / side.coarse;
    return node;
  }

  bool add_loop(std::size_t l) {
    const std::vector<LoopNode>& fine = region_.loops[l];
    const int n = static_cast<int>(fine.size());
    std::vector<Side> sides = sides_of(l);
    for (Side& side : sides) choose_facets(fine, side);
    auto facets = [&] {
      int sum = 0;
      for (const Side& side : sides) sum += side.coarse;
      return sum;
    };
    while (facets() < fewest_facets || facets() % 2 != 0)
      if (!change_one(sides, facets() > fewest_facets)) return false;
    std::vector<LoopNode>& loop = result_.region.loops.emplace_back();
    std::vector<int>&at = result_.at.emplace_back(), &of_side = result_.side.emplace_back();
    for (const Side& side : sides) {
      for (int k = 0; k < side.coarse; ++k) {
        at.push_back(side.first + static_cast<int>((2L * side.fine * k + side.coarse) / (2L * side.coarse)));
        of_side.push_back(static_cast<int>(result_.side_intervals.size()));
        loop.push_back(coarse_node(fine, side, k));
      }
      result_.side_intervals.push_back(side.fine);
    }
    at.push_back(at.front() + n);
    return true;
  }

  // The ring moves away from the centre along (u, v), in which a pole's surroundings are even.
  void add_fan(const Fan& fan) {
    double reach = 0;
    for (const LoopNode& node : fan.ring) reach = std::max(reach, norm(node.x - fan.centre.x));
    const double room = nearest_node(region_, fan.centre.x);
    double factor = std::max(1.0, std::min<double>(ratio_, fan_room * room / reach));
    Fan coarse = fan;
    coarse.centre.h *= factor;
    for (LoopNode& node : coarse.ring) {
      const Vec2 near = region_.chart->uv(1e-6 * node.p), uv = near + factor * (region_.chart->uv(node.p) - near);
      node.p = region_.chart->to_chart(uv);
      node.x = region_.surface->point(uv);
      node.h *= factor;
    }
    result_.region.fans.push_back(std::move(coarse));
  }

  const Region& region_;
  const int ratio_;
  std::vector<std::vector<char>> touches_;
  CoarseRegion result_;
};

}  // namespace

std::optional<CoarseRegion> coarsen(const Region& region, int ratio) { return Coarsener(region, ratio).run(); }

}  // namespace paver
