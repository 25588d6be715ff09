// In: loops, counts. Out: places on straight edges, counts that take them.
// Steps, face by face: facets between evenly spaced nodes; per straight edge the vertices near it, nearest first; a
// place opposite each, where nothing lies on the way there, unless a node is about there.
#include "boundary/border/opposite_vertices.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "base/boxes/box_tree.h"
#include "base/segment.h"
#include "boundary/border/border_facets.h"

namespace paver {
namespace {

constexpr double near = 0.1;       // intervals: without a node what lies between is a needle
constexpr double shorter = 0.7;    // intervals: the vertex's facets; else both sides are divided alike
constexpr int most_intervals = 3;  // of the edge: more would all change for the sake of one place
constexpr int most_rounds = 4;
constexpr double straight = 0.999;   // chord by length
constexpr double towards = 0.5;      // cosine between the way to the edge and that into the face
constexpr double convex = 0.01;      // sine of the turn at a corner of the face ...
constexpr double smooth = 0.85;      // ... and its cosine
constexpr double apart = 0.3;        // of the distance, or of the vertex's facets: nearer places are one
constexpr double mitred = 2;         // times as far, or as near, along the edge as from it
constexpr double longer = 1.4;       // intervals: than the edge had without places
constexpr double on_facet = 1e-9;    // of its length
constexpr double beside = 0.25;      // of the distance
constexpr double on_end = 1 - 1e-6;  // of a facet

struct Place {
  double distance = 0;  // of the vertex, mm
  double share = 0;     // of the edge
  double apart = 0;     // mm, from other nodes
};

double longest(const std::vector<double>& shares) {
  double most = 0;
  for (std::size_t i = 1; i < shares.size(); ++i) most = std::max(most, shares[i] - shares[i - 1]);
  return most;
}

class Border {
 public:
  /// `is_divided`: whether an edge has places opposite vertices, which face others like vertices.
  Border(std::vector<BorderFacet> facets, const std::function<bool(int edge)>& is_divided)
      : facets_(std::move(facets)) {
    std::vector<Box> of_facets(facets_.size()), of_starts;
    for (int i = 0; i < static_cast<int>(facets_.size()); ++i) {
      of_facets[i].add(facets_[i].a), of_facets[i].add(facets_[i].b);
      if (facets_[facets_[i].before].edge == facets_[i].edge && !is_divided(facets_[i].edge)) continue;
      starts_.push_back(i);
      of_starts.emplace_back().add(facets_[i].a);
    }
    facet_tree_ = BoxTree(std::move(of_facets));
    start_tree_ = BoxTree(std::move(of_starts));
  }

  /// Nearest first. `interval`: mm; `chord`: from the edge's start to its end.
  std::vector<Place> places_on(int edge, double interval, Vec3 start, Vec3 chord) const {
    std::vector<Place> places;
    for (int i = 0; i < static_cast<int>(facets_.size()); ++i) {
      if (facets_[i].edge != edge) continue;
      Box about;
      about.add(facets_[i].a), about.add(facets_[i].b);
      start_tree_.each_meeting(about.grown(near * interval), [&](int k) {
        const int v = starts_[k];
        const std::optional<double> distance = distance_before(i, v, interval);
        const double share = dot(facets_[v].a - start, chord) / dot(chord, chord);
        if (distance) places.push_back({*distance, share, apart * std::min(*distance, shortest_at(facets_, v))});
      });
    }
    std::ranges::sort(places, {}, [](const Place& place) { return std::pair(place.distance, place.share); });
    return places;
  }

 private:
  /// Of the node at the start of facet v from facet i, where it needs one there.
  std::optional<double> distance_before(int i, int v, double interval) const {
    const BorderFacet &facet = facets_[i], &node = facets_[v];
    if (facets_[node.before].edge == facet.edge || node.edge == facet.edge) return std::nullopt;
    const double distance = dot(node.a - facet.a, facet.inward),
                 along = dot(node.a - facet.a, facet.b - facet.a) / facet.length();
    const bool is_near = distance > on_facet * interval && distance < near * interval;
    if (!is_near || shortest_at(facets_, v) > shorter * interval || !is_seen(i, v) ||
        is_mitred(facet.before, v, distance, along) || is_mitred(facet.after, v, distance, facet.length() - along))
      return std::nullopt;
    return distance;
  }

