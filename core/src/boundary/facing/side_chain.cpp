#include "boundary/facing/side_chain.h"

#include <algorithm>
#include <cmath>

namespace paver {
namespace {

constexpr double most_lean = 2.5;  // widths along the side
constexpr double sliver = 0.1;     // of the shortest edge there

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
