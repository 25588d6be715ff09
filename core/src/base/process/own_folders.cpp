#include "base/process/own_folders.h"

#include <dlfcn.h>

#include <system_error>

namespace paver {
namespace fs = std::filesystem;

std::vector<fs::path> own_folders() {
  Dl_info info{};
  std::error_code ignored;
  std::vector<fs::path> ours{fs::read_symlink("/proc/self/exe", ignored)};
  if (::dladdr(reinterpret_cast<const void*>(&own_folders), &info) && info.dli_fname)
    ours.insert(ours.begin(), fs::weakly_canonical(info.dli_fname, ignored));
  std::vector<fs::path> folders;
  for (const fs::path& own : ours) {
    const fs::path folder = own.parent_path(), above = folder.parent_path(), top = above.parent_path();
    for (const fs::path& one : {folder, above / "core", top / "core"}) folders.push_back(one);
    for (const fs::path& one :
         {above / "lib" / "paver", top.parent_path() / "paver", top.parent_path().parent_path() / "bin"})
      folders.push_back(one);
  }
  return folders;
}

}  // namespace paver
