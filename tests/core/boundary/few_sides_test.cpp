// Faces of two and three sides: how many intervals the others get where one side has several, and lunes that turn.
#include <gtest/gtest.h>

#include "boundary/facing/raise_counts.h"
#include "boundary/region_loops.h"
#include "support/fake_model.h"

namespace paver {
namespace {

using Counts = std::vector<int>;

/// Of an arc, and of the one or two straight edges that close it, all of these with one interval and this wish.
Counts divided(const Model& model, int on_arc, double wish) {
  std::vector<EdgeCount> counts{{1.0 * on_arc, 1, on_arc}};
  while (counts.size() < model.edges.size()) counts.push_back({wish, 1, 1});
  divide_few_sides(model, {linked_loops(model, 0)}, counts);
  Counts result;
  for (const EdgeCount& count : counts) result.push_back(count.count);
  return result;
}

/// The first edge is an arc of this angle about the origin; its ends are joined straight, or over the origin.
Model part_of_disc(double angle, bool over_middle) {
  fake::Builder builder;
  const int a = builder.vertex({1, 0, 0}), b = builder.vertex({std::cos(angle), std::sin(angle), 0});
  builder.arc({}, 1, 0, angle, a, b);
  std::vector<Coedge> loop{builder.use(0)};
  if (over_middle) {
    const int middle = builder.vertex({0, 0, 0});
    loop.push_back(builder.use(builder.line(b, middle)));
    loop.push_back(builder.use(builder.line(middle, a)));
  } else {
    loop.push_back(builder.use(builder.line(b, a)));
  }
  builder.face(std::make_shared<fake::Plane>(Vec3{}, Vec3{1, 0, 0}, Vec3{0, 1, 0}), 0.5 * angle, {loop});
  return builder.take();
}

TEST(FewSides, RadiiOfAQuarterAreDividedWhereTheyAreLong) {
  const Model quarter = part_of_disc(fake::pi / 2, true);
  EXPECT_EQ(divided(quarter, 2, 0.9), (Counts{2, 2, 2}));
  EXPECT_EQ(divided(quarter, 2, 0.5), (Counts{2, 1, 1})) << "short against the target length";
}

TEST(FewSides, ATriangleStaysOne) { EXPECT_EQ(divided(part_of_disc(fake::pi / 3, true), 1, 0.9), (Counts{1, 1, 1})); }

TEST(FewSides, ADiameterIsDivided) { EXPECT_EQ(divided(part_of_disc(fake::pi, false), 4, 1.3), (Counts{4, 2})); }

TEST(FewSides, LeavesFacesOfFourSidesAlone) {
  EXPECT_EQ(divided(fake::polygon({{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}}), 3, 1), (Counts{3, 1, 1, 1}));
}

class Meridian : public Curve {
 public:
  explicit Meridian(double longitude) : out_{std::cos(longitude), std::sin(longitude), 0} {}
  Vec3 point(double t) const override { return std::cos(t) * out_ + Vec3{0, 0, std::sin(t)}; }
  CurveSlope slope(double t) const override { return {point(t), -std::sin(t) * out_ + Vec3{0, 0, std::cos(t)}}; }
  CurveJet jet(double t) const override { return {slope(t), -1 * point(t)}; }

 private:
  Vec3 out_;
};

/// Of a ball's unit sphere between two meridians from pole to pole.
Counts on_lune(double angle, std::vector<int> intervals) {
  constexpr double top = fake::pi / 2;
  fake::Builder builder;
  const int south = builder.vertex({0, 0, -1}), north = builder.vertex({0, 0, 1});
  for (double longitude : {0.0, angle})
    builder.edge(std::make_shared<Meridian>(longitude), -top, top, south, north, fake::pi);
  builder.face(std::make_shared<fake::Sphere>(1), 2 * angle,
               {{builder.use(1, true, {angle, -top}, {angle, top}), builder.use(0, false, {0, -top}, {0, top})}});
  const Model model = builder.take();
  std::vector<EdgeCount> counts;
  for (int n : intervals) counts.push_back({0.1, 1, n});
  divide_lunes(model, fake::pi / 4, {linked_loops(model, 0)}, counts);
  return {counts[0].count, counts[1].count};
}

TEST(Lunes, HaveThreeIntervalsWhereTheyTurnTooFarForOneElement) {
  EXPECT_EQ(on_lune(fake::pi / 2, {1, 2}), (Counts{3, 3}));
  EXPECT_EQ(on_lune(1.5 * fake::pi, {2, 2}), (Counts{3, 3})) << "the way round, not the angle of the normals";
}

TEST(Lunes, KeepTheirCountsWhereOneElementIsEnoughOrTheseAreMore) {
  EXPECT_EQ(on_lune(fake::pi / 3, {1, 2}), (Counts{1, 2}));
  EXPECT_EQ(on_lune(fake::pi / 2, {5, 4}), (Counts{5, 4}));
}

TEST(Lunes, AreNoDiscs) { EXPECT_EQ(on_lune(fake::pi, {2, 2}), (Counts{2, 2})); }

}  // namespace
}  // namespace paver
