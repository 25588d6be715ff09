// The kernel has no bounds of its own: numbers that a file states may keep it busy for days, or lead it outside of its
// memory. Time is that of processors: how busy the machine is makes no difference.
#include "paver/breakdown.h"

#include <fmt/format.h>
#include <signal.h>

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>

namespace paver {
namespace {

/// A hundred times what OpenCASCADE takes for sound files.
constexpr double base_seconds = 20, seconds_per_byte = 60e-6;

/// Stands before the code and before the sentence of a refusal; the kernel prints text only.
constexpr char mark = '\x1e';

std::atomic<bool> is_watched{false};

bool is_of_kernel(Stage stage) { return stage == Stage::read || stage == Stage::topology; }

bool is_fault(int signal) {
  return signal == SIGSEGV || signal == SIGBUS || signal == SIGFPE || signal == SIGILL || signal == SIGABRT;
}

double processor_seconds(pid_t process) {
  clockid_t clock{};
  timespec used{};
  if (::clock_getcpuclockid(process, &clock) != 0 || ::clock_gettime(clock, &used) != 0) return 0;
  return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

}  // namespace

Error breakdown(const std::string& name, Stage stage, int signal, const std::string& who, const std::string& choice) {
  if (is_of_kernel(stage) && is_fault(signal))
    return Error(ErrorCode::damaged_file, fmt::format("'{}' could not be read: the CAD kernel broke down on it ({}, in "
                                                      "stage {}); export the model again.",
                                                      name, ::strsignal(signal), stage_name(stage)));
  if (is_of_kernel(stage) && signal == SIGXCPU)
    return Error(
        ErrorCode::damaged_file,
        fmt::format("'{}' could not be read: the CAD kernel came to no end with it (in stage {}); export the "
                    "model again{}.",
                    name, stage_name(stage), stage == Stage::topology ? ", or mesh its parts one by one" : ""));
  std::string what =
      fmt::format("{} was ended by signal {} ({}) in stage {}", who, signal, ::strsignal(signal), stage_name(stage));
  if (signal == SIGKILL)
    return Error(
        ErrorCode::out_of_memory,
        fmt::format("{}, as the system does when memory runs out; nothing was written, choose {}.", what, choice));
  return Error(ErrorCode::internal, what + "; nothing was written, report it with the model.");
}

void allow_breakdown() { is_watched.store(true); }

bool may_break_down() { return is_watched.load(); }

std::string refusal_text(const Error& error) {
  return fmt::format("{0}{1}{0}{2}", mark, static_cast<int>(error.code()), error.what());
}

std::optional<Error> refusal_in(const std::string& output) {
  const auto code = output.find(mark);
  if (code == std::string::npos) return std::nullopt;
  const auto sentence = output.find(mark, code + 1);
  if (sentence == std::string::npos) return std::nullopt;
  return Error(static_cast<ErrorCode>(std::atoi(output.c_str() + code + 1)), output.substr(sentence + 1));
}

bool is_hung(pid_t process, Stage stage, const std::string& path) {
  if (!is_of_kernel(stage)) return false;
  const double used = processor_seconds(process);
  if (used < base_seconds) return false;
  std::error_code error;
  const auto bytes = std::filesystem::file_size(path, error);
  return !error && used > base_seconds + seconds_per_byte * static_cast<double>(bytes);
}

}  // namespace paver
