// STEP: reads the file, transfers all roots in millimetres, and takes the names of its objects and faces along.
#include <STEPControl_Reader.hxx>
#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepShape_FaceSurface.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <fstream>
#include <string_view>

#include "formats/exchange_settings_impl.h"
#include "formats/object_labels_impl.h"
#include "formats/step_poles_impl.h"
#include "formats/transfer_impl.h"

namespace paver {
namespace {

std::string stated_unit(STEPControl_Reader& reader) {
  TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
  reader.FileUnits(lengths, angles, solid_angles);
  std::string unit;
  for (int i = 1; i <= lengths.Length(); ++i) {
    std::string name = lengths(i).ToCString();
    if (unit.find(name) != std::string::npos) continue;
    unit += (unit.empty() ? "" : ", ") + name;
  }
  return unit.empty() ? "not stated" : unit;
}

/// The reader marks entities whose content it could not load, and crashes later where it follows them into geometry.
void check_entities(const std::string& name, STEPControl_Reader& reader) {
  Handle(Interface_InterfaceModel) model = reader.Model();
  for (int i = 1; i <= model->NbEntities(); ++i) {
    if (!model->IsErrorEntity(i)) continue;
    Handle(Standard_Transient) entity = model->Value(i);
    std::string_view type = entity->DynamicType()->Name();
    if (!type.starts_with("StepGeom_") && !type.starts_with("StepShape_")) continue;
    if (const char* reason = fail_of(model, i))
      throw Error(ErrorCode::damaged_file, "'" + name + "' is damaged at entity " +
                                               model->StringLabel(entity)->ToCString() + " (" + reason +
                                               "); export the model again.");
  }
}

Handle(TCollection_HAsciiString) face_name(const Handle(Standard_Transient) & entity) {
  Handle(StepShape_FaceSurface) face = Handle(StepShape_FaceSurface)::DownCast(entity);
  return face.IsNull() ? Handle(TCollection_HAsciiString)() : face->Name();
}

/// Of a part, as its writer calls it; empty where it only says who wrote it.
std::string product_name(const Handle(StepBasic_ProductDefinition) & definition) {
  if (definition->Formation().IsNull() || definition->Formation()->OfProduct().IsNull()) return "";
  Handle(StepBasic_Product) product = definition->Formation()->OfProduct();
  for (Handle(TCollection_HAsciiString) text : {product->Name(), product->Id()})
    if (!text.IsNull() && !text->IsEmpty())
      return text->String().StartsWith("Open CASCADE STEP translator") ? "" : text->ToCString();
  return "";
}

/// Past the mark of UTF-8 that some editors put in front: the kernel's grammar knows no such token.
void skip_byte_order_mark(std::istream& content) {
  std::string start(3, '\0');
  if (!content.read(start.data(), 3) || start != "\xEF\xBB\xBF") content.clear(), content.seekg(0);
}

void label_objects(STEPControl_Reader& reader, Shape& shape) {
  ObjectLabels objects;
  Handle(Transfer_TransientProcess) process = reader.WS()->TransferReader()->TransientProcess();
  Handle(Interface_InterfaceModel) model = reader.Model();
  for (int i = 1; i <= model->NbEntities(); ++i) {
    auto definition = Handle(StepBasic_ProductDefinition)::DownCast(model->Value(i));
    if (!definition.IsNull()) objects.add(TransferBRep::ShapeResult(process, definition), product_name(definition));
  }
  objects.give_to(shape.shape, shape.labels);
}

}  // namespace

extern "C" void paver_read_format(const FileSource& file, const Doubt& doubt, Shape& shape, ModelReport& report,
                                  Progress& progress) {
  STEPControl_Reader reader;
  MillimetreReading millimetres;
  std::ifstream content(file.path, std::ios::binary);  // OpenCASCADE 7.8 opens no path that is not UTF-8
  skip_byte_order_mark(content);
  check_loaded(reader.ReadStream(file.path.c_str(), content), file, "STEP", progress);
  check_entities(file.name, reader);
  if (has_fails(reader.Model())) doubt();
  report.unit = stated_unit(reader);
  transfer(reader, shape, progress, face_name);
  if (shape.shape.IsNull()) return;
  report.unread = unread_faces(reader, [](const Handle(Standard_Transient) & entity) {
    return !Handle(StepShape_FaceSurface)::DownCast(entity).IsNull();
  });
  label_objects(reader, shape);
  restore_poles(reader, shape);
}

}  // namespace paver
