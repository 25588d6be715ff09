// In: model, limits. Out: the model without its thin faces.
// Steps, face by face: its two long sides, which is what lies between two of its vertices or short edges, or the two
// loops of a ring; how far these are apart; which of them its neighbours go on across without a corner; that one's
// edges replaced by the other's, edge by edge.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "sizing/merging/merge_steps.h"
#include "sizing/merging/side_match.h"

namespace paver {
namespace {

constexpr std::size_t most_edges = 64;  // of a face
constexpr std::size_t most_pairs = 8;   // of sides that are measured
constexpr double end_share = 1.5;       // of the limit: edges so short end a face between its sides
constexpr double wider = 3;       // than a face: so wide are neighbours that take its place, and those at its ends
constexpr double opposite = 2;    // times the limit: vertices so near are opposite each other
constexpr double clearly = 0.9;   // so much nearer are sides that are less alike
constexpr double most_ratio = 3;  // of the lengths of opposite edges: nodes of the one would fall together on the other

struct Sides {
  Side one, two;          // run the same way
  std::vector<int> ends;  // edges between them
  double limit = 0;       // they are no farther apart
  bool is_forced = true;  // the other one could not stay
};

class ThinFaces {
 public:
  ThinFaces(ModelEdits& edits, const MergeLimits& limits, std::vector<Merge>& merges)
      : edits_(edits), limits_(limits), merges_(merges) {}

  /// Gives faces that were to go, so that others could, and could not.
  std::vector<int> run() {
    // Faces of a narrow band end at one another: first which of them can go, if those do that they end at.
    const auto count = static_cast<int>(edits_.model().faces.size());
    stays_at_.assign(static_cast<std::size_t>(count), -1);
    goes_at_ = stays_at_;
    for (int f = 0; f < count; ++f) {
      sides_.push_back(find(f));
      may_go_.push_back(sides_.back().has_value());
    }
    align_bands();
    for (bool has_changed = true; has_changed;) {
      has_changed = false;
      for (int f = 0; f < count; ++f) {
        if (!may_go_[f] || can_go(f, *sides_[f])) continue;
        may_go_[f] = 0;
        has_changed = true;
      }
      has_changed = keep_rims() || has_changed;
    }
    for (int f = 0; f < count; ++f) {
      if (!may_go_[f]) continue;
      std::optional<Sides> sides = find(f);  // of edges that others before it have left
      if (sides && can_go(f, *sides)) merge(f, *sides);
    }
    std::vector<int> stayed;
    for (int f = 0; f < count; ++f)
      if (may_go_[f] && edits_.face(f).has_area) stayed.push_back(f);
    return stayed;
  }

 private:
  /// Rims of a plate, all of which would go: its two faces had nothing but their border, and lay on one another.
  /// Whether there are any.
  bool keep_rims() {
    struct Meeting {
      std::set<int> edges, rims;
    };
    std::map<std::pair<int, int>, Meeting> meetings;  // of two faces: the first one's edges at rims between them
    for (int f = 0; f < static_cast<int>(may_go_.size()); ++f) {
      if (!may_go_[f]) continue;
      const Sides& sides = *sides_[f];
      const int one = neighbour(f, sides.one.front().edge), two = neighbour(f, sides.two.front().edge);
      auto note = [&](int at, int other, const Side& side) {
        Meeting& meeting = meetings[{at, other}];
        meeting.rims.insert(f);
        for (const SideEdge& e : side) meeting.edges.insert(e.edge);
      };
      note(one, two, sides.one), note(two, one, sides.two);
    }
    bool has_any = false;
    for (const auto& [faces, meeting] : meetings) {
      if (faces.first < 0 || !has_only(edits_.face(faces.first), meeting.edges)) continue;
      for (int f : meeting.rims) may_go_[f] = 0;
      has_any = true;
    }
    return has_any;
  }

