// OpenCASCADE's own formats. They state no unit: FreeCAD and this program write millimetres.
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <fstream>

#include "brep/readers_impl.h"

namespace paver {

void read_brep(const std::string& path, bool is_binary, Shape& shape, ModelReport& report, Progress& progress) {
  report.unit = "mm (as written)";
  Handle(OcctProgress) indicator = new OcctProgress(progress, read_units);
  std::ifstream in(path, std::ios::binary);
  // The readers loop for ever or crash on values they could not read: the stream itself must stop them.
  in.exceptions(std::ios::failbit | std::ios::badbit);
  try {
    if (is_binary) {
      BinTools::Read(shape.shape, in, indicator->Start());
    } else {
      BRep_Builder builder;
      BRepTools::Read(shape.shape, in, builder, indicator->Start());
    }
  } catch (const std::ios_base::failure&) {
    shape.shape.Nullify();
  }
  indicator->finish();
  if (shape.shape.IsNull())
    throw Error(ErrorCode::damaged_file, "'" + path + "' is cut off or damaged; copy or export it again.");
}

}  // namespace paver
