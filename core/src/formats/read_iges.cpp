// IGES: reads the file, transfers all roots (also blanked ones) in millimetres, and takes names of faces along.
#include <IGESControl_Reader.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESEntity.hxx>
#include <IGESData_IGESModel.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include "brep/format_library_impl.h"
#include "brep/readers_impl.h"
#include "formats/exchange_settings_impl.h"
#include "formats/face_labels_impl.h"

namespace paver {
namespace {

constexpr int trimmed_surface = 144, face_entity = 510;

std::string stated_unit(const Handle(IGESData_IGESModel) & model) {
  // IGES 5.3, 2.2.4.3.14: units flag; 3 means "see the name".
  static const char* const names[] = {"", "INCH", "MM", "", "FOOT", "MILE", "M", "KM", "MIL", "UM", "CM", "UIN"};
  const IGESData_GlobalSection& global = model->GlobalSection();
  int flag = global.UnitFlag();
  if (flag >= 1 && flag <= 11 && *names[flag]) return names[flag];
  Handle(TCollection_HAsciiString) name = global.UnitName();
  return name.IsNull() || name->IsEmpty() ? "not stated" : name->ToCString();
}

std::vector<std::string> face_labels(IGESControl_Reader& reader, const TopoDS_Shape& shape) {
  FaceLabels labels;
  Handle(Transfer_TransientProcess) process = reader.WS()->TransferReader()->TransientProcess();
  Handle(Interface_InterfaceModel) model = reader.Model();
  for (int i = 1; i <= model->NbEntities(); ++i) {
    Handle(IGESData_IGESEntity) entity = Handle(IGESData_IGESEntity)::DownCast(model->Value(i));
    if (entity.IsNull() || (entity->TypeNumber() != trimmed_surface && entity->TypeNumber() != face_entity)) continue;
    Handle(TCollection_HAsciiString) name = entity->NameValue();
    if (name.IsNull() || name->IsEmpty()) continue;
    labels.add(TransferBRep::ShapeResult(process, entity), name->ToCString());
  }
  return labels.in_face_order(shape);
}

}  // namespace

extern "C" void paver_read_format(const FileSource& file, Shape& shape, ModelReport& report, Progress& progress) {
  IGESControl_Reader reader;
  MillimetreReading millimetres;
  if (reader.ReadFile(file.path.c_str()) != IFSelect_RetDone)
    throw Error(ErrorCode::damaged_file, "'" + file.name + "' is not readable IGES; export the model again.");
  progress.check();
  Handle(IGESData_IGESModel) model = reader.IGESModel();
  if (!model.IsNull()) report.unit = stated_unit(model);
  reader.SetReadVisible(Standard_False);
  Handle(OcctProgress) indicator = new OcctProgress(progress, read_units);
  reader.TransferRoots(indicator->Start());
  indicator->finish();
  shape.shape = reader.OneShape();
  if (!shape.shape.IsNull()) shape.labels = face_labels(reader, shape.shape);
}

}  // namespace paver
