// Looks for the programs of a run, and prepares the variables by which Open MPI is told what it needs to know.
#include "launch/programs.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string_view>
#include <thread>

#include "base/process/own_folders.h"
#include "paver/error.h"

namespace paver {
namespace {

namespace fs = std::filesystem;

bool is_program(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored) && ::access(path.c_str(), X_OK) == 0;
}

std::optional<std::string> on_path(const char* name) {
  const char* path = std::getenv("PATH");
  std::string_view left = path ? path : "";
  while (!left.empty()) {
    std::string_view folder = left.substr(0, left.find(':'));
    left.remove_prefix(std::min(folder.size() + 1, left.size()));
    fs::path file = fs::path(folder) / name;
    if (!folder.empty() && is_program(file)) return file.string();
  }
  return std::nullopt;
}

/// The program that a variable names.
std::optional<std::string> from_variable(const char* variable, int ranks) {
  const char* path = std::getenv(variable);
  if (!path || !*path) return std::nullopt;
  if (is_program(path)) return path;
  throw Error(
      ErrorCode::bad_option,
      fmt::format("ranks is {}, but {} names '{}', which is no program; correct or unset it.", ranks, variable, path));
}

/// Whether a variable belongs to a run of MPI or to the batch system around it.
bool is_of_a_run(std::string_view variable, bool is_in_a_run) {
  if (!is_in_a_run)  // the user's own settings
    for (std::string_view start : {"OMPI_MCA_", "PRTE_MCA_", "PMIX_MCA_"})
      if (variable.starts_with(start)) return false;
  for (std::string_view start : {"OMPI_", "PMIX_", "PMI_", "PMI2_", "PRTE_", "SLURM_", "PBS_", "LSB_"})
    if (variable.starts_with(start)) return true;
  return false;
}

/// Whether the user has told Open MPI where to run ranks: then it must see the cores of this machine.
bool is_placed() {
  for (char** variable = environ; *variable; ++variable)
    for (std::string_view start :
         {"OMPI_MCA_hwloc_", "OMPI_MCA_rmaps_", "PRTE_MCA_hwloc_", "PRTE_MCA_rmaps_", "HWLOC_"})
      if (std::string_view(*variable).starts_with(start)) return true;
  return false;
}

bool is_in_a_run() {
  return std::getenv("OMPI_COMM_WORLD_RANK") || std::getenv("PMIX_RANK") || std::getenv("PMI_RANK");
}

/// Settings of Open MPI. They count only where the user has set nothing else, but for the folders. From version 5 on
/// mpirun reads its own as PRTE_MCA_..., and "sm" is the component that was "vader".
std::vector<std::pair<std::string, std::string>> settings(const RunFolder& folder, int ranks) {
  std::vector<std::pair<std::string, std::string>> list{
      {"TMPDIR", folder.path()},
      {"OMPI_MCA_orte_tmpdir_base", folder.path()},
      {"OMPI_MCA_btl_vader_backing_directory", folder.shared_memory()},
      {"OMPI_MCA_btl_sm_backing_directory", folder.shared_memory()},
      {"OMPI_MCA_plm", "isolated"},                // this machine only, no remote shell
      {"OMPI_MCA_rmaps_base_oversubscribe", "1"},  // more ranks than cores
      {"PRTE_MCA_rmaps_default_mapping_policy", "slot:oversubscribe"},
      {"OMPI_MCA_hwloc_base_binding_policy", "none"},  // ranks have threads
      {"PRTE_MCA_hwloc_default_binding_policy", "none"},
      {"OMPI_MCA_pml", "ob1"},                               // no search for networks, ...
      {"OMPI_MCA_btl", "self,vader"},                        // ... shared memory serves
      {"OMPI_MCA_btl_vader_single_copy_mechanism", "none"},  // containers forbid it, and it would not be faster here
      {"OMPI_MCA_odls_base_sigkill_timeout", "1"},
      {"PRTE_MCA_odls_base_sigkill_timeout", "1"}};
  if (ranks > static_cast<int>(std::thread::hardware_concurrency()))
    list.emplace_back("OMPI_MCA_mpi_yield_when_idle", "1");
  if (!is_placed()) list.emplace_back("HWLOC_COMPONENTS", "no_os,stop");  // no look at caches, graphics, X servers, ...
  if (::geteuid() == 0) {  // who runs us as root has decided that already
    list.emplace_back("OMPI_ALLOW_RUN_AS_ROOT", "1");
    list.emplace_back("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1");
  }
  return list;
}

}  // namespace

std::string find_mpirun(int ranks) {
  if (auto path = from_variable("PAVER_MPIRUN", ranks)) return *path;
  if (auto path = on_path("mpirun")) return *path;
  throw Error(ErrorCode::bad_option,
              fmt::format("ranks is {}, but there is no mpirun on the PATH; install Open MPI (package openmpi-bin), or "
                          "leave ranks out to mesh in this process.",
                          ranks));
}

std::string find_worker(int ranks) {
  if (auto path = from_variable("PAVER_WORKER", ranks)) return *path;
  if (auto path = beside_us("paver-worker", X_OK)) return *path;
  if (auto path = on_path("paver-worker")) return *path;
  throw Error(ErrorCode::bad_option,
              fmt::format("ranks is {}, but there is no program paver-worker; build Paver where Open MPI is installed "
                          "(package libopenmpi-dev), or leave ranks out to mesh in this process.",
                          ranks));
}

std::string find_watcher(const std::string& worker, int ranks) {
  fs::path beside_worker = fs::path(worker).parent_path() / "paver-watch";
  if (is_program(beside_worker)) return beside_worker.string();
  if (auto path = beside_us("paver-watch", X_OK)) return *path;
  if (auto path = on_path("paver-watch")) return *path;
  throw Error(
      ErrorCode::bad_option,
      fmt::format("ranks is {}, but there is no program paver-watch beside '{}'; install both, or leave ranks out "
                  "to mesh in this process.",
                  ranks, worker));
}

std::vector<std::string> rank_environment(const RunFolder& folder, int ranks) {
  std::vector<std::string> list;
  bool is_inside = is_in_a_run();
  for (char** variable = environ; *variable; ++variable)
    if (!is_of_a_run(*variable, is_inside)) list.emplace_back(*variable);
  for (const auto& [name, value] : settings(folder, ranks)) {
    const std::string start = name + "=";
    auto same = std::find_if(list.begin(), list.end(), [&](const std::string& v) { return v.starts_with(start); });
    bool is_folder = value == folder.path() || value == folder.shared_memory();
    if (same == list.end()) {
      list.push_back(start + value);
    } else if (is_folder) {
      *same = name + "=" + value;
    }
  }
  return list;
}

}  // namespace paver
