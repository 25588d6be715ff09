// paver-worker: one rank of a run in several processes, started by mpirun or srun.
// core/docs/ranks.md has the contract.
#include <fmt/format.h>
#include <mpi.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <sstream>

#include "base/process/run_files.h"
#include "base/tasks/gather.h"
#include "paver/breakdown.h"
#include "paver/launch.h"
#include "paver/mesher.h"
#include "worker/mpi_ranks.h"
#include "worker/reporter.h"

namespace paver {
namespace {

constexpr const char* usage = R"(One rank of a run of Paver in several processes; all of them together write one mesh.

  mpirun -n N paver-worker JOB.json     or srun -n N paver-worker JOB.json

JOB.json names the model, the options and the files to write: {"input": "wing.step", "mesh": "wing.msh",
"options": {"size": "5 mm"}}. All keys, the events for other programs and the exit codes: core/docs/ranks.md.
On one machine 'paver mesh ... --ranks N' does all this by itself.
)";

/// What `make` gives at rank 0, everywhere; what it throws there is thrown everywhere.
template <class F>
std::string from_rank_0(MpiRanks& ranks, F&& make) {
  std::string bytes;
  if (ranks.rank() == 0) {
    try {
      bytes = "+" + make();
    } catch (const Error& error) {
      bytes = "-" + pack_error(error);
    }
  }
  ranks.spread(bytes);
  bool is_sound = bytes.starts_with('+');
  bytes.erase(0, 1);
  if (!is_sound) throw_packed(bytes);
  return bytes;
}

/// Finds at rank 0 whether the files can be written. The temporary names they will have, which all ranks know, so that
/// whoever is left removes them.
std::vector<std::string> prepare_outputs(const Job& job, MpiRanks& ranks) {
  std::string names = from_rank_0(ranks, [&] {
    check_outputs(job.files, ranks.count());
    std::string list;
    for (const std::string& path : job.files.paths()) list += temporary_name(path) + "\n";
    if (!job.folder.empty()) write_run_file(job.folder + "/" + temporaries_file, list);
    return list;
  });
  std::vector<std::string> result;
  std::istringstream lines(names);
  for (std::string name; std::getline(lines, name);) result.push_back(name);
  return result;
}

Options options_of(const Job& job, const MpiRanks& ranks) {
  Options options = read_options(job.options);
  check(options);
  int cores = static_cast<int>(std::thread::hardware_concurrency());
  if (options.threads == 0) options.threads = std::max(1, cores / ranks.count_here());
  return options;
}

/// What goes back to the process that started the run: the whole mesh share by share, or the report alone.
void hand_back(const Job& job, MeshShare& share, const MpiRanks& ranks) {
  if (!job.folder.empty() && job.returns_mesh)
    write_run_file(fmt::format("{}/share{}", job.folder, ranks.rank()), pack_share(share));
  share.result.mesh = {};
  if (!job.folder.empty() && !job.returns_mesh && ranks.rank() == 0)
    write_run_file(job.folder + "/result", pack_result(share.result));
}

/// One job from its file to its outputs; the exit code.
int run_job(const std::string& path, MpiRanks& ranks, Progress& progress, std::optional<Reporter>& reporter) {
  auto start = std::chrono::steady_clock::now();
  Job job = parse_job(from_rank_0(ranks, [&] { return job_text(read_job(path)); }), path);
  reporter.emplace(progress, job, ranks.rank());
  Options options = options_of(job, ranks);
  reporter->set_temporaries(prepare_outputs(job, ranks));
  reporter->started(ranks.count(), options.threads);
  const std::string& name = job.name.empty() ? job.input : job.name;
  CadModel model =
      read_bytes(from_rank_0(ranks, [&] { return file_content(job.input, name); }), name, progress, job.labels);
  OutputFiles files = job.files;
  files.threads = options.threads;
  if (!files.repaired.empty()) files.repaired_text = repaired_model(model, options, progress);
  MeshShare share = mesh_share(model, options, progress, ranks);
  if (is_empty(share.result)) files.mesh.clear();
  write_outputs(share, files, progress, ranks);
  hand_back(job, share, ranks);
  std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  const std::vector<double> busy = gather_all(std::vector<double>{seconds.count() - ranks.waited_seconds()}, ranks);
  progress.begin(Stage::done);
  bool is_whole = !shortfall(share.result);
  if (ranks.rank() == 0) reporter->done(share.result, busy);
  ranks.finish();
  return is_whole ? 0 : exit_code(ErrorCode::face_failed);
}

/// Until MPI ends this rank, too, because another one has failed.
void wait_for_abort(const Progress& progress) {
  constexpr std::chrono::milliseconds longest(2000), interval(10);
  for (auto waited = interval; waited < longest && !progress.is_cancelled(); waited += interval)
    std::this_thread::sleep_for(interval);
}

/// Until mpirun has read what this rank has said: what it has not read when a rank aborts it may forget.
void wait_for_reader(int descriptor) {
  constexpr std::chrono::milliseconds interval(5);
  constexpr int most_looks = 200;
  int unread = 0;
  for (int looks = 0; looks < most_looks && ::ioctl(descriptor, FIONREAD, &unread) == 0 && unread > 0; ++looks)
    std::this_thread::sleep_for(interval);
}

/// Others may wait for this rank for ever: all must end. Of ranks that fail alike the first one says so.
[[noreturn]] void end_all(const Error& error, const Progress& progress, MpiRanks& ranks,
                          std::optional<Reporter>& reporter) {
  bool is_cancelled = error.code() == ErrorCode::cancelled;
  if (!is_cancelled && !ranks.is_first()) {
    wait_for_abort(progress);
    reporter ? reporter->end_process(exit_code(error.code())) : ::_exit(exit_code(error.code()));
  }
  if (reporter) {
    reporter->failed(error);
    if (is_cancelled) reporter->end_process(exit_code(error.code()));
    reporter->remove_temporaries();
  } else if (!is_cancelled || ranks.rank() == 0) {  // all ranks are cancelled; one says so
    fmt::print(stderr, "paver-worker: {}\n", error.what());
  }
  for (int descriptor : {STDOUT_FILENO, STDERR_FILENO}) wait_for_reader(descriptor);
  MPI_Abort(MPI_COMM_WORLD, exit_code(error.code()));
  ::_exit(exit_code(error.code()));
}

int run_rank(const std::string& path, int argc, char** argv) {
  static Progress progress;
  allow_breakdown();  // whoever started the run says so
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_SERIALIZED, &provided);
  listen_to_signals(progress);
  int code = 0;
  {
    MpiRanks ranks(progress);
    std::optional<Reporter> reporter;
    try {
      if (provided < MPI_THREAD_SERIALIZED)
        throw Error(ErrorCode::internal, "This MPI does not allow threads; install one that does, as Open MPI.");
      code = run_job(path, ranks, progress, reporter);
    } catch (...) {
      end_all(current_error(), progress, ranks, reporter);
    }
  }
  MPI_Finalize();
  return code;
}

int run(int argc, char** argv) {
  std::vector<std::string> arguments(argv + 1, argv + argc);
  std::string first = arguments.empty() ? "--help" : arguments[0];
  if (first == "--version") return fmt::print("paver-worker {}\n", PAVER_VERSION), 0;
  if (first == "--help" || first == "-h") return fmt::print("{}", usage), arguments.empty() ? 2 : 0;
  if (arguments.size() == 1 && !first.starts_with('-')) return run_rank(first, argc, argv);
  fmt::print(stderr, "paver-worker: One argument is needed, the path of a job file; see paver-worker --help.\n");
  return exit_code(ErrorCode::bad_option);
}

}  // namespace
}  // namespace paver

int main(int argc, char** argv) { return paver::run(argc, argv); }
