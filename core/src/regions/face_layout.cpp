// Chooses a chart per face. In: model. Out: layouts.
// A face goes round when it uses an edge twice with a period between the two images. Polar charts need one direction
// of going round; a second one (torus) stays as a cut. Two poles need a cut between them that meets no other loop.
// A face without any border gets a structured layout where one fits.
#include "regions/face_layout.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "boundary/region_loops.h"
#include "charts/pole.h"

namespace paver {
namespace {

constexpr int edge_samples = 16;      // per edge, of the parameters that a face takes
constexpr double widest_point = 3.4;  // radians, at a pole: a little more than half a turn
constexpr double least_cut = 0.1;     // of the box's height: a gap that is wide enough to cut a closed face there

struct Range {
  double lo = 1e300, hi = -1e300;
  void add(double v) { lo = std::min(lo, v), hi = std::max(hi, v); }
  double size() const { return hi - lo; }
};

Vec2 image(const Model& model, const Coedge& c, double share) {
  const Edge& e = edge_of(model, c);
  return c.pcurve->uv(e.t0 + share * (e.t1 - e.t0));
}

/// What a face takes of a parameter, and how that closes.
struct ParameterRange : Range {
  bool wraps = false, low_pole = false, high_pole = false;
  bool has_pole() const { return low_pole || high_pole; }
};

class LayoutPlanner {
 public:
  LayoutPlanner(const Model& model, const SizeField& size, int face, ClosedLayouts closed, const Progress& progress)
      : model_(model), face_(model.faces[face]), index_(face), size_(size), closed_(closed), progress_(progress) {
    layout_.dropped = own_periodic_coedges(model, face);
    periodic_ = periodic_coedges(model, face);
  }

  FaceLayout run() {
    measure();
    find_poles();
    const bool goes_round = u_.wraps || v_.wraps;
    const bool is_swapped = goes_round ? !u_.wraps : u_.has_pole() && !v_.has_pole();
    const ParameterRange &along = is_swapped ? v_ : u_, &across = is_swapped ? u_ : v_;
    layout_.box = {{along.lo, across.lo}, {along.hi, across.hi}, is_swapped, across.low_pole, across.high_pole};
    Vec2 period = face_.surface->period();
    layout_.period = is_swapped ? period.y : period.x;
    if (goes_round && layout_.period > 0 && !lay_closed()) choose_polar();
    if (!goes_round && is_wide_sector()) layout_.kind = LayoutKind::sector;
    if (layout_.kind == LayoutKind::row || layout_.kind == LayoutKind::sector) {
      for (auto& loop : layout_.dropped) loop.assign(loop.size(), false);
    } else if (layout_.kind == LayoutKind::polar || layout_.kind == LayoutKind::two_polar) {
      settle_periodic(u_.wraps && v_.wraps);
    }
    return layout_;
  }

 private:
  void measure() {
    Vec2 period = face_.surface->period();
    for (std::size_t l = 0; l < face_.loops.size(); ++l)
      for (std::size_t c = 0; c < face_.loops[l].coedges.size(); ++c) {
        const Coedge& coedge = face_.loops[l].coedges[c];
        for (int i = 0; i <= edge_samples; ++i) {
          Vec2 uv = image(model_, coedge, i / double{edge_samples});
          u_.add(uv.x), v_.add(uv.y);
        }
        if (!periodic_[l][c]) continue;
        Vec2 gap = gap_to_twin(coedge);
        if (period.x > 0 && std::fabs(gap.x) > 0.25 * period.x) u_.wraps = true;
        if (period.y > 0 && std::fabs(gap.y) > 0.25 * period.y) v_.wraps = true;
      }
  }

  Vec2 gap_to_twin(const Coedge& coedge) const {
    for (const Coedge& other : coedges_of(face_.loops))
      if (other.edge == coedge.edge && &other != &coedge) return image(model_, other, 0.5) - image(model_, coedge, 0.5);
    return {};
  }

