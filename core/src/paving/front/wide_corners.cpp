// Steps: from the sharpest corner on, the facets by which a row inside is shorter than its boundary, less those that
// ends of rows take away; a wide corner ends rows where more than one facet is owed.
#include "paving/front/wide_corners.h"

#include <algorithm>
#include <cmath>

namespace paver {
namespace {

constexpr double deg = M_PI / 180;
constexpr double sharp = 110 * deg, widest = 136 * deg, reflex = 225 * deg;
constexpr double per_end = 2;    // facets
constexpr double most_owed = 1;  // facets: from further back corners do not follow
constexpr double sharpest = 30 * deg;

}  // namespace

std::vector<std::size_t> passed_corners(const std::vector<double>& angles) {
  std::vector<std::size_t> passed;
  const std::size_t n = angles.size(),
                    first = static_cast<std::size_t>(std::ranges::min_element(angles) - angles.begin());
  double owed = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = (first + k) % n;
    const double angle = angles[i];
    owed += 2 / std::tan(0.5 * std::max(angle, sharpest));  // of facets as long as the row is high
    if (angle < sharp) {
      owed -= per_end;
    } else if (angle < widest) {
      if (owed >= 0.5 * per_end) {
        owed -= per_end;
      } else {
        passed.push_back(i);
      }
    } else if (angle > reflex) {
      owed += per_end;
    }
    owed = std::clamp(owed, -most_owed, most_owed);
  }
  return passed;
}

}  // namespace paver
