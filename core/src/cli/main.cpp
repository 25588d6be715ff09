// paver mesh FILE -o OUT: reads the command line, meshes, writes, and turns every outcome into an exit code and, where
// it failed, one sentence on stderr. The contract: core/docs/quality.md lists the report, --help the rest.
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "arguments.h"
#include "guard.h"
#include "paver/breakdown.h"
#include "paver/launch.h"
#include "paver/mesher.h"
#include "terminal.h"
#include "trial.h"

namespace paver {
namespace {

MeshResult mesh_in_other_processes(const Arguments& arguments, Progress& progress) {
  // Longer than those processes take to end once they are told to.
  Terminal terminal(progress, arguments.is_quiet, {}, std::chrono::milliseconds(5000));
  Job job;
  job.input = arguments.input;
  job.options = arguments.given;
  job.files = arguments.files;
  MeshResult result = mesh_in_ranks(job, arguments.options.ranks, progress).result;
  progress.begin(Stage::done);
  return result;
}

MeshResult mesh_and_write(const Arguments& arguments, Progress& progress) {
  std::vector<std::string> temporaries;
  for (const std::string& path : arguments.files.paths()) temporaries.push_back(temporary_name(path));
  Terminal terminal(progress, arguments.is_quiet, temporaries);
  const CadModel model = read_file(arguments.input, progress);
  OutputFiles files = arguments.files;
  files.threads = arguments.options.threads;
  if (!files.repaired.empty()) files.repaired_text = repaired_model(model, arguments.options, progress);
  MeshResult result = mesh_model(model, arguments.options, progress);
  if (is_empty(result)) files.mesh.clear();
  write_outputs(result, files, progress);
  progress.begin(Stage::done);
  return result;
}

int mesh(const Arguments& arguments, Progress& progress) {
  check(arguments.options);
  check_outputs(arguments.files, std::max(arguments.options.ranks, 1));
  MeshResult result =
      arguments.options.ranks > 0 ? mesh_in_other_processes(arguments, progress) : mesh_and_write(arguments, progress);
  if (!arguments.is_quiet) {
    std::string table = report_table(result.report);
    std::fwrite(table.data(), 1, table.size(), stdout);
  }
  if (auto error = shortfall(result)) throw Error(*error);
  return 0;
}

int run(int argc, const char* const* argv) {
  try {
    Arguments arguments;
    if (auto finished = read_arguments(argc, argv, arguments)) return *finished;
    return mesh(arguments, guard_run(arguments));
  } catch (...) {
    const Error error = current_error();
    complain(with_command_line_names(error.what()));
    return exit_code(error.code());
  }
}

}  // namespace
}  // namespace paver

int main(int argc, char** argv) {
  paver::open_standard_streams();
  constexpr int with_trial = 5;
  if (argc == with_trial && std::string_view(argv[1]) == paver::trial_command)
    return paver::try_file(argv[2], argv[3], std::strtol(argv[4], nullptr, 10));
  return paver::run(argc, argv);
}