  /// Of a side that is one point the image may be divided, where edges inside the face end in it, or a part, where the
  /// border of a face that goes round leads through it.
  void find_poles() {
    constexpr double half = 0.5, any = 1e-3;  // of a side: shorter ones are just a point
    std::array<double, 2> u_share{}, v_share{};
    for (const Coedge& c : coedges_of(face_.loops)) {
      if (!edge_of(model_, c).is_degenerate) continue;
      Vec2 a = image(model_, c, 0), b = image(model_, c, 1);
      double du = std::fabs(b.x - a.x) / std::max(u_.size(), 1e-300);
      double dv = std::fabs(b.y - a.y) / std::max(v_.size(), 1e-300);
      bool along_u = du > dv;
      double at = along_u ? 0.5 * (a.y + b.y) : 0.5 * (a.x + b.x);
      const Range& range = along_u ? v_ : u_;
      bool is_low = at - range.lo < range.hi - at;
      (along_u ? v_share : u_share)[is_low ? 0 : 1] += std::max(du, dv);
    }
    const double least = u_.wraps || v_.wraps ? any : half;
    u_.low_pole = u_share[0] >= least, u_.high_pole = u_share[1] >= least;
    v_.low_pole = v_share[0] >= least, v_.high_pole = v_share[1] >= least;
  }

  // A face without border: all its edges are its own periodic ones or poles.
  bool lay_closed() {
    if (size_.faces[index_].is_graded() || size_.faces[index_].turn_weight() > 0) return false;  // not one length
    if (!face_.points.empty()) return false;
    if (!linked_loops(model_, index_, layout_.dropped).empty()) return false;
    for (const Coedge& c : coedges_of(face_.loops))
      for (int user : edge_of(model_, c).faces)
        if (user != index_) return false;
    const ParameterBox& box = layout_.box;
    Vec2 period = face_.surface->period();
    // Damaged images lie anywhere.
    constexpr double most_periods = 1.5;
    if (box.hi.x - box.lo.x > most_periods * layout_.period) return false;
    ClosedFace face{*face_.surface, size_.faces[index_], box, layout_.period, 0, size_.turn_limit};
    if (box.low_pole && box.high_pole) {
      for (bool is_low : {true, false})
        if (measure_pole(*face_.surface, box, layout_.period, is_low).is_sharp()) return false;
      lay([&] { return lay_cube(face, progress_); });
    } else if (u_.wraps && v_.wraps && !box.low_pole && !box.high_pole) {
      face.other_period = box.is_swapped ? period.x : period.y;
      if (box.hi.y - box.lo.y > most_periods * face.other_period) return false;
      lay([&] { return lay_torus(face, progress_); });
    }
    return layout_.kind == LayoutKind::closed;
  }

  template <class Make>
  void lay(Make make) {
    if (closed_ == ClosedLayouts::made) layout_.closed = make();
    if (layout_.closed || closed_ == ClosedLayouts::assumed) layout_.kind = LayoutKind::closed;
  }

  void choose_polar() {
    if (layout_.box.low_pole && layout_.box.high_pole) {
      if (!find_cut()) return;
      const auto [low, high] = layout_.box.halves(layout_.cut);
      if (make_polar_chart(*face_.surface, low, layout_.period) &&
          make_polar_chart(*face_.surface, high, layout_.period))
        layout_.kind = LayoutKind::two_polar;
    } else if (!is_long_bent_tube() && !comes_to_point() &&
               make_polar_chart(*face_.surface, layout_.box, layout_.period)) {
      layout_.kind = LayoutKind::polar;
    }
  }