  /// Whether a node lies opposite a facet, with nothing between.
  bool is_seen(int i, int v) const {
    const BorderFacet& facet = facets_[i];
    const Vec3 chord = facet.b - facet.a;
    const double share = dot(facets_[v].a - facet.a, chord) / dot(chord, chord);
    return share > 1 - on_end && share < on_end && is_facing(v, facet.inward) && is_open(i, v);
  }

  /// Whether the face about a node lies towards what has this inward normal. Not so at convex corners.
  bool is_facing(int v, Vec3 inward) const {
    const BorderFacet &after = facets_[v], &before = facets_[after.before];
    const bool is_convex = dot(unit(after.b - after.a), before.inward) > convex;
    if (is_convex && dot(before.inward, after.inward) < smooth) return false;
    return -std::min(dot(before.inward, inward), dot(after.inward, inward)) >= towards;
  }

  /// Whether no other facet comes near the way from a node to a facet.
  bool is_open(int i, int v) const {
    const Vec3 from = facets_[v].a;
    const double distance = dot(from - facets_[i].a, facets_[i].inward);
    const Vec3 way = -distance * facets_[i].inward;
    Box about;
    about.add(from), about.add(from + way);
    bool is_open = true;
    facet_tree_.each_meeting(about.grown(beside * distance), [&](int k) {
      const BorderFacet& facet = facets_[k];
      if (facet.edge == facets_[i].edge || k == v || k == facets_[v].before) return;
      for (double share : {beside, 0.5, 1 - beside})
        is_open = is_open && distance_to_segment(from + share * way, facet.a, facet.b) >= beside * distance;
    });
    return is_open;
  }

  /// Whether a node, at `distance` from one facet and about as far along it, lies opposite the next one, too, and so
  /// opposite the corner between them.
  bool is_mitred(int next, int v, double distance, double along) const {
    return along > distance / mitred && along < distance * mitred && is_seen(next, v);
  }

  std::vector<BorderFacet> facets_;
  std::vector<int> starts_;  // facets that start at a vertex or opposite one
  BoxTree start_tree_, facet_tree_;
};

class Facing {
 public:
  Facing(const Model& model, std::vector<EdgeCount>& counts)
      : model_(model), counts_(counts), first_(counts), opposite(counts.size()) {}

  /// The edges of a face; those that get places.
  std::vector<int> face(int f, const std::vector<Loop>& loops) {
    std::vector<int> open, found;
    for (const Coedge& coedge : coedges_of(loops))
      if (may_get_places(coedge.edge)) open.push_back(coedge.edge);
    if (open.empty()) return found;
    std::vector<BorderFacet> facets = border_of(model_, f, loops, counts_, opposite);
    if (facets.empty()) return found;
    const Border border(std::move(facets), [&](int edge) { return !opposite[edge].empty(); });
    for (int e : open) {
      const Edge& edge = model_.edges[e];
      const double interval = edge.length / first_[e].count;
      if (take(e, border.places_on(e, interval, model_.vertices[edge.start], chord_of(edge)))) found.push_back(e);
    }
    return found;
  }

 private:
  /// From its start to its end.
  Vec3 chord_of(const Edge& edge) const { return model_.vertices[edge.end] - model_.vertices[edge.start]; }

  bool may_get_places(int e) const {
    const Edge& edge = model_.edges[e];
    return first_[e].count <= most_intervals && norm(chord_of(edge)) >= straight * edge.length;
  }

  /// Whether there are new ones among the places.
  bool take(int edge, const std::vector<Place>& places) {
    std::vector<double>& shares = opposite[edge];
    const std::size_t before = shares.size();
    for (const Place& place : places) {
      auto is_there = [&](double share) {
        return std::fabs(share - place.share) * model_.edges[edge].length < place.apart;
      };
      if (!is_there(0) && !is_there(1) && std::ranges::none_of(shares, is_there)) shares.push_back(place.share);
    }
    int least = std::max(first_[edge].count, static_cast<int>(shares.size()) + 1);
    while (longest(shares_of(shares, least)) * first_[edge].count > longer) ++least;
    raise_to(counts_[edge], least);
    return shares.size() > before;
  }

  const Model& model_;
  std::vector<EdgeCount>& counts_;
  const std::vector<EdgeCount> first_;

 public:
  OppositeShares opposite;
};

}  // namespace

OppositeShares face_near_vertices(const Model& model, const std::vector<std::vector<Loop>>& loops,
                                  std::vector<EdgeCount>& counts) {
  Facing facing(model, counts);
  divide_in_rounds(model, loops.size(), most_rounds, [&](int f) { return facing.face(f, loops[f]); });
  return std::move(facing.opposite);
}

}  // namespace paver
