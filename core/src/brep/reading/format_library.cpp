#include <dlfcn.h>
#include <unistd.h>

#include <Standard_Transient.hxx>
#include <typeinfo>

#include "base/process/own_folders.h"
#include "brep/reading/readers_impl.h"

namespace paver {
namespace {

/// A host may have loaded another OpenCASCADE for all to see: what we load must take ours all the same.
int search_order() {
  void* everyone = ::dlopen(nullptr, RTLD_NOW);
  const void* theirs = everyone ? ::dlsym(everyone, "_ZTI18Standard_Transient") : nullptr;
  return theirs && theirs != &typeid(Standard_Transient) ? RTLD_DEEPBIND : 0;
}

}  // namespace

FormatReader& format_library(const std::string& format, const FileSource& file) {
  const std::string name = "libpaver_" + format + ".so";
  // Where it is not beside us the system may know it. It stays: OpenCASCADE keeps tables of it.
  void* library = ::dlopen(beside_us(name, F_OK).value_or(name).c_str(), RTLD_NOW | RTLD_LOCAL | search_order());
  void* function = library ? ::dlsym(library, "paver_read_format") : nullptr;
  if (!function)
    throw Error(ErrorCode::internal, "'" + file.name + "' cannot be read without the library " + name + " (" +
                                         ::dlerror() + "); put it beside the program or build Paver again.");
  return *reinterpret_cast<FormatReader*>(function);
}

}  // namespace paver
