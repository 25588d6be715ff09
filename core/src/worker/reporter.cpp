// Events as JSON lines to a pipe, or lines and a table for people; one look at the progress every 50 ms.
#include "worker/reporter.h"

#include <fcntl.h>
#include <fmt/ranges.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "paver/signals.h"

namespace paver {
namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds interval(50), patience(700), retry(5);
constexpr int most_retries = 100;
constexpr std::size_t longest_sentence = 3000;  // lines of up to 4096 bytes come whole through a pipe

Json error_json(const Error& error) {
  std::string sentence = error.what();
  if (sentence.size() > longest_sentence) sentence = sentence.substr(0, longest_sentence) + " ...";
  Json json = {{"code", code_name(error.code())}, {"stage", error.where().stage}, {"sentence", sentence}};
  if (error.where().face >= 0) json["face"] = "Face" + std::to_string(error.where().face + 1);
  return json;
}

std::string line_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n"; }

}  // namespace

void listen_to_signals(Progress& progress) {
  cancel_on_signals(progress);
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
}

Reporter::Reporter(Progress& progress, const Job& job, int rank)
    : progress_(progress), job_(job), rank_(rank), stage_start_(Clock::now()) {
  open(job.events);
  thread_ = std::jthread([this](std::stop_token stop) { watch(std::move(stop)); });
}

Reporter::~Reporter() {
  thread_.request_stop();
  thread_.join();
  if (style_ == Style::lines && descriptor_ > STDERR_FILENO) ::close(descriptor_);
}

void Reporter::open(const std::string& events) {
  if (events.empty()) {
    style_ = rank_ == 0 ? Style::table : Style::silent;
    return;
  }
  style_ = Style::lines;
  if (events == "-") {
    descriptor_ = STDOUT_FILENO;
    return;
  }
  descriptor_ = ::open(events.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor_ < 0) progress_.cancel();  // who started this is gone
}

void Reporter::set_temporaries(std::vector<std::string> temporaries) {
  std::lock_guard lock(mutex_);
  temporaries_ = std::move(temporaries);
}

void Reporter::started(int ranks, int threads) {
  if (rank_ != 0 || style_ != Style::lines) return;
  say(line_of({{"event", "start"}, {"ranks", ranks}, {"threads", threads}}), true);
}

void Reporter::failed(const Error& error) {
  if (error.code() == ErrorCode::cancelled && rank_ != 0) return;  // all ranks are; one says so
  if (style_ == Style::lines) {
    Json json = {{"event", "error"}, {"rank", rank_}};
    json.update(error_json(error));
    say(line_of(json), true);
  } else {
    fmt::print(stderr, "paver-worker: {}\n", error.what());
  }
}

void Reporter::done(const MeshResult& result, const std::vector<double>& busy_seconds) {
  std::optional<Error> error = shortfall(result);
  if (style_ == Style::lines) {
    show();
    const QualityReport& quality = result.report.quality;
    Json json = {{"event", "done"},
                 {"mesh", job_.files.mesh},
                 {"report", job_.files.report},
                 {"elements", quality.quads + quality.triangles},
                 {"busy_seconds", busy_seconds}};
    if (error) json["shortfall"] = error_json(*error);
    say(line_of(json), true);
    return;
  }
  std::lock_guard lock(mutex_);
  show_finished_stages();
  std::string table = report_table(result.report);
  fmt::print("{}{:<14}{} busy for {:.2f} s\n", table, "ranks", busy_seconds.size(), fmt::join(busy_seconds, ", "));
  std::fflush(stdout);
  if (error) fmt::print(stderr, "paver-worker: {}\n", error->what());
}

void Reporter::remove_temporaries() const {
  for (const std::string& name : temporaries_) ::unlink(name.c_str());
}

void Reporter::end_process(int code) {
  remove_temporaries();
  ::_exit(code);
}

void Reporter::watch(std::stop_token stop) {
  std::unique_lock lock(mutex_);
  Clock::time_point cancelled_at{};
  while (!stopping_.wait_for(lock, stop, interval, [&] { return stop.stop_requested(); })) {
    if (!is_heard()) progress_.cancel();
    if (!progress_.is_cancelled()) {
      show();
    } else if (cancelled_at == Clock::time_point{}) {
      cancelled_at = Clock::now();
    } else if (Clock::now() - cancelled_at > patience) {
      end_process(exit_code(ErrorCode::cancelled));
    }
  }
}

bool Reporter::is_heard() const {
  if (descriptor_ < 0) return true;
  pollfd ours{descriptor_, 0, 0};
  return ::poll(&ours, 1, 0) <= 0 || (ours.revents & (POLLERR | POLLNVAL)) == 0;
}

void Reporter::show() {
  if (rank_ != 0) return;
  if (style_ == Style::table) return show_finished_stages();
  if (progress_.stage() == Stage::done) return;  // done() says so
  int percent = static_cast<int>(std::floor(100 * progress_.fraction()));
  std::string line = line_of({{"event", "progress"}, {"stage", stage_name(progress_.stage())}, {"percent", percent}});
  if (line == shown_) return;
  shown_ = line;
  say(line, false);
}

void Reporter::show_finished_stages() {
  for (int now = static_cast<int>(progress_.stage()); stage_ < now; ++stage_) {
    std::chrono::duration<double> seconds = Clock::now() - stage_start_;
    stage_start_ = Clock::now();
    fmt::print("{:<9} 100 %  {:.1f} s\n", stage_name(static_cast<Stage>(stage_)), seconds.count());
    std::fflush(stdout);
  }
}

// A full pipe means a slow reader: what only tells progress is left out then.
void Reporter::say(const std::string& line, bool is_needed) {
  for (int tries = 0; tries < (is_needed ? most_retries : 1); ++tries) {
    if (::write(descriptor_, line.data(), line.size()) >= 0 || (errno != EAGAIN && errno != EINTR)) return;
    std::this_thread::sleep_for(retry);
  }
}

}  // namespace paver
