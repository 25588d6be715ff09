// Builds the regions of each face from its layout.
#include "regions/build_regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <unordered_map>

#include "base/cells.h"
#include "boundary/region_loops.h"
#include "charts/pole.h"
#include "regions/crossing_facets.h"
#include "topology/end_direction.h"

namespace paver {
namespace {

constexpr double end_share = 2e-3;  // of half an interval: as near to its end tangents are taken
constexpr double small = 0.01;      // of an interval: as far from a node its angle in the chart is measured
constexpr double fan_radius = 0.8;  // of the target length: the quads about an apex
constexpr double fan_room = 0.45, point_room = 0.4;  // of the distance to the nearest loop, about an apex and a point
constexpr double dip = 0.6;  // per radian of half a quad about an apex: its outer corner lies so far behind the line
constexpr int fewest_quads = 4;       // about an apex: three lie twice as far off the surface
constexpr double beside_pole = 1e-3;  // of the sides about it
constexpr double least_side = 0.3;    // of the fan's radius, or of the target length
constexpr double most_about = 0.2;    // of the way round a rod: half of the four quads about a point on it
constexpr double fold = 0.26;         // radians (15 degrees): an edge that turns back by all but this is folded

class RegionBuilder {
 public:
  RegionBuilder(const Model& model, const SizeField& size, const FaceLayout& layout, int face, EdgeNodes& nodes)
      : model_(model), face_(model.faces[face]), size_(size), layout_(layout), nodes_(nodes), index_(face) {
    for (const Coedge& coedge : coedges_of(face_.loops))
      if (const Edge& edge = edge_of(model_, coedge); edge.is_degenerate) poles_.push_back(edge.start);
  }

  void run(std::vector<Region>& regions) {
    if (layout_.kind == LayoutKind::closed) {
      add_fills(regions);
      return;
    }
    std::vector<Loop> loops = linked_loops(model_, index_, layout_.dropped);
    if (layout_.kind == LayoutKind::two_polar) {
      build_halves(loops, regions);
      return;
    }
    Region region = make_region();
    const bool is_polar = layout_.kind == LayoutKind::polar;
    region.goes_round = is_polar;
    region.own_area = face_.area;
    region.chart = layout_.kind == LayoutKind::row ? make_row_chart(*region.surface, layout_.box)
                                                   : make_polar_chart(*region.surface, layout_.box, layout_.period);
    Slits slits;
    for (const Loop& loop : loops) add_loop(loop, region, slits);
    settle_loops(slits, region);
    if (is_polar && (layout_.box.low_pole || layout_.box.high_pole))
      add_fan(layout_.box, !face_.points.empty(), region);
    for (const InnerPoint& point : face_.points) add_point(point, region);
    regions.push_back(std::move(region));
  }

 private:
  Region make_region() const {
    Region region;
    region.face = index_;
    region.surface = face_.surface->clone();
    region.size = size_.faces[index_];
    region.h = size_.face_h[index_];
    region.area = face_.area;
    region.gradation = size_.gradation;
    region.turn_limit = size_.turn_limit;
    return region;
  }

  static constexpr double near = 1e-3;           // of a facet: images of edges at one vertex
  using Slits = std::vector<std::vector<char>>;  // per loop and facet: whether it is on a slit

  void add_loop(const Loop& loop, Region& region, Slits& slits) const {
    std::vector<LoopNode> out;
    std::vector<char> is_slit;
    const Coedge* before = &loop.coedges.back();
    for (const Coedge& c : loop.coedges) {
      const EdgeDivision& d = nodes_.edges[c.edge];
      int n = d.intervals();
      for (int i = 0; i < n; ++i) {
        int k = c.is_reversed ? n - i : i;
        LoopNode node;
        node.global = d.node[k];
        node.edge = c.edge;
        const Place place = place_at(c.pcurve->uv(d.t[2 * k]));
        node.p = region.chart->to_chart(place.uv);
        node.x = nodes_.nodes[node.global];
        node.h = target_at(c, d.t[2 * k], place, nodes_.node_target[node.global]);
        node.angle = i == 0 ? angle_at(*before, c, place) : angle_inside(c, k, place);
        if (i > 0 && (node.angle < fold || node.angle > 2 * M_PI - fold)) node.angle = chart_angle(c, k, region);
        if (i == 0 && before->edge == c.edge && before->is_reversed != c.is_reversed && !c.is_slit)
          node.angle = chart_angle(*before, c, region);
        if (i == 0 && is_at_pole(c))
          if (const double share = share_of_apex(); share > 0) node.angle = share * chart_angle(*before, c, region);
        out.push_back(node);
        is_slit.push_back(c.is_slit || std::ranges::find(layout_.slits, c.edge) != layout_.slits.end());
      }
      if (n > 0) before = &c;
    }
    if (out.empty()) return;
    region.loops.push_back(std::move(out));
    slits.push_back(std::move(is_slit));
  }

