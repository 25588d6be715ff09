// What a STEP or IGES file holds and of which the kernel makes nothing: it goes on without, and says so in its own
// lists only. A face without its surface is missing then, a loop without one of its curves leaves its hole filled, or
// its face as large as the surface.
#pragma once

#include <Interface_Check.hxx>
#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <Interface_InterfaceModel.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TransferBRep.hxx>
#include <Transfer_Binder.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_Reader.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <cstring>
#include <string>
#include <vector>

namespace paver {

/// "#12 ConicalSurface": how the file numbers an entity, and what it is.
inline std::string entity_label(const Handle(Interface_InterfaceModel) & model,
                                const Handle(Standard_Transient) & entity) {
  const char* const type = entity->DynamicType()->Name();
  const char* const end_of_package = std::strchr(type, '_');
  return std::string(model->StringLabel(entity)->ToCString()) + " " + (end_of_package ? end_of_package + 1 : type);
}

/// Without any the kernel has no graph of them.
inline bool has_entities(const XSControl_Reader& reader) {
  const Handle(Interface_InterfaceModel) model = reader.Model();
  return !model.IsNull() && model->NbEntities() > 0;
}

/// Looks through the entities of a file after they were transferred.
class LostEntities {
 public:
  explicit LostEntities(XSControl_Reader& reader)
      : model_(reader.Model()),
        graph_(reader.WS()->Graph()),
        process_(reader.WS()->TransferReader()->TransientProcess()) {}

  bool is_lost(const Handle(Standard_Transient) & entity) const {
    return TransferBRep::ShapeResult(process_, entity).IsNull();
  }

  /// Labels of what failed, by its cause: of a face that failed with its surface only the surface. Where nothing failed
  /// and nothing came either, labels of the outermost. `is_shape(entity)`: something has to come of it.
  template <class IsShape>
  std::vector<std::string> labels(IsShape is_shape) const {
    const Entities failed = failed_entities();
    Marks told = beyond(failed, &Interface_Graph::Sharings);
    std::vector<std::string> labels;
    for (const int i : failed) {
      if (!told[i]) labels.push_back(entity_label(model_, model_->Value(i)));
      told[i] = true;
    }
    Entities lost;
    for (int i = 1; i <= model_->NbEntities(); ++i)
      if (is_lost(model_->Value(i)) && is_shape(model_->Value(i))) lost.push_back(i);
    const Marks is_inner = beyond(lost, &Interface_Graph::Shareds);
    for (const int i : lost)
      if (!told[i] && !is_inner[i]) labels.push_back(entity_label(model_, model_->Value(i)));
    return labels;
  }

 private:
  using Entities = std::vector<int>;
  using Marks = std::vector<bool>;  // per entity, from 1
  using Neighbours = Interface_EntityIterator (Interface_Graph::*)(const Handle(Standard_Transient) &) const;

  Entities failed_entities() const {
    Entities failed;
    for (int i = 1; i <= process_->NbMapped(); ++i) {
      const Handle(Transfer_Binder) result = process_->MapItem(i);
      if (result.IsNull() || !result->Check()->HasFailed()) continue;
      if (const int entity = model_->Number(process_->Mapped(i)); entity > 0) failed.push_back(entity);
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

  Handle(Interface_InterfaceModel) model_;
  const Interface_Graph& graph_;
  Handle(Transfer_TransientProcess) process_;
};

}  // namespace paver
