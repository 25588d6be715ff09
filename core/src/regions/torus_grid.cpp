// A grid without irregular nodes on a face that goes round both ways.
// In: face. Out: one patch.
// The nodes lie on a lattice of n x m places (i, j): all of them when rows run along the parameters, those with i + j
// even when they run diagonally. Steps: n and m of either kind from the area; both smoothed on a coarse lattice, the
// lower energy wins; finer lattices, each started from the displacements of the one before; the patch.
#include <algorithm>
#include <cmath>

#include "regions/closed_grid_parts.h"

namespace paver {
namespace {

constexpr int least_sweeps = 5;
constexpr int coarsest = 24;       // places along the shorter way where smoothing starts
constexpr int first_sweeps = 100;  // there: long waves settle
// Coefficient of variation of the lengths: paving reaches 0.15 on the fattest tube, with 4 % of irregular nodes.
constexpr double most_uneven = 0.25;

enum class Rows { along, diagonal };

struct Lattice {
  Rows rows = Rows::along;
  int n = 0, m = 0;
  bool has_node(int i, int j) const { return rows == Rows::along || (i + j) % 2 == 0; }
};

class TorusGrid {
 public:
  TorusGrid(const ClosedFace& face, const Lattice& lattice) : face_(face), lattice_(lattice) {
    grid_.charts = {make_plain_chart()};
  }

  GluedGrid& grid() { return grid_; }

  void start(const TorusGrid* coarse) {
    int n = lattice_.n, m = lattice_.m;
    for (int j = 0; j < m; ++j)
      for (int i = 0; i < n; ++i) {
        if (!lattice_.has_node(i, j)) continue;
        Vec2 shift = coarse ? coarse->shift_at(static_cast<double>(i) / n, static_cast<double>(j) / m) : Vec2{};
        grid_.add_node(0, box_uv(face_.box, regular(i, j) + shift), face_.surface, face_.size);
      }
    each_quad([&](const auto& places) {
      std::array<int, 4> v;
      for (std::size_t k = 0; k < 4; ++k) v[k] = node(places[k][0], places[k][1]);
      if (face_.box.is_swapped) std::swap(v[1], v[3]);
      grid_.mesh.add_element(v);
    });
  }

  std::shared_ptr<const ClosedGrid> patches() const {
    auto closed = std::make_shared<ClosedGrid>();
    closed->h = grid_.mesh.h;
    GridPatch& patch = closed->patches.emplace_back();
    // Not the row chart, whose rows of different lengths bend large elements.
    FaceExtent extent = measure_extent(face_);
    patch.chart = make_plain_chart(box_uv(face_.box, {extent.round / face_.period, extent.tall / face_.other_period}));
    std::vector<int> known(static_cast<std::size_t>(lattice_.n + 2) * (lattice_.m + 2), -1);  // from place (-1, -1) on
    each_quad([&](const auto& places) {
      std::array<int, 4> v;
      for (std::size_t k = 0; k < 4; ++k) {
        int& at = known[static_cast<std::size_t>(places[k][1] + 1) * (lattice_.n + 2) + places[k][0] + 1];
        v[k] = at < 0 ? static_cast<int>(patch.node.size()) : at;
        if (at >= 0) continue;
        at = v[k];
        patch.node.push_back(node(places[k][0], places[k][1]));
        patch.uv.push_back(box_uv(face_.box, unrolled(places[k][0], places[k][1])));
      }
      patch.quads.push_back(v);
    });
    return finish_patch(patch) ? closed : nullptr;
  }

 private:
  static int wrapped(int i, int n) { return (i % n + n) % n; }
  int node(int i, int j) const {
    int place = wrapped(j, lattice_.m) * lattice_.n + wrapped(i, lattice_.n);
    return lattice_.rows == Rows::along ? place : place / 2;
  }

