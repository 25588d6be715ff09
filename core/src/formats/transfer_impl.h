// What reading STEP and IGES has in common.
#pragma once

#include <Interface_Check.hxx>
#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <Interface_InterfaceModel.hxx>
#include <Interface_ReportEntity.hxx>
#include <Interface_Static.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopoDS_TShape.hxx>
#include <TransferBRep.hxx>
#include <Transfer_Binder.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_Reader.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <cstring>
#include <string>
#include <unordered_map>
#include <vector>

#include "brep/occt_shapes_impl.h"
#include "brep/reading/readers_impl.h"

namespace paver {

/// A setting of OpenCASCADE's readers, put back afterwards: they are global, and a host may use them too. Holds as long
/// as it lives. Make it after the reader, which registers the settings; one that it does not know is left.
class ReaderSetting {
 public:
  ReaderSetting(const char* name, const char* value) : name_(name) {
    if (const char* saved = Interface_Static::CVal(name)) saved_ = saved;
    Interface_Static::SetCVal(name, value);
  }
  ~ReaderSetting() {
    if (!saved_.empty()) Interface_Static::SetCVal(name_, saved_.c_str());
  }
  ReaderSetting(const ReaderSetting&) = delete;
  ReaderSetting& operator=(const ReaderSetting&) = delete;

 private:
  const char* name_;
  std::string saved_;
};

/// All entities of a file, in its order.
inline std::vector<Handle(Standard_Transient)> entities_of(const XSControl_Reader& reader) {
  const Handle(Interface_InterfaceModel) model = reader.Model();
  std::vector<Handle(Standard_Transient)> entities;
  for (int i = 1; i <= model->NbEntities(); ++i) entities.push_back(model->Value(i));
  return entities;
}

inline Handle(Transfer_TransientProcess) process_of(const XSControl_Reader& reader) {
  return reader.WS()->TransferReader()->TransientProcess();
}

/// What came of an entity; null where nothing did.
inline TopoDS_Shape shape_of(const XSControl_Reader& reader, const Handle(Standard_Transient) & entity) {
  return TransferBRep::ShapeResult(process_of(reader), entity);
}

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
  for (const Handle(Standard_Transient) & entity : entities_of(reader)) {
    Handle(TCollection_HAsciiString) name = name_of(entity);
    if (name.IsNull()) continue;
    const std::string label = name->ToCString();
    if (label.empty() || label == "NONE" || label == "none") continue;  // these say nothing
    for (const TopoDS_Face& face : faces_of(shape_of(reader, entity))) labels[face.TShape().get()] = label;
  }
  const auto faces = shapes_of(shape.shape, TopAbs_FACE);
  shape.labels.assign(static_cast<std::size_t>(faces.Extent()), {});
  for (int i = 1; i <= faces.Extent(); ++i)
    if (const auto found = labels.find(faces(i).TShape().get()); found != labels.end())
      shape.labels[i - 1] = found->second;
}

/// "#12 ConicalSurface": how the file numbers an entity, and what it is.
inline std::string entity_label(const XSControl_Reader& reader, const Handle(Standard_Transient) & entity) {
  const char* const type = entity->DynamicType()->Name();
  const char* const end_of_package = std::strchr(type, '_');
  return std::string(reader.Model()->StringLabel(entity)->ToCString()) + " " +
         (end_of_package ? end_of_package + 1 : type);
}

/// Without any the kernel has no graph of them.
inline bool has_entities(const XSControl_Reader& reader) {
  const Handle(Interface_InterfaceModel) model = reader.Model();
  return !model.IsNull() && model->NbEntities() > 0;
}

/// Looks through the entities of a file after they were transferred, for those of which the kernel makes nothing: it
/// goes on without, and says so in its own lists only. A face without its surface is missing then, a loop without one
/// of its curves leaves its hole filled, or its face as large as the surface.
class LostEntities {
 public:
  explicit LostEntities(const XSControl_Reader& reader)
      : reader_(reader), model_(reader.Model()), graph_(reader.WS()->Graph()) {}

  bool is_lost(const Handle(Standard_Transient) & entity) const { return shape_of(reader_, entity).IsNull(); }

  /// Labels of what failed, by its cause: of a face that failed with its surface only the surface. Where nothing failed
  /// and nothing came either, labels of the outermost. `is_shape(entity)`: something has to come of it.
  template <class IsShape>
  std::vector<std::string> labels(IsShape is_shape) const {
    const Entities failed = failed_entities();
    Marks told = beyond(failed, &Interface_Graph::Sharings);
    std::vector<std::string> labels;
    for (const int i : failed) {
      if (!told[i]) labels.push_back(entity_label(reader_, model_->Value(i)));
      told[i] = true;
    }
    Entities lost;
    for (int i = 1; i <= model_->NbEntities(); ++i)
      if (is_lost(model_->Value(i)) && is_shape(model_->Value(i))) lost.push_back(i);
    const Marks is_inner = beyond(lost, &Interface_Graph::Shareds);
    for (const int i : lost)
      if (!told[i] && !is_inner[i]) labels.push_back(entity_label(reader_, model_->Value(i)));
    return labels;
  }

 private:
  using Entities = std::vector<int>;
  using Marks = std::vector<bool>;  // per entity, from 1
  using Neighbours = Interface_EntityIterator (Interface_Graph::*)(const Handle(Standard_Transient) &) const;

  Entities failed_entities() const {
    const Handle(Transfer_TransientProcess) process = process_of(reader_);
    Entities failed;
    for (int i = 1; i <= process->NbMapped(); ++i) {
      const Handle(Transfer_Binder) result = process->MapItem(i);
      if (result.IsNull() || !result->Check()->HasFailed()) continue;
      if (const int entity = model_->Number(process->Mapped(i)); entity > 0) failed.push_back(entity);
    }
    return failed;
  }

  /// What `neighbours` leads to from any of `start`, one step or more.
  Marks beyond(Entities start, Neighbours neighbours) const {
    Marks reached(static_cast<std::size_t>(model_->NbEntities()) + 1, false);
    while (!start.empty()) {
      Interface_EntityIterator next = (graph_.*neighbours)(model_->Value(start.back()));
      start.pop_back();
      for (; next.More(); next.Next()) {
        const int entity = model_->Number(next.Value());
        if (entity == 0 || reached[entity]) continue;
        reached[entity] = true;
        start.push_back(entity);
      }
    }
    return reached;
  }

  const XSControl_Reader& reader_;
  Handle(Interface_InterfaceModel) model_;
  const Interface_Graph& graph_;
};

}  // namespace paver
