// In: an IGES file after its transfer. Out: labels of what is not as the file has it. Steps: shapes of which nothing
// came; transformations of transformations; unit and scale.
#include <IGESData_BasicEditor.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESEntity.hxx>
#include <IGESData_IGESModel.hxx>
#include <IGESData_TransfEntity.hxx>
#include <algorithm>
#include <array>
#include <cmath>

#include "formats/iges_losses_impl.h"
#include "formats/lost_entities_impl.h"

namespace paver {
namespace {

constexpr double same_scale = 1e-9;
constexpr int named_unit = 3, last_unit = 11;  // unit flags: IGES 5.3, 2.2.4.3.14

// By number of type, IGES 5.3, 3.2: bounded, trimmed and curve-bounded surfaces; solids from primitives up to
// assemblies, B-rep solids, instances; subfigure instances, also in arrays; faces and shells.
constexpr std::array shape_types = {142, 143, 144, 150, 152, 154, 156, 158, 160, 162, 164, 168,
                                    180, 182, 184, 186, 408, 412, 414, 420, 430, 508, 510, 514};

bool is_shape(const Handle(Standard_Transient) & entity) {
  const auto part = Handle(IGESData_IGESEntity)::DownCast(entity);
  return !part.IsNull() && std::binary_search(shape_types.begin(), shape_types.end(), part->TypeNumber());
}

/// Flags and names as IGES 5.3 has them, of which the kernel takes all others for millimetres.
bool is_known_unit(const IGESData_GlobalSection& global) {
  if (global.UnitFlag() != named_unit) return global.UnitFlag() >= 1 && global.UnitFlag() <= last_unit;
  const Handle(TCollection_HAsciiString) name = global.UnitName();
  return !name.IsNull() && IGESData_BasicEditor::UnitNameFlag(name->ToCString()) > 0;
}

}  // namespace

std::vector<std::string> iges_losses(IGESControl_Reader& reader) {
  if (!has_entities(reader)) return {};
  std::vector<std::string> labels = LostEntities(reader).labels(is_shape);
  const Handle(IGESData_IGESModel) model = reader.IGESModel();
  for (int i = 1; i <= model->NbEntities(); ++i)
    if (const auto matrix = Handle(IGESData_TransfEntity)::DownCast(model->Value(i));
        !matrix.IsNull() && matrix->HasTransf())
      labels.push_back(entity_label(model, matrix) + " (transformation of its own)");
  const IGESData_GlobalSection& global = model->GlobalSection();
  if (!is_known_unit(global)) labels.emplace_back("unit of length");
  if (std::abs(global.Scale() - 1) > same_scale && global.Scale() != 0) labels.emplace_back("scale of the model");
  return labels;
}

}  // namespace paver
