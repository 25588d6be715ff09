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

/// Collective: the values that the ranks give, by rank.
template <class T>
std::vector<T> gather_all(const std::vector<T>& mine, Ranks& ranks) {
  if (ranks.count() == 1) return mine;
  std::vector<T> all;
  for (std::string& bytes : ranks.gather(pack(mine))) {
    for (T& value : unpack<std::vector<T>>(bytes)) all.push_back(std::move(value));
    bytes = {};
  }
  return all;
}

/// Collective: mine[r] is for rank r; what each has for this one, by rank.
template <class T>
std::vector<std::vector<T>> exchange_all(const std::vector<std::vector<T>>& mine, Ranks& ranks) {
  std::vector<std::string> packed;
  for (const std::vector<T>& some : mine) packed.push_back(pack(some));
  std::vector<std::vector<T>> theirs;
  for (std::string& bytes : ranks.exchange(packed)) {
    theirs.push_back(unpack<std::vector<T>>(bytes));
    bytes = {};
  }
  return theirs;
}

/// Collective: each value goes to rank number(value) modulo their count; those for this one, by the rank they come
/// from.
template <class T, class Number>
std::vector<T> deal(const std::vector<T>& mine, Ranks& ranks, Number number) {
  if (ranks.count() == 1) return mine;
  std::vector<std::vector<T>> by_rank(static_cast<std::size_t>(ranks.count()));
  for (const T& value : mine) by_rank[number(value) % ranks.count()].push_back(value);
  std::vector<T> here;
  for (const std::vector<T>& some : exchange_all(by_rank, ranks)) here.insert(here.end(), some.begin(), some.end());
  return here;
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
