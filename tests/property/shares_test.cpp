// Real models: faces that fail, elements that are mended across faces, and all the rest come out on several ranks as on
// one.
#include "support/shares.h"

#include <gtest/gtest.h>

#include <BRepBndLib.hxx>
#include <Bnd_Box.hxx>
#include <cmath>
#include <filesystem>
#include <set>

#include "brep/shape_impl.h"
#include "support/folders.h"

namespace paver {
namespace {

TEST(SharesOfRealModels, AreTheSameOnThreeRanks) {
  const std::filesystem::path folder = test::shared_folder() / "cad";
  if (!std::filesystem::exists(folder))
    GTEST_SKIP() << "needs real models, " << folder << " is missing: set PAVER_SHARED";
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.insert(entry.path());
  int models = 0, mended = 0;
  for (const std::filesystem::path& file : files) {
    const std::string ending = file.extension();
    if (ending != ".step" && ending != ".stp" && ending != ".brep" && ending != ".igs") continue;
    SCOPED_TRACE(file.filename());
    Progress progress;
    const CadModel model = read_file(file, progress);
    Options options;
    Bnd_Box box;
    BRepBndLib::Add(model.shape->shape, box, Standard_False);
    options.size = std::sqrt(box.SquareExtent()) / 15;
    options.threads = 1;
    const MeshResult alone = mesh_model(model, options, progress);
    test::expect_same_on_ranks(model, options, alone, 3, 1);
    mended += !alone.report.element_repairs.empty();
    ++models;
  }
  EXPECT_GT(models, 10);
  EXPECT_GT(mended, 3);
}

}  // namespace
}  // namespace paver
