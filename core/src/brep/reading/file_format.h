// Which CAD format a file has, by its content.
#pragma once

#include <string>

namespace paver {

enum class FileFormat { step, iges, brep, binary_brep };

/// Name as it stands in the report: "STEP", "IGES", "BREP".
const char* format_name(FileFormat format);

/// Looks at the first and last bytes of a file, which messages call `name`. Throws file_missing when it cannot be read,
/// not_a_cad_file when it is empty or of another format, damaged_file when its end is missing.
FileFormat find_format(const std::string& path, const std::string& name);

}  // namespace paver