  static void settle_loops(const Slits& slits, Region& region) {
    unite_places(slits, region.loops);
    for (std::size_t l = 0; l < slits.size(); ++l) open_slits(slits[l], region.loops[l]);
    choose_sides(slits, region.loops);
  }

  // Loops, and parts of one, that meet at a vertex have it at one place: their edges' images end near each other only,
  // which is enough for them to cross there. Slits begin where the others meet.
  static void unite_places(const Slits& is_slit, std::vector<std::vector<LoopNode>>& loops) {
    std::unordered_map<int, std::vector<Vec2>> places;
    for (bool slits : {false, true}) {
      for (std::size_t l = 0; l < loops.size(); ++l) {
        for (std::size_t i = 0; i < loops[l].size(); ++i) {
          if (static_cast<bool>(is_slit[l][i]) != slits) continue;
          LoopNode& node = loops[l][i];
          const double facet = shorter_facet(loops[l], i);
          std::vector<Vec2>& known = places[node.global];
          auto is_near = [&](Vec2 place) { return norm(place - node.p) < near * facet; };
          if (auto at = std::find_if(known.begin(), known.end(), is_near); at != known.end())
            node.p = *at;
          else
            known.push_back(node.p);
        }
      }
    }
  }

  // The two sides of a slit lie on one line: nodes on them are moved apart in the chart, by so little that it is no
  // matter, so that the loop is simple there. They stay where they are in space.
  static void open_slits(const std::vector<char>& is_slit, std::vector<LoopNode>& loop) {
    constexpr double opening = 1e-6;  // of a facet
    const std::size_t count = loop.size();
    std::vector<Vec2> moved;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t last = (i + count - 1) % count, next = (i + 1) % count;
      moved.push_back(loop[i].p);
      if (!is_slit[i] && !is_slit[last]) continue;
      if (loop[next].global == loop[last].global && is_slit[i] && is_slit[last]) {
        loop[i].angle = 2 * M_PI;  // the slit's end
        continue;
      }
      Vec2 ahead = loop[next].p - loop[i].p, back = loop[last].p - loop[i].p;
      double angle = std::atan2(cross(ahead, back), dot(ahead, back));
      if (angle <= 0) angle += 2 * M_PI;
      double reach = opening * std::min(norm(ahead), norm(back)) / norm(ahead);
      double c = std::cos(0.5 * angle), s = std::sin(0.5 * angle);
      moved.back() = loop[i].p + reach * Vec2{c * ahead.x - s * ahead.y, s * ahead.x + c * ahead.y};
    }
    for (std::size_t i = 0; i < count; ++i) loop[i].p = moved[i];
  }

  // Counter-clockwise, from 0 to 2 pi.
  static double turn(Vec2 from, Vec2 to) {
    const double angle = std::atan2(cross(from, to), dot(from, to));
    return angle < 0 ? angle + 2 * M_PI : angle;
  }

  // A loop that meets a slit on its way has the vertex on the side where it lies.
  static void choose_sides(const Slits& is_slit, std::vector<std::vector<LoopNode>>& loops) {
    struct Side {
      Vec2 place, ahead;
      double angle;  // of the sector that begins there
    };
    std::unordered_map<int, std::vector<Side>> sides;
    auto visit = [&](bool slits, auto&& look) {
      for (std::size_t l = 0; l < is_slit.size(); ++l)
        for (std::size_t i = 0, n = loops[l].size(); i < n; ++i) {
          const std::size_t last = (i + n - 1) % n;
          if (static_cast<bool>(is_slit[l][i]) == slits && static_cast<bool>(is_slit[l][last]) == slits)
            look(loops[l][i], loops[l][(i + 1) % n].p - loops[l][i].p, loops[l][last].p - loops[l][i].p);
        }
    };
    visit(true, [&](const LoopNode& node, Vec2 ahead, Vec2 back) {
      sides[node.global].push_back({node.p, ahead, turn(ahead, back)});
    });
    if (sides.empty()) return;
    visit(false, [&](LoopNode& node, Vec2 ahead, Vec2 back) {
      auto found = sides.find(node.global);
      if (found == sides.end()) return;
      const double facet = std::min(norm(ahead), norm(back));
      for (const Side& side : found->second)
        if (norm(side.place - node.p) < near * facet && turn(side.ahead, ahead) < side.angle) node.p = side.place;
    });
  }

