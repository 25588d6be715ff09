#include "boundary/facing/side_chain.h"

#include <algorithm>
#include <cmath>

namespace paver {
namespace {

constexpr double most_lean = 2.5;  // widths along the side
constexpr double sliver = 0.1;     // of the shortest edge there
constexpr double rim_lean = 1;     // widths along a rim: how far two vertices may lean that both rims are cut at
constexpr std::size_t most_on_rims = 100;  // edges: so that all pairs of vertices can be looked at

std::optional<SideChain> chain_of(const Model& model, const std::vector<int>& edges) {
  SideChain chain{edges, {}, 0};
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Edge& edge = model.edges[edges[i]];
    if (edge.start == edge.end) return {};
    chain.length += edge.length;
    auto touches = [&](int vertex, const Edge& other) { return vertex == other.start || vertex == other.end; };
    if (i + 1 < edges.size())
      chain.is_against.push_back(touches(edge.start, model.edges[edges[i + 1]]));
    else
      chain.is_against.push_back(i > 0 && touches(edge.end, model.edges[edges[i - 1]]));
  }
  return chain;
}

Vec3 start_of(const Model& model, const SideChain& chain) {
  const Edge& edge = model.edges[chain.edges[0]];
  return model.vertices[chain.is_against[0] ? edge.end : edge.start];
}

/// Round a rim; none where the edges do not close.
std::optional<SideChain> closed_chain(const Model& model, const std::vector<int>& edges) {
  for (bool is_against : {false, true}) {
    const Edge& first = model.edges[edges[0]];
    const int start = is_against ? first.end : first.start;
    SideChain chain{edges, {}, 0};
    int at = start;
    for (int e : edges) {
      const Edge& edge = model.edges[e];
      chain.is_against.push_back(chain.is_against.empty() ? is_against : edge.start != at);
      if ((chain.is_against.back() ? edge.end : edge.start) != at) at = -1;
      if (at >= 0) at = chain.is_against.back() ? edge.start : edge.end;
      chain.length += edge.length;
    }
    if (at == start) return chain;
  }
  return {};
}

/// So that edge `i` is the first.
void begin_with(std::size_t i, SideChain& rim) {
  const auto place = static_cast<std::ptrdiff_t>(i);
  std::rotate(rim.edges.begin(), rim.edges.begin() + place, rim.edges.end());
  std::rotate(rim.is_against.begin(), rim.is_against.begin() + place, rim.is_against.end());
}

/// At a share of the length.
Vec3 point_at(const Model& model, const SideChain& chain, double share) {
  double rest = share * chain.length;
  std::size_t i = 0;
  for (; i + 1 < chain.edges.size() && rest > model.edges[chain.edges[i]].length; ++i)
    rest -= model.edges[chain.edges[i]].length;
  const Edge& edge = model.edges[chain.edges[i]];
  return edge.curve->point(edge.parameter(chain.is_against[i] ? 1 - rest / edge.length : rest / edge.length));
}

/// A single edge does not tell which way it runs beside the other side.
void turn_along(const Model& model, const SideChain& other, SideChain& single) {
  auto apart = [&] {
    return norm(start_of(model, single) - start_of(model, other)) +
           norm(end_of_edge(model, single, single.edges.size() - 1) -
                end_of_edge(model, other, other.edges.size() - 1));
  };
  const double as_it_is = apart();
  single.is_against[0] = !single.is_against[0];
  if (apart() >= as_it_is) single.is_against[0] = !single.is_against[0];
}

/// Of a side of a narrow face, how far its breaks are known.
class Walk {
 public:
  Walk(const Model& model, const SideChain& side) : model_(model), side_(side), place_(length_of(0)) {}

  bool is_done() const { return edge_ + 1 == side_.edges.size(); }
  double place() const { return place_; }  ///< where its edge ends
  Vec3 vertex() const { return end_of_edge(model_, side_, edge_); }
  double shortest() const { return std::min(length_of(edge_), length_of(edge_ + 1)); }
  void go_on() { place_ += length_of(++edge_); }

