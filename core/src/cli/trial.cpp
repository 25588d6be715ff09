// What goes wrong in orderly ways behind the reading is left to the process that asks: it will meet the same.
#include "trial.h"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <optional>

#include "paver/breakdown.h"
#include "paver/mesher.h"

namespace paver {
namespace {

/// Half of what the machine has: the system must not come to choose which process is to die.
void limit_memory() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_AS, &limit) != 0) return;
  const auto half = static_cast<rlim_t>(::sysconf(_SC_PHYS_PAGES)) * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE)) / 2;
  limit.rlim_cur = std::min(limit.rlim_cur, half);
  ::setrlimit(RLIMIT_AS, &limit);
}

void no_core_file() {
  const rlimit none{};
  ::setrlimit(RLIMIT_CORE, &none);
}

/// Nothing where the file is refused, and the reason is said.
std::optional<CadModel> read(const char* path, const char* name, Progress& progress) {
  try {
    return read_file(path, progress, name);
  } catch (const Error& error) {
    if (error.code() == ErrorCode::out_of_memory) throw;
    std::fputs(refusal_text(error).c_str(), stdout);
    return std::nullopt;
  }
}

int read_and_build(const char* path, const char* name) {
  Progress progress;
  Options options;
  options.size = 1;
  try {
    auto model = read(path, name, progress);
    if (!model) return 0;
    std::puts(stage_name(Stage::topology));
    std::fflush(stdout);
    predict(*model, options, progress);
  } catch (...) {
    if (current_error().code() == ErrorCode::out_of_memory) return out_of_memory_exit_code;
  }
  return 0;
}

}  // namespace

int try_file(const char* path, const char* name, long asking) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != asking) return 0;
  allow_breakdown();
  limit_memory();
  no_core_file();
  const int code = read_and_build(path, name);
  std::fflush(nullptr);
  ::_exit(code);
}

}  // namespace paver
