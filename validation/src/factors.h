// Factors of a matrix: by the same code of Eigen, compiled for several kinds of processors.
#pragma once

#include <vector>

#include "moments.h"

namespace paver::validation {

/// P A = L U. Takes the matrix over and keeps its factors in its place.
class Factors {
 public:
  explicit Factors(Matrix matrix);
  Eigen::MatrixXcd solve(const Eigen::MatrixXcd& given) const;

 private:
  Matrix factors_;
  std::vector<int> places_;  // of the matrix's rows in P A
};

}  // namespace paver::validation