  struct Place {
    Vec2 uv;
    Vec3 normal;
    bool has_normal = false;
  };

  Place place_at(Vec2 uv) const {
    const auto [x, xu, xv] = face_.surface->slope(uv);
    const Vec3 normal = cross(xu, xv);
    constexpr double degenerate = 1e-6;  // sine between the derivatives
    constexpr double collapsed = 1e-9;   // of the other derivative: rounding, at a pole
    const bool is_pole = std::min(norm(xu), norm(xv)) <= collapsed * std::max(norm(xu), norm(xv));
    return {uv, normal, !is_pole && norm(normal) > degenerate * norm(xu) * norm(xv)};
  }

  double target_at(Vec2 uv) const { return std::min(size_.h, size_.faces[index_].at(uv, *face_.surface)); }

  // An edge is divided finely where it turns. Where it turns within the face (a small hole in a plate) the face follows
  // with small elements; where it only turns with the face (the rim of a tube, a leading edge) long ones do.
  double target_at(const Coedge& coedge, double t, const Place& place, double edge_target) const {
    const CurveJet at = edge_of(model_, coedge).curve->jet(t);
    Vec3 tangent = unit(at.t), bend = at.tt - dot(at.tt, tangent) * tangent;
    double within = std::fabs(dot(bend, unit(cross(unit(place.normal), tangent)))) / dot(at.t, at.t);
    double target = target_at(place.uv);
    if (!(within * target > size_.turn_limit)) return std::isfinite(within) ? target : std::min(target, edge_target);
    return std::min(target, std::max(edge_target, size_.turn_limit_of(edge_of(model_, coedge)).longest_edge(within)));
  }

  // Direction of travel on a coedge at an end of interval i of its division, just inside it.
  Vec3 travel(const Coedge& c, int i, bool at_end) const {
    const EdgeDivision& d = nodes_.edges[c.edge];
    const int end = 2 * i + (at_end ? 2 : 0), middle = 2 * i + 1;
    const double inside = 0.5 * (d.t[2 * i] + d.t[2 * i + 2]);
    const Vec3 way =
        end_direction(*edge_of(model_, c).curve, d.t[end], inside, unit(d.x[middle] - d.x[end]), end_share);
    return at_end != c.is_reversed ? -1 * way : way;
  }

  static double interior_angle(Vec3 in, Vec3 out, const Place& place) {
    Vec3 back = -1 * in;
    if (!place.has_normal || !(norm(in) > 0) || !(norm(out) > 0)) return -1;
    double angle = std::atan2(dot(unit(place.normal), cross(out, back)), dot(out, back));
    return angle < 0 ? angle + 2 * M_PI : angle;
  }

  bool is_at_pole(const Coedge& c) const {
    return std::ranges::find(poles_, start_of(edge_of(model_, c), c)) != poles_.end();
  }

  /// The surface about the apex of a cone, of a whole turn; 0 where the chart does not go round one.
  double share_of_apex() const {
    const bool goes_round = layout_.kind == LayoutKind::polar || layout_.kind == LayoutKind::sector;
    if (!goes_round || layout_.box.low_pole == layout_.box.high_pole) return 0;
    const PoleShape shape = measure_pole(*face_.surface, layout_.box, layout_.period, layout_.box.low_pole);
    return shape.slant > 0 && shape.is_sharp() ? shape.cone_angle / (2 * M_PI) : 0;
  }

  double angle_at(const Coedge& before, const Coedge& c, const Place& place) const {
    int last = nodes_.edges[before.edge].intervals() - 1, n = nodes_.edges[c.edge].intervals();
    // Tiny rims that became poles have a normal, which tells nothing.
    if (last < 0 || is_at_pole(c)) return -1;
    Vec3 in = travel(before, before.is_reversed ? 0 : last, !before.is_reversed);
    Vec3 out = travel(c, c.is_reversed ? n - 1 : 0, c.is_reversed);
    return interior_angle(in, out, place);
  }

