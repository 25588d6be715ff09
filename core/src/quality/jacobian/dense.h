// Small dense matrices for building tables; not for the hot path.
#pragma once

#include <cstddef>
#include <vector>

namespace paver {

/// n x n, row by row.
struct Dense {
  explicit Dense(int size) : n(size), a(static_cast<std::size_t>(size) * size) {}
  long double& at(int row, int column) { return a[static_cast<std::size_t>(row) * n + column]; }
  long double at(int row, int column) const { return a[static_cast<std::size_t>(row) * n + column]; }
  std::vector<double> rounded() const { return {a.begin(), a.end()}; }
  std::vector<double> rounded_columns() const {
    std::vector<double> columns;
    for (int column = 0; column < n; ++column)
      for (int row = 0; row < n; ++row) columns.push_back(static_cast<double>(at(row, column)));
    return columns;
  }

  int n;
  std::vector<long double> a;
};

/// Gauss-Jordan with row exchange. The matrix must be regular.
Dense inverse(Dense m);

Dense product(const Dense& a, const Dense& b);

}  // namespace paver
