// Inverse and product of the small matrices behind the tables of jacobian.h, in long double so that the tables are
// exact to the last digits of a double.
#include "quality/jacobian/dense.h"

#include <cmath>
#include <utility>

namespace paver {
namespace {

int pivot_row(const Dense& m, int column) {
  int best = column;
  for (int r = column + 1; r < m.n; ++r) {
    if (std::fabs(m.at(r, column)) > std::fabs(m.at(best, column))) best = r;
  }
  return best;
}

void swap_rows(Dense& m, int r, int s) {
  for (int c = 0; c < m.n; ++c) std::swap(m.at(r, c), m.at(s, c));
}

/// Row `to` plus factor times row `from`.
void add_row(Dense& m, int to, int from, long double factor) {
  for (int c = 0; c < m.n; ++c) m.at(to, c) += factor * m.at(from, c);
}

}  // namespace

Dense inverse(Dense m) {
  Dense result(m.n);
  for (int i = 0; i < m.n; ++i) result.at(i, i) = 1;
  for (int k = 0; k < m.n; ++k) {
    int best = pivot_row(m, k);
    swap_rows(m, k, best);
    swap_rows(result, k, best);
    long double scale = 1 / m.at(k, k);
    add_row(result, k, k, scale - 1);
    add_row(m, k, k, scale - 1);
    for (int r = 0; r < m.n; ++r) {
      if (r == k) continue;
      long double factor = -m.at(r, k);
      add_row(result, r, k, factor);
      add_row(m, r, k, factor);
    }
  }
  return result;
}

Dense product(const Dense& a, const Dense& b) {
  Dense result(a.n);
  for (int i = 0; i < a.n; ++i) {
    for (int k = 0; k < a.n; ++k) {
      for (int j = 0; j < a.n; ++j) result.at(i, j) += a.at(i, k) * b.at(k, j);
    }
  }
  return result;
}

}  // namespace paver
