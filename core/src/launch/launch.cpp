// A run in several processes, seen from the process that asked for it.
//
// What is started is paver-watch, the watcher: it starts mpirun, waits for it, ends all that is left of the run and
// removes the temporary folders, also when this process is gone, which it sees by its stdin. Ranks tell how far they
// are through a named pipe; when our end of it closes they stop by themselves. Once they have said that their outputs
// are in place, nobody waits for them to take leave of each other: the watcher kills them.
#include "paver/launch.h"

#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <regex>
#include <sstream>
#include <string_view>
#include <thread>

#include "base/process/child.h"
#include "base/process/run_files.h"
#include "launch/events.h"
#include "launch/programs.h"
#include "launch/run_folder.h"
#include "paver/breakdown.h"

namespace paver {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int poll_milliseconds = 20;
constexpr std::chrono::milliseconds patience(3000);  // the watcher itself needs at most two seconds
constexpr long units = 1000;                         // of a stage, in our progress

/// Passes the ranks' progress on, and keeps how they ended.
class Listener {
 public:
  explicit Listener(Progress& progress) : progress_(progress) {}

  void hear(const Event& event) {
    switch (event.kind) {
      case Event::Kind::progress:
        follow(event);
        break;
      case Event::Kind::error:
        if (!error_ || error_->code() == ErrorCode::cancelled) error_.emplace(*event.error);
        break;
      case Event::Kind::done:
        busy_ = event.busy;
        break;
      case Event::Kind::other:
        break;
    }
  }
  /// The first error that is not only the answer to another one's.
  const std::optional<Error>& error() const { return error_; }
  const std::optional<std::vector<double>>& busy() const { return busy_; }

 private:
  void follow(const Event& event) {
    if (progress_.is_cancelled()) return;
    try {
      if (event.stage != progress_.stage() || !has_begun_) {
        progress_.begin(event.stage, units);
        credited_ = 0;
        has_begun_ = true;
      }
      long now = static_cast<long>(event.fraction * units);
      if (now > credited_) progress_.advance(now - credited_);
      credited_ = std::max(credited_, now);
    } catch (const Error&) {
      // Cancelled in between; the loop sees it next.
    }
  }

  Progress& progress_;
  bool has_begun_ = false;
  long credited_ = 0;
  std::optional<Error> error_;
  std::optional<std::vector<double>> busy_;
};

std::string read_and_remove(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  std::error_code ignored;
  std::filesystem::remove(path, ignored);
  return bytes;
}

/// What the ranks left in the run's folder for us.
MeshResult take_result(const RunFolder& folder, int ranks, bool has_mesh) {
  if (!has_mesh) return unpack_result(read_and_remove(folder.file("result")));
  MeshResult whole;
  for (int rank = 0; rank < ranks; ++rank)
    add_share(unpack_share(read_and_remove(folder.file(fmt::format("share{}", rank)))), whole);
  return whole;
}

/// Until the watcher has closed its output, by which it says that all ranks have ended.
void wait_for_ranks(Child& child, EventPipe& pipe, Listener& listener, const Progress& progress) {
  std::optional<Clock::time_point> stopped;
  bool is_open = true, is_done = false;
  while (is_open) {
    pollfd waited[] = {{pipe.descriptor(), POLLIN, 0}, {child.output(), POLLIN, 0}};
    ::poll(waited, 2, poll_milliseconds);
    is_open = child.read_output();
    for (const Event& event : pipe.read()) listener.hear(event);
    if (listener.busy() && !is_done) {
      is_done = true;
      child.poke();
    }
    if (progress.is_cancelled() && !stopped) {
      stopped = Clock::now();
      child.stop();
      pipe.close();
    }
    if (stopped && Clock::now() - *stopped > patience) child.kill();
  }
}

/// Tells the watcher that its folders are not needed any more, and waits until it has removed them. What waitpid() says
/// of the watcher, which ends as mpirun ended.
int wait_for_end(Child& child) {
  child.stop();
  auto start = Clock::now();
  while (!child.status()) {
    if (Clock::now() - start > patience) child.kill();
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  return *child.status();
}

/// What mpirun says when a rank ended by a signal; it breaks its lines anywhere.
std::optional<Error> lost_rank(const std::string& name, const std::string& output, int ranks,
                               const Progress& progress) {
  static const std::regex rank_words("process\\s+rank\\s+(\\d{1,9})"),
      signal_words("exited\\s+on\\s+signal\\s+(\\d{1,9})");
  std::smatch rank, signal;
  if (!std::regex_search(output, rank, rank_words) ||
      !std::regex_search(rank[0].second, output.end(), signal, signal_words))
    return std::nullopt;
  return breakdown(name, progress.stage(), std::stoi(signal[1]), fmt::format("Rank {} of {}", rank[1].str(), ranks),
                   "fewer ranks or a larger target length");
}

/// What the system says when it cannot start the ranks for want of a library.
std::optional<Error> missing_library(const std::string& output, int ranks) {
  constexpr std::string_view words = "error while loading shared libraries: ";
  const std::size_t at = output.find(words);
  if (at == std::string::npos) return std::nullopt;
  const std::size_t start = at + words.size();
  const std::string library = output.substr(start, output.find_first_of(":\n", start) - start);
  const bool is_of_mpi = library.starts_with("libmpi") || library.starts_with("libopen-");
  const char* remedy = is_of_mpi ? "install Open MPI (package openmpi-bin) and start it with its own mpirun"
                                 : "install Paver again, as it was made for this system";
  return Error(ErrorCode::bad_option,
               fmt::format("ranks is {}, but paver-worker does not start without the library {}; {}, or leave ranks "
                           "out to mesh in this process.",
                           ranks, library, remedy));
}

/// The first line of mpirun's output with two letters next to each other.
std::string first_words(const std::string& output) {
  auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);)
    if (std::adjacent_find(line.begin(), line.end(), [&](char a, char b) { return is_letter(a) && is_letter(b); }) !=
        line.end())
      return line;
  return "it says nothing";
}

