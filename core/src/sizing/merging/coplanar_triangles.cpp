// In: model. Out: the model with fewer faces.
// Steps: parts of which most faces are triangles (some of theirs were cut where others touch); of their flat faces the
// largest first, and all that lie in its plane about it; the edges between them go, the others are chained to loops.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "sizing/merging/merge_limits.h"
#include "sizing/merging/merge_small.h"

namespace paver {
namespace {

constexpr std::size_t fewest = 8;            // triangles of a part: a box has twelve, before others touch it
constexpr double least_share = 0.5;          // of its faces
constexpr double coplanar = 1e-6;            // of the diagonal: corners lie so far from the plane
constexpr double single_precision = 2.4e-7;  // of the largest coordinate: STL files have no more
constexpr double straight = 1e-6;            // of an edge: its middle lies so far from its chord
constexpr double small_share = 0.5;          // of the target length: the root of a face's area
constexpr double largest_turn = M_PI / 4;    // between normals: a face folded back on itself lies in its plane, too

/// A plane with its (u, v) as lengths in it.
class Plane {
 public:
  explicit Plane(const Surface& surface) {
    const auto [x, u, v] = surface.slope({0, 0});
    origin_ = x;
    normal_ = unit(cross(u, v));
    const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), det = uu * vv - uv * uv;
    by_u_ = (vv / det) * u - (uv / det) * v;
    by_v_ = (uu / det) * v - (uv / det) * u;
  }

  Vec3 normal() const { return normal_; }
  double height(Vec3 x) const { return dot(x - origin_, normal_); }
  Vec2 uv(Vec3 x) const { return {dot(x - origin_, by_u_), dot(x - origin_, by_v_)}; }

 private:
  Vec3 origin_, normal_, by_u_, by_v_;
};

class CoplanarJoiner {
 public:
  CoplanarJoiner(Model& model, const Options& options)
      : model_(model), edits_(model), limits_(edits_, options, lasting_), group_(model.faces.size(), -1) {
    double largest = 0;
    for (Vec3 x : model.vertices) largest = std::max({largest, std::fabs(x.x), std::fabs(x.y), std::fabs(x.z)});
    tolerance_ = std::max(coplanar * model.report.diagonal, single_precision * largest);
  }

  CoplanarTriangles run() {
    find_faces();
    std::vector<int> order(model_.faces.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, std::greater{}, [&](int f) { return model_.faces[f].area; });
    for (int f : order)
      if (may_join_[f] && group_[f] < 0) join(grow(f));
    for (int f : order) joined_.small += may_join_[f] && model_.faces[f].is_meshed() && is_small(model_.faces[f]);
    return std::move(joined_);
  }

 private:
  void find_faces() {
    may_join_.assign(model_.faces.size(), 0);
    std::vector<std::vector<int>> faces_of(model_.parts.size());
    for (std::size_t f = 0; f < model_.faces.size(); ++f)
      if (model_.faces[f].is_meshed())
        for (int part : model_.face_parts[f]) faces_of[part].push_back(static_cast<int>(f));
    for (const std::vector<int>& faces : faces_of) {
      const auto found = std::ranges::count_if(faces, [&](int f) { return is_triangle(f); });
      if (static_cast<std::size_t>(found) < fewest ||
          static_cast<double>(found) < least_share * static_cast<double>(faces.size()))
        continue;
      for (int f : faces) may_join_[f] = is_flat(f);
    }
  }

  bool is_small(const Face& face) const {
    const double side = small_share * limits_.target_length();
    return face.area < side * side;
  }

  bool is_triangle(int f) const {
    const Face& face = model_.faces[f];
    return is_flat(f) && face.loops.size() == 1 && face.loops[0].coedges.size() == 3 &&
           std::ranges::all_of(face.loops[0].coedges,
                               [&](const Coedge& use) { return is_straight(edge_of(model_, use)); });
  }

  bool is_flat(int f) const {
    const Face& face = model_.faces[f];
    if (face.surface->kind() != SurfaceKind::plane || limits_.is_protected_face(f)) return false;
    for (const Coedge& use : coedges_of(face.loops))
      if (use.is_slit || !edge_of(model_, use).curve) return false;
    return true;
  }

  bool is_straight(const Edge& edge) const {
    const Vec3 a = edge.curve->point(edge.t0), b = edge.curve->point(edge.t1),
               x = edge.curve->point(edge.parameter(0.5));
    return norm(cross(x - a, b - a)) <= straight * dot(b - a, b - a);
  }

  /// All in the plane of the first.
  std::vector<int> grow(int first) {
    std::vector<int> faces{first};
    const Plane plane(*model_.faces[first].surface);
    group_[first] = first;
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (const Coedge& use : coedges_of(model_.faces[faces[i]].loops)) {
        const int other = limits_.neighbour(faces[i], use.edge);
        if (other < 0 || !may_join_[other] || group_[other] >= 0 || !lies_in(plane, other)) continue;
        if (!may_go(faces[i], use.edge)) continue;
        group_[other] = first;
        faces.push_back(other);
      }
    return faces;
  }

  bool may_go(int f, int edge) const {
    const std::vector<int>&own = model_.face_parts[f], &others = model_.face_parts[limits_.neighbour(f, edge)];
    if (!std::is_permutation(own.begin(), own.end(), others.begin(), others.end())) return false;
    const std::optional<double> turn = limits_.corner_across(f, edge);
    return turn && *turn <= largest_turn;
  }