  template <class Use>
  void each_quad(Use use) const {
    using Places = std::array<std::array<int, 2>, 4>;
    for (int j = 0; j < lattice_.m; ++j)
      for (int i = 0; i < lattice_.n; ++i) {
        if (lattice_.rows == Rows::along) {
          use(Places{{{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}});
        } else if ((i + j) % 2 != 0) {
          use(Places{{{i - 1, j}, {i, j - 1}, {i + 1, j}, {i, j + 1}}});
        }
      }
  }

  Vec2 regular(double i, double j) const {
    return {face_.box.lo.x + face_.period * i / lattice_.n, face_.box.lo.y + face_.other_period * j / lattice_.m};
  }

  // Place in the box of a node's copy at (i, j), whole periods from the node's own.
  Vec2 unrolled(int i, int j) const {
    Vec2 place = box_uv(face_.box, grid_.mesh.p[node(i, j)]), wish = regular(i, j);
    place.x += face_.period * std::round((wish.x - place.x) / face_.period);
    place.y += face_.other_period * std::round((wish.y - place.y) / face_.other_period);
    return place;
  }

  Vec2 shift(int i, int j) const {
    if (lattice_.has_node(i, j)) return unrolled(i, j) - regular(i, j);
    return 0.25 * (shift(i - 1, j) + shift(i + 1, j) + shift(i, j - 1) + shift(i, j + 1));
  }

  Vec2 shift_at(double s, double t) const {
    s *= lattice_.n, t *= lattice_.m;
    int i = static_cast<int>(s), j = static_cast<int>(t);
    s -= i, t -= j;
    return (1 - t) * ((1 - s) * shift(i, j) + s * shift(i + 1, j)) +
           t * ((1 - s) * shift(i, j + 1) + s * shift(i + 1, j + 1));
  }

  const ClosedFace& face_;
  Lattice lattice_;
  GluedGrid grid_;
};

// Diagonal rows need even numbers, for both ways to close.
int rounded(double wish, int step) { return step * static_cast<int>(std::lround(wish / step)); }

Lattice choose_lattice(const ClosedFace& face, Rows rows) {
  FaceExtent extent = measure_extent(face);
  int step = rows == Rows::along ? 1 : 2;
  double places = step * extent.elements;  // every other one has a node when rows run diagonally
  // An element that stands on its corner reaches further.
  double reach = rows == Rows::along ? 1 : M_SQRT2;
  int least = static_cast<int>(std::ceil(2 * M_PI * reach / face.turn_limit - 1e-9));
  least += least % 2;
  double exact = std::sqrt(places * extent.tall / extent.round);
  Lattice lattice{rows, 0, 0};
  // The shorter way first: the longer one, with its finer steps, makes up for the area.
  if (extent.tall < extent.round) {
    lattice.m = std::max(least, rounded(exact, step));
    lattice.n = std::max(least, rounded(places / lattice.m, step));
  } else {
    lattice.n = std::max(least, rounded(places / exact, step));
    lattice.m = std::max(least, rounded(places / lattice.n, step));
  }
  return lattice;
}

std::vector<Lattice> levels_of(Lattice lattice) {
  std::vector<Lattice> levels{lattice};
  while (std::min(levels.back().n, levels.back().m) > coarsest) {
    const Lattice& last = levels.back();
    levels.push_back({last.rows, (last.n + 3) / 4 * 2, (last.m + 3) / 4 * 2});
  }
  std::reverse(levels.begin(), levels.end());
  return levels;
}

}  // namespace

std::shared_ptr<const ClosedGrid> make_torus_grid(const ClosedFace& face, const Progress& progress) {
  std::unique_ptr<TorusGrid> grid;
  std::vector<Lattice> levels;
  double least = 0;
  for (Rows rows : {Rows::along, Rows::diagonal}) {
    std::vector<Lattice> candidates = levels_of(choose_lattice(face, rows));
    auto first = std::make_unique<TorusGrid>(face, candidates[0]);
    first->start(nullptr);
    smooth_grid(first->grid(), face.surface, face.size, first_sweeps, progress);
    double energy = measure_grid(first->grid()).energy;
    if (!grid || energy < least) grid = std::move(first), levels = candidates, least = energy;
  }
  for (std::size_t i = 1; i < levels.size(); ++i) {
    auto finer = std::make_unique<TorusGrid>(face, levels[i]);
    finer->start(grid.get());
    if (!is_smooth_enough(finer->grid()))
      smooth_grid(finer->grid(), face.surface, face.size, finer_sweeps(finer->grid(), least_sweeps), progress);
    grid = std::move(finer);
  }
  return is_good(measure_grid(grid->grid()), most_uneven, M_PI) ? grid->patches() : nullptr;
}

}  // namespace paver
