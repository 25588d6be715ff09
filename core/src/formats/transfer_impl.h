// What reading STEP and IGES has in common.
#pragma once

#include <Interface_Check.hxx>
#include <Interface_InterfaceModel.hxx>
#include <Interface_ReportEntity.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopoDS_TShape.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_Reader.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <cstring>
#include <string>
#include <unordered_map>

#include "brep/occt_shapes_impl.h"
#include "brep/reading/format_library_impl.h"
#include "brep/reading/readers_impl.h"

namespace paver {

/// Throws Error{damaged_file}, with the `format`'s name, when what came of reading is not "done".
inline void check_loaded(IFSelect_ReturnStatus status, const FileSource& file, const std::string& format,
                         Progress& progress) {
  if (status != IFSelect_RetDone)
    throw Error(ErrorCode::damaged_file, "'" + file.name + "' is not readable " + format + "; export the model again.");
  progress.check();
}

/// What the reader has found that is not as the format wants it in entity i; null where it is. Names may be missing:
/// some writers leave them out.
inline const char* fail_of(const Handle(Interface_InterfaceModel) & model, int i) {
  if (!model->IsReportEntity(i)) return nullptr;
  const Handle(Interface_Check) check = model->ReportEntity(i)->Check();
  for (int k = 1; k <= check->NbFails(); ++k)
    if (!std::strstr(check->CFail(k), "(name)")) return check->CFail(k);
  return nullptr;
}

inline bool has_fails(const Handle(Interface_InterfaceModel) & model) {
  for (int i = 1; i <= model->NbEntities(); ++i)
    if (fail_of(model, i)) return true;
  return false;
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
  std::unordered_map<const TopoDS_TShape*, std::string> labels;
  Handle(Transfer_TransientProcess) process = reader.WS()->TransferReader()->TransientProcess();
  Handle(Interface_InterfaceModel) model = reader.Model();
  for (int i = 1; i <= model->NbEntities(); ++i) {
    Handle(Standard_Transient) entity = model->Value(i);
    Handle(TCollection_HAsciiString) name = name_of(entity);
    if (name.IsNull()) continue;
    const std::string label = name->ToCString();
    if (label.empty() || label == "NONE" || label == "none") continue;  // these say nothing
    for (const TopoDS_Face& face : faces_of(TransferBRep::ShapeResult(process, entity)))
      labels[face.TShape().get()] = label;
  }
  const auto faces = shapes_of(shape.shape, TopAbs_FACE);
  shape.labels.assign(static_cast<std::size_t>(faces.Extent()), {});
  for (int i = 1; i <= faces.Extent(); ++i)
    if (const auto found = labels.find(faces(i).TShape().get()); found != labels.end())
      shape.labels[i - 1] = found->second;
}

}  // namespace paver