  bool has_only(const Face& face, const std::set<int>& edges) const {
    for (const Coedge& use : coedges_of(face.loops))
      if (!edges.contains(use.edge) && !edits_.edge(use.edge).is_degenerate) return false;
    return true;
  }

  /// The sides of a thin face, `one` the side that would stay.
  std::optional<Sides> find(int f) const {
    const Face& thin = edits_.face(f);
    if (!thin.has_area || !thin.surface || thin.loops.empty() || limits_.is_protected_face(f) || limits_.lasts(f))
      return std::nullopt;
    std::vector<int> periodic;
    std::vector<Side> loops = border(thin, is_hairline(f), periodic);
    std::size_t count = 0;
    for (const Side& loop : loops) count += loop.size();
    if (count < 2 || count > most_edges || loops.size() > 2 || !limits_.is_thin(f)) return std::nullopt;
    const double limit = limits_.thin_face(limits_.longest_edge(f));
    std::optional<Sides> sides =
        loops.size() == 2 ? sides_of_ring(std::move(loops), limit) : sides_between_ends(f, loops.front(), limit);
    if (!sides) return std::nullopt;
    sides->ends.insert(sides->ends.end(), periodic.begin(), periodic.end());
    sides->limit = limit;
    const std::optional<double> one = corner_across(f, sides->one), two = corner_across(f, sides->two);
    if (!one && !two) return std::nullopt;
    if (!two || (one && *one < *two)) std::swap(sides->one, sides->two);
    if (!one || !two) return sides;
    Sides other = *sides;
    std::swap(other.one, other.two);
    const bool can_stay = can_lose(f, *sides), can_change = can_lose(f, other);
    sides->is_forced = other.is_forced = can_stay != can_change;
    const bool is_asked = borders(f, other.one, stays_at_[f]) && !borders(f, sides->one, stays_at_[f]);
    return can_change && (!can_stay || is_asked) ? other : sides;
  }

  /// Whether a side of the face lies at this one.
  bool borders(int f, const Side& side, int other) const {
    return other >= 0 && std::ranges::any_of(side, [&](const SideEdge& e) { return neighbour(f, e.edge) == other; });
  }

  /// Whether the two sides lie at the faces at which they were found first.
  bool lie_as_before(int f, const Sides& sides) const {
    const int stays = stays_at_[f], goes = goes_at_[f];
    return (borders(f, sides.one, stays) && borders(f, sides.two, goes)) ||
           (borders(f, sides.one, goes) && borders(f, sides.two, stays));
  }

  /// Faces of a band, which end at one another, all keep the same side of it: that of those that have no choice, else
  /// that of the first.
  void align_bands() {
    const auto count = static_cast<int>(sides_.size());
    std::vector<char> is_aligned(sides_.size(), 0);
    for (const bool is_forced : {true, false})
      for (int f = 0; f < count; ++f)
        if (sides_[f] && is_aligned[f] == 0 && sides_[f]->is_forced == is_forced) align_band(f, is_aligned);
    for (int f = 0; f < count; ++f)
      if (sides_[f]) {
        stays_at_[f] = neighbour(f, sides_[f]->one.front().edge);
        goes_at_[f] = neighbour(f, sides_[f]->two.front().edge);
      }
  }

  void align_band(int first, std::vector<char>& is_aligned) {
    std::vector<int> open{first};
    is_aligned[first] = 1;
    for (std::size_t i = 0; i < open.size(); ++i) {
      const Sides& before = *sides_[open[i]];
      for (int end : before.ends)
        for (int next : edits_.edge(end).faces) {
          if (!sides_[next] || is_aligned[next] != 0 ||
              std::ranges::find(sides_[next]->ends, end) == sides_[next]->ends.end())
            continue;
          Sides& sides = *sides_[next];
          if (!sides.is_forced && !meet_at(before.one, sides.one, end)) std::swap(sides.one, sides.two);
          is_aligned[next] = 1;
          open.push_back(next);
        }
    }
  }

