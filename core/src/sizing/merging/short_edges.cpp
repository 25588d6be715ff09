// In: model, limits. Out: the model without its short edges.
// Steps: tiny faces become points; then edge by edge, the shortest first: where another edge runs into it without a
// corner at one end, that end goes to the other one. No vertex moves by more than the limit in all.
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "sizing/merging/merge_steps.h"

namespace paver {
namespace {

constexpr std::size_t fewest_edges = 3;  // that a loop keeps
constexpr double much_longer = 3;        // times a short edge
constexpr double small_bend = 10;        // the same: edges that get a bend where it was
constexpr double slender = 0.2;          // of its extent: so wide is a face with two sides
constexpr double longest_end = 3;        // widths of a face: an edge that goes is an end of it, no side

class ShortEdges {
 public:
  ShortEdges(ModelEdits& edits, const MergeLimits& limits, std::vector<Merge>& merges)
      : edits_(edits), limits_(limits), merges_(merges), members_(edits.model().vertices.size()) {
    for (std::size_t v = 0; v < members_.size(); ++v) members_[v] = {edits.point(static_cast<int>(v))};
  }

  /// Gives faces that have to go now.
  std::vector<int> run_faces() {
    for (std::size_t f = 0; f < edits_.model().faces.size(); ++f) visit_face(static_cast<int>(f));
    return std::move(going_);
  }

  void run_edges() {
    std::vector<int> edges;
    for (std::size_t e = 0; e < edits_.model().edges.size(); ++e)
      if (may_collapse(static_cast<int>(e))) edges.push_back(static_cast<int>(e));
    std::ranges::stable_sort(edges, {}, [&](int e) { return edits_.edge(e).length; });
    for (int e : edges)
      if (may_collapse(e)) visit_edge(e);
  }

 private:
  bool may_collapse(int e) const {
    const Edge& edge = edits_.edge(e);
    return edge.curve && edge.start != edge.end && !edge.faces.empty() && !limits_.is_protected(e) &&
           !edge.is_periodic && edge.length < limits_.short_edge(e);
  }

  void visit_edge(int e) {
    if (!leaves_loops(e) || ends_strip(e)) return;
    const Edge& edge = edits_.edge(e);
    const int at_start = next_at(e, edge.start), at_end = next_at(e, edge.end);
    const bool start_goes = at_start >= 0 && can_move(e, edge.start, edge.end);
    const bool end_goes = at_end >= 0 && can_move(e, edge.end, edge.start);
    if (!start_goes && !end_goes) return;
    const bool is_start = start_goes && (!end_goes || bend(e, at_start, edge.start) <= bend(e, at_end, edge.end));
    const int gone = is_start ? edge.start : edge.end, kept = is_start ? edge.end : edge.start;
    const Edge& next = edits_.edge(is_start ? at_start : at_end);
    merges_.push_back({MergeKind::edge, edge.name, next.name, edge.length, edits_.point(kept)});
    edits_.collapse({e});
    move(gone, kept);
  }

  double bend(int e, int other, int vertex) const { return bend_between(edits_.edge(e), edits_.edge(other), vertex); }

  /// The edge at the vertex that goes on from `e` best; -1 where all make corners with it.
  int next_at(int e, int vertex) const {
    int best = -1;
    double least = smooth_angle * M_PI / 180;
    for (int other : edits_.edges_at(vertex)) {
      if (other == e || edits_.edge(other).start == edits_.edge(other).end) continue;
      const double angle = bend(e, other, vertex);
      if (angle < least) least = angle, best = other;
    }
    return best;
  }

  /// All that the vertex stands for stays within the limit, and no other edge there is as short.
  bool can_move(int e, int from, int to) const {
    if (edits_.is_fixed(from) || from == to || limits_.holds(from, {e}, edits_.edge(e).length)) return false;
    const std::vector<int>& edges = edits_.edges_at(from);
    const double limit = limits_.short_edge(e);
    const double own_bend =
        M_PI - angle_between(direction_out(edits_.edge(e), false), direction_out(edits_.edge(e), true));
    const auto is_too_short = [&](int other) {
      const bool bends = std::max(own_bend, bend(e, other, from)) >= smooth_angle * M_PI / 180;
      return other != e && edits_.edge(other).length < (bends ? small_bend : much_longer) * edits_.edge(e).length;
    };
    if (std::ranges::any_of(edges, is_too_short)) return false;
    return std::ranges::all_of(members_[from], [&](Vec3 x) { return norm(x - edits_.point(to)) <= limit; });
  }

  bool leaves_loops(int e) const {
    for (int f : edits_.edge(e).faces)
      for (const Loop& loop : edits_.face(f).loops) {
        const bool has_edge = std::ranges::find(loop.coedges, e, &Coedge::edge) != loop.coedges.end();
        const auto kept = std::ranges::count_if(loop.coedges, [&](const Coedge& coedge) {
          return coedge.edge != e && !edits_.edge(coedge.edge).is_degenerate;
        });
        if (has_edge && static_cast<std::size_t>(kept) < fewest_edges) return false;
      }
    return true;
  }

  /// Whether a face would run out into a point where the edge is.
  bool ends_strip(int e) const {
    return std::ranges::any_of(edits_.edge(e).faces, [&](int f) { return limits_.sharpens(f, e); });
  }

