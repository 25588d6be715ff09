// Figures of single elements, several at a time.
#pragma once

#include <vector>

#include "paver/result.h"
#include "quality/jacobian/jacobian.h"

namespace paver {

struct ElementFigures {
  double sj, area, ratio;
  Validity validity;
};

/// Figures of elements begin, begin + 1, ... below end of one kind, into figures[0], figures[1], ...
void measure_elements(const SurfaceMesh& mesh, bool is_quad, std::size_t begin, std::size_t end,
                      ElementFigures* figures);

/// Elements of one kind whose Jacobian is not proven positive, rising. Runs on the threads of the calling arena.
std::vector<int> find_invalid(const SurfaceMesh& mesh, bool is_quad);

}  // namespace paver