  double angle_inside(const Coedge& c, int k, const Place& place) const {
    Vec3 low = travel(c, k - 1, true), high = travel(c, k, false);
    return interior_angle(c.is_reversed ? high : low, c.is_reversed ? low : high, place);
  }

  // Where an edge folds back on itself in space (the flattened end of a body) only the chart tells the angle.
  double chart_angle(const Coedge& c, int k, const Region& region) const {
    const EdgeDivision& d = nodes_.edges[c.edge];
    auto chart = [&](double t) { return region.chart->to_chart(c.pcurve->uv(t)); };
    double t = d.t[2 * k];
    Vec2 p = chart(t), low = chart(t + small * (d.t[2 * k - 2] - t)), high = chart(t + small * (d.t[2 * k + 2] - t));
    return turn((c.is_reversed ? low : high) - p, (c.is_reversed ? high : low) - p);
  }

  // The same at the vertex between two edges.
  double chart_angle(const Coedge& before, const Coedge& c, const Region& region) const {
    auto chart = [&](const Coedge& use, double t) { return region.chart->to_chart(use.pcurve->uv(t)); };
    auto beside = [&](const Coedge& use, bool at_end) {
      const EdgeDivision& d = nodes_.edges[use.edge];
      const bool is_last = at_end != use.is_reversed;
      const std::size_t end = is_last ? d.t.size() - 1 : 0, next = is_last ? end - 2 : 2;
      return chart(use, d.t[end] + small * (d.t[next] - d.t[end]));
    };
    const Vec2 p = chart(c, nodes_.edges[c.edge].t[c.is_reversed ? nodes_.edges[c.edge].t.size() - 1 : 0]);
    return turn(beside(before, true) - p, beside(c, false) - p);
  }

  double meridian_of(const Loop& loop) const {
    const Coedge& c = loop.coedges.front();
    const Edge& e = edge_of(model_, c);
    return layout_.box.uv(c.pcurve->uv(0.5 * (e.t0 + e.t1))).y;
  }

  // Parts of its blocks, so many that they are tasks for many ranks. Nodes on cuts are shared.
  void add_fills(std::vector<Region>& regions) {
    constexpr double part_quads = 8192;
    const ClosedLayout& closed = *layout_.closed;
    const BlockNumbers numbers(closed.layout);
    std::unordered_map<int, std::pair<int, Vec2>> known;  // by number in the layout: node and (u, v)
    for (std::size_t b = 0; b < closed.blocks.size(); ++b)
      for (const MappedFill& fill : divided(closed.blocks[b], part_quads)) {
        Region region = make_region();
        region.chart = closed.blocks[b]->chart;
        region.fill = fill;
        std::vector<LoopNode>& loop = region.loops.emplace_back();
        for (const auto& [i, j] : fill.outline()) {
          auto [at, is_new] = known.insert({numbers.node(b, i, j), {}});
          auto& [node, uv] = at->second;
          if (is_new) {
            uv = region.chart->uv(fill.block->place(i, j));
            node = nodes_.add(face_.surface->point(uv), -1, region.size.at(uv, *face_.surface));
          }
          const Vec2 here = nearest_image(uv, closed.layout.blocks[b].middle, closed.layout.period);
          loop.push_back({node, -1, region.chart->to_chart(here), nodes_.nodes[node], nodes_.node_target[node], -1});
        }
        regions.push_back(std::move(region));
      }
  }

