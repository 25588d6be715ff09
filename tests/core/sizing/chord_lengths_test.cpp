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
  }
  return faces;
}

TEST(ChordLengths, OnlyFacesThatAreTooFarOffGetShorterOnes) {
  ChordLengths lengths(0.1, 2);
  std::vector<FaceReport> faces = faces_off({0.05, 0.8, 0.1, 5});
  faces[3].status = FaceStatus::failed;
  const std::vector<LocalSize> next = lengths.next(faces, {10, 10, 10, 10});
  ASSERT_EQ(next.size(), 1u);
  EXPECT_EQ(next[0].part, "Face2");
  EXPECT_NEAR(*next[0].size, 0.9 * 0.5 * 10, 1e-12);                                                // a third power
  EXPECT_NEAR(*ChordLengths(0.2, 1).next(faces, {10, 10, 10, 10})[0].size, 0.9 * 0.5 * 10, 1e-12);  // a square
}

TEST(ChordLengths, ASetOfFacesGetsThatOfItsFirst) {
  std::vector<FaceReport> faces = faces_off({1});
  faces[0].name = "Face3 + Face9";
  EXPECT_EQ(ChordLengths(0.1, 2).next(faces, {1})[0].part, "Face3");
}

TEST(ChordLengths, EndWhateverTheMeshDoes) {
  ChordLengths lengths(0.1, 2);
  double length = 10;
  int rounds = 0;
  for (; rounds < 100; ++rounds) {
    const std::vector<LocalSize> next = lengths.next(faces_off({1}), {length});
    if (next.empty()) break;
    EXPECT_LT(*next[0].size, length);
    length = *next[0].size;
  }
  EXPECT_LT(rounds, 9);
  EXPECT_NE(lengths.note(faces_off({1})).find("Face1 is up to 1 mm"), std::string::npos);
  EXPECT_EQ(lengths.note(faces_off({0.1})), "");
}

}  // namespace
}  // namespace paver
