// What a search over pairs found.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "base/tasks/gather.h"
#include "check/near/near_search.h"

namespace paver {

/// One place for each pair of numbers: the first by its key(). `Place`, trivially copyable, has that and its `pair`.
template <class Place>
class FoundPlaces {
 public:
  using Pair = std::array<int, 2>;

  void add(const Place& place) {
    const auto [known, is_new] = by_pair_.try_emplace(place.pair, place);
    if (!is_new && place.key() < known->second.key()) known->second = place;
  }
  void add(const FoundPlaces& others) {
    for (const auto& [pair, place] : others.by_pair_) add(place);
  }
  /// Or none.
  const Place* of(Pair pair) const {
    const auto known = by_pair_.find(pair);
    return known == by_pair_.end() ? nullptr : &known->second;
  }
  /// In the order of their pairs.
  std::vector<Place> list() const {
    std::vector<Place> places;
    for (const auto& [pair, place] : by_pair_) places.push_back(place);
    return places;
  }

 private:
  std::map<Pair, Place> by_pair_;
};

/// Collective: what kind.compare(found, a, b, order) finds on all ranks.
template <class Place, class Kind>
std::vector<Place> find_places(const Kind& kind, const MeshPieces& pieces, Ranks& ranks) {
  using Found = FoundPlaces<Place>;
  auto compare = [&](Found& found, const Piece& a, const Piece& b, const PairOrder& order) {
    kind.compare(found, a, b, order);
  };
  Found found = NearSearch(kind, pieces, ranks).template run<Found>(compare);
  for (const Place& place : gather_all(found.list(), ranks)) found.add(place);
  return found.list();
}

}  // namespace paver
