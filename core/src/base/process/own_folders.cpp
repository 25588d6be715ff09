#include "base/process/own_folders.h"

#include <dlfcn.h>
#include <unistd.h>

#include <filesystem>
#include <system_error>
#include <vector>

namespace paver {
namespace fs = std::filesystem;

std::optional<std::string> beside_us(const std::string& name, int mode) {
  Dl_info info{};
  std::error_code ignored;
  std::vector<fs::path> ours{fs::read_symlink("/proc/self/exe", ignored)};
  if (::dladdr(reinterpret_cast<const void*>(&beside_us), &info) && info.dli_fname)
    ours.insert(ours.begin(), fs::weakly_canonical(info.dli_fname, ignored));
  for (const fs::path& own : ours) {
    const fs::path folder = own.parent_path(), above = folder.parent_path(), top = above.parent_path();
    for (const fs::path& one : {folder, above / "core", top / "core", above / "lib" / "paver",
                                top.parent_path() / "paver", top.parent_path().parent_path() / "bin"})
      if (const fs::path path = one / name; fs::is_regular_file(path, ignored) && ::access(path.c_str(), mode) == 0)
        return path.string();
  }
  return std::nullopt;
}

}  // namespace paver