 private:
  double length_of(std::size_t i) const { return model_.edges[side_.edges[i]].length; }

  const Model& model_;
  const SideChain& side_;
  std::size_t edge_ = 0;
  double place_;
};

}  // namespace

bool are_alike(double one, double other) {
  constexpr double most_unlike = 0.1;  // of the longer side
  return std::fabs(one - other) <= most_unlike * std::max(one, other);
}

Vec3 end_of_edge(const Model& model, const SideChain& chain, std::size_t i) {
  const Edge& edge = model.edges[chain.edges[i]];
  return model.vertices[chain.is_against[i] ? edge.start : edge.end];
}

std::optional<ChainPair> chains_of(const Model& model, const OppositeSides& pair) {
  if (pair.first.empty() || pair.second.empty()) return {};
  std::optional<SideChain> first = chain_of(model, pair.first), second = chain_of(model, pair.second);
  if (!first || !second) return {};
  if (!are_alike(first->length, second->length)) return {};
  if (first->edges.size() == 1) turn_along(model, *second, *first);
  if (second->edges.size() == 1) turn_along(model, *first, *second);
  return ChainPair{std::move(*first), std::move(*second)};
}

std::optional<ChainPair> rims_of(const Model& model, const OppositeSides& pair) {
  if (pair.first.empty() || pair.second.empty() || pair.first.size() + pair.second.size() > most_on_rims) return {};
  std::optional<SideChain> first = closed_chain(model, pair.first), second = closed_chain(model, pair.second);
  if (!first || !second) return {};
  return ChainPair{std::move(*first), std::move(*second)};
}

void turn_round(SideChain& side) {
  std::reverse(side.edges.begin(), side.edges.end());
  std::reverse(side.is_against.begin(), side.is_against.end());
  side.is_against.flip();
}

std::optional<ChainPair> facing_rims_of(const Model& model, const OppositeSides& pair, double width) {
  std::optional<ChainPair> rims = rims_of(model, pair);
  if (!rims) return {};
  double nearest = width * std::sqrt(1 + rim_lean * rim_lean);
  std::optional<std::pair<std::size_t, std::size_t>> cut;
  for (std::size_t i = 0; i < pair.first.size(); ++i)
    for (std::size_t k = 0; k < pair.second.size(); ++k) {
      const double apart = norm(end_of_edge(model, rims->first, i) - end_of_edge(model, rims->second, k));
      if (apart < nearest) nearest = apart, cut = {i, k};
    }
  if (!cut) return {};
  begin_with((cut->first + 1) % pair.first.size(), rims->first);
  begin_with((cut->second + 1) % pair.second.size(), rims->second);
  const Vec3 quarter = point_at(model, rims->first, 0.25);
  if (norm(point_at(model, rims->second, 0.75) - quarter) < norm(point_at(model, rims->second, 0.25) - quarter))
    turn_round(rims->second);
  return rims;
}

std::vector<Break> breaks_between(const Model& model, const ChainPair& sides, double width) {
  const double reach = width * std::sqrt(1 + most_lean * most_lean);
  std::vector<Break> breaks;
  Break facing;  // the last such
  Walk first(model, sides.first), second(model, sides.second);
  while (!first.is_done() || !second.is_done()) {
    const double along = first.place() - facing.first, other_along = second.place() - facing.second;
    const bool is_facing = !first.is_done() && !second.is_done() &&
                           (norm(first.vertex() - second.vertex()) <= reach ||
                            std::fabs(along - other_along) <= sliver * std::min(first.shortest(), second.shortest()));
    const bool is_first = !first.is_done() && (second.is_done() || along < other_along);
    breaks.push_back({is_facing || is_first ? first.place() : facing.first + other_along,
                      is_facing || !is_first ? second.place() : facing.second + along, is_facing || is_first,
                      is_facing || !is_first});
    if (is_facing) facing = breaks.back();
    if (breaks.back().is_of_first) first.go_on();
    if (breaks.back().is_of_second) second.go_on();
  }
  breaks.push_back({first.place(), second.place()});
  return breaks;
}

}  // namespace paver
