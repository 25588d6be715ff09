// What all ranks have, on all of them.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "paver/ranks.h"

namespace paver {

/// Collective: the values that the ranks give, by rank.
template <class T>
std::vector<T> gather_all(const std::vector<T>& mine, Ranks& ranks) {
  if (ranks.count() == 1) return mine;
  std::vector<T> all;
  for (const std::string& bytes : ranks.gather(bytes_of(mine))) {
    const std::vector<T> theirs = from_bytes<T>(bytes);
    all.insert(all.end(), theirs.begin(), theirs.end());
  }
  return all;
}

/// Collective.
template <class T>
T greatest(T mine, Ranks& ranks) {
  return std::ranges::max(gather_all(std::vector<T>{mine}, ranks));
}

}  // namespace paver
