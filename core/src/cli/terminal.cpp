// The reporter thread: looks at the progress twenty times a second, prints it, and watches over a cancelled run.
//
// A run stops at its next check of the progress. Inside a long call of the CAD library there is none, so a cancelled
// run that has not come back in time is ended here; its temporary files go first, so nothing is left.
#include "terminal.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace paver {
namespace {

constexpr std::chrono::milliseconds interval(50);
constexpr int cancelled_exit_code = 130;

void print(std::FILE* stream, const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stream);
  std::fflush(stream);
}

}  // namespace

Terminal::Terminal(const Progress& progress, bool is_quiet, std::vector<std::string> temporaries,
                   std::chrono::milliseconds patience)
    : progress_(progress),
      is_quiet_(is_quiet),
      is_terminal_(::isatty(STDERR_FILENO) == 1),
      temporaries_(std::move(temporaries)),
      patience_(patience),
      stage_start_(Clock::now()),
      thread_([this](std::stop_token stop) { watch(std::move(stop)); }) {}

Terminal::~Terminal() {
  thread_.request_stop();
  thread_.join();
  if (!progress_.is_cancelled()) show();
  if (!shown_.empty()) print(stderr, "\r\x1b[K");
}

void Terminal::watch(std::stop_token stop) {
  std::unique_lock lock(mutex_);
  Clock::time_point cancelled_at{};
  while (!stopping_.wait_for(lock, stop, interval, [&] { return stop.stop_requested(); })) {
    if (!progress_.is_cancelled()) {
      show();
    } else if (cancelled_at == Clock::time_point{}) {
      cancelled_at = Clock::now();
    } else if (Clock::now() - cancelled_at > patience_) {
      end_process();
    }
  }
}

void Terminal::show() {
  if (!is_quiet_) is_terminal_ ? show_on_line() : show_finished_stages();
}

void Terminal::show_on_line() {
  std::string line = fmt::format("{:<9}{:>4.0f} %", stage_name(progress_.stage()), 100 * progress_.fraction());
  if (line == shown_) return;
  shown_ = line;
  print(stderr, "\r\x1b[K" + line);
}

void Terminal::show_finished_stages() {
  for (int now = static_cast<int>(progress_.stage()); stage_ < now; ++stage_) {
    std::chrono::duration<double> seconds = Clock::now() - stage_start_;
    stage_start_ = Clock::now();
    print(stdout, fmt::format("{:<9} 100 %  {:.1f} s\n", stage_name(static_cast<Stage>(stage_)), seconds.count()));
  }
}

void Terminal::end_process() const {
  for (const std::string& name : temporaries_) ::unlink(name.c_str());
  print(stderr, std::string(shown_.empty() ? "" : "\r\x1b[K") + "paver: Cancelled; nothing was written.\n");
  ::_exit(cancelled_exit_code);
}

}  // namespace paver