  void move(int from, int to) {
    edits_.move_vertex(from, to, limits_.target_length());
    std::vector<Vec3>&members = members_[from], &all = members_[to];
    all.insert(all.end(), members.begin(), members.end());
    members.clear();
  }

  /// A face of one loop that is tiny beside its neighbours.
  void visit_face(int f) {
    Face& small = edits_.face(f);
    if (!small.has_area || small.loops.size() != 1 || limits_.is_protected_face(f)) return;
    if (limits_.width(f) < slender * limits_.extent(f) && limits_.may_be_merged(f)) {
      going_.push_back(f);  // one of its sides for the other moves less than all of it to a point
      return;
    }
    std::vector<Coedge> coedges = small.loops.front().coedges;
    std::erase_if(coedges, [&](const Coedge& coedge) { return edits_.edge(coedge.edge).is_degenerate; });
    if (coedges.empty() || !is_tiny(f, coedges)) return;
    std::vector<int> edges;
    std::set<int> vertices;
    for (const Coedge& coedge : coedges) {
      edges.push_back(coedge.edge);
      vertices.insert({edits_.edge(coedge.edge).start, edits_.edge(coedge.edge).end});
    }
    const auto is_held = [&](int vertex) { return limits_.holds(vertex, edges, limits_.extent(f)); };
    // One of them may stay where it is.
    const auto held = std::ranges::count_if(vertices, is_held);
    if (held > 1) return;
    const int kept = held == 0 ? *vertices.begin() : *std::ranges::find_if(vertices, is_held);
    for (const Coedge& coedge : coedges)
      if (const int other = limits_.neighbour(f, coedge.edge); !leaves_loop(other, coedges, false))
        going_.push_back(other);
    const std::string into = edits_.edge(edges.front()).name;
    merges_.push_back({MergeKind::face, small.name, into, limits_.extent(f), edits_.point(kept)});
    edits_.collapse(edges);
    edits_.leave_out(f);
    for (int vertex : vertices)
      if (vertex != kept) move(vertex, kept);
  }

  /// Against the target length, and its neighbours: these go on without a corner unless it is far smaller.
  bool is_tiny(int f, const std::vector<Coedge>& coedges) const {
    double limit = INFINITY, largest = 0, corner = 0;
    for (const Coedge& coedge : coedges) limit = std::min(limit, short_edge(coedge.edge));
    if (!(limits_.extent(f) < limit)) return false;  // before neighbours are looked at, which may have many edges
    for (const Coedge& coedge : coedges) {
      const Edge& edge = edits_.edge(coedge.edge);
      const std::optional<double> across = limits_.corner_across(f, coedge.edge);
      if (!edge.curve || !across || edits_.is_fixed(edge.start) || edits_.is_fixed(edge.end)) return false;
      const int other = limits_.neighbour(f, coedge.edge);
      if (!leaves_loop(other, coedges, limits_.may_be_merged(other))) return false;
      largest = std::max(largest, limits_.extent(other));
      corner = std::max(corner, *across);
    }
    return limits_.extent(f) < (corner <= smooth_angle * M_PI / 180 ? 1 : tiny_share) * limit && largest > limit;
  }

  /// Edges shorter than this are merged; poles are no edges.
  double short_edge(int e) const { return edits_.edge(e).curve ? limits_.short_edge(e) : 0; }

  /// Whether the face keeps a border of some edges, or none at all of a hole that the small face fills. One that
  /// `goes` itself may keep two; one that stays keeps its sides: all across a narrow face would be drawn to one place.
  bool leaves_loop(int f, const std::vector<Coedge>& gone, bool goes) const {
    const auto is_gone = [&](const Coedge& c) { return std::ranges::find(gone, c.edge, &Coedge::edge) != gone.end(); };
    for (std::size_t l = 0; l < edits_.face(f).loops.size(); ++l) {
      const std::vector<Coedge>& coedges = edits_.face(f).loops[l].coedges;
      const auto going = static_cast<std::size_t>(std::ranges::count_if(coedges, is_gone));
      if (going == 0) continue;
      const bool is_hole = edits_.face(f).loops.size() > 1 && going == coedges.size() && going == gone.size();
      if (!is_hole && coedges.size() < going + (goes ? 2 : fewest_edges)) return false;
      if (is_hole || goes) continue;
      for (const Coedge& coedge : coedges)
        if (is_gone(coedge) && (edits_.edge(coedge.edge).length > longest_end * limits_.width(f) ||
                                (going == 1 && limits_.sharpens(f, coedge.edge))))
          return false;
    }
    return true;
  }

  ModelEdits& edits_;
  const MergeLimits& limits_;
  std::vector<Merge>& merges_;
  std::vector<std::vector<Vec3>> members_;  // places that were merged into a vertex
  std::vector<int> going_;                  // thin faces, and those that run out into a point where a tiny one was
};

}  // namespace

void collapse_short_edges(ModelEdits& edits, const MergeLimits& limits, std::vector<Merge>& merges) {
  ShortEdges(edits, limits, merges).run_edges();
}

std::vector<int> collapse_tiny_faces(ModelEdits& edits, const MergeLimits& limits, std::vector<Merge>& merges) {
  return ShortEdges(edits, limits, merges).run_faces();
}

}  // namespace paver
