// Sides inside narrow faces must not cross the curved edges beside them.
#include "curving/edge_bulges.h"

#include <gtest/gtest.h>

#include <random>

#include "quality/jacobian/jacobian.h"

namespace paver {
namespace {

/// Between two edges that leave their chords; divided by the diagonal from the first one's start to the other's end.
struct Strip {
  double width_at_start, width_at_end, bulge, other_bulge;

  std::array<Vec3, 4> corners() const {
    return {{{0, 0, 0}, {10, 0, 0}, {10, width_at_end, 0}, {0, width_at_start, 0}}};
  }
  Vec3 middle() const { return {5, bulge, 0}; }
  Vec3 other_middle() const { return {5, 0.5 * (width_at_start + width_at_end) + other_bulge, 0}; }
  Vec3 diagonal_by(Vec3 off) const { return 0.5 * (corners()[0] + corners()[2]) + off; }

  Beside beside() const {
    const auto x = corners();
    EdgeBulges bulges;
    bulges.add(0, x[0], 1, x[1], middle());
    bulges.add(3, x[3], 2, x[2], other_middle());
    return bulges.beside({{}, x[0], {}, 1, 0}, {{}, x[2], {}, 1, 2});
  }
  /// Whether both halves are elements.
  bool is_divided_by(Vec3 diagonal) const {
    const auto [a, b, c, d] = corners();
    const Vec3 one[] = {a, b, c, middle(), 0.5 * (b + c), diagonal};
    const Vec3 other[] = {a, c, d, diagonal, other_middle(), 0.5 * (d + a)};
    const JacobianForm form(ElementShape::triangle, 2);
    return form.is_valid(one) && form.is_valid(other);
  }
};

TEST(EdgeBulges, DiagonalsStayBetweenTheEdgesOfNarrowFaces) {
  const Strip strip{1e-3, 1e-3, 0.4, 0.4};
  EXPECT_FALSE(strip.is_divided_by(strip.diagonal_by({})));
  EXPECT_TRUE(strip.is_divided_by(strip.diagonal_by(strip.beside().bulge)));
  EXPECT_NEAR(strip.beside().width, 1e-3, 1e-9);
}

TEST(EdgeBulges, DivideStripsWhoseWidthsAndBulgesDiffer) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> width(0.001, 0.02), share(-0.45, 0.45);
  for (int i = 0; i < 200; ++i) {
    Strip strip{width(random), width(random), 0.3, 0};
    strip.other_bulge = strip.bulge + 0.5 * (strip.width_at_start + strip.width_at_end) * share(random);
    EXPECT_TRUE(strip.is_divided_by(strip.diagonal_by(strip.beside().bulge))) << i;
  }
}

TEST(EdgeBulges, LeaveSidesStraightThatRunElsewhere) {
  EdgeBulges bulges;
  bulges.add(0, {0, 0, 0}, 1, {10, 0, 0}, {5, 1, 0});
  const SideEnd start{{}, {0, 0, 0}, {}, 1, 0}, end{{}, {10, 0, 0}, {}, 1, 1};
  EXPECT_EQ(norm(bulges.beside(start, {{}, {0, 10, 0}, {}, 1, -1}).bulge), 0);
  EXPECT_EQ(norm(bulges.beside(start, end).bulge), 0);  // another side between the same nodes
  EXPECT_GT(norm(bulges.beside(start, {{}, {10, 1, 0}, {}, 1, -1}).bulge), 0.8);
}

}  // namespace
}  // namespace paver
