// Loops of a face: its edges in order, face to the left in (u, v).
// The kernel's explorer is tried first; where it loses edges or leaves gaps in (u, v) (it does at poles and periodic
// edges now and then), the edges are chained here: at each vertex the one whose image begins nearest.
#include <BRepTools_WireExplorer.hxx>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "base/box.h"
#include "base/predicates.h"
#include "brep/occt_shapes_impl.h"
#include "brep/surfaces/evaluators_impl.h"
#include "topology/build_parts_impl.h"

namespace paver {
namespace {

/// A gap in (u, v) above this share of the loop's extent is a jump, not inaccuracy.
constexpr double jump_share = 1e-3;
constexpr int area_samples = 16;  // per edge

using Chain = std::vector<Coedge>;

class LoopBuilder : CoedgeWalker {
 public:
  LoopBuilder(const TopoDS_Face& face, const Surface& surface, const EdgeIndex& index, const std::vector<Edge>& edges)
      : CoedgeWalker(edges), face_(face), surface_(surface), index_(index) {}

  LoopResult build() {
    for (const TopoDS_Wire& wire : wires_of(face_))
      if (result_.fault.empty()) add_wire(wire);
    if (result_.fault.empty() && result_.loops.empty())
      result_.fault = "it has no boundary; trim it in the CAD program";
    if (!result_.fault.empty()) {
      result_.loops.clear();
      return std::move(result_);
    }
    for (Loop& loop : result_.loops) fill_poles(loop.coedges);
    measure_gaps();
    turn_loops();
    if (!inner_.empty()) result_.skipped_edges += add_slits(surface_, edges_, inner_, result_.loops);
    return std::move(result_);
  }

 private:
  /// Nothing for edges that are not the model's; a fault for edges without curve or image.
  std::optional<Coedge> make_coedge(const TopoDS_Edge& shape) {
    Coedge c;
    c.edge = index_.find(shape);
    if (c.edge < 0) return std::nullopt;
    c.is_reversed = shape.Orientation() == TopAbs_REVERSED;
    c.pcurve = make_parameter_curve(shape, face_, edge(c).t0, edge(c).t1);
    if (!edge(c).is_degenerate && (!c.pcurve || !edge(c).curve))
      result_.fault = edge(c).name + " has no " + (c.pcurve ? "finite curve in space" : "curve in its surface") +
                      "; repair it in the CAD program";
    return c;
  }

  void add_wire(const TopoDS_Wire& wire) {
    Chain all;
    for (TopoDS_Iterator parts(wire); parts.More(); parts.Next()) {
      if (parts.Value().ShapeType() != TopAbs_EDGE) continue;
      const TopoDS_Edge& edge_shape = TopoDS::Edge(parts.Value());
      auto c = make_coedge(edge_shape);
      if (!result_.fault.empty()) return;
      if (c && is_bounding(edge_shape)) {
        all.push_back(std::move(*c));
      } else if (c && !edge(*c).is_degenerate) {
        inner_.push_back(std::move(*c));
      } else {
        ++result_.skipped_edges;
      }
    }
    if (all.empty()) return;
    Chain explored = explore(wire);
    bool is_good = explored.size() == all.size() && is_closed(explored);
    if (is_good && largest_gap(explored) <= jump_share * extent(explored)) {
      result_.loops.push_back({std::move(explored)});
      return;
    }
    auto chained = chain(std::move(all));
    auto is_better = [&](const Loop& loop) { return largest_gap(loop.coedges) < largest_gap(explored); };
    if (chained && (!is_good || std::ranges::all_of(*chained, is_better))) {
      std::ranges::move(*chained, std::back_inserter(result_.loops));
    } else if (is_good) {
      result_.loops.push_back({std::move(explored)});
    } else {
      result_.fault = "its boundary is open at " + open_name_ + "; repair it in the CAD program";
    }
  }

  Chain explore(const TopoDS_Wire& wire) {
    Chain result;
    for (BRepTools_WireExplorer explorer(wire, face_); explorer.More(); explorer.Next()) {
      if (!is_bounding(explorer.Current())) continue;
      if (auto c = make_coedge(explorer.Current())) result.push_back(std::move(*c));
    }
    return result;
  }

  bool is_closed(const Chain& chain) const {
    for (std::size_t i = 0; i < chain.size(); ++i)
      if (end(chain[i]) != start(chain[(i + 1) % chain.size()])) return false;
    return !chain.empty();
  }

  /// From the end of `a` to the start of `b` in (u, v); 0 where a pole has no image.
  double gap(const Coedge& a, const Coedge& b) const {
    return a.pcurve && b.pcurve ? norm(uv_at(b, 0) - uv_at(a, 1)) : 0;
  }

