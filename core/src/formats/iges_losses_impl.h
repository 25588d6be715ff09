// What an IGES file has and the kernel leaves out, or reads otherwise than it is meant.
#pragma once

#include <IGESControl_Reader.hxx>
#include <string>
#include <vector>

namespace paver {

/// Labels of shapes of which nothing came, of transformations that have one of their own, which is not applied, and of
/// a unit and a scale of the model that are not understood. After the transfer.
std::vector<std::string> iges_losses(IGESControl_Reader& reader);

}  // namespace paver
