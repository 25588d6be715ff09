#include "repair/mend_mesh.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "repair/find_bad.h"
#include "repair/shared_sides.h"

namespace paver {
namespace {

constexpr int most_rounds = 4;  // what mends the elements about a divided twin may make others

}  // namespace

Mended mend_mesh(const ElementJudge& judge, ElementKinds kinds, std::vector<int> bad, RegionMesh& mesh) {
  Mended mended = mend_region(judge, kinds, std::move(bad), mesh);
  for (int round = 0; kinds.triangles && round < most_rounds; ++round) {
    const std::vector<Vec3> made = divide_inner_sides(judge.region(), twin_sides(mesh, 0), mesh);
    if (made.empty()) break;
    for (Vec3 x : made) mended.places.push_back({ElementRepairKind::divided, x});
    Mended again = mend_region(judge, kinds, find_bad(judge), mesh);
    mended.left = std::move(again.left), mended.sides = std::move(again.sides);
    std::ranges::move(again.places, std::back_inserter(mended.places));
  }
  return mended;
}

}  // namespace paver