  double largest_gap(const Chain& chain) const {
    double worst = 0;
    for (std::size_t i = 0; i < chain.size(); ++i)
      worst = std::max(worst, gap(chain[i], chain[(i + 1) % chain.size()]));
    return worst;
  }

  std::vector<Vec2> polygon(const Chain& chain) const {
    std::vector<Vec2> points;
    for (const Coedge& c : chain) {
      for (int i = 0; c.pcurve && i < area_samples; ++i)
        points.push_back(uv_at(c, static_cast<double>(i) / area_samples));
    }
    return points;
  }

  /// Diagonal of the chain's box in (u, v).
  double extent(const Chain& chain) const {
    Box box;
    for (Vec2 p : polygon(chain)) box.add(p);
    return box.is_empty() ? 0 : norm(box.high - box.low);
  }

  /// Closed chains of all coedges of one wire; nothing when one stays open.
  std::optional<std::vector<Loop>> chain(Chain pool) {
    std::vector<Loop> loops;
    while (!pool.empty()) {
      Chain current{std::move(pool.front())};
      pool.erase(pool.begin());
      for (;;) {
        auto next = nearest(current.back(), pool);
        bool closes = end(current.back()) == start(current.front());
        if (closes && (next == pool.end() || gap(current.back(), current.front()) <= gap(current.back(), *next))) break;
        if (next == pool.end()) {
          open_name_ = edge(current.back()).name;
          return std::nullopt;
        }
        current.push_back(std::move(*next));
        pool.erase(next);
      }
      loops.push_back({std::move(current)});
    }
    return loops;
  }

  Chain::iterator nearest(const Coedge& from, Chain& pool) const {
    auto best = pool.end();
    for (auto c = pool.begin(); c != pool.end(); ++c) {
      if (start(*c) == end(from) && (best == pool.end() || gap(from, *c) < gap(from, *best))) best = c;
    }
    return best;
  }

  /// A pole without an image gets the straight line between its neighbours' images.
  void fill_poles(Chain& chain) const {
    for (std::size_t i = 0; i < chain.size(); ++i) {
      if (chain[i].pcurve) continue;
      const Coedge& before = chain[(i + chain.size() - 1) % chain.size()];
      const Coedge& after = chain[(i + 1) % chain.size()];
      if (!before.pcurve || !after.pcurve) continue;
      Vec2 a = uv_at(before, 1), b = uv_at(after, 0);
      if (chain[i].is_reversed) std::swap(a, b);
      chain[i].pcurve = make_straight_parameter_curve(a, b, edge(chain[i]).t0, edge(chain[i]).t1);
    }
    for (const Coedge& c : chain) {
      if (!c.pcurve) throw Error(ErrorCode::face_failed, edge(c).name + " has no curve in its surface");
    }
  }

  void measure_gaps() {
    for (const Loop& loop : result_.loops) {
      double size = extent(loop.coedges);
      if (size > 0) result_.largest_gap = std::max(result_.largest_gap, largest_gap(loop.coedges) / size);
    }
  }

  static double signed_area(const std::vector<Vec2>& polygon) {
    double area = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
      area += 0.5 * cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
    return area;
  }

  /// The largest loop must run counter-clockwise and those inside it clockwise. Surfaces that close on themselves are
  /// left alone: there a loop's area in (u, v) says nothing about its side.
  void turn_loops() {
    if (!(surface_.period() == Vec2{}) || result_.largest_gap > jump_share) return;
    std::vector<std::vector<Vec2>> polygons;
    std::vector<double> areas;
    for (const Loop& loop : result_.loops) {
      polygons.push_back(polygon(loop.coedges));
      areas.push_back(signed_area(polygons.back()));
    }
    auto larger = [&](std::size_t a, std::size_t b) { return std::abs(areas[a]) < std::abs(areas[b]); };
    std::size_t outer = 0;
    for (std::size_t i = 1; i < areas.size(); ++i)
      if (larger(outer, i)) outer = i;
    for (std::size_t i = 0; i < areas.size(); ++i) {
      bool is_wrong = i == outer ? areas[i] < 0 : areas[i] > 0 && is_inside(polygons[outer], polygons[i][0]);
      if (!is_wrong) continue;
      Chain& chain = result_.loops[i].coedges;
      std::reverse(chain.begin(), chain.end());
      for (Coedge& c : chain) c.is_reversed = !c.is_reversed;
      ++result_.turned_loops;
    }
  }

  const TopoDS_Face& face_;
  const Surface& surface_;
  const EdgeIndex& index_;
  LoopResult result_;
  std::string open_name_;
  std::vector<Coedge> inner_;  ///< inside the face
};

}  // namespace

LoopResult build_loops(const TopoDS_Face& face, const Surface& surface, const EdgeIndex& index,
                       const std::vector<Edge>& edges) {
  return LoopBuilder(face, surface, index, edges).build();
}

}  // namespace paver
