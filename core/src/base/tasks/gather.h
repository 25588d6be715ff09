// What all ranks have, on all of them.
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/box.h"
#include "base/packing.h"
#include "paver/error.h"
#include "paver/ranks.h"

namespace paver {

/// Collective: of the values that the ranks give, by rank, those that are wanted here.
template <class T, class Wanted>
std::vector<T> gather_wanted(const std::vector<T>& mine, Ranks& ranks, Wanted is_wanted) {
  std::vector<T> wanted;
  for (std::string& bytes : ranks.gather(pack(mine))) {
    for (T& value : unpack<std::vector<T>>(bytes))
      if (is_wanted(value)) wanted.push_back(std::move(value));
    bytes = {};
  }
  return wanted;
}

/// Collective: the values that the ranks give, by rank.
template <class T>
std::vector<T> gather_all(const std::vector<T>& mine, Ranks& ranks) {
  if (ranks.count() == 1) return mine;
  return gather_wanted(mine, ranks, [](const T&) { return true; });
}

/// Collective.
double greatest(double mine, Ranks& ranks);

/// Collective: each box grows by those at its place on all ranks. Zeros may get the other sign.
void unite(std::vector<Box>& boxes, Ranks& ranks);

/// An error as bytes for other ranks, never empty.
std::string pack_error(const Error& error);
[[noreturn]] void throw_packed(std::string_view bytes);

/// Collective: calls `work`, and when it throws an Error on any rank, all ranks throw that of the lowest such rank. So
/// no rank waits for one that has given up. `work` itself must call nothing collective.
void do_together(Ranks& ranks, const std::function<void()>& work);

}  // namespace paver
