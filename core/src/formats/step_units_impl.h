// Units of length in STEP files.
#pragma once

#include <STEPControl_Reader.hxx>
#include <Standard_Transient.hxx>
#include <string>

namespace paver {

/// What the file calls its units of length, or "not stated".
std::string stated_unit(STEPControl_Reader& reader);

/// Of a representation of a shape, whether it states one unit of length that the kernel understands: that takes
/// millimetres where it finds none, the last of several, and of a unit that is defined by another than an SI unit only
/// the number (ISO 10303-41, conversion_based_unit). True for all other entities.
bool is_measured_as_stated(const Handle(Standard_Transient) & entity);

/// Of a representation of a shape, mm; 0 for other entities, and where the kernel understands none.
double largest_unit(const Handle(Standard_Transient) & entity);

}  // namespace paver
