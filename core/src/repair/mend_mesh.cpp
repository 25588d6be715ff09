#include "repair/mend_mesh.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "repair/edits/patch.h"
#include "repair/find_bad.h"
#include "repair/shared_sides.h"

namespace paver {
namespace {

constexpr int most_rounds = 4;  // what mends the elements about a twin may make others

void append(Mended again, Mended& mended) {
  mended.left = std::move(again.left), mended.sides = std::move(again.sides);
  std::ranges::move(again.places, std::back_inserter(mended.places));
}

/// The elements on both sides of each.
std::vector<int> elements_at(const std::vector<InnerSide>& sides, const RegionMesh& mesh) {
  std::vector<int> found;
  for (const InnerSide& side : sides)
    for (int e : {mesh.across(side.a, side.b), mesh.across(side.b, side.a)})
      if (e >= 0) found.push_back(e);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace

Mended mend_mesh(const ElementJudge& judge, ElementKinds kinds, std::vector<int> bad, RegionMesh& mesh) {
  Mended mended = mend_region(judge, kinds, std::move(bad), mesh);
  ElementJudge strict = judge;
  for (int round = 0; kinds.triangles && round < most_rounds; ++round) {
    const std::vector<InnerSide> twins = twin_sides(mesh, 0);
    if (twins.empty()) break;
    for (const InnerSide& side : twins) strict.forbid(side.a, side.b);
    append(mend_region(strict, kinds, elements_at(twins, mesh), mesh), mended);
    const std::vector<Vec3> made = divide_inner_sides(judge.region(), twin_sides(mesh, 0), mesh);
    if (made.empty()) continue;
    for (Vec3 x : made) mended.places.push_back({ElementRepairKind::divided, x});
    append(mend_region(strict, kinds, find_bad(strict), mesh), mended);
  }
  return mended;
}

}  // namespace paver
