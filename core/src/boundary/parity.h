// Interval counts made even loop by loop, for the whole model at once.
#pragma once

#include <vector>

namespace paver {

/// Interval count of one edge while it is being chosen.
struct EdgeCount {
  double wish = 0;        ///< integral of ds/h
  int minimum = 1;        ///< least count allowed
  int count = 0;          ///< 0: not divided (degenerate or unused); left alone
  bool is_tied = false;   ///< sides of a face agree because of it: others change first
  bool is_short = false;  ///< not as long as the target length: its turn alone asks for more than one
};

/// So many intervals at least, from now on.
void raise_to(EdgeCount& edge, int count);

/// Two intervals at least, where it is divided at all.
void want_two(EdgeCount& edge);

bool are_divided(const std::vector<int>& edges, const std::vector<EdgeCount>& counts);
long sum_of_counts(const std::vector<int>& edges, const std::vector<EdgeCount>& counts);

/// Changes counts by one so that the loops come out even: `loop_edges` lists the edges of each loop, an edge once per
/// use. Which edges change is a T-join on the graph whose nodes are loops and whose arcs are the edges between them
/// (edges of one loop only lead to the outside, which takes any parity); odd loops are paired by least relative change.
/// An entry of `counts` may stand for several edges that change together: `loop_edges` then lists it for each of them.
/// Edges of one interval change last, and only when they are longer than 0.7 h.
/// With `may_split_short` those too, after everything else. Gives the number of loops that stay odd. Ties are broken by
/// index.
int even_out_loops(const std::vector<std::vector<int>>& loop_edges, std::vector<EdgeCount>& counts,
                   bool may_split_short = false);

}  // namespace paver
