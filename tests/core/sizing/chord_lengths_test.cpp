#include "sizing/chord_lengths.h"

#include <gtest/gtest.h>

namespace paver {
namespace {

std::vector<FaceReport> faces_off(std::vector<double> distances) {
  std::vector<FaceReport> faces;
  for (double distance : distances) {
    FaceReport& face = faces.emplace_back();
    face.name = "Face" + std::to_string(faces.size());
    face.distance.largest = distance;
    face.quads = 100;
  }
  return faces;
}

/// A square of this side on the first face.
FarPlace square_off(double distance, double side, double target) {
  return {0, 4, distance, target, {Vec3{}, Vec3{side, 0, 0}, Vec3{side, side, 0}, Vec3{0, side, 0}}};
}

TEST(ChordLengths, OnlyFacesThatAreTooFarOffGetShorterOnes) {
  ChordLengths lengths(0.1, 2);
  std::vector<FaceReport> faces = faces_off({0.05, 0.8, 0.1, 5});
  faces[3].status = FaceStatus::failed;
  const std::vector<LocalSize> next = lengths.next(faces, {10, 10, 10, 10}, {}).faces;
  ASSERT_EQ(next.size(), 1u);
  EXPECT_EQ(next[0].part, "Face2");
  EXPECT_NEAR(*next[0].size, 0.9 * 0.5 * 10, 1e-12);  // a third power
  const ShorterLengths first_order = ChordLengths(0.2, 1).next(faces, {10, 10, 10, 10}, {});
  EXPECT_NEAR(*first_order.faces[0].size, 0.9 * 0.5 * 10, 1e-12);  // a square
}

TEST(ChordLengths, FewPlacesGetThemAlone) {
  ChordLengths lengths(0.1, 2);
  const ShorterLengths next = lengths.next(faces_off({0.8}), {10}, {square_off(0.8, 10, 10)});
  EXPECT_TRUE(next.faces.empty());
  ASSERT_EQ(next.places.size(), 6u);  // sides and lines between their middles
  for (const SizeSource& place : next.places) {
    EXPECT_LE(place.value, 0.8 * 0.5 * 10);
    EXPECT_GT(place.value, 0.3 * 10);
  }
}

TEST(ChordLengths, APlaceThatIsShortEnoughGetsNoLongerOne) {
  ChordLengths lengths(0.1, 2);
  const FarPlace near = square_off(0.051, 10, 10);
  const ShorterLengths next = lengths.next(faces_off({0.8}), {10}, {near, square_off(0.8, 10, 10)});
  for (const SizeSource& place : next.places) EXPECT_LT(place.value, 10);
}

TEST(ChordLengths, ManyPlacesAreTheirFace) {
  ChordLengths lengths(0.1, 2);
  const ShorterLengths next = lengths.next(faces_off({0.8}), {10}, std::vector(100, square_off(0.8, 10, 10)));
  EXPECT_EQ(next.faces.size(), 1u);
  EXPECT_TRUE(next.places.empty());
}

TEST(ChordLengths, ASetOfFacesGetsThatOfItsFirst) {
  std::vector<FaceReport> faces = faces_off({1});
  faces[0].name = "Face3 + Face9";
  EXPECT_EQ(ChordLengths(0.1, 2).next(faces, {1}, {}).faces[0].part, "Face3");
}

TEST(ChordLengths, EndWhateverTheMeshDoes) {
  ChordLengths lengths(0.1, 2);
  double length = 10;
  int rounds = 0;
  for (; rounds < 100; ++rounds) {
    const ShorterLengths next = lengths.next(faces_off({1}), {length}, {});
    if (next.is_empty()) break;
    EXPECT_LT(*next.faces[0].size, length);
    length = *next.faces[0].size;
  }
  EXPECT_LT(rounds, 13);
  EXPECT_NE(lengths.note(faces_off({1})).find("Face1 is up to 1 mm"), std::string::npos);
  EXPECT_EQ(lengths.note(faces_off({0.1})), "");
}

}  // namespace
}  // namespace paver
