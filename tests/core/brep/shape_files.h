// Helpers of the tests of brep/ and topology/: a folder that goes away, files in it, shapes as Shape.
#pragma once

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shape.hxx>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <sstream>
#include <string>
#include <vector>

#include "brep/shape_impl.h"
#include "paver/options.h"
#include "support/alone.h"
#include "topology/build_model.h"

namespace paver::test {

class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "paver_test_XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::string file(const std::string& name) const { return (std::filesystem::path(path_) / name).string(); }

 private:
  std::string path_;
};

inline void write_text(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

inline std::string read_text(const std::string& path) {
  std::stringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

template <class Shapes>
TopoDS_Compound compound(const Shapes& parts) {
  BRep_Builder builder;
  TopoDS_Compound result;
  builder.MakeCompound(result);
  for (const TopoDS_Shape& part : parts) builder.Add(result, part);
  return result;
}
inline TopoDS_Compound compound(std::initializer_list<TopoDS_Shape> parts) {
  return compound<std::initializer_list<TopoDS_Shape>>(parts);
}

/// Its faces, each with edges of its own, as files without solids have them.
inline std::vector<TopoDS_Shape> loose_faces(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Shape> faces;
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next())
    faces.push_back(BRepBuilderAPI_Copy(face.Current()).Shape());
  return faces;
}

inline Shape as_shape(const TopoDS_Shape& shape) { return {shape, {}, {}}; }

/// Without a target length one at which only creases divide faces.
inline Model model_of(const TopoDS_Shape& shape, Options options = {}) {
  if (!options.size && !options.frequency) options.size = 1e-3;
  Progress progress;
  Alone alone(progress);
  return build_model(as_shape(shape), options, {}, progress, alone);
}

}  // namespace paver::test