  /// Whether two sides end at one vertex of an edge between them.
  bool meet_at(const Side& a, const Side& b, int edge) const {
    auto ends_at = [&](const Side& side, int vertex) {
      return edits_.start_of(side.front()) == vertex || edits_.end_of(side.back()) == vertex;
    };
    const Edge& end = edits_.edge(edge);
    return (ends_at(a, end.start) && ends_at(b, end.start)) || (ends_at(a, end.end) && ends_at(b, end.end));
  }

  /// Loops without periodic edges, which tie the two loops of a ring. None where the face has poles or images fail;
  /// edges at the ends of a hairline have no length and count as poles.
  std::vector<Side> border(const Face& thin, bool may_have_poles, std::vector<int>& periodic) const {
    std::vector<Side> loops;
    for (const Loop& loop : thin.loops) {
      const std::size_t n = loop.coedges.size();
      std::size_t first = 0;
      for (std::size_t i = 0; i < n; ++i) {
        const Coedge& coedge = loop.coedges[i];
        if (edits_.edge(coedge.edge).is_degenerate ? !may_have_poles : !coedge.pcurve || coedge.is_slit) return {};
        if (edits_.edge(coedge.edge).is_periodic) first = i;
      }
      loops.emplace_back();
      for (std::size_t i = 0; i < n; ++i) {
        const Coedge& coedge = loop.coedges[(first + i) % n];
        if (edits_.edge(coedge.edge).is_degenerate) continue;
        if (!edits_.edge(coedge.edge).is_periodic)
          loops.back().push_back({coedge.edge, coedge.is_reversed});
        else if (!loops.back().empty())
          loops.emplace_back();
        if (edits_.edge(coedge.edge).is_periodic) periodic.push_back(coedge.edge);
      }
      if (loops.back().empty()) return {};
    }
    std::sort(periodic.begin(), periodic.end());
    periodic.erase(std::unique(periodic.begin(), periodic.end()), periodic.end());
    return loops;
  }

  /// Each begins at a vertex that has one of the other opposite, no farther away than twice what the two are apart.
  std::optional<Sides> sides_of_ring(std::vector<Side> loops, double limit) const {
    Side one = std::move(loops[0]), two = reversed(std::move(loops[1]));
    std::size_t first = 0, second = 0;
    double least = INFINITY;
    for (std::size_t i = 0; i < one.size(); ++i)
      for (std::size_t k = 0; k < two.size(); ++k) {
        const double away = norm(edits_.point(edits_.start_of(one[i])) - edits_.point(edits_.start_of(two[k])));
        if (away < least) least = away, first = i, second = k;
      }
    std::rotate(one.begin(), one.begin() + static_cast<std::ptrdiff_t>(first), one.end());
    std::rotate(two.begin(), two.begin() + static_cast<std::ptrdiff_t>(second), two.end());
    // An elbow is as short on its inner side: the pipe before it does not end where that after it begins.
    const double width = distance_between(edits_, one, two, limit);
    if (width > limit || least > opposite * width || tilt_between(edits_, one, two) > smooth_angle * M_PI / 180)
      return std::nullopt;
    return Sides{one, two, {}};
  }

