// What reading STEP and IGES has in common.
#pragma once

#include <Interface_InterfaceModel.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_Reader.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include "brep/format_library_impl.h"
#include "brep/readers_impl.h"
#include "formats/face_labels_impl.h"

namespace paver {

/// Throws Error{damaged_file}, with the `format`'s name, when what came of reading is not "done".
inline void check_loaded(IFSelect_ReturnStatus status, const FileSource& file, const std::string& format,
                         Progress& progress) {
  if (status != IFSelect_RetDone)
    throw Error(ErrorCode::damaged_file, "'" + file.name + "' is not readable " + format + "; export the model again.");
  progress.check();
}

/// Transfers all roots. `name_of(entity)`: what the file calls a face, null for other entities and where it has no
/// name.
template <class NameOf>
void transfer(XSControl_Reader& reader, Shape& shape, Progress& progress, NameOf name_of) {
  Handle(OcctProgress) indicator = new OcctProgress(progress, read_units);
  reader.TransferRoots(indicator->Start());
  indicator->finish();
  shape.shape = reader.OneShape();
  if (shape.shape.IsNull()) return;
  FaceLabels labels;
  Handle(Transfer_TransientProcess) process = reader.WS()->TransferReader()->TransientProcess();
  Handle(Interface_InterfaceModel) model = reader.Model();
  for (int i = 1; i <= model->NbEntities(); ++i) {
    Handle(Standard_Transient) entity = model->Value(i);
    Handle(TCollection_HAsciiString) name = name_of(entity);
    if (name.IsNull() || name->IsEmpty()) continue;
    labels.add(TransferBRep::ShapeResult(process, entity), name->ToCString());
  }
  shape.labels = labels.in_face_order(shape.shape);
}

}  // namespace paver