  // At the apex of a cone that its border leads through: rows side by side end there as at any corner, while a polar
  // chart spreads it to so much of a whole turn that nodes between two nearby sides of it come to lie on these.
  bool comes_to_point() const {
    const ParameterBox& box = layout_.box;
    if (box.low_pole == box.high_pole) return false;
    double way = 0;
    bool is_on_border = false;
    for (std::size_t l = 0; l < face_.loops.size(); ++l)
      for (const Coedge& c : face_.loops[l].coedges) {
        if (!edge_of(model_, c).is_degenerate) continue;
        way += std::fabs(box.uv(image(model_, c, 1) - image(model_, c, 0)).x);
        is_on_border = is_on_border || has_only_border_at(edge_of(model_, c).start);
      }
    if (!is_on_border) return false;
    const PoleShape pole = measure_pole(*face_.surface, box, layout_.period, box.low_pole);
    return pole.is_sharp() && way / layout_.period * pole.cone_angle < widest_point;
  }

  // A periodic edge that ends there would divide the point.
  bool has_only_border_at(int vertex) const {
    bool is_on_border = false;
    for (std::size_t l = 0; l < face_.loops.size(); ++l)
      for (std::size_t c = 0; c < face_.loops[l].coedges.size(); ++c) {
        const Edge& edge = edge_of(model_, face_.loops[l].coedges[c]);
        if (edge.is_degenerate || (edge.start != vertex && edge.end != vertex)) continue;
        if (layout_.dropped[l][c]) return false;
        is_on_border = true;
      }
    return is_on_border;
  }

  // Rows side by side come to a point of less than half a turn at the pole.
  bool is_wide_sector() const {
    constexpr double most_share = 0.999;  // of the period
    const ParameterBox& box = layout_.box;
    if (!(layout_.period > 0) || box.low_pole == box.high_pole) return false;
    const double share = (box.hi.x - box.lo.x) / layout_.period;
    return share <= most_share &&
           share * measure_pole(*face_.surface, box, layout_.period, box.low_pole).cone_angle >= widest_point &&
           make_polar_chart(*face_.surface, box, layout_.period) != nullptr;
  }

  // Rings about it would tilt bend by bend; with its seam as a cut it is a grid along the axis.
  bool is_long_bent_tube() const {
    constexpr double longest = 4;             // in circumferences
    constexpr double bent = 45 * M_PI / 180;  // of the axis, in all
    constexpr int cells = 16, across = 8;
    const ParameterBox& box = layout_.box;
    if (box.low_pole || box.high_pole || face_.loops.size() > 1 || !face_.points.empty()) return false;
    const MeridianTable table(*face_.surface, box, cells);
    double rounds = 0, turn = 0;
    Vec3 last_centre, last_way;
    for (int i = 0; i <= cells; ++i) {
      Vec3 centre;
      for (int j = 0; j < across; ++j) {
        const double u = box.lo.x + layout_.period * j / across, v = table.lo() + i * table.step();
        centre += (1.0 / across) * face_.surface->point(box.uv({u, v}));
      }
      const Vec3 way = i > 0 ? unit(centre - last_centre) : Vec3{};
      if (i > 1) turn += std::acos(std::clamp(dot(way, last_way), -1.0, 1.0));
      if (i > 0)
        rounds += table.step() * table.height(i - 1) / (0.5 * (table.width(i - 1) + table.width(i)) * layout_.period);
      last_centre = centre, last_way = way;
    }
    return rounds > longest && turn > bent;
  }

  // The widest stretch of the meridian that no other loop or point reaches into, cut in its middle.
  bool find_cut() {
    const ParameterBox& box = layout_.box;
    std::vector<std::pair<double, double>> taken{{box.lo.y, box.lo.y}, {box.hi.y, box.hi.y}};
    for (std::size_t l = 0; l < face_.loops.size(); ++l)
      for (std::size_t c = 0; c < face_.loops[l].coedges.size(); ++c) {
        const Coedge& coedge = face_.loops[l].coedges[c];
        if (layout_.dropped[l][c] || edge_of(model_, coedge).is_degenerate) continue;
        Range r;
        for (int i = 0; i <= edge_samples; ++i) r.add(box.uv(image(model_, coedge, i / double{edge_samples})).y);
        taken.push_back({r.lo, r.hi});
      }
    for (const InnerPoint& point : face_.points) {
      const double at = box.uv(point.uv).y;
      taken.push_back({at, at});
    }
    std::sort(taken.begin(), taken.end());
    double reach = box.lo.y, best = 0;
    for (auto [lo, hi] : taken) {
      if (lo - reach > best) best = lo - reach, layout_.cut = 0.5 * (lo + reach);
      reach = std::max(reach, hi);
    }
    return best > least_cut * (box.hi.y - box.lo.y);
  }

