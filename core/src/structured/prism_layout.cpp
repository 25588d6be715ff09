// A prism's sides on a face that goes round between two poles: other numbers of elements than a cube has.
// In: face. Out: its layout: n blocks about each pole between spokes of s_0, s_1, ... quads, and m rings between them.
// Steps: the n, s and m that come near the elements asked for, the most even ones first; of these the grid that,
// smoothed, has the least energy.
//
//            mid 1                 cap of n = 3: valence 3 at the pole and at the corners,
//      corner 0  \   corner 1      2 n blocks of s_i x m below it
//         \       |      /
//       mid 0 -- pole -- mid 2 ...
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "structured/closed_layout.h"

namespace paver {
namespace {

constexpr int fewest_sides = 3, most_sides = 5;
constexpr int most_spoke = 6;         // quads: from there on cubes have the numbers
constexpr double near_enough = 0.04;  // of the elements asked for
constexpr double farthest_off = 0.1;
constexpr double price_off = 10;  // against unevenness, and the energy of a grid
constexpr std::size_t most_tried = 4;
constexpr double most_uneven = 0.25;  // of the lengths
constexpr double most_turn = 1.6;     // radians across an element
constexpr double far_corner = 1.15;   // of a spoke's length, from the pole to a cap's corner
constexpr double spoke_price = 0.5;   // of the spokes' variance by their mean square

struct PrismCounts {
  std::vector<int> spokes;
  int rings = 0;
  double off_price = 0;  ///< of what is farther from the elements asked for than near enough

  int sum() const { return std::accumulate(spokes.begin(), spokes.end(), 0); }
  double quads() const {
    int cap = 0;
    for (std::size_t i = 0; i < spokes.size(); ++i) cap += spokes[i] * spokes[(i + 1) % spokes.size()];
    return 2.0 * cap + 2.0 * sum() * rings;
  }
};

/// Spokes that differ by one at most, the greater ones side by side or as evenly among the others as they go.
std::vector<std::vector<int>> ways_round(int sides, int least) {
  std::vector<std::vector<int>> ways;
  for (int greater = 0; greater < sides; ++greater) {
    std::vector<int> together, apart;
    for (int i = 0; i < sides; ++i) {
      together.push_back(least + (i < greater ? 1 : 0));
      apart.push_back(least + ((i + 1) * greater / sides - i * greater / sides));
    }
    ways.push_back(std::move(together));
    if (greater > 1 && greater < sides - 1) ways.push_back(std::move(apart));  // else they are the same, turned
  }
  return ways;
}

/// On the sphere a meridian along two spokes asks for half as many quads as the girth.
double unevenness(const PrismCounts& counts, double ratio) {
  const double mean = static_cast<double>(counts.sum()) / static_cast<double>(counts.spokes.size());
  double uneven = 0;
  for (int s : counts.spokes) {
    const double along = std::log((2 * s + counts.rings) / (ratio * counts.sum())), spoke = s / mean - 1;
    uneven += along * along + spoke_price * spoke * spoke;
  }
  return uneven / static_cast<double>(counts.spokes.size());
}

/// The most even ones that come near enough first.
std::vector<PrismCounts> choose_counts(const ClosedFace& face, double most_off) {
  const FaceExtent extent = measure_extent(face);
  const int least_round = static_cast<int>(std::ceil(2 * M_PI / face.turn_limit - 1e-9));
  std::vector<PrismCounts> found;
  for (int sides = fewest_sides; sides <= most_sides; ++sides)
    for (int least = 1; least <= most_spoke; ++least)
      for (const std::vector<int>& spokes : ways_round(sides, least)) {
        PrismCounts counts{spokes, 1, 0};
        for (; counts.quads() < (1 + most_off) * extent.elements; ++counts.rings) {
          const double off = std::fabs(counts.quads() / extent.elements - 1);
          if (off >= most_off || 2 * std::min(counts.sum(), 2 * least + counts.rings) < least_round) continue;
          counts.off_price = price_off * std::max(0.0, off - near_enough);
          found.push_back(counts);
        }
      }
  std::stable_sort(found.begin(), found.end(), [ratio = 2 * extent.tall / extent.girth](const auto& a, const auto& b) {
    return a.off_price + unevenness(a, ratio) < b.off_price + unevenness(b, ratio);
  });
  if (found.size() > most_tried) found.resize(most_tried);
  return found;
}

class Prism {
 public:
  Prism(const ClosedFace& face, const PrismCounts& counts)
      : face_(face), counts_(counts), sides_(static_cast<int>(counts.spokes.size())), meridian_(face) {
    int passed = 0;
    for (int i = 0; i < sides_; ++i) {
      mid_.push_back({static_cast<double>(passed) / (2 * counts.sum()), reach(spoke(i))});
      passed += spoke(i + 1);
      corner_.push_back({static_cast<double>(passed) / (2 * counts.sum()),
                         far_corner * 0.5 * (reach(spoke(i)) + reach(spoke(i + 1)))});
      passed += spoke(i);
    }
    layout_.period = face.periods();
    for (int i = 0; i < sides_; ++i) add_ring_blocks(i);
    for (bool is_high : {false, true}) add_cap(is_high);
  }

