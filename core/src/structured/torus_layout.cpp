// Columns around a face that goes round both ways.
// In: face. Out: its layout. Places are (x, y): x = 0..1 once around the way whose lengths vary most, y = 0..1 along a
// column, by length, from where that way is longest.
// Where columns would be about equally wide everywhere: three blocks by three, no irregular node. Else k cells with
// more columns on the wider, outer side:
//
//        W--------------W'        inner: q columns
//       / \            / \        W: valence 5
//      / C \     H    / C'\       C: s x s, H: q x s
//     A     B--------A'    B'     V: valence 3
//      \ V / \        \ V'/
//       |||   |        |||        outer: L and R of s columns each, Q of q
//
// The columns of L turn right at V, cross H and turn down again in the next cell's R. The same upside down on the other
// side of the tube. Steps: the k whose whole numbers of columns come nearest to what both sides want; it and the plain
// layout are smoothed coarsely, and the lower energy wins.
#include <algorithm>
#include <cmath>

#include "base/cells.h"
#include "structured/closed_layout.h"

namespace paver {
namespace {

// Coefficient of variation of the lengths: paving reaches 0.07 to 0.13 on the fattest tubes.
constexpr double most_uneven = 0.15;
constexpr double dip_share = 0.3;                                  // of a cell's height
constexpr int fewest_cells = 3, most_cells = 12, usual_cells = 6;  // of usual ones the worst element is best
constexpr int profile_cells = 256;
constexpr double cell_price = 0.006;  // per cell more or less than usual, of the columns' misfit
constexpr double fewest_columns =
    0.5;                              // of those that the turn asks for, by the target length: below, it decides alone
constexpr long compared_quads = 600;  // of the grids whose energies are compared

/// Lengths of a closed face around each of its columns' places.
class Profile {
 public:
  explicit Profile(const ClosedFace& face) : face_(face) {
    const Lengths straight = measure(false), turned = measure(true);
    is_turned_ = spread(turned.width) > spread(straight.width);
    width_ = is_turned_ ? turned.width : straight.width;
    height_ = is_turned_ ? turned.height : straight.height;
    start_ = static_cast<std::size_t>(std::max_element(width_.begin(), width_.end()) - width_.begin());
    for (std::size_t i = 0; i <= profile_cells; ++i) arc_.push_back(i == 0 ? 0 : arc_.back() + height_[at(i - 1)]);
  }

  double length() const { return arc_.back(); }
  double greatest() const { return *std::max_element(width_.begin(), width_.end()); }
  double least() const { return *std::min_element(width_.begin(), width_.end()); }
  /// Mean length around between two places along.
  double mean(double from, double to) const {
    double sum = 0, all = 0;
    for (std::size_t i = 0; i < profile_cells; ++i) {
      const double y = 0.5 * (arc_[i] + arc_[i + 1]) / length();
      const bool is_between = from < to ? y > from && y < to : y > from || y < to;
      if (is_between) sum += width_[at(i)] * height_[at(i)], all += height_[at(i)];
    }
    return all > 0 ? sum / all : greatest();
  }
  /// The places on either side of y = 0 where the length around falls below `width`.
  std::pair<double, double> falls_below(double width) const {
    std::size_t up = 0, down = profile_cells;
    while (up < profile_cells && width_[at(up)] >= width) ++up;
    while (down > up && width_[at(down - 1)] >= width) --down;
    return {arc_[up] / length(), arc_[down] / length()};
  }
  Vec2 uv(Vec2 place) const {
    const double whole = std::floor(place.y), wish = (place.y - whole) * length();
    const std::size_t i = cell_of(arc_, wish);
    const double cell = (wish - arc_[i]) / (arc_[i + 1] - arc_[i]);
    const double along = (static_cast<double>(start_ + i) + cell) / profile_cells + whole;
    return uv_at({place.x, along}, is_turned_);
  }

 private:
  std::size_t at(std::size_t i) const { return (start_ + i) % profile_cells; }

  struct Lengths {
    std::vector<double> width, height;  // per cell along
  };

  static double spread(const std::vector<double>& width) {
    return *std::max_element(width.begin(), width.end()) / *std::min_element(width.begin(), width.end());
  }

  // At shares of the ways round; turned: the box's second one comes first.
  Vec2 uv_at(Vec2 share, bool is_turned) const {
    if (is_turned) std::swap(share.x, share.y);
    return face_.box.uv({face_.box.lo.x + share.x * face_.period, face_.box.lo.y + share.y * face_.other_period});
  }

