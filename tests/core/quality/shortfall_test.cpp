#include <gtest/gtest.h>

#include "core/quality/wavy_mesh.h"

namespace paver {
namespace {

TEST(Shortfall, IsNothingWhenEveryFaceIsMeshed) { EXPECT_FALSE(shortfall(fake::WavyMesh(1, 4, 0).result())); }

TEST(Shortfall, NamesFacesReasonsAndTheFirstPlace) {
  MeshResult result = fake::WavyMesh(1, 4, 0).result();
  result.report.faces[1].status = FaceStatus::failed;
  result.report.faces[1].stage = "paving";
  result.report.faces[1].reason = "no room.";
  result.report.faces[1].where = Vec3{1, 2, 3};
  auto error = shortfall(result);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->code(), ErrorCode::face_failed);
  EXPECT_STREQ(error->what(),
               "1 of 2 faces could not be meshed, the mesh of the others is delivered: Face2 (paving: no room).");
  EXPECT_EQ(error->where().face, 1);
  EXPECT_EQ(error->where().stage, "paving");
  EXPECT_EQ(error->where().point.value().z, 3);
}

TEST(Shortfall, IsNoFacesWhenNoneHasAnArea) {
  MeshResult result;
  result.report.faces.resize(3);
  for (FaceReport& face : result.report.faces) face.status = FaceStatus::no_area;
  EXPECT_EQ(shortfall(result).value().code(), ErrorCode::no_faces);
}

TEST(Shortfall, NamesSolidsWithoutAnOutside) {
  MeshResult result = fake::WavyMesh(1, 4, 0).result();
  result.report.model.one_sided = {"Solid2"};
  auto error = shortfall(result);
  ASSERT_TRUE(error);
  EXPECT_EQ(exit_code(error->code()), 4);
  EXPECT_NE(std::string(error->what()).find("of Solid2 cannot"), std::string::npos);
  EXPECT_STREQ(verdict(result.report), "faulty");
}

TEST(Shortfall, NamesCurvesFarOffTheirFaces) {
  MeshResult result = fake::WavyMesh(1, 4, 0).result();
  result.report.target_length = 2;
  result.report.model.diagonal = 100;
  result.report.model.stray_edges = {"Edge3", "Edge7"};
  result.report.model.curve_distance = 0.49;
  EXPECT_FALSE(shortfall(result));
  result.report.model.curve_distance = 0.51;
  auto error = shortfall(result);
  ASSERT_TRUE(error);
  EXPECT_EQ(exit_code(error->code()), 4);
  EXPECT_NE(std::string(error->what()).find("0.51 mm off faces that use them (Edge3, Edge7), so"), std::string::npos);
  EXPECT_STREQ(verdict(result.report), "faulty");
  result.report.target_length = 1e6;
  EXPECT_FALSE(shortfall(result));
  result.report.model.curve_distance = 1.3;
  EXPECT_TRUE(shortfall(result)) << "however long elements are";
}

TEST(Shortfall, NamesPartsThatAreNotConnected) {
  MeshResult result = fake::WavyMesh(1, 4, 0).result();
  result.report.quality.quads = 3;
  result.report.model.unconnected = {{"Solid1", "Sheet2"}, {"Sheet1", "Sheet2"}};
  auto error = shortfall(result);
  ASSERT_TRUE(error);
  EXPECT_EQ(exit_code(error->code()), 4);
  EXPECT_NE(std::string(error->what()).find("Solid1 and Sheet2, Sheet1 and Sheet2;"), std::string::npos);
  EXPECT_EQ(faults(result.report).size(), 1u);
}

TEST(Shortfall, ListsTenFaces) {
  MeshResult result;
  result.report.faces.resize(12);
  for (FaceReport& face : result.report.faces) face.status = FaceStatus::failed, face.name = "FaceX";
  std::string text = shortfall(result).value().what();
  EXPECT_NE(text.find("12 of 12 faces could not be meshed, there is no mesh: "), std::string::npos) << text;
  EXPECT_NE(text.find(" and 2 more."), std::string::npos) << text;
}

TEST(Faults, AreNoneOfAMeshWhoseFacesAreAllThere) {
  RunReport report;
  report.faces.resize(2);
  report.faces[1].status = FaceStatus::no_area;
  EXPECT_EQ(faults(report).size(), 1u);  // no mesh
  report.quality.quads = 3;
  EXPECT_TRUE(faults(report).empty());
  report.quality.undecided = 1;
  EXPECT_EQ(faults(report).size(), 1u);
}

TEST(Faults, NameEachFaceThatFailed) {
  RunReport report;
  report.faces.resize(3);
  for (int i : {0, 2}) {
    FaceReport& face = report.faces[static_cast<std::size_t>(i)];
    face.name = "Face" + std::to_string(i + 1), face.status = FaceStatus::failed, face.stage = "quality";
    face.reason = "an element folds; use a smaller size";
  }
  EXPECT_EQ(faults(report),
            (std::vector<std::string>{"Face1 failed (quality): an element folds; use a smaller size.",
                                      "Face3 failed (quality): an element folds; use a smaller size."}));
}

TEST(Doubts, NameFacesWithElementsThatAreFarTooLong) {
  RunReport report;
  report.target_length = 2;
  report.faces.resize(3);
  report.faces[0].name = "Face1", report.faces[0].longest_side = 3;
  report.faces[2].name = "Face3", report.faces[2].longest_side = 25;
  report.quality.quads = 10;
  ASSERT_EQ(doubts(report).size(), 1U);
  EXPECT_NE(doubts(report)[0].find("Face3 (12.5)"), std::string::npos) << doubts(report)[0];
  EXPECT_EQ(doubts(report)[0].find("Face1"), std::string::npos);
  EXPECT_STREQ(verdict(report), "doubtful");
}

TEST(Doubts, NameFacesWhoseElementsFoldOver) {
  RunReport report;
  report.target_length = 1;
  report.faces.resize(3);
  report.faces[0].name = "Face1", report.faces[0].distance.angle = 3;  // a lip
  report.faces[0].cad_area = 10, report.faces[0].mesh_area = 10.01;
  report.faces[1].name = "Face2", report.faces[1].distance.angle = 1;  // coarse
  report.faces[1].cad_area = 10, report.faces[1].mesh_area = 10.2;
  EXPECT_TRUE(doubts(report).empty());
  report.faces[2].name = "Face3", report.faces[2].distance.angle = 3;
  report.faces[2].cad_area = 10, report.faces[2].mesh_area = 10.9;
  ASSERT_EQ(doubts(report).size(), 1U);
  EXPECT_NE(doubts(report)[0].find(": Face3 (+9.0 %);"), std::string::npos);
}

TEST(Doubts, NameFacesThatElementsAreTooCoarseFor) {
  RunReport report;
  report.target_length = 1, report.order = 1;
  report.faces.resize(6);
  for (int i = 0; i < 6; ++i) report.faces[static_cast<std::size_t>(i)].name = "Face" + std::to_string(i + 1);
  report.faces[0].cad_area = 100, report.faces[0].mesh_area = 86;  // a ball of few elements
  report.faces[1].cad_area = 1, report.faces[1].mesh_area = 0.1;   // small beside the others
  report.faces[4].cad_area = 100, report.faces[4].mesh_area = 100,
  report.faces[4].distance = {.largest = 0.01, .angle = 3};
  report.faces[4].longest_side = 1;  // a lip
  EXPECT_TRUE(doubts(report).empty());
  report.faces[5].cad_area = 100, report.faces[5].mesh_area = 100,
  report.faces[5].distance = {.largest = 0.3, .angle = 3};
  report.faces[5].longest_side = 1;
  report.faces[2].cad_area = 100, report.faces[2].mesh_area = 43;
  report.faces[3].cad_area = 100, report.faces[3].mesh_area = 75, report.faces[3].distance.angle = 2;
  ASSERT_EQ(doubts(report).size(), 1U);
  EXPECT_NE(doubts(report)[0].find("of Face3 (43 % of its area), Face4 (75 % of its area), Face6 (100 % of its area);"),
            std::string::npos)
      << doubts(report)[0];
}

TEST(Doubts, NameFacesOfAnotherAreaThanTheirCurvedElements) {
  RunReport report;
  report.target_length = 1, report.quality.quads = 10;
  report.faces.resize(4);
  for (int i = 0; i < 4; ++i) {
    FaceReport& face = report.faces[static_cast<std::size_t>(i)];
    face.name = "Face" + std::to_string(i + 1), face.cad_area = face.mesh_area = 100;
  }
  report.faces[1].mesh_area = 98;                                   // a ball of eight elements
  report.faces[2].cad_area = 0.1, report.faces[2].mesh_area = 0.2;  // small beside the others
  EXPECT_TRUE(doubts(report).empty());
  report.faces[0].mesh_area = 93, report.faces[3].mesh_area = 106;
  ASSERT_EQ(doubts(report).size(), 1U);
  EXPECT_NE(doubts(report)[0].find("of Face1 (93 % of its area), Face4 (106 % of its area);"), std::string::npos)
      << doubts(report)[0];
  EXPECT_STREQ(verdict(report), "doubtful");
  report.order = 1;  // chords cut off more
  EXPECT_TRUE(doubts(report).empty());
  report.order = 2;
  report.faces[2].status = FaceStatus::merged, report.faces[2].cad_area = 5;  // its neighbours have its area
  EXPECT_TRUE(doubts(report).empty());
}

}  // namespace
}  // namespace paver