  // Two regions with a common artificial loop of fixed nodes.
  void build_halves(const std::vector<Loop>& loops, std::vector<Region>& regions) {
    const std::array<ParameterBox, 2> boxes = layout_.box.halves(layout_.cut);
    std::array<Region, 2> halves{make_region(), make_region()};
    std::array<Slits, 2> slits;
    for (std::size_t k : {0, 1}) {
      halves[k].goes_round = true;
      halves[k].chart = make_polar_chart(*halves[k].surface, boxes[k], layout_.period);
    }
    if (loops.empty()) {
      const double of_low = area_of(boxes[0]), of_high = area_of(boxes[1]);
      halves[0].own_area = face_.area * of_low / (of_low + of_high);
      halves[1].own_area = face_.area - halves[0].own_area;
    }
    auto half_at = [&](double meridian) { return meridian < layout_.cut ? 0U : 1U; };
    auto half_of = [&](const InnerPoint& point) { return half_at(layout_.box.uv(point.uv).y); };
    auto is_in_half = [&](std::size_t k) { return [&, k](const InnerPoint& point) { return half_of(point) == k; }; };
    for (const Loop& loop : loops) {
      const std::size_t k = half_at(meridian_of(loop));
      add_loop(loop, halves[k], slits[k]);
    }
    std::vector<LoopNode> ring = cut_nodes();
    for (std::size_t k : {0, 1}) {
      settle_loops(slits[k], halves[k]);
      for (std::size_t i = 0; i < ring.size(); ++i) ring[i].p = halves[k].chart->to_chart(uv_[i]);
      // The ring runs along the period: it has the high side on its left unless the box is swapped.
      const bool is_forward = (k == 1) != layout_.box.is_swapped;
      halves[k].loops.push_back(is_forward ? ring : std::vector<LoopNode>(ring.rbegin(), ring.rend()));
      add_fan(boxes[k], std::ranges::any_of(face_.points, is_in_half(k)), halves[k]);
    }
    for (const InnerPoint& point : face_.points) add_point(point, halves[half_of(point)]);
    std::ranges::move(halves, std::back_inserter(regions));
  }

  /// How far to go along the meridian from a pole for a way of length `reach`; `guess` as if it went on as it starts.
  double meridian_step(double along, double pole, double guess, double reach) const {
    constexpr int chords = 16, most_tries = 8;
    constexpr double near_enough = 0.02, most_change = 4;
    double step = std::fabs(guess);
    for (int i = 0; i < most_tries; ++i) {
      double length = 0;
      Vec3 last = face_.surface->point(layout_.box.uv({along, pole}));
      for (int k = 1; k <= chords; ++k) {
        const Vec3 x = face_.surface->point(layout_.box.uv({along, pole + std::copysign(step, guess) * k / chords}));
        length += norm(x - last), last = x;
      }
      if (std::fabs(length - reach) <= near_enough * reach) break;
      step *= std::clamp(reach / length, 1 / most_change, most_change);
    }
    return step;
  }

  double area_of(const ParameterBox& box) const {
    constexpr int across = 32, along = 64;
    const Vec2 step{(box.hi.x - box.lo.x) / across, (box.hi.y - box.lo.y) / along};
    double sum = 0;
    for (int i = 0; i < across; ++i)
      for (int j = 0; j < along; ++j) {
        const Vec2 uv = box.uv({box.lo.x + (i + 0.5) * step.x, box.lo.y + (j + 0.5) * step.y});
        const auto [x, xu, xv] = face_.surface->slope(uv);
        sum += norm(cross(xu, xv)) * step.x * step.y;
      }
    return sum;
  }

  std::vector<LoopNode> cut_nodes() {
    constexpr int samples = 256;
    std::vector<double> weight{0};  // up to each sample
    double turn = 0;
    Vec3 last, last_tangent, last_normal;
    for (int i = 0; i <= samples; ++i) {
      Vec2 uv = layout_.box.uv({layout_.box.lo.x + layout_.period * i / samples, layout_.cut});
      const auto [x, xu, xv] = face_.surface->slope(uv);
      const Vec3 tangent = unit(layout_.box.is_swapped ? xv : xu);
      const NormalTable* normals = size_.faces[index_].normals();
      const Vec3 normal = normals ? normals->at(uv) : Vec3{};
      if (i > 0) {
        const double step = norm(x - last), turned = size_.faces[index_].turn_weight() * norm(normal - last_normal);
        const double facets = step / target_at(uv);
        weight.push_back(weight.back() + std::sqrt(facets * facets + turned * turned));
        turn += std::acos(std::clamp(dot(tangent, last_tangent), -1.0, 1.0));
      }
      last = x, last_tangent = tangent, last_normal = normal;
    }
    int n = std::max(
        {4, static_cast<int>(std::lround(weight.back())), static_cast<int>(std::ceil(turn / size_.turn_limit - 1e-9))});
    n = 4 * ((n + 3) / 4);
    std::vector<LoopNode> ring;
    for (int i = 0; i < n; ++i) {
      const double turns = share_of(weight, weight.back() * i / n);
      uv_.push_back(layout_.box.uv({layout_.box.lo.x + layout_.period * turns, layout_.cut}));
      LoopNode node;
      node.x = face_.surface->point(uv_.back());
      node.h = target_at(uv_.back());
      node.angle = M_PI;
      node.global = nodes_.add(node.x, -1, node.h);
      ring.push_back(node);
    }
    return ring;
  }