  bool lies_in(const Plane& plane, int f) const {
    for (const Coedge& use : coedges_of(model_.faces[f].loops))
      if (std::fabs(plane.height(model_.vertices[start_of(edge_of(model_, use), use)])) > tolerance_) return false;
    return true;
  }

  void join(const std::vector<int>& faces) {
    if (faces.size() < 2) return;
    const int first = faces[0];
    Face& kept = model_.faces[first];
    const Plane plane(*kept.surface);
    std::vector<int> between;
    std::vector<Coedge> border;
    for (int f : faces) {
      const bool is_turned = dot(model_.faces[f].surface->normal({0, 0}), plane.normal()) < 0;
      for (const Coedge& use : coedges_of(model_.faces[f].loops)) {
        const int other = limits_.neighbour(f, use.edge);
        if (other < 0 || group_[other] != first) {
          border.push_back(seen_from(plane, use, is_turned));
        } else if (may_go(f, use.edge)) {
          between.push_back(use.edge);
        } else {
          return;  // it would be an edge inside the face
        }
      }
    }
    std::vector<Loop> loops = chained(plane, std::move(border));
    if (loops.empty()) return;
    for (int f : faces) {
      if (f == first) continue;
      for (const Coedge& use : coedges_of(model_.faces[f].loops))
        std::ranges::replace(edits_.edge(use.edge).faces, f, first);
      take_out(f, kept);
    }
    std::sort(between.begin(), between.end());
    between.erase(std::unique(between.begin(), between.end()), between.end());
    edits_.take_out(between);
    kept.loops = std::move(loops);
  }

  void take_out(int f, Face& kept) {
    Face& face = model_.faces[f];
    const Edge& edge = edge_of(model_, face.loops[0].coedges[0]);
    joined_.merges.push_back({MergeKind::face, face.name, kept.name, limits_.extent(f), model_.vertices[edge.start]});
    kept.area += face.area;
    face.area = 0;
    edits_.leave_out(f);
    face.surface = kept.surface;
  }

  Coedge seen_from(const Plane& plane, const Coedge& use, bool is_turned) const {
    Coedge seen = use;
    seen.is_reversed = use.is_reversed != is_turned;
    seen.pcurve = image_by([plane, curve = edge_of(model_, use).curve](double t) { return plane.uv(curve->point(t)); });
    return seen;
  }

  /// The face on the left: at a vertex with several ways on the first one clockwise from the way back. Empty where they
  /// do not close.
  std::vector<Loop> chained(const Plane& plane, std::vector<Coedge> border) const {
    std::map<int, std::vector<std::size_t>> from;
    for (std::size_t i = 0; i < border.size(); ++i) from[start_of(edge_of(model_, border[i]), border[i])].push_back(i);
    std::vector<char> is_used(border.size(), 0);
    std::vector<Loop> loops;
    for (std::size_t first = 0; first < border.size(); ++first) {
      if (is_used[first]) continue;
      Loop& loop = loops.emplace_back();
      const int start = start_of(edge_of(model_, border[first]), border[first]);
      for (std::size_t i = first;;) {
        is_used[i] = 1;
        loop.coedges.push_back(border[i]);
        const int end = end_of(edge_of(model_, border[i]), border[i]);
        std::optional<std::size_t> next;
        double least = INFINITY;
        for (std::size_t k : from[end]) {
          if (is_used[k] && k != first) continue;
          const double angle = angle_between_ways(plane, border[i], border[k]);
          if (angle < least) least = angle, next = k;
        }
        if (!next) return {};
        if (*next == first && end == start) break;
        i = *next;
      }
    }
    return loops;
  }

  /// Clockwise, from the way back along one to the other.
  double angle_between_ways(const Plane& plane, const Coedge& in, const Coedge& out) const {
    auto way = [&](const Coedge& use, bool is_back) {
      const Edge& edge = edge_of(model_, use);
      const Vec3 x = model_.vertices[start_of(edge, use)], y = model_.vertices[end_of(edge, use)];
      return plane.uv(is_back ? x : y) - plane.uv(is_back ? y : x);
    };
    return angle_to_left(way(out, false), way(in, true));
  }

  Model& model_;
  ModelEdits edits_;
  std::vector<int> lasting_;  // none
  const MergeLimits limits_;
  double tolerance_ = 0;        // mm
  std::vector<char> may_join_;  // per face
  std::vector<int> group_;      // per face: the first of those in its plane, -1 before that is known
  CoplanarTriangles joined_;
};

}  // namespace

CoplanarTriangles join_coplanar_triangles(Model& model, const Options& options) {
  if (!(options.merge > 0) || model.faces.size() < fewest) return {};
  return CoplanarJoiner(model, options).run();
}

std::vector<std::string> notes_of(const CoplanarTriangles& joined) {
  constexpr long many = 100;  // a few are as many elements
  std::vector<std::string> notes;
  if (!joined.merges.empty())
    notes.push_back(
        fmt::format("Flat faces beside others in their plane, triangles as of an STL file, are meshed with them: {} "
                    "(merge off keeps "
                    "them).",
                    joined.merges.size()));
  if (joined.small >= many)
    notes.push_back(
        fmt::format("Surfaces are made of flat triangles, as of an STL file, {} smaller than the target length, and "
                    "elements are no "
                    "larger than these; mesh the CAD model itself, or one with fewer triangles.",
                    joined.small));
  return notes;
}

}  // namespace paver
