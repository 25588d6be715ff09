#include <algorithm>

#include "paver/mesher.h"

namespace paver {

int RowNumbers::row_of(long number) const {
  if (number < whole_rows) return static_cast<int>(number);
  const auto at = std::lower_bound(list.begin(), list.end(), number);
  return at != list.end() && *at == number ? static_cast<int>(at - list.begin()) : -1;
}

ShareNumbers whole_numbers(const SurfaceMesh& mesh) {
  ShareNumbers numbers;
  numbers.nodes = numbers.node_number.whole_rows = static_cast<long>(mesh.nodes.size());
  numbers.quads = numbers.quad_number.whole_rows = static_cast<long>(mesh.quad_count());
  numbers.triangles = numbers.triangle_number.whole_rows = static_cast<long>(mesh.triangle_count());
  return numbers;
}

}  // namespace paver
