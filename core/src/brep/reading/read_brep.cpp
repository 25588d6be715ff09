// OpenCASCADE's own formats. They state no unit: FreeCAD and this program write millimetres.
//
// A binary stream is a set of shapes and, after it, which of them is meant. OpenCASCADE says so in 9 bytes
// (orientation, place from the end, location), FreeCAD in 12 (place, location, orientation); read the other way the
// shape is garbage that crashes its user later.
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <BinTools_ShapeSet.hxx>
#include <sstream>

#include "brep/reading/readers_impl.h"
#include "brep/reading/texts.h"

namespace paver {
namespace {

constexpr std::streamoff freecad_tail_bytes = 3 * sizeof(Standard_Integer);

std::streamoff bytes_left(std::istream& in) {
  std::streampos here = in.tellg();
  in.seekg(0, std::ios::end);
  std::streamoff left = in.tellg() - here;
  in.seekg(here);
  return left;
}

bool is_orientation(int number) { return number >= TopAbs_FORWARD && number <= TopAbs_EXTERNAL; }

/// Null when the numbers point to nothing.
TopoDS_Shape read_freecad_tail(BinTools_ShapeSet& set, std::istream& in) {
  Standard_Integer place = 0, location = 0, orientation = 0;
  for (Standard_Integer* number : {&place, &location, &orientation}) BinTools::GetInteger(in, *number);
  bool is_sound = place >= 1 && place <= set.NbShapes() && location >= 0 && location <= set.Locations().NbLocations() &&
                  is_orientation(orientation);
  if (!is_sound) return {};
  TopoDS_Shape shape = set.Shape(place);
  shape.Location(set.Locations().Location(location), Standard_False);
  shape.Orientation(static_cast<TopAbs_Orientation>(orientation));
  return shape;
}

TopoDS_Shape read_binary(std::istream& in, const Message_ProgressRange& range) {
  BinTools_ShapeSet set;
  set.Read(in, range);
  if (set.NbShapes() == 0) return {};
  if (bytes_left(in) == freecad_tail_bytes) return read_freecad_tail(set, in);
  TopoDS_Shape shape;
  set.ReadSubs(shape, in, set.NbShapes());
  return shape;
}

void check_text(const FileSource& file, std::string_view text) {
  const std::string fault = fault_of_brep(text);
  if (!fault.empty())
    throw Error(ErrorCode::damaged_file,
                "'" + file.name + "' is cut off or damaged (" + fault + "); copy or export it again.");
}

}  // namespace

void read_brep(const FileSource& file, bool is_binary, Shape& shape, ModelReport& report, Progress& progress) {
  report.unit = "mm (as written)";
  Handle(OcctProgress) indicator = new OcctProgress(progress, read_units);
  std::istringstream in(content_of(file));
  if (!is_binary) check_text(file, in.view());
  // The readers loop for ever or crash on values they could not read: the stream itself must stop them.
  in.exceptions(std::ios::failbit | std::ios::badbit);
  try {
    if (is_binary) {
      shape.shape = read_binary(in, indicator->Start());
    } else {
      BRep_Builder builder;
      BRepTools::Read(shape.shape, in, builder, indicator->Start());
    }
  } catch (const std::ios_base::failure&) {
    shape.shape.Nullify();
  }
  indicator->finish();
  if (shape.shape.IsNull())
    throw Error(ErrorCode::damaged_file, "'" + file.name + "' is cut off or damaged; copy or export it again.");
}

}  // namespace paver
