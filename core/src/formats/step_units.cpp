// Units of the contexts of shapes: one of length, SI or converted to SI in one step.
#include <STEPConstruct_UnitContext.hxx>
#include <StepBasic_ConversionBasedUnitAndLengthUnit.hxx>
#include <StepBasic_HArray1OfNamedUnit.hxx>
#include <StepBasic_MeasureWithUnit.hxx>
#include <StepBasic_SiUnitAndLengthUnit.hxx>
#include <StepBasic_Unit.hxx>
#include <StepGeom_GeomRepContextAndGlobUnitAssCtxAndGlobUncertaintyAssCtx.hxx>
#include <StepGeom_GeometricRepresentationContextAndGlobalUnitAssignedContext.hxx>
#include <StepRepr_GlobalUnitAssignedContext.hxx>
#include <StepShape_ShapeRepresentation.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <optional>
#include <set>

#include "formats/step_impl.h"

namespace paver {
namespace {

constexpr double not_understood = 0;

/// In metres, nothing of other units than lengths. The kernel follows a conversion to an SI unit, and no further.
std::optional<double> length_of(const Handle(StepBasic_NamedUnit) & unit) {
  const auto metres = [](const Handle(StepBasic_SiUnit) & si) {
    if (si.IsNull() || si->Name() != StepBasic_sunMetre) return not_understood;
    return si->HasPrefix() ? STEPConstruct_UnitContext::ConvertSiPrefix(si->Prefix()) : 1;
  };
  if (unit.IsNull()) return {};
  if (unit->IsKind(STANDARD_TYPE(StepBasic_SiUnitAndLengthUnit)))
    return metres(Handle(StepBasic_SiUnit)::DownCast(unit));
  const auto converted = Handle(StepBasic_ConversionBasedUnitAndLengthUnit)::DownCast(unit);
  if (converted.IsNull()) return {};
  const Handle(StepBasic_MeasureWithUnit) measure = converted->ConversionFactor();
  if (measure.IsNull()) return not_understood;
  return measure->ValueComponent() * metres(Handle(StepBasic_SiUnit)::DownCast(measure->UnitComponent().Value()));
}

Handle(StepRepr_GlobalUnitAssignedContext) units_of(const Handle(StepRepr_RepresentationContext) & context) {
  if (const auto whole = Handle(StepGeom_GeomRepContextAndGlobUnitAssCtxAndGlobUncertaintyAssCtx)::DownCast(context);
      !whole.IsNull())
    return whole->GlobalUnitAssignedContext();
  if (const auto both = Handle(StepGeom_GeometricRepresentationContextAndGlobalUnitAssignedContext)::DownCast(context);
      !both.IsNull())
    return both->GlobalUnitAssignedContext();
  return Handle(StepRepr_GlobalUnitAssignedContext)::DownCast(context);
}

/// Units of length of a representation of a shape, in metres; nothing of other entities.
std::optional<std::set<double>> lengths_for(const Handle(Standard_Transient) & entity) {
  const auto representation = Handle(StepShape_ShapeRepresentation)::DownCast(entity);
  if (representation.IsNull()) return std::nullopt;
  std::set<double> lengths;
  const Handle(StepRepr_GlobalUnitAssignedContext) units = units_of(representation->ContextOfItems());
  for (int i = 1; !units.IsNull() && i <= units->NbUnits(); ++i)
    if (const auto length = length_of(units->UnitsValue(i))) lengths.insert(*length);
  return lengths;
}

}  // namespace

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

bool is_measured_as_stated(const Handle(Standard_Transient) & entity) {
  const auto lengths = lengths_for(entity);
  return !lengths || (lengths->size() == 1 && *lengths->begin() > 0);
}

double largest_unit(const Handle(Standard_Transient) & entity) {
  constexpr double millimetres = 1000;
  const auto lengths = lengths_for(entity);
  return lengths && !lengths->empty() ? millimetres * *lengths->rbegin() : 0;
}

}  // namespace paver