  Lengths measure(bool is_turned) const {
    constexpr int across = 8;
    Lengths lengths{std::vector<double>(profile_cells, 0), std::vector<double>(profile_cells, 0)};
    for (int i = 0; i < profile_cells; ++i)
      for (int j = 0; j < across; ++j) {
        const Vec2 uv = uv_at({(j + 0.5) / across, (i + 0.5) / profile_cells}, is_turned);
        const auto [x, a, b] = face_.surface.slope(uv);
        double round = norm(face_.box.is_swapped ? b : a) * face_.period;
        double along = norm(face_.box.is_swapped ? a : b) * face_.other_period;
        if (is_turned) std::swap(round, along);
        lengths.width[i] += round / across, lengths.height[i] += along / profile_cells / across;
      }
    return lengths;
  }

  const ClosedFace& face_;
  bool is_turned_ = false;
  std::size_t start_ = 0;
  std::vector<double> width_, height_;  // per cell along
  std::vector<double> arc_;             // before each cell from the start on
};

/// A layout and where its blocks start: places of their corners.
struct Candidate {
  BlockLayout layout;
  std::vector<std::array<Vec2, 4>> corners;
};

class Columns {
 public:
  Columns(const ClosedFace& face, const Profile& profile, double elements, double scale_round, double scale_along)
      : face_(face),
        profile_(profile),
        elements_(elements),
        chart_(make_plain_chart(face.box.uv({scale_round, scale_along}))) {
    h_ = std::sqrt(profile.mean(0, 1) * profile.length() / elements);
    least_ = static_cast<int>(std::ceil(2 * M_PI / face.turn_limit - 1e-9));
  }

  /// Whether the shorter way is so few target lengths long that neither even lengths nor paving are to be had.
  bool is_thin() const {
    return std::min(profile_.mean(0, 1), profile_.length()) < fewest_columns * least_ * face_.size.own();
  }

  /// Columns that are the same all along.
  Candidate plain() const {
    constexpr int parts = 3;
    Candidate result;
    const double h = is_thin() ? face_.size.own() : h_;
    int m = std::max(least_, round_to(profile_.mean(0, 1) / h)), n = std::max(least_, round_to(profile_.length() / h));
    if (!is_thin()) {  // the longer way has the finer steps
      if (m < n)
        n = std::max(least_, round_to(elements_ / m));
      else
        m = std::max(least_, round_to(elements_ / n));
    }
    auto cut = [](int count, int part) { return count * part / parts; };
    for (int j = 0; j < parts; ++j)
      for (int i = 0; i < parts; ++i) {
        auto corner = [&](int a, int b) { return b % parts * parts + a % parts; };
        auto place = [&](int a, int b) {
          return Vec2{static_cast<double>(cut(m, a)) / m, static_cast<double>(cut(n, b)) / n};
        };
        add(result, {corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)},
            {cut(m, i + 1) - cut(m, i), cut(n, j + 1) - cut(n, j)},
            {place(i, j), place(i + 1, j), place(i + 1, j + 1), place(i, j + 1)});
      }
    return finished(std::move(result));
  }

  /// More columns on the outer side; nothing where there are too few elements for them.
  std::optional<Candidate> graded() const {
    const auto [up, down] = profile_.falls_below(0.5 * (profile_.greatest() + profile_.least()));
    const double outer = profile_.mean(down, up) / h_, inner = profile_.mean(up, down) / h_;
    const double rows = profile_.length() / h_, share = up + 1 - down;  // of the rows that are on the outer side
    std::optional<Counts> best;
    for (int cells = fewest_cells; cells <= most_cells; ++cells) {
      Counts counts{cells, round_to((outer - inner) / (2 * cells)), round_to(inner / cells)};
      counts.o = round_to(share * rows - counts.s);
      if (counts.s < 1 || counts.q < 1 || counts.o < 1) continue;
      const long fixed = (2L * counts.s + counts.q) * counts.o + 2L * counts.s * (counts.s + counts.q);
      counts.i = round_to((elements_ / cells - static_cast<double>(fixed)) / counts.q);
      if (counts.i < 1 || counts.q * cells < least_ || counts.rows() < least_) continue;
      counts.misfit =
          std::max(std::fabs((2 * counts.s + counts.q) * cells / outer - 1), std::fabs(counts.q * cells / inner - 1)) +
          cell_price * std::abs(cells - usual_cells);
      if (!best || counts.misfit < best->misfit) best = counts;
    }
    if (!best) return std::nullopt;
    return finished(cells_of(*best, 0.5 * (up + down - 1), share));
  }

  /// Chart point of a candidate's start.
  Vec2 place(const Candidate& candidate, std::size_t block, double s, double t) const {
    const auto& c = candidate.corners[block];
    return chart_->to_chart(profile_.uv((1 - t) * ((1 - s) * c[0] + s * c[1]) + t * ((1 - s) * c[3] + s * c[2])));
  }

