#include "repair/mend_mesh.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "repair/find_bad.h"
#include "repair/shared_sides.h"

namespace paver {
namespace {

constexpr int most_rounds = 4;  // what mends the elements about a twin may make others

/// `again`: of all bad elements.
void append(Mended again, Mended& mended) {
  mended.left = std::move(again.left), mended.sides = std::move(again.sides);
  std::ranges::move(again.places, std::back_inserter(mended.places));
}

/// All bad elements, those on both sides of the twins among them.
std::vector<int> bad_with(const std::vector<InnerSide>& twins, const ElementJudge& judge) {
  std::vector<int> bad = find_bad(judge);
  for (const InnerSide& side : twins)
    for (int e : {judge.mesh().across(side.a, side.b), judge.mesh().across(side.b, side.a)})
      if (e >= 0) bad.push_back(e);
  std::sort(bad.begin(), bad.end());
  bad.erase(std::unique(bad.begin(), bad.end()), bad.end());
  return bad;
}

}  // namespace

Mended mend_mesh(const ElementJudge& judge, ElementKinds kinds, std::vector<int> bad, RegionMesh& mesh) {
  Mended mended = mend_region(judge, kinds, std::move(bad), mesh);
  ElementJudge strict = judge;
  for (int round = 0; kinds.triangles && round < most_rounds; ++round) {
    const std::vector<InnerSide> twins = twin_sides(mesh);
    if (twins.empty()) break;
    for (const InnerSide& side : twins) strict.forbid(side.a, side.b);
    append(mend_region(strict, kinds, bad_with(twins, strict), mesh), mended);
    const std::vector<Vec3> made = divide_inner_sides(judge.region(), twin_sides(mesh), mesh);
    for (Vec3 x : made) mended.places.push_back({ElementRepairKind::divided, x});
    if (!made.empty()) append(mend_region(strict, kinds, find_bad(strict), mesh), mended);
  }
  return mended;
}

}  // namespace paver