  /// Of all pairs of ends those that leave sides of about one length; of these the sides that are nearest, and of
  /// such as are about as near those with edges at their ends: in a side it has no counterpart in the other.
  std::optional<Sides> sides_between_ends(int f, const Side& loop, double limit) const {
    struct End {
      std::size_t first, behind;  // the sides end before `first` and begin at `behind`
    };
    const std::size_t n = loop.size();
    std::vector<End> ends;
    for (std::size_t i = 0; i < n; ++i) {
      if (edits_.edge(loop[i].edge).length <= end_share * limit) ends.push_back({i, i + 1});
      ends.push_back({i, i});
    }
    struct Pair {
      double difference;
      std::size_t a, b;
    };
    std::vector<double> upto{0};
    for (std::size_t i = 0; i < 2 * n; ++i) upto.push_back(upto.back() + edits_.edge(loop[i % n].edge).length);
    std::vector<Pair> pairs;
    for (std::size_t a = 0; a < ends.size(); ++a)
      for (std::size_t b = a + 1; b < ends.size(); ++b) {
        if (ends[b].first <= ends[a].behind || ends[a].first + n <= ends[b].behind) continue;
        const double one = upto[ends[b].first] - upto[ends[a].behind],
                     two = upto[ends[a].first + n] - upto[ends[b].behind];
        if (std::abs(one - two) <= opposite * limit) pairs.push_back({std::abs(one - two), a, b});
      }
    std::stable_sort(pairs.begin(), pairs.end(), [](auto& a, auto& b) { return a.difference < b.difference; });
    if (pairs.size() > most_pairs) pairs.resize(most_pairs);
    std::optional<Sides> best;
    double least = limit;
    bool is_known = false;  // the sides that the face had before others were merged
    for (const Pair& pair : pairs) {
      const End &a = ends[pair.a], &b = ends[pair.b];
      Sides sides;
      for (std::size_t i = a.behind; i < b.first; ++i) sides.one.push_back(loop[i % n]);
      for (std::size_t i = b.behind; i < a.first + n; ++i) sides.two.push_back(loop[i % n]);
      sides.two = reversed(sides.two);
      for (const End& end : {a, b})
        if (end.behind > end.first) sides.ends.push_back(loop[end.first % n].edge);
      const bool is_known_one = lie_as_before(f, sides);
      if (is_known && !is_known_one) continue;
      if (is_known_one && !is_known) is_known = true, best.reset(), least = limit;
      const bool has_more_ends = best && sides.ends.size() > best->ends.size();
      const double distance = distance_between(edits_, sides.one, sides.two, least / clearly);
      if (distance < (has_more_ends ? 1 / clearly : best ? clearly : 1) * least)
        least = distance, best = std::move(sides);
    }
    return best;
  }

  void merge(int f, Sides& sides) {
    Side &kept = sides.one, &gone = sides.two;
    for (const SideEdge& e : kept)
      if (!is_hairline(f) && !limits_.is_sharp(e.edge)) edits_.note_smooth(e.edge);
    const double width = distance_between(edits_, kept, gone);
    // Sides not longer than what is narrow here may have vertices that are nearer to each other.
    const bool has_opposite =
        divide_alike(edits_, kept, gone, opposite * sides.limit) || divide_alike(edits_, kept, gone, opposite * width);
    if (!has_opposite || !are_alike(kept, gone)) return;
    const Vec3 where = edits_.edge(kept.front().edge).curve->point(edits_.edge(kept.front().edge).t0);
    merges_.push_back(
        {MergeKind::face, edits_.face(f).name, edits_.face(neighbour(f, gone.front().edge)).name, width, where});
    for (const SideEdge& e : gone) edits_.face(neighbour(f, e.edge)).merged_area += edits_.face(f).area;
    take_out_face(f, kept, gone, sides.ends);
    for (std::size_t i = 0; i < kept.size(); ++i) {
      const bool is_against = kept[i].is_reversed != gone[i].is_reversed;
      const auto match = match_edges(edits_.edge(kept[i].edge), edits_.edge(gone[i].edge), is_against);
      const std::array<int, 2> from{edits_.start_of(gone[i]), edits_.end_of(gone[i])},
          to{edits_.start_of(kept[i]), edits_.end_of(kept[i])};
      edits_.replace(gone[i].edge, kept[i].edge, !is_against, match);
      for (std::size_t k = 0; k < from.size(); ++k)
        if (from[k] != to[k]) edits_.move_vertex(from[k], to[k], limits_.target_length());
    }
  }

