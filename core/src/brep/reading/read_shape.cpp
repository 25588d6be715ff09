// Reads a CAD file into a shape: find the format, let OpenCASCADE read it, check that it has faces.
// Exceptions and messages of OpenCASCADE end here: a failure is an Error, nothing is printed.
#include "brep/reading/read_shape.h"

#include <fmt/format.h>

#include <BRepTools_ReShape.hxx>
#include <BRep_Tool.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <algorithm>
#include <chrono>
#include <fstream>
#include <mutex>
#include <utility>

#include "base/listed.h"
#include "brep/occt_shapes_impl.h"
#include "brep/reading/file_format.h"
#include "brep/reading/readers_impl.h"
#include "brep/reading/texts.h"
#include "brep/shape_impl.h"

namespace paver {

namespace {

/// The readers of STEP and IGES keep settings and tables for the whole process: one at a time.
std::unique_lock<std::timed_mutex> wait_for_readers(const Progress& progress) {
  static std::timed_mutex busy;
  std::unique_lock lock(busy, std::defer_lock);
  while (!lock.try_lock_for(std::chrono::milliseconds(20))) progress.check();
  return lock;
}

/// Notes entities that other ones name and that are not there.
bool is_doubtful_step(std::string_view content, const FileSource& file, ModelReport& report) {
  const StepNames names = find_step_names(content);
  if (names.doubled != 0 && !names.has_scopes)
    throw Error(ErrorCode::damaged_file, fmt::format("'{}' is damaged at entity #{} (there is more than one of it); "
                                                     "export the model again.",
                                                     file.name, names.doubled));
  if (!names.has_scopes)
    for (const std::uint64_t number : names.missing) report.unread.push_back(fmt::format("#{} (not there)", number));
  return names.doubled != 0 || !names.is_whole;
}

/// Faces that have triangles and no surface: newer kernels make them of tessellated solids, and none can go on with
/// them.
void leave_triangles_out(Shape& shape, ModelReport& report) {
  const auto faces = shapes_of(shape.shape, TopAbs_FACE);
  BRepTools_ReShape changes;
  std::vector<std::string> triangles, labels;
  for (int i = 1; i <= faces.Extent(); ++i)
    if (BRep_Tool::Surface(TopoDS::Face(faces(i))).IsNull()) {
      changes.Remove(faces(i));
      triangles.push_back("Face" + std::to_string(i) + " (triangles only)");
    } else if (static_cast<std::size_t>(i) <= shape.labels.size()) {
      labels.push_back(shape.labels[i - 1]);
    }
  if (triangles.empty()) return;
  shape.shape = changes.Apply(shape.shape);
  shape.labels = std::move(labels);
  report.unread.insert(report.unread.begin(), triangles.begin(), triangles.end());
}

constexpr std::size_t most_named = 5;  // in an error; a report has all

Error nothing_to_mesh(const FileSource& file, const std::vector<std::string>& unread) {
  if (unread.empty())
    return {ErrorCode::no_faces, "'" + file.name +
                                     "' has no faces and no wires, so there is nothing to mesh; "
                                     "export surfaces, solids or curves, not meshes."};
  return {ErrorCode::no_faces,
          fmt::format("Nothing of '{}' could be read: {}; export the model again, as one file, or in another format.",
                      file.name, listed(unread, most_named))};
}

}  // namespace

LooseShapes::LooseShapes(const TopoDS_Shape& shape) {
  for (TopExp_Explorer free(shape, TopAbs_EDGE, TopAbs_FACE); free.More(); free.Next()) edges.Add(free.Current());
  TopExp_Explorer free(shape, TopAbs_VERTEX, TopAbs_EDGE);
  if (!free.More()) return;
  TopTools_MapOfShape ends;  // one that is inside a face as well is of the edge: a pole of a ball that lies on a plate
  for (TopExp_Explorer edge(shape, TopAbs_EDGE); edge.More(); edge.Next())
    for (TopoDS_Iterator end(edge.Current()); end.More(); end.Next()) ends.Add(end.Value());
  for (; free.More(); free.Next())
    if (!ends.Contains(free.Current())) vertices.Add(free.Current());
}

std::string content_of(const FileSource& file) {
  std::ifstream in(file.path, std::ios::binary | std::ios::ate);
  std::string content(static_cast<std::size_t>(std::max<std::streamoff>(0, in.tellg())), '\0');
  in.seekg(0);
  in.read(content.data(), static_cast<std::streamsize>(content.size()));
  content.resize(static_cast<std::size_t>(in.gcount()));
  return content;
}

std::shared_ptr<Shape> read_shape(const FileSource& file, ModelReport& report, Progress& progress) {
  progress.begin(Stage::read, read_units);
  FileFormat format = find_format(file.path, file.name);
  report.file = file.name;
  report.format = format_name(format);

  auto shape = std::make_shared<Shape>();
  bool was_tried = false;  // once is enough
  const auto try_once = [&] {
    if (!std::exchange(was_tried, true)) try_elsewhere(file, progress);
  };
  QuietMessages quiet;
  guard_occt(ErrorCode::damaged_file, "'" + file.name + "' could not be read; export the model again", progress, [&] {
    if (format == FileFormat::brep || format == FileFormat::binary_brep) {
      if (format == FileFormat::binary_brep && !file.is_handed_over) try_once();
      read_brep(file, format == FileFormat::binary_brep, *shape, report, progress);
      return;
    }
    const std::string content = content_of(file);
    if (format == FileFormat::iges ? !fault_of_iges(content).empty() : is_doubtful_step(content, file, report))
      try_once();
    auto lock = wait_for_readers(progress);
    format_library(format == FileFormat::step ? "step" : "iges", file)(file, content, try_once, *shape, report,
                                                                       progress);
  });
  progress.check();

  if (!shape->shape.IsNull()) leave_triangles_out(*shape, report);
  const auto faces = shapes_of(shape->shape, TopAbs_FACE), edges = shapes_of(shape->shape, TopAbs_EDGE);
  if (faces.IsEmpty() && edges.IsEmpty()) throw nothing_to_mesh(file, report.unread);
  const LooseShapes loose(shape->shape);
  shape->labels.resize(static_cast<std::size_t>(faces.Extent() + loose.edges.Extent() + loose.vertices.Extent()));
  return shape;
}

}  // namespace paver
