#include "base/process/run_files.h"

#include <fmt/format.h>

#include <fstream>

#include "paver/error.h"

namespace paver {

void write_run_file(const std::string& path, std::span<const char> content) {
  std::ofstream out(path, std::ios::binary);
  out.write(content.data(), static_cast<std::streamsize>(content.size()));
  out.close();
  if (!out)
    throw Error(ErrorCode::unwritable_output,
                fmt::format("Cannot write the temporary file '{}'; free some space or set TMPDIR.", path));
}

}  // namespace paver
