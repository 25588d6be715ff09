// IGES: reads the file, transfers all roots (also blanked ones) in millimetres, and takes names of faces along.
#include <IGESControl_Reader.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESEntity.hxx>
#include <IGESData_IGESModel.hxx>

#include "formats/exchange_settings_impl.h"
#include "formats/iges_losses_impl.h"
#include "formats/transfer_impl.h"

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

Handle(TCollection_HAsciiString) face_name(const Handle(Standard_Transient) & entity) {
  Handle(IGESData_IGESEntity) part = Handle(IGESData_IGESEntity)::DownCast(entity);
  const bool is_face = !part.IsNull() && (part->TypeNumber() == trimmed_surface || part->TypeNumber() == face_entity);
  return is_face ? part->NameValue() : Handle(TCollection_HAsciiString)();
}

}  // namespace

extern "C" void paver_read_format(const FileSource& file, std::string_view /*content*/, const Doubt& doubt,
                                  Shape& shape, ModelReport& report, Progress& progress) {
  IGESControl_Reader reader;
  MillimetreReading millimetres;
  check_loaded(reader.ReadFile(file.path.c_str()), file, "IGES", progress);
  Handle(IGESData_IGESModel) model = reader.IGESModel();
  if (!model.IsNull()) report.unit = stated_unit(model);
  if (has_fails(model)) doubt();
  reader.SetReadVisible(Standard_False);
  transfer(reader, shape, progress, face_name);
  report.unread = iges_losses(reader);
}

}  // namespace paver
