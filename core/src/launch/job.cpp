// The job file: JSON with the same words as the command line.
#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "paver/launch.h"

namespace paver {
namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void refuse(const std::string& path, const std::string& what) {
  throw Error(ErrorCode::bad_option,
              fmt::format("The job file '{}' {}; core/docs/ranks.md lists its keys.", path, what));
}

std::string text_of(const Json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

/// An option is given as text or number, a repeated one as a list of texts.
void add_option(const std::string& name, const Json& value, std::vector<GivenOption>& options) {
  if (!value.is_array()) {
    options.emplace_back(name, text_of(value));
    return;
  }
  for (const Json& one : value) options.emplace_back(name, text_of(one));
}

MshVersion version_of(const std::string& text, const std::string& path) {
  if (const auto version = msh_version(text)) return *version;
  refuse(path, fmt::format("has msh_version '{}', which is neither 4.1 nor 2.2", text));
}

/// False for a key that is not known.
bool read_key(const std::string& key, const Json& value, const std::string& path, Job& job) {
  if (key == "options") {
    for (const auto& [name, given] : value.items()) add_option(name, given, job.options);
    return true;
  }
  if (key == "labels") {
    job.labels = value.get<std::vector<std::string>>();
    return true;
  }
  if (key == "ascii" || key == "returns_mesh") {
    (key == "ascii" ? job.files.is_ascii : job.returns_mesh) = value.get<bool>();
    return true;
  }
  if (key == "msh_version") {
    job.files.msh_version = version_of(text_of(value), path);
    return true;
  }
  const std::pair<const char*, std::string*> texts[] = {
      {"input", &job.input},   {"name", &job.name},     {"mesh", &job.files.mesh},        {"report", &job.files.report},
      {"events", &job.events}, {"folder", &job.folder}, {"repaired", &job.files.repaired}};
  for (auto [name, text] : texts) {
    if (key != name) continue;
    *text = value.get<std::string>();
    return true;
  }
  return false;
}

std::string content(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  if (in) text << in.rdbuf();
  if (!in || !text)
    throw Error(ErrorCode::file_missing,
                fmt::format("The job file '{}' cannot be read; give the path of a job file.", path));
  return text.str();
}

}  // namespace

std::string job_text(const Job& job) {
  Json options = Json::object();
  for (const auto& [name, text] : job.options) {
    if (!options.contains(name)) options[name] = Json::array();
    options[name].push_back(text);
  }
  Json json = {{"input", job.input},
               {"name", job.name},
               {"labels", job.labels},
               {"options", options},
               {"mesh", job.files.mesh},
               {"report", job.files.report},
               {"msh_version", job.files.msh_version == MshVersion::v2_2 ? "2.2" : "4.1"},
               {"ascii", job.files.is_ascii},
               {"events", job.events},
               {"folder", job.folder},
               {"returns_mesh", job.returns_mesh},
               {"repaired", job.files.repaired}};
  try {
    return json.dump(1) + "\n";
  } catch (const Json::exception&) {
    throw Error(ErrorCode::bad_option, "A file name or an option is not UTF-8 text; rename the file.");
  }
}

Job read_job(const std::string& path) { return parse_job(content(path), path); }

Job parse_job(const std::string& text, const std::string& path) {
  Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) refuse(path, "is damaged: it is not a JSON object");
  Job job;
  for (const auto& [key, value] : json.items()) {
    bool is_known = false;
    try {
      is_known = read_key(key, value, path, job);
    } catch (const Json::exception&) {
      refuse(path, fmt::format("has a value of the wrong kind for '{}'", key));
    }
    if (!is_known) refuse(path, fmt::format("has the unknown key '{}'", key));
  }
  if (job.input.empty()) refuse(path, "names no input");
  if (job.files.mesh.empty() && job.files.report.empty() && job.folder.empty()) refuse(path, "names no mesh to write");
  job.files.input = job.input;
  return job;
}

}  // namespace paver
