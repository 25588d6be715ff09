// What a STEP file has and the kernel leaves out, or reads otherwise than it is meant.
#pragma once

#include <STEPControl_Reader.hxx>
#include <string>
#include <vector>

namespace paver {

/// Labels of shapes of which nothing came, of positions of parts that are not as the file has them (a scale, a mirror
/// image or no placement at all), and of units of length that are not as stated. After the transfer.
std::vector<std::string> step_losses(STEPControl_Reader& reader);

/// Labels of solids that came without a closed shell.
std::vector<std::string> open_solids(STEPControl_Reader& reader);

}  // namespace paver
