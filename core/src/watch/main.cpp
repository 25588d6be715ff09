// paver-watch: what Paver starts for a run in several processes, and what starts mpirun. A program of its own, without
// the CAD kernel and MPI, because it must be there at once and has nothing to do with either.
#include <cstdio>

#include "watch/watch_run.h"

int main(int argc, char** argv) {
  constexpr int first_of_command = 3, usage_exit_code = 2;
  if (argc > first_of_command) return paver::watch_run({argv[1], argv[2]}, {argv + first_of_command, argv + argc});
  std::fputs("paver-watch: Paver starts this program itself, for 'paver mesh ... --ranks N'.\n", stderr);
  return usage_exit_code;
}
