// Loads a library by its name: where that is searched for stands in the program (CMAKE_BUILD_RPATH).
#include <dlfcn.h>

#include "brep/format_library_impl.h"

namespace paver {

FormatReader& format_library(const std::string& format, const FileSource& file) {
  const std::string name = "libpaver_" + format + ".so";
  void* library = ::dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);  // stays: OpenCASCADE keeps tables of it
  void* function = library ? ::dlsym(library, "paver_read_format") : nullptr;
  if (!function)
    throw Error(ErrorCode::internal, "'" + file.name + "' cannot be read without the library " + name + " (" +
                                         ::dlerror() + "); put it beside the program or build Paver again.");
  return *reinterpret_cast<FormatReader*>(function);
}

}  // namespace paver
