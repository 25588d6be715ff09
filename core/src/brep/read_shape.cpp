// Reads a CAD file into a shape: find the format, let OpenCASCADE read it, check that it has faces.
// Exceptions and messages of OpenCASCADE end here: a failure is an Error, nothing is printed.
#include "brep/read_shape.h"

#include <TopAbs_ShapeEnum.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "brep/file_format.h"
#include "brep/readers_impl.h"
#include "brep/shape_impl.h"

namespace paver {

std::shared_ptr<Shape> read_shape(const std::string& path, ModelReport& report, Progress& progress) {
  progress.begin(Stage::read, read_units);
  FileFormat format = find_format(path);
  report.file = path;
  report.format = format_name(format);

  auto shape = std::make_shared<Shape>();
  QuietMessages quiet;
  guard_occt(ErrorCode::damaged_file, "'" + path + "' could not be read; export the model again", [&] {
    if (format == FileFormat::step) {
      read_step(path, *shape, report, progress);
    } else if (format == FileFormat::iges) {
      read_iges(path, *shape, report, progress);
    } else {
      read_brep(path, format == FileFormat::binary_brep, *shape, report, progress);
    }
  });
  progress.check();

  TopTools_IndexedMapOfShape faces;
  if (!shape->shape.IsNull()) TopExp::MapShapes(shape->shape, TopAbs_FACE, faces);
  if (faces.IsEmpty())
    throw Error(ErrorCode::no_faces, "'" + path +
                                         "' has no faces, so there is nothing to mesh; "
                                         "export surfaces or solids, not curves or meshes.");
  shape->labels.resize(static_cast<std::size_t>(faces.Extent()));
  return shape;
}

}  // namespace paver