[[noreturn]] void fail(const std::string& name, const Child& child, int status, int ranks, const Listener& listener,
                       const Progress& progress) {
  if (progress.is_cancelled()) progress.check();
  const std::optional<Error>& error = listener.error();
  if (error && error->code() != ErrorCode::cancelled) throw Error(*error);
  if (auto lost = lost_rank(name, child.last_output(), ranks, progress)) throw Error(*lost);
  if (auto missing = missing_library(child.last_output(), ranks)) throw Error(*missing);
  int number = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status) - signal_exit_code;
  if (number == SIGKILL)
    throw Error(ErrorCode::internal,
                fmt::format("mpirun was ended by signal {} in stage {}; nothing was written, find out "
                            "who kills processes here, or leave ranks out.",
                            number, stage_name(progress.stage())));
  if (error) throw Error(*error);
  throw Error(ErrorCode::internal, fmt::format("mpirun ended with exit code {} before the mesh was written ({}); check "
                                               "that 'mpirun -n {} true' works here.",
                                               WEXITSTATUS(status), first_words(child.last_output()), ranks));
}

/// With fewer than it needs mpirun waits for ever; it was measured with 2 and 8 ranks.
void check_open_files(int ranks) {
  const rlim_t enough = 32 + 4 * static_cast<rlim_t>(ranks);
  rlimit allowed{};
  if (::getrlimit(RLIMIT_NOFILE, &allowed) != 0 || allowed.rlim_cur >= enough) return;
  throw Error(
      ErrorCode::bad_option,
      fmt::format("ranks is {}, which takes {} open files, and the system allows {}; allow more (ulimit -n), or "
                  "use fewer ranks.",
                  ranks, enough, allowed.rlim_cur));
}

}  // namespace

RanksResult mesh_in_ranks(const Job& job, int ranks, Progress& progress, std::span<const char> content) {
  std::string mpirun = find_mpirun(ranks), worker = find_worker(ranks), watcher = find_watcher(worker, ranks);
  check_open_files(ranks);
  RunFolder folder;
  EventPipe pipe(folder.file("events"));
  Job handed = job;
  handed.events = pipe.path();
  handed.folder = folder.path();
  if (job.input.empty()) {
    handed.input = folder.file("model");
    write_run_file(handed.input, content);
  }
  write_run_file(folder.file("job.json"), job_text(handed));
  Listener listener(progress);
  Child child({watcher, folder.path(), folder.shared_memory(), mpirun, "-n", std::to_string(ranks), worker,
               folder.file("job.json")},
              rank_environment(folder, ranks));
  wait_for_ranks(child, pipe, listener, progress);
  std::optional<MeshResult> result;
  if (listener.busy()) result = take_result(folder, ranks, job.returns_mesh);
  int status = wait_for_end(child);
  if (!result) fail(job.name.empty() ? job.input : job.name, child, status, ranks, listener, progress);
  return {*std::move(result), *listener.busy()};
}

}  // namespace paver