  bool is_possible() const {
    return std::all_of(layout_.blocks.begin(), layout_.blocks.end(), [](const Block& b) { return b.chart != nullptr; });
  }
  const BlockLayout& layout() const { return layout_; }

  /// Chart point where a grid starts.
  Vec2 place(std::size_t block, double s, double t) const {
    const int b = static_cast<int>(block), ring_blocks = 2 * sides_;
    const Vec2 at = b < ring_blocks ? on_ring(b / 2, b % 2, s, t)
                                    : on_cap((b - ring_blocks) % sides_, b >= ring_blocks + sides_, s, t);
    return layout_.blocks[block].chart->to_chart(meridian_.uv(at.x, at.y));
  }

 private:
  /// Where a node of a cap lies: turns about the axis, and share of a meridian from the pole.
  struct Reach {
    double turns = 0, share = 0;
    Vec2 flat() const { return share * Vec2{std::cos(2 * M_PI * turns), std::sin(2 * M_PI * turns)}; }
  };

  int spoke(int i) const { return counts_.spokes[i % sides_]; }
  double reach(int spoke) const { return static_cast<double>(spoke) / (2 * spoke + counts_.rings); }
  const Reach& mid(int i) const { return mid_[i % sides_]; }
  const Reach& corner(int i) const { return corner_[i]; }

  // Numbers of corners: the pole, the spokes' ends, the caps' corners.
  int pole_number(bool is_high) const { return is_high ? 2 * sides_ + 1 : 0; }
  int mid_number(int i, bool is_high) const { return pole_number(is_high) + 1 + i % sides_; }
  int corner_number(int i, bool is_high) const { return pole_number(is_high) + 1 + sides_ + i; }

  void add_ring_blocks(int i) {
    const int mid = mid_number(i, false), corner = corner_number(i, false), next = mid_number(i + 1, false);
    const int up = pole_number(true);
    const double from = this->mid(i).turns, to = this->corner(i).turns,
                 end = i + 1 < sides_ ? this->mid(i + 1).turns : 1;
    add_ring_block({mid, corner, up + corner, up + mid}, spoke(i + 1), from, to);
    add_ring_block({corner, next, up + next, up + corner}, spoke(i), to, end);
  }

  void add_ring_block(std::array<int, 4> corners, int across, double from, double to) {
    ParameterBox box = face_.box;
    box.low_pole = box.high_pole = false;
    box.lo.x = face_.box.lo.x + from * face_.period;
    box.hi.x = face_.box.lo.x + to * face_.period;
    layout_.blocks.push_back(
        {corners, {across, counts_.rings}, make_row_chart(face_.surface, box), face_.box.uv(0.5 * (box.lo + box.hi))});
  }

  void add_cap(bool is_high) {
    ParameterBox box = face_.box;
    (is_high ? box.low_pole : box.high_pole) = false;
    const std::shared_ptr<const Chart> chart = make_polar_chart(face_.surface, box, face_.period);
    for (int i = 0; i < sides_; ++i)
      layout_.blocks.push_back(
          {{pole_number(is_high), mid_number(i, is_high), corner_number(i, is_high), mid_number(i + 1, is_high)},
           {spoke(i), spoke(i + 1)},
           chart,
           {}});
  }

  // As turns and share of a meridian.
  Vec2 on_cap(int i, bool is_high, double s, double t) const {
    return turned(s * (1 - t) * mid(i).flat() + s * t * corner(i).flat() + (1 - s) * t * mid(i + 1).flat(), is_high);
  }

  static Vec2 turned(Vec2 flat, bool is_high) {
    const double turns = std::atan2(flat.y, flat.x) / (2 * M_PI), share = norm(flat);
    return {turns < -1e-12 ? turns + 1 : turns, is_high ? 1 - share : share};
  }

  Vec2 on_ring(int i, int half, double s, double t) const {
    const Vec2 a = half == 0 ? mid(i).flat() : corner(i).flat(), b = half == 0 ? corner(i).flat() : mid(i + 1).flat();
    Vec2 low = turned((1 - s) * a + s * b, false);
    if (half == 1 && i + 1 == sides_ && low.x < 0.25) low.x += 1;
    return {low.x, low.y + t * (1 - 2 * low.y)};
  }

  const ClosedFace& face_;
  const PrismCounts& counts_;
  const int sides_;
  const Meridian meridian_;
  std::vector<Reach> mid_, corner_;  // of the low cap
  BlockLayout layout_;
};

}  // namespace

std::shared_ptr<const ClosedLayout> lay_prism(const ClosedFace& face, double most_off, const Progress& progress) {
  std::shared_ptr<const ClosedLayout> best;
  double least = INFINITY;
  for (const PrismCounts& counts : choose_counts(face, std::min(most_off, farthest_off))) {
    const Prism prism(face, counts);
    if (!prism.is_possible()) continue;
    auto place = [&](std::size_t block, double s, double t) { return prism.place(block, s, t); };
    const BlockGrid grid = placed_grid(face, prism.layout(), place, most_placed, progress);
    const GridFigures figures = measure_grid(grid.grid());
    const double cost = figures.energy + counts.off_price;
    if (cost >= least || !is_good(figures, most_uneven, most_turn)) continue;
    if (auto layout = mapped(face, prism.layout(), grid, figures.turn)) best = std::move(layout), least = cost;
  }
  return best;
}

}  // namespace paver