  // A torus goes round twice: what wraps the second direction stays as a cut. What others have stays as a slit.
  void settle_periodic(bool goes_round_twice) {
    for (std::size_t l = 0; l < face_.loops.size(); ++l)
      for (std::size_t c = 0; c < face_.loops[l].coedges.size(); ++c) {
        if (!periodic_[l][c]) continue;
        const Coedge& coedge = face_.loops[l].coedges[c];
        if (goes_round_twice && !is_along_round(coedge)) {
          layout_.dropped[l][c] = false;
        } else if (!layout_.dropped[l][c]) {
          layout_.slits.push_back(coedge.edge);
        }
      }
  }

  bool is_along_round(const Coedge& coedge) const {
    Vec2 period = face_.surface->period(), gap = gap_to_twin(coedge);
    return layout_.box.is_swapped ? std::fabs(gap.y) > 0.25 * period.y : std::fabs(gap.x) > 0.25 * period.x;
  }

  const Model& model_;
  const Face& face_;
  int index_;
  const SizeField& size_;
  const ClosedLayouts closed_;
  const Progress& progress_;
  FaceLayout layout_;
  std::vector<std::vector<bool>> periodic_;  // per loop and coedge
  ParameterRange u_, v_;
};

}  // namespace

std::vector<FaceLayout> plan_layouts(const Model& model, const SizeField& size, ClosedLayouts closed,
                                     const Progress& progress) {
  std::vector<FaceLayout> layouts(model.faces.size());
  for (std::size_t f = 0; f < model.faces.size(); ++f)
    if (model.faces[f].is_meshed())
      layouts[f] = LayoutPlanner(model, size, static_cast<int>(f), closed, progress).run();
  return layouts;
}

namespace {

/// An edge alone inside a face: a slit of one interval has no node to open it at.
bool is_lone_slit(const Loop& loop) {
  return loop.coedges.size() == 2 && loop.coedges[0].is_slit && loop.coedges[0].edge == loop.coedges[1].edge;
}

}  // namespace

void settle_counts(const Model& model, const std::vector<FaceLayout>& layouts, std::vector<int>& counts) {
  std::vector<bool> is_needed(model.edges.size(), false), is_cut(model.edges.size(), false);
  std::vector<int> least(model.edges.size(), 0);
  for (const FaceLayout& layout : layouts)
    for (int e : layout.slits) least[e] = 2;
  for (std::size_t f = 0; f < model.faces.size(); ++f)
    for (std::size_t l = 0; l < layouts[f].dropped.size(); ++l) {
      const Loop& loop = model.faces[f].loops[l];
      if (is_lone_slit(loop)) least[loop.coedges[0].edge] = 2;
      for (std::size_t c = 0; c < layouts[f].dropped[l].size(); ++c) {
        if (layouts[f].dropped[l][c]) continue;
        const int e = loop.coedges[c].edge;
        is_needed[e] = true;
        if (model.edges[e].is_periodic) is_cut[e] = true;
      }
    }
  for (std::size_t e = 0; e < counts.size(); ++e) {
    if (!is_needed[e] && !model.edges[e].is_wire()) counts[e] = 0;
    counts[e] = std::max(counts[e], least[e]);
    if (is_cut[e] && model.edges[e].start == model.edges[e].end) counts[e] += counts[e] % 2;
  }
}

}  // namespace paver
