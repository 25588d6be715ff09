// STEP: reads the file, transfers all roots in millimetres, and takes the names of its faces along.
#include <Interface_Check.hxx>
#include <Interface_InterfaceModel.hxx>
#include <Interface_ReportEntity.hxx>
#include <STEPControl_Reader.hxx>
#include <StepShape_FaceSurface.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <string_view>

#include "brep/format_library_impl.h"
#include "brep/readers_impl.h"
#include "formats/exchange_settings_impl.h"
#include "formats/face_labels_impl.h"

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
/// Names are allowed to be missing: some writers leave them out.
void check_entities(const std::string& name, STEPControl_Reader& reader) {
  Handle(Interface_InterfaceModel) model = reader.Model();
  for (int i = 1; i <= model->NbEntities(); ++i) {
    if (!model->IsErrorEntity(i)) continue;
    Handle(Standard_Transient) entity = model->Value(i);
    std::string_view type = entity->DynamicType()->Name();
    if (!type.starts_with("StepGeom_") && !type.starts_with("StepShape_")) continue;
    Handle(Interface_Check) check = model->ReportEntity(i)->Check();
    for (int k = 1; k <= check->NbFails(); ++k) {
      std::string reason = check->CFail(k);
      if (reason.find("(name)") != std::string::npos) continue;
      throw Error(ErrorCode::damaged_file, "'" + name + "' is damaged at entity " +
                                               model->StringLabel(entity)->ToCString() + " (" + reason +
                                               "); export the model again.");
    }
  }
}

std::vector<std::string> face_labels(STEPControl_Reader& reader, const TopoDS_Shape& shape) {
  FaceLabels labels;
  Handle(Transfer_TransientProcess) process = reader.WS()->TransferReader()->TransientProcess();
  Handle(Interface_InterfaceModel) model = reader.Model();
  for (int i = 1; i <= model->NbEntities(); ++i) {
    Handle(StepShape_FaceSurface) face = Handle(StepShape_FaceSurface)::DownCast(model->Value(i));
    if (face.IsNull() || face->Name().IsNull() || face->Name()->IsEmpty()) continue;
    labels.add(TransferBRep::ShapeResult(process, face), face->Name()->ToCString());
  }
  return labels.in_face_order(shape);
}

}  // namespace

extern "C" void paver_read_format(const FileSource& file, Shape& shape, ModelReport& report, Progress& progress) {
  STEPControl_Reader reader;
  MillimetreReading millimetres;
  if (reader.ReadFile(file.path.c_str()) != IFSelect_RetDone)
    throw Error(ErrorCode::damaged_file, "'" + file.name + "' is not readable STEP; export the model again.");
  progress.check();
  check_entities(file.name, reader);
  report.unit = stated_unit(reader);
  Handle(OcctProgress) indicator = new OcctProgress(progress, read_units);
  reader.TransferRoots(indicator->Start());
  indicator->finish();
  shape.shape = reader.OneShape();
  if (!shape.shape.IsNull()) shape.labels = face_labels(reader, shape.shape);
}

}  // namespace paver
