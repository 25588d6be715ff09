// orientation() against 128-bit integers, on points in line but for the last bits.
#include "base/predicates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace paver {
namespace {

__extension__ typedef __int128 Wide;

int sign(double v) { return (v > 0) - (v < 0); }

/// Sign of the determinant of whole numbers below 2^61, exactly.
int exact_sign(Vec2 a, Vec2 b, Vec2 c) {
  auto whole = [](double v) { return static_cast<Wide>(v); };
  Wide left = (whole(a.x) - whole(c.x)) * (whole(b.y) - whole(c.y));
  Wide right = (whole(a.y) - whole(c.y)) * (whole(b.x) - whole(c.x));
  return (left > right) - (left < right);
}

void expect_exact(Vec2 a, Vec2 b, Vec2 c, double scale) {
  int expected = exact_sign(a, b, c);
  Vec2 p = scale * a, q = scale * b, r = scale * c;
  EXPECT_EQ(sign(orientation(p, q, r)), expected);
  EXPECT_EQ(sign(orientation(q, r, p)), expected);
  EXPECT_EQ(sign(orientation(r, p, q)), expected);
  EXPECT_EQ(sign(orientation(q, p, r)), -expected);
  EXPECT_EQ(sign(orientation(p, r, q)), -expected);
}

TEST(Orientation, PlainCasesAndZero) {
  EXPECT_GT(orientation({0, 0}, {1, 0}, {0, 1}), 0);
  EXPECT_LT(orientation({0, 0}, {0, 1}, {1, 0}), 0);
  EXPECT_EQ(orientation({0, 0}, {1, 1}, {2, 2}), 0);
  EXPECT_EQ(orientation({3, 5}, {3, 5}, {7, 1}), 0);
  EXPECT_EQ(orientation({0.1, 0.1}, {0.2, 0.2}, {0.3, 0.3}), 0);
  EXPECT_NE(orientation({0, 0}, {0.1, 0.3}, {0.2, 0.6000000000000001}), 0);
}

// The classic picture: a grid of single bits about a point that lies on the line through the two others.
TEST(Orientation, IsExactOnAGridOfLastBits) {
  const double bit = 0x1p-53;
  int zeros = 0;
  for (int i = 0; i < 64; ++i)
    for (int j = 0; j < 64; ++j) {
      Vec2 p{0.5 + i * bit, 0.5 + j * bit}, q{12, 12}, r{24, 24};
      // In units of a bit all are whole; the line is the diagonal, so the sign is that of j - i.
      ASSERT_EQ(sign(orientation(p, q, r)), (j > i) - (j < i)) << i << " " << j;
      zeros += i == j;
    }
  EXPECT_EQ(zeros, 64);
}

TEST(Orientation, IsExactOnNearlyStraightTriplesOfAnySize) {
  std::mt19937_64 random(1);
  auto whole = [&](int bits) { return std::ldexp(static_cast<double>(random() >> 11), bits - 53); };
  for (int i = 0; i < 20000; ++i) {
    int bits = 20 + static_cast<int>(random() % 33);
    Vec2 a{std::floor(whole(bits)), std::floor(whole(bits))}, b{std::floor(whole(bits)), std::floor(whole(bits))};
    double t = whole(1);
    Vec2 c{std::floor(a.x + t * (b.x - a.x)), std::floor(a.y + t * (b.y - a.y))};
    c = c + Vec2{static_cast<double>(random() % 3) - 1, static_cast<double>(random() % 3) - 1};
    double scale = std::ldexp(1.0, static_cast<int>(random() % 400) - 200);
    expect_exact(a, b, c, scale);
    if (HasFailure()) return;
  }
}

TEST(Orientation, IsExactWhereCoordinatesDifferByManyOrders) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 20000; ++i) {
    auto number = [&] {  // whole, with 1 to 53 leading bits and up to 2^59
      double v = static_cast<double>((random() >> 11) >> (random() % 53));
      return (random() % 2 ? 1 : -1) * std::ldexp(v, static_cast<int>(random() % 6));
    };
    Vec2 a{number(), number()}, b{number(), number()};
    Vec2 c = random() % 2 ? Vec2{2 * b.x - a.x, 2 * b.y - a.y} : Vec2{number(), number()};
    if (std::max({std::fabs(c.x), std::fabs(c.y)}) > 0x1p60) continue;
    expect_exact(a, b, c, 1);
    if (HasFailure()) return;
  }
}

TEST(InCircle, DecidesClearCasesAndSaysNoToDoubtfulOnes) {
  Vec2 a{1, 0}, b{0, 1}, c{-1, 0};
  EXPECT_TRUE(in_circle(a, b, c, {0, 0}));
  EXPECT_TRUE(in_circle(a, b, c, {0, -0.999}));
  EXPECT_FALSE(in_circle(a, b, c, {0, -1.001}));
  EXPECT_FALSE(in_circle(a, b, c, {0, -1}));
  EXPECT_FALSE(in_circle(a, b, c, {0.6, -0.8}));
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(0, 6.283185307179586);
  for (int i = 0; i < 1000; ++i) {  // four points of one circle: never both diagonals at once, or flips would not end
    std::vector<double> t{angle(random), angle(random), angle(random), angle(random)};
    std::sort(t.begin(), t.end());
    std::vector<Vec2> p;
    for (double s : t) p.push_back({1e3 + std::cos(s), 1e3 + std::sin(s)});
    EXPECT_FALSE(in_circle(p[0], p[1], p[2], p[3]) && in_circle(p[1], p[2], p[3], p[0]));
  }
}

}  // namespace
}  // namespace paver
