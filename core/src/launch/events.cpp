// Reading events, from a named pipe in the folder of the run.
#include "launch/events.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string_view>

namespace paver {
namespace {

using Json = nlohmann::json;

constexpr mode_t own_only = 0600;

/// The value of this name; the last one where none has it.
template <class Value, class NameOf>
Value named(const std::string& name, NameOf name_of, Value last) {
  for (int i = 0; i < static_cast<int>(last); ++i)
    if (name == name_of(static_cast<Value>(i))) return static_cast<Value>(i);
  return last;
}

Event progress_event(const Json& json) {
  const Stage stage = named(json.at("stage").get<std::string>(), stage_name, Stage::done);
  return {Event::Kind::progress, stage, json.at("percent").get<double>() / 100, {}, {}};
}

Event error_event(const Json& json) {
  Where where;
  where.stage = json.value("stage", "");
  std::string face = json.value("face", "");
  if (face.starts_with("Face")) where.face = std::atoi(face.c_str() + 4) - 1;
  Event event{Event::Kind::error, Stage::read, 0, {}, {}};
  const ErrorCode code = named(json.at("code").get<std::string>(), code_name, ErrorCode::internal);
  event.error.emplace(code, json.at("sentence").get<std::string>(), where);
  return event;
}

/// A line that is not as it should be is of no kind we know: it is left to others.
Event read_event(std::string_view line) {
  try {
    Json json = Json::parse(line);
    std::string kind = json.at("event").get<std::string>();
    if (kind == "progress") return progress_event(json);
    if (kind == "error") return error_event(json);
    if (kind == "done")
      return {Event::Kind::done, Stage::done, 1, {}, json.at("busy_seconds").get<std::vector<double>>()};
  } catch (const Json::exception&) {
    // Not one of ours.
  }
  return {};
}

}  // namespace

EventPipe::EventPipe(std::string path) : path_(std::move(path)) {
  // Open for both: there is a reader from now on, and no end of file while no rank has opened it yet.
  if (::mkfifo(path_.c_str(), own_only) == 0) descriptor_ = ::open(path_.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  if (descriptor_ < 0) {
    throw Error(ErrorCode::unwritable_output,
                fmt::format("Cannot make the pipe '{}' ({}); set TMPDIR to a folder of this machine.", path_,
                            std::strerror(errno)));
  }
}

std::vector<Event> EventPipe::read() {
  std::vector<Event> events;
  std::array<char, 4096> part{};
  ssize_t bytes = 0;
  while (descriptor_ >= 0 && (bytes = ::read(descriptor_, part.data(), part.size())) > 0)
    unfinished_.append(part.data(), static_cast<std::size_t>(bytes));
  std::size_t start = 0;
  for (std::size_t end; (end = unfinished_.find('\n', start)) != std::string::npos; start = end + 1)
    events.push_back(read_event(std::string_view(unfinished_).substr(start, end - start)));
  unfinished_.erase(0, start);
  return events;
}

void EventPipe::close() {
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = -1;
}

}  // namespace paver
