// CadModel: reading from files and memory, and the members of a compound.
#include <TopoDS_Iterator.hxx>
#include <algorithm>
#include <chrono>
#include <fstream>
#include <sstream>

#include "base/process/memory_file.h"
#include "brep/occt_shapes_impl.h"
#include "brep/reading/file_format.h"
#include "brep/shape_impl.h"
#include "paver/mesher.h"

namespace paver {
namespace {

CadModel read(const FileSource& file, Progress& progress, const std::vector<std::string>& labels = {}) {
  auto start = std::chrono::steady_clock::now();
  CadModel model;
  std::shared_ptr<Shape> shape = read_shape(file, model.report, progress);
  for (std::size_t f = 0; f < std::min(labels.size(), shape->labels.size()); ++f) shape->labels[f] = labels[f];
  model.shape = std::move(shape);
  model.read_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return model;
}

/// 0-based places in `all` of the parts of one kind of `shape`, in its own order.
std::vector<int> places(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind, const TopTools_IndexedMapOfShape& all) {
  const auto own = shapes_of(shape, kind);
  std::vector<int> result;
  for (int i = 1; i <= own.Extent(); ++i) result.push_back(all.FindIndex(own(i)) - 1);
  return result;
}

}  // namespace

CadModel read_file(const std::string& path, Progress& progress, const std::string& name) {
  return read({path, name.empty() ? path : name}, progress);
}

CadModel read_bytes(std::span<const char> bytes, const std::string& name, Progress& progress,
                    const std::vector<std::string>& labels) {
  MemoryFile file(bytes);
  return read({file.path(), name, true}, progress, labels);
}

std::string file_content(const std::string& path, const std::string& name) {
  const std::string& shown = name.empty() ? path : name;
  find_format(path, shown);  // looks at the ends, and refuses what is no such file
  std::ifstream in(path, std::ios::binary);
  std::ostringstream content;
  content << in.rdbuf();
  if (!in || !content)
    throw Error(ErrorCode::file_missing, "'" + shown + "' could not be read to its end; check the disk.");
  return std::move(content).str();
}

std::vector<ModelPart> model_parts(const CadModel& model) {
  const TopoDS_Shape& shape = model.shape->shape;
  constexpr TopAbs_ShapeEnum kinds[] = {TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX, TopAbs_SOLID};
  TopTools_IndexedMapOfShape all[4];
  for (int k = 0; k < 4; ++k) all[k] = shapes_of(shape, kinds[k]);
  std::vector<ModelPart> parts;
  auto add = [&](const TopoDS_Shape& part) {
    ModelPart& made = parts.emplace_back();
    std::vector<int>* lists[] = {&made.faces, &made.edges, &made.vertices, &made.solids};
    for (int k = 0; k < 4; ++k) *lists[k] = places(part, kinds[k], all[k]);
  };
  if (shape.ShapeType() != TopAbs_COMPOUND) {
    add(shape);
    return parts;
  }
  for (TopoDS_Iterator members(shape); members.More(); members.Next()) add(members.Value());
  return parts;
}

}  // namespace paver
