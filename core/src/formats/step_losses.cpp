// In: a STEP file after its transfer. Out: labels of what is not as the file has it. Steps: shapes and parts of which
// nothing came; parts that are in other files; representations that were not read; positions; units of length.
#include <StepAP214_AppliedDocumentReference.hxx>
#include <StepBasic_DocumentFile.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepGeom_Axis2Placement3d.hxx>
#include <StepGeom_CartesianTransformationOperator3d.hxx>
#include <StepGeom_Curve.hxx>
#include <StepGeom_Direction.hxx>
#include <StepGeom_Surface.hxx>
#include <StepRepr_ItemDefinedTransformation.hxx>
#include <StepRepr_MappedItem.hxx>
#include <StepRepr_NextAssemblyUsageOccurrence.hxx>
#include <StepRepr_PropertyDefinition.hxx>
#include <StepRepr_RepresentationMap.hxx>
#include <StepRepr_RepresentationRelationshipWithTransformation.hxx>
#include <StepRepr_Transformation.hxx>
#include <StepShape_Block.hxx>
#include <StepShape_BooleanResult.hxx>
#include <StepShape_ConnectedFaceSet.hxx>
#include <StepShape_ContextDependentShapeRepresentation.hxx>
#include <StepShape_EdgeBasedWireframeModel.hxx>
#include <StepShape_EdgeCurve.hxx>
#include <StepShape_EdgeLoop.hxx>
#include <StepShape_Face.hxx>
#include <StepShape_FaceBasedSurfaceModel.hxx>
#include <StepShape_GeometricSet.hxx>
#include <StepShape_ManifoldSolidBrep.hxx>
#include <StepShape_RightAngularWedge.hxx>
#include <StepShape_RightCircularCone.hxx>
#include <StepShape_RightCircularCylinder.hxx>
#include <StepShape_ShapeDefinitionRepresentation.hxx>
#include <StepShape_ShapeRepresentation.hxx>
#include <StepShape_ShellBasedSurfaceModel.hxx>
#include <StepShape_SolidModel.hxx>
#include <StepShape_Sphere.hxx>
#include <StepShape_Torus.hxx>
#include <TColStd_MapOfTransient.hxx>
#include <TopExp_Explorer.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Vec.hxx>
#include <string_view>

#include "formats/step_impl.h"
#include "formats/transfer_impl.h"