  // An apex must be a node: quads about it in advance, as many as the surface's angle there asks for. The same for a
  // smooth pole where the rows have nowhere else to start, as they have about points.
  void add_fan(const ParameterBox& box, bool has_points, Region& region) {
    PoleShape shape = measure_pole(*region.surface, box, layout_.period, box.low_pole);
    if (!(shape.slant > 0) || (!shape.is_sharp() && (has_points || !is_bag(region)))) return;
    if (leads_through(shape.apex, region)) return;
    double pole = box.low_pole ? box.lo.y : box.hi.y, inward = box.low_pole ? 1 : -1;
    double per_length = shape.small / shape.slant;  // meridian parameter per mm at the pole
    double room = nearest_node(region, shape.apex);
    double h = size_.faces[index_].given_at(shape.apex), radius = std::min(fan_radius * h, fan_room * room);
    auto at = [&](double share, double reach) {
      const double along = box.lo.x + layout_.period * share;
      return layout_.box.uv({along, pole + inward * meridian_step(along, pole, inward * per_length * reach, reach)});
    };
    // Two sides of each within the limit of turn.
    const std::vector<double> turned = turns_about([&](double share) { return at(share, radius); });
    const int quads = std::max(fewest_quads, static_cast<int>(std::lround(0.5 * turned.back())));
    Fan fan;
    fan.is_apex = shape.is_sharp();
    fan.centre.x = shape.apex;
    fan.centre.h = std::min(h, radius);
    fan.centre.p = {0, 0};
    const int vertex = pole_vertex(shape.apex);
    fan.centre.global = vertex >= 0 ? node_at(vertex, fan.centre.h) : nodes_.add(shape.apex, -1, fan.centre.h);
    constexpr double farthest = 1.4, least_cosine = 0.7;  // of the corners between a fan's spokes
    double half = shape.cone_angle / (2 * quads);
    for (int i = 0; i < 2 * quads; ++i) {
      const double reach =
          radius *
          (i % 2 ? std::min(farthest, std::max(1 / std::max(least_cosine, std::cos(half)), 1 + dip * half)) : 1.0);
      LoopNode node;
      const double share = static_cast<double>(i) / (2 * quads);
      const Vec2 uv = at(turned.back() > 0 ? share_of(turned, share * turned.back()) : share, reach);
      node.p = region.chart->to_chart(uv);
      node.x = region.surface->point(uv);
      node.h = std::min(h, std::max(radius * 2 * half, least_side * radius));
      fan.ring.push_back(node);
    }
    double area = 0;
    for (std::size_t i = 0; i < fan.ring.size(); ++i)
      area += cross(fan.ring[i].p, fan.ring[(i + 1) % fan.ring.size()].p);
    if (area < 0) std::reverse(fan.ring.begin() + 1, fan.ring.end());
    region.fans.push_back(std::move(fan));
  }

  /// Whether a loop has the pole on its way. In space, as images end near it only, and charts of slim cones are as
  /// small about a good part of it.
  static bool leads_through(Vec3 pole, const Region& region) {
    return std::ranges::any_of(region.loops, [&](const std::vector<LoopNode>& loop) {
      for (std::size_t i = 0; i < loop.size(); ++i)
        if (norm(loop[i].x - pole) < near * norm(loop[(i + 1) % loop.size()].x - loop[i].x)) return true;
      return false;
    });
  }

  /// Turns in limits of turn, added up at equal steps about a pole; `place` gives (u, v) by the share of the way
  /// round.
  template <class Place>
  std::vector<double> turns_about(const Place& place) const {
    constexpr int steps = 64;
    const NormalTable* normals = size_.faces[index_].normals();
    auto normal = [&](double share) {
      return normals ? normals->at(place(share)) : face_.surface->normal(place(share));
    };
    std::vector<double> turned{0};
    Vec3 last = normal(0);
    for (int i = 1; i <= steps; ++i) {
      const Vec3 here = normal(i / double{steps});
      turned.push_back(turned.back() + norm(here - last) / size_.turn_limit);
      last = here;
    }
    return turned;
  }

