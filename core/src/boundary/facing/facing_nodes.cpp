// Nodes that face vertices across narrow faces.
// In: pairs of sides, nodes of every edge. Out: edges whose nodes move, and where to.
// Steps: narrow faces with as many intervals on either side; the side that is one edge follows the other where that one
// has vertices, or has moved itself; until nothing moves. Rows across a narrow face join nodes of equal number: where
// a trace ends on one side of a board's thin wall, evenly divided edges beyond lean such rows until they are needles.
// A node moves only until its row leans by 45 degrees, and so neither side gets intervals shorter than both had.
#include "boundary/facing/facing_nodes.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace paver {
namespace {

constexpr double narrow = 0.7;       // intervals: wider faces are paved, not laid as one row
constexpr double most_unlike = 0.1;  // of the longer side: else equal shares of the sides do not face each other

/// Chain of edges from one corner to the next.
struct Side {
  std::vector<int> edges;
  std::vector<bool> is_against;  // the edge runs the other way
  double length = 0;
  std::size_t intervals = 0;
};

std::optional<Side> side_of(const Model& model, const std::vector<int>& edges, const NodeLengths& lengths) {
  Side side{edges, {}, 0, 0};
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Edge& edge = model.edges[edges[i]];
    if (lengths[edges[i]].size() < 2 || edge.start == edge.end) return {};
    side.length += lengths[edges[i]].back();
    side.intervals += lengths[edges[i]].size() - 1;
    auto touches = [&](int vertex, const Edge& other) { return vertex == other.start || vertex == other.end; };
    if (i + 1 < edges.size())
      side.is_against.push_back(touches(edge.start, model.edges[edges[i + 1]]));
    else
      side.is_against.push_back(i > 0 && touches(edge.end, model.edges[edges[i - 1]]));
  }
  return side;
}

Vec3 end_of(const Model& model, const Side& side, bool is_last) {
  const std::size_t i = is_last ? side.edges.size() - 1 : 0;
  const Edge& edge = model.edges[side.edges[i]];
  return model.vertices[is_last != side.is_against[i] ? edge.end : edge.start];
}

/// A single edge does not tell which way it runs beside the other side.
void turn_along(const Model& model, const Side& other, Side& single) {
  auto apart = [&] {
    return norm(end_of(model, single, false) - end_of(model, other, false)) +
           norm(end_of(model, single, true) - end_of(model, other, true));
  };
  const double as_it_is = apart();
  single.is_against[0] = !single.is_against[0];
  if (apart() >= as_it_is) single.is_against[0] = !single.is_against[0];
}

/// Distances of a side's nodes from its first corner.
std::vector<double> places_along(const Side& side, const NodeLengths& lengths) {
  std::vector<double> places = {0};
  for (std::size_t i = 0; i < side.edges.size(); ++i) {
    const std::vector<double>& of_edge = lengths[side.edges[i]];
    const double before = places.back();
    for (std::size_t k = 1; k < of_edge.size(); ++k)
      places.push_back(before + (side.is_against[i] ? of_edge.back() - of_edge[of_edge.size() - 1 - k] : of_edge[k]));
  }
  return places;
}

class Following {
 public:
  Following(const Model& model, NodeLengths lengths)
      : model_(model), lengths_(std::move(lengths)), has_moved_(lengths_.size(), false) {}

  /// Whether an edge has moved.
  bool follow(const OppositeSides& pair) {
    const std::vector<int>*leader = &pair.first, *follower = &pair.second;
    if (follower->size() > 1 || leads(*follower)) std::swap(leader, follower);
    if (follower->size() > 1 || leads(*follower) || !leads(*leader)) return false;
    std::optional<Side> one = side_of(model_, *leader, lengths_), other = side_of(model_, *follower, lengths_);
    if (!one || !other || one->intervals != other->intervals) return false;
    if (std::fabs(one->length - other->length) > most_unlike * std::max(one->length, other->length)) return false;
    const double width = width_between(model_, pair);
    if (width * static_cast<double>(one->intervals) > narrow * std::min(one->length, other->length)) return false;
    if (one->edges.size() == 1) turn_along(model_, *other, *one);
    turn_along(model_, *one, *other);
    return move(places_along(*one, lengths_), width * other->length / one->length, *other);
  }

  std::vector<MovedNodes> moved;

 private:
  bool leads(const std::vector<int>& side) const { return side.size() > 1 || has_moved_[side[0]]; }

  bool move(const std::vector<double>& facing, double width, const Side& side) {
    std::vector<double> places = places_along(side, lengths_);
    bool is_needed = false;
    for (std::size_t i = 1; i + 1 < places.size(); ++i) {
      const double opposite = facing[i] * side.length / facing.back();
      const double place = std::clamp(places[i], opposite - width, opposite + width);
      is_needed = is_needed || place != places[i];
      places[i] = place;
    }
    if (!is_needed) return false;
    if (side.is_against[0]) {
      std::ranges::reverse(places);
      for (double& place : places) place = side.length - place;
    }
    const int edge = side.edges[0];
    lengths_[edge] = places;
    has_moved_[edge] = true;
    moved.push_back({edge, std::move(places)});
    return true;
  }

  const Model& model_;
  NodeLengths lengths_;
  std::vector<bool> has_moved_;
};

}  // namespace

std::vector<MovedNodes> face_vertices(const Model& model, const std::vector<OppositeSides>& pairs,
                                      NodeLengths lengths) {
  std::vector<const OppositeSides*> open;
  for (const OppositeSides& pair : pairs)
    if (pair.partner >= 0 && !pair.first.empty() && !pair.second.empty()) open.push_back(&pair);
  Following following(model, std::move(lengths));
  while (std::erase_if(open, [&](const OppositeSides* pair) { return following.follow(*pair); }) > 0) {
  }
  return std::move(following.moved);
}

}  // namespace paver