  bool are_alike(const Side& one, const Side& two) const {
    return std::ranges::equal(one, two, [&](const SideEdge& a, const SideEdge& b) {
      const auto [least, most] = std::minmax(edits_.edge(a.edge).length, edits_.edge(b.edge).length);
      return most <= most_ratio * least;
    });
  }

  void take_out_face(int f, const Side& kept, const Side& gone, const std::vector<int>& ends) {
    for (const Coedge& coedge : coedges_of(edits_.face(f).loops))
      if (edits_.edge(coedge.edge).is_degenerate) std::erase(edits_.edge(coedge.edge).faces, f);
    edits_.leave_out(f);
    for (const Side* side : {&kept, &gone})
      for (const SideEdge& e : *side) std::erase(edits_.edge(e.edge).faces, f);
    edits_.take_out(ends);
  }

  int neighbour(int f, int edge) const { return limits_.neighbour(f, edge); }

  /// Largest angle between the face and its neighbours across a side; nothing where it must stay.
  std::optional<double> corner_across(int f, const Side& side) const {
    double most = 0;
    for (const SideEdge& e : side) {
      const std::optional<double> corner = limits_.corner_across(f, e.edge);
      if (!corner || limits_.width(neighbour(f, e.edge)) < wider * limits_.width(f)) return std::nullopt;
      most = std::max(most, *corner);
    }
    return most <= smooth_angle * M_PI / 180 || is_hairline(f) ? std::optional(most) : std::nullopt;
  }

  /// Of files whose parts were placed with too few digits: nothing that a mesh could show.
  bool is_hairline(int f) const {
    const int longest = limits_.longest_edge(f);
    return longest >= 0 && edits_.edge(longest).curve && limits_.width(f) <= hairline * limits_.length(longest);
  }

  /// What goes is nobody else's, and all faces about it keep a border.
  bool can_go(int f, const Sides& sides) const {
    if (!can_lose(f, sides)) return false;
    const std::vector<int>& ends = sides.ends;
    for (int end : ends) {
      if (limits_.is_protected(end)) return false;
      for (int user : edits_.edge(end).faces)
        if (user != f && !may_go_[user] &&
            (edge_count(user) < 4 || limits_.width(user) < wider * edits_.edge(end).length ||
             limits_.sharpens(user, end)))
          return false;
    }
    return true;
  }

  /// Whether the second side may go.
  bool can_lose(int f, const Sides& sides) const {
    std::vector<int> own = sides.ends;
    for (const SideEdge& e : sides.two) own.push_back(e.edge);
    for (const SideEdge& e : sides.two) {
      const bool is_held = limits_.holds(edits_.start_of(e), own, limits_.width(f)) ||
                           limits_.holds(edits_.end_of(e), own, limits_.width(f));
      if (edits_.is_fixed(edits_.start_of(e)) || edits_.is_fixed(edits_.end_of(e)) || is_held) return false;
      if (!is_hairline(f) && limits_.is_sharp(e.edge) && edits_.edge(e.edge).length >= limits_.short_edge(e.edge))
        return false;
    }
    for (const SideEdge& e : sides.two)
      for (const SideEdge& k : sides.one)
        if (e.edge == k.edge || neighbour(f, e.edge) == neighbour(f, k.edge)) return false;
    return true;
  }

  std::size_t edge_count(int f) const {
    std::size_t count = 0;
    for (const Loop& loop : edits_.face(f).loops) count += loop.coedges.size();
    return count;
  }

  ModelEdits& edits_;
  const MergeLimits& limits_;
  std::vector<Merge>& merges_;
  std::vector<std::optional<Sides>> sides_;  // per face, before any is merged
  std::vector<char> may_go_;                 // per face
  std::vector<int> stays_at_, goes_at_;      // per face: one at the side that stays, or goes; -1: not found yet
};

}  // namespace

std::vector<int> merge_thin_faces(ModelEdits& edits, const MergeLimits& limits, std::vector<Merge>& merges) {
  return ThinFaces(edits, limits, merges).run();
}

}  // namespace paver
