#include <STEPConstruct_UnitContext.hxx>
#include <StepBasic_ConversionBasedUnitAndLengthUnit.hxx>
#include <StepBasic_HArray1OfNamedUnit.hxx>
#include <StepBasic_MeasureWithUnit.hxx>
#include <StepBasic_SiUnit.hxx>
#include <StepBasic_Unit.hxx>
#include <StepGeom_GeomRepContextAndGlobUnitAssCtxAndGlobUncertaintyAssCtx.hxx>
#include <StepGeom_GeometricRepresentationContextAndGlobalUnitAssignedContext.hxx>
#include <StepRepr_GlobalUnitAssignedContext.hxx>
#include <StepShape_ShapeRepresentation.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <cmath>
#include <optional>
#include <set>

#include "formats/step_units_impl.h"

namespace paver {
namespace {

constexpr double millimetres_per_metre = 1000;
constexpr int most_conversions = 8;  // from unit to unit; more is a circle
constexpr double same_factor = 1e-9;

/// In millimetres; 0 of what cannot be worked out, nothing of other units than lengths.
std::optional<double> length_of(const Handle(Standard_Transient) & entity, int conversions = 0) {
  if (const auto unit = Handle(StepBasic_SiUnit)::DownCast(entity); !unit.IsNull()) {
    if (unit->Name() != StepBasic_sunMetre) return {};
    return millimetres_per_metre * (unit->HasPrefix() ? STEPConstruct_UnitContext::ConvertSiPrefix(unit->Prefix()) : 1);
  }
  const auto unit = Handle(StepBasic_ConversionBasedUnit)::DownCast(entity);
  if (unit.IsNull()) return {};
  const Handle(StepBasic_MeasureWithUnit) measure = unit->ConversionFactor();
  if (measure.IsNull() || conversions > most_conversions)
    return entity->IsKind(STANDARD_TYPE(StepBasic_ConversionBasedUnitAndLengthUnit)) ? std::optional(0.0)
                                                                                     : std::nullopt;
  const auto inner = length_of(measure->UnitComponent().Value(), conversions + 1);
  return inner ? std::optional(*inner * measure->ValueComponent()) : std::nullopt;
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
  const auto representation = Handle(StepShape_ShapeRepresentation)::DownCast(entity);
  if (representation.IsNull()) return true;
  const Handle(StepRepr_GlobalUnitAssignedContext) units = units_of(representation->ContextOfItems());
  if (units.IsNull()) return false;
  std::set<double> lengths;
  for (int i = 1; i <= units->NbUnits(); ++i)
    if (const auto length = length_of(units->UnitsValue(i))) lengths.insert(*length);
  STEPConstruct_UnitContext factors;
  factors.ComputeFactors(units);
  return lengths.size() == 1 && factors.LengthDone() &&
         std::abs(factors.LengthFactor() / *lengths.begin() - 1) < same_factor;
}

}  // namespace paver