  /// The share of the way where the sum is `wanted`.
  static double share_of(const std::vector<double>& sums, double wanted) {
    const std::size_t i = cell_of(sums, wanted);
    const double steps = static_cast<double>(sums.size() - 1), step = sums[i + 1] - sums[i];
    return (static_cast<double>(i) + (step > 0 ? std::min(1.0, (wanted - sums[i]) / step) : 0)) / steps;
  }

  // A node inside the face, a point or the end of a wire: four quads about it in advance.
  void add_point(const InnerPoint& point, Region& region) {
    constexpr int quads = 4;
    Fan fan;
    fan.centre.p = region.chart->to_chart(point.uv);
    fan.centre.h = target_at(point.uv);
    fan.centre.global = node_at(point.vertex, fan.centre.h);
    auto is_same = [&](const LoopNode& node) { return node.global == fan.centre.global; };
    if (std::ranges::any_of(region.fans, is_same, &Fan::centre)) return;  // an apex
    for (const auto& loop : region.loops)
      if (std::ranges::any_of(loop, is_same)) return;  // on a periodic edge that stays as a cut
    fan.centre.x = nodes_.nodes[fan.centre.global];
    double room = nearest_facet(region, fan.centre.x);
    for (const InnerPoint& other : face_.points)
      if (other.vertex != point.vertex) room = std::min(room, 0.5 * norm(model_.vertices[other.vertex] - fan.centre.x));
    for (const Fan& other : region.fans)
      for (const LoopNode& node : other.ring) room = std::min(room, norm(node.x - fan.centre.x));
    double side = std::min(fan.centre.h, point_room * room);
    side = std::min(side, most_about * way_round(*face_.surface, point.uv, side));
    SurfaceSlope at = region.slope(fan.centre.p);
    // The kernel gives surfaces of revolution no slope along their circles within 1e-7 of the axis.
    if (!(norm(cross(at.u, at.v)) > 0)) at = region.slope(fan.centre.p + Vec2{beside_pole * side / norm(at.u), 0});
    Vec3 across = unit(at.u), up = unit(cross(cross(at.u, at.v), at.u));
    for (int i = 0; i < 2 * quads; ++i) {
      double angle = M_PI * i / quads, reach = i % 2 ? M_SQRT2 * side : side;
      Vec3 way = reach * (std::cos(angle) * across + std::sin(angle) * up);
      LoopNode node;
      Vec2 step;
      pull_back(at.u, at.v, way, step);
      node.p = region.chart->walk(fan.centre.p, step);
      node.x = region.point(node.p);
      node.h = std::max(side, least_side * fan.centre.h);
      fan.ring.push_back(node);
    }
    region.fans.push_back(std::move(fan));
  }

  int node_at(int vertex, double h) {
    int& known = nodes_.node_of_vertex[vertex];
    if (known < 0) known = nodes_.add(model_.vertices[vertex], -1, h);
    return known;
  }

  /// The vertex of the face's pole next to `apex`, or -1.
  int pole_vertex(Vec3 apex) const {
    const auto distance = [&](int vertex) { return norm(model_.vertices[vertex] - apex); };
    return poles_.empty() ? -1 : std::ranges::min(poles_, {}, distance);
  }

  // A long body closed by a pole, with a rim of few nodes: rows need something to start from.
  static bool is_bag(const Region& region) {
    std::size_t nodes = 0;
    for (const auto& loop : region.loops) nodes += loop.size();
    return nodes <= 8 && region.area > 20 * region.h * region.h;
  }

  const Model& model_;
  const Face& face_;
  const SizeField& size_;
  const FaceLayout& layout_;
  EdgeNodes& nodes_;
  int index_;
  std::vector<int> poles_;  // vertices
  std::vector<Vec2> uv_;
};

}  // namespace

std::vector<Region> build_regions(const Model& model, const SizeField& size, const std::vector<FaceLayout>& layouts,
                                  EdgeNodes& nodes) {
  std::vector<Region> regions;
  for (std::size_t f = 0; f < model.faces.size(); ++f)
    if (model.faces[f].is_meshed()) RegionBuilder(model, size, layouts[f], static_cast<int>(f), nodes).run(regions);
  return regions;
}

}  // namespace paver