 private:
  struct Counts {
    int cells = 0, s = 0, q = 0, o = 0, i = 0;  // o, i: rows of the outer and the inner side
    double misfit = 0;
    int rows() const { return o + 2 * s + i; }
  };

  static int round_to(double wish) { return static_cast<int>(std::lround(wish)); }

  void add(Candidate& result, std::array<int, 4> corner, std::array<int, 2> count, std::array<Vec2, 4> places) const {
    result.layout.blocks.push_back({corner, count, chart_, {}});
    result.corners.push_back(places);
  }

  Candidate finished(Candidate result) const {
    result.layout.period = face_.periods();
    for (std::size_t b = 0; b < result.corners.size(); ++b) {
      Vec2 middle{0, 0};
      for (Vec2 corner : result.corners[b]) middle = middle + 0.25 * corner;
      result.layout.blocks[b].middle = profile_.uv(middle);
    }
    return result;
  }

  // Corners of a cell on either side of the tube: V, A, B, W. `middle`: of the outer side along; it takes `share`.
  Candidate cells_of(const Counts& counts, double middle, double share) const {
    enum { v, a, b, w, corners };
    const int cells = counts.cells, s = counts.s, q = counts.q, o = counts.o, i = counts.i;
    Candidate result;
    const double height = static_cast<double>(s) / counts.rows(), dip = dip_share * height;
    auto number = [&](int cell, bool is_up, int corner) { return (cell % cells * 2 + is_up) * corners + corner; };
    auto place = [&](int cell, bool is_up, int corner) {
      const double turn = corner == a ? 0 : corner == b ? 2 * s : s;
      const double reach = 0.5 * share - 0.5 * height + (corner == v ? -dip : corner == w ? height : 0);
      return Vec2{(cell + turn / (2 * s + q)) / cells, middle + (is_up ? reach : -reach)};
    };
    struct At {
      int cell;
      bool is_up;
      int corner;
      double around = 0;
    };
    auto quad = [&](std::array<At, 4> at, std::array<int, 2> count) {
      std::array<int, 4> corner{};
      std::array<Vec2, 4> places;
      for (std::size_t k = 0; k < 4; ++k) {
        corner[k] = number(at[k].cell, at[k].is_up, at[k].corner);
        places[k] = place(at[k].cell, at[k].is_up, at[k].corner) + Vec2{0, at[k].around};
      }
      add(result, corner, count, places);
    };
    for (int c = 0; c < cells; ++c) {
      quad({At{c, false, a}, {c, false, v}, {c, true, v}, {c, true, a}}, {s, o});
      quad({At{c, false, v}, {c, false, b}, {c, true, b}, {c, true, v}}, {s, o});
      quad({At{c, false, b}, {c + 1, false, a}, {c + 1, true, a}, {c, true, b}}, {q, o});
      for (bool is_up : {false, true}) {
        quad({At{c, is_up, v}, {c, is_up, b}, {c, is_up, w}, {c, is_up, a}}, {s, s});
        quad({At{c, is_up, b}, {c + 1, is_up, a}, {c + 1, is_up, w}, {c, is_up, w}}, {q, s});
      }
      quad({At{c, true, w}, {c + 1, true, w}, {c + 1, false, w, 1}, {c, false, w, 1}}, {q, i});
    }
    return result;
  }

  const ClosedFace& face_;
  const Profile& profile_;
  const double elements_;
  const std::shared_ptr<const Chart> chart_;
  double h_ = 1;
  int least_ = 1;
};

}  // namespace

std::shared_ptr<const ClosedLayout> lay_torus(const ClosedFace& face, const Progress& progress) {
  const Profile profile(face);
  const FaceExtent extent = measure_extent(face);
  const Columns columns(face, profile, extent.elements, extent.round / face.period, extent.tall / face.other_period);
  Candidate best = columns.plain();
  auto place = [&](std::size_t b, double s, double t) { return columns.place(best, b, s, t); };
  if (columns.is_thin())
    return mapped(face, best.layout, BlockGrid(best.layout, best.layout, face.surface, face.size, place), 0);
  auto energy = [&] {
    return measure_grid(placed_grid(face, best.layout, place, compared_quads, progress).grid()).energy;
  };
  if (std::optional<Candidate> graded = columns.graded()) {
    const double of_plain = energy();
    std::swap(best, *graded);
    if (energy() >= of_plain) std::swap(best, *graded);
  }
  const BlockGrid grid = placed_grid(face, best.layout, place, most_placed, progress);
  const GridFigures figures = measure_grid(grid.grid());
  return is_good(figures, most_uneven, M_PI) ? mapped(face, best.layout, grid, figures.turn) : nullptr;
}

}  // namespace paver