namespace paver {
namespace {

using Entity = Handle(Standard_Transient);

constexpr double least_scale = 1e-9;  // by which sizes may be off 1 and none is meant

template <class... Types>
bool is_any(const Entity& entity) {
  return !entity.IsNull() && (entity->IsKind(STANDARD_TYPE(Types)) || ...);
}

/// Whether a test holds for any of some entities.
template <class Test>
bool any_of(Interface_EntityIterator entities, Test test) {
  for (; entities.More(); entities.Next())
    if (test(entities.Value())) return true;
  return false;
}

/// Of which something has to come by itself.
bool is_shape(const Entity& entity) {
  return is_any<StepShape_Face, StepShape_EdgeLoop, StepShape_EdgeCurve, StepShape_ConnectedFaceSet,
                StepShape_SolidModel, StepShape_ShellBasedSurfaceModel, StepShape_FaceBasedSurfaceModel,
                StepShape_EdgeBasedWireframeModel, StepShape_GeometricSet, StepShape_Block, StepShape_Sphere,
                StepShape_Torus, StepShape_RightAngularWedge, StepShape_RightCircularCylinder,
                StepShape_RightCircularCone, StepShape_BooleanResult>(entity);
}

/// What came of a shell may be known only to the solid or the surface model that has it: it is lost with its faces. One
/// that turns another one over has its faces a level deeper.
bool has_lost_face(const LostEntities& lost, const Interface_Graph& graph, const Entity& shell, int levels = 1) {
  return any_of(graph.Shareds(shell), [&](const Entity& inner) {
    if (is_any<StepShape_Face>(inner)) return lost.is_lost(inner);
    return is_any<StepShape_ConnectedFaceSet>(inner) && levels > 0 && has_lost_face(lost, graph, inner, levels - 1);
  });
}

bool is_of(const char* package, const Entity& entity) {
  return std::string_view(entity->DynamicType()->Name()).starts_with(package);
}

/// Part of a drawing, of dimensions or of what a shape was constructed with, and of no shape: the kernel leaves these.
bool is_beside_shapes(const Interface_Graph& graph, const Entity& entity) {
  const Interface_EntityIterator users = graph.Sharings(entity);
  return users.NbEntities() > 0 && !any_of(users, [&](const Entity& user) {
           return is_of("StepShape_", user) ||
                  (!is_any<StepRepr_Representation>(user) && !is_any<StepShape_GeometricSet>(entity));
         });
}

/// A surface or a curve that stands for itself.
bool is_in_set(const Interface_Graph& graph, const Entity& entity) {
  return is_any<StepGeom_Surface, StepGeom_Curve>(entity) && any_of(graph.Sharings(entity), [&](const Entity& user) {
           return is_any<StepShape_GeometricSet>(user) && !is_beside_shapes(graph, user);
         });
}

/// Whether a representation has any shape, or leads to one: one for a part alone may refer to one with its shape.
bool leads_to_shape(const Interface_Graph& graph, const Entity& start) {
  std::vector<Entity> open{start};
  TColStd_MapOfTransient seen;
  while (!open.empty()) {
    const Entity entity = open.back();
    open.pop_back();
    if (!seen.Add(entity)) continue;
    if (is_shape(entity)) return true;
    for (Interface_EntityIterator inner = graph.Shareds(entity); inner.More(); inner.Next())
      if (!is_any<StepBasic_ProductDefinition>(inner.Value())) open.push_back(inner.Value());
    if (!is_any<StepRepr_Representation, StepBasic_ProductDefinition, StepRepr_ProductDefinitionUsage,
                StepRepr_PropertyDefinition>(entity))
      continue;
    for (Interface_EntityIterator user = graph.Sharings(entity); user.More(); user.Next())
      if (is_any<StepRepr_PropertyDefinition, StepShape_ShapeDefinitionRepresentation,
                 StepShape_ContextDependentShapeRepresentation>(user.Value()) ||
          user.Value()->IsInstance(STANDARD_TYPE(StepRepr_ShapeRepresentationRelationship)))
        open.push_back(user.Value());
  }
  return false;
}

/// Whether only colours and drawings have it.
bool is_presented_only(const Interface_Graph& graph, const Entity& entity) {
  const Interface_EntityIterator users = graph.Sharings(entity);
  return users.NbEntities() > 0 && !any_of(users, [](const Entity& user) { return !is_of("StepVisual_", user); });
}

/// A part at a place of an assembly. Parts may be empty, representations of drawings are mapped as well, and drawings
/// map parts.
bool is_placed_shape(const Interface_Graph& graph, const Entity& entity) {
  if (const auto mapped = Handle(StepRepr_MappedItem)::DownCast(entity); !mapped.IsNull())
    return !mapped->MappingSource().IsNull() && !is_presented_only(graph, entity) &&
           is_any<StepShape_ShapeRepresentation>(mapped->MappingSource()->MappedRepresentation()) &&
           leads_to_shape(graph, mapped->MappingSource()->MappedRepresentation());
  const auto usage = Handle(StepRepr_NextAssemblyUsageOccurrence)::DownCast(entity);
  return !usage.IsNull() &&
         (leads_to_shape(graph, usage) ||
          (!usage->RelatedProductDefinition().IsNull() && leads_to_shape(graph, usage->RelatedProductDefinition())));
}

// By name, as older kernels have no such class.
bool is_tessellated(const Entity& entity) { return is_of("StepVisual_Tessellated", entity); }

bool is_exact(const Entity& representation) { return !representation.IsNull() && !is_tessellated(representation); }

/// Triangles that stand for themselves among exact shapes.
bool is_tessellated_item(const Interface_Graph& graph, const Entity& entity) {
  return is_tessellated(entity) && any_of(graph.Sharings(entity), [](const Entity& user) {
           return is_any<StepShape_ShapeRepresentation>(user) && is_exact(user);
         });
}

/// Whether a representation that could not be read is not the only one of its part: tessellated and exact ones of one
/// part may stand side by side. True for all other entities.
bool has_representation(const Interface_Graph& graph, const Entity& entity) {
  const auto link = Handle(StepShape_ShapeDefinitionRepresentation)::DownCast(entity);
  if (link.IsNull() || is_exact(link->UsedRepresentation())) return true;
  const Entity part = link->Definition().Value();
  return part.IsNull() || any_of(graph.Sharings(part), [](const Entity& user) {
           const auto other = Handle(StepShape_ShapeDefinitionRepresentation)::DownCast(user);
           return !other.IsNull() && is_exact(other->UsedRepresentation());
         });
}

bool is_axes(const Entity& placement) { return is_any<StepGeom_Axis2Placement3d>(placement); }

/// Shapes or places of them, which dimensions and drawings have not.
bool has_shapes(const Entity& entity) {
  const auto representation = Handle(StepShape_ShapeRepresentation)::DownCast(entity);
  if (representation.IsNull() || representation->Items().IsNull()) return false;
  for (const Handle(StepRepr_RepresentationItem) & item : *representation->Items())
    if (is_axes(item) || is_shape(item) || is_any<StepRepr_MappedItem>(item)) return true;
  return false;
}

/// Without a scale and no mirror image, of which the kernel makes turned parts of the same size. The second axis alone
/// says on which side it is: ISO 10303-42, base_axis.
bool is_motion(const Entity& entity) {
  const auto operation = Handle(StepGeom_CartesianTransformationOperator3d)::DownCast(entity);
  if (operation.IsNull() || operation->LocalOrigin().IsNull()) return false;
  if (operation->HasScale() && std::abs(operation->Scale() - 1) > least_scale) return false;
  if (!operation->HasAxis2()) return true;
  const auto axis = [](bool has, const Handle(StepGeom_Direction) & direction, const gp_Vec& otherwise) {
    if (!has || direction.IsNull() || direction->NbDirectionRatios() < 3) return otherwise;
    return gp_Vec(direction->DirectionRatiosValue(1), direction->DirectionRatiosValue(2),
                  direction->DirectionRatiosValue(3));
  };
  const gp_Vec x = axis(operation->HasAxis1(), operation->Axis1(), gp_Vec(1, 0, 0)),
               y = axis(true, operation->Axis2(), gp_Vec(0, 1, 0)),
               z = axis(operation->HasAxis3(), operation->Axis3(), gp_Vec(0, 0, 1));
  return z.Crossed(x).Dot(y) > 0;
}

bool is_placed_as_stated(const Entity& entity) {
  if (const auto mapped = Handle(StepRepr_MappedItem)::DownCast(entity); !mapped.IsNull()) {
    const Handle(StepRepr_RepresentationMap) source = mapped->MappingSource();
    if (source.IsNull() || !is_any<StepShape_ShapeRepresentation>(source->MappedRepresentation())) return true;
    return is_motion(mapped->MappingTarget()) || (is_axes(source->MappingOrigin()) && is_axes(mapped->MappingTarget()));
  }
  const auto relation = Handle(StepRepr_RepresentationRelationshipWithTransformation)::DownCast(entity);
  if (relation.IsNull()) return true;
  const Entity operation = relation->TransformationOperator().Value();
  const auto axes = Handle(StepRepr_ItemDefinedTransformation)::DownCast(operation);
  return axes.IsNull() ? is_motion(operation) : is_axes(axes->TransformItem1()) && is_axes(axes->TransformItem2());
}

/// Of a part without a shape here, of which the file says that another one has it; empty otherwise.
std::string other_file(const XSControl_Reader& reader, const Entity& entity) {
  const auto reference = Handle(StepAP214_AppliedDocumentReference)::DownCast(entity);
  if (reference.IsNull() || reference->Items().IsNull()) return "";
  const auto file = Handle(StepBasic_DocumentFile)::DownCast(reference->AssignedDocument());
  if (file.IsNull() || file->Id().IsNull()) return "";
  for (const StepAP214_DocumentReferenceItem& item : *reference->Items()) {
    const Handle(StepBasic_ProductDefinition) part = item.ProductDefinition();
    if (part.IsNull()) continue;
    const TopoDS_Shape shape = shape_of(reader, part);
    if (shape.IsNull() || !TopExp_Explorer(shape, TopAbs_VERTEX).More()) return file->Id()->ToCString();
  }
  return "";
}

}  // namespace

std::vector<std::string> open_solids(STEPControl_Reader& reader) {
  std::vector<std::string> labels;
  for (const Entity& entity : entities_of(reader)) {
    if (!is_any<StepShape_ManifoldSolidBrep>(entity)) continue;
    const TopoDS_Shape shape = shape_of(reader, entity);
    if (!shape.IsNull() && TopExp_Explorer(shape, TopAbs_SHELL, TopAbs_SOLID).More())
      labels.push_back(entity_label(reader, entity));
  }
  return labels;
}

std::vector<std::string> step_losses(STEPControl_Reader& reader) {
  if (!has_entities(reader)) return {};
  const LostEntities lost(reader);
  const Interface_Graph& graph = reader.WS()->Graph();
  std::vector<std::string> labels = lost.labels([&](const Entity& entity) {
    if (is_any<StepShape_ConnectedFaceSet>(entity)) return has_lost_face(lost, graph, entity);
    return is_shape(entity)
               ? !is_beside_shapes(graph, entity)
               : is_in_set(graph, entity) || is_tessellated_item(graph, entity) || is_placed_shape(graph, entity);
  });
  for (const Entity& entity : entities_of(reader)) {
    if (const std::string file = other_file(reader, entity); !file.empty())
      if (const std::string label = "'" + file + "' (another file)"; std::ranges::find(labels, label) == labels.end())
        labels.push_back(label);
    if (!has_representation(graph, entity)) labels.push_back(entity_label(reader, entity));
    if (!is_placed_as_stated(entity)) labels.push_back(entity_label(reader, entity) + " (position)");
    if (has_shapes(entity) && !is_measured_as_stated(entity))
      labels.push_back(entity_label(reader, entity) + " (unit of length)");
  }
  return labels;
}

}  // namespace paver
