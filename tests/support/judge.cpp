#include "support/judge.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "support/folders.h"

namespace paver::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const fs::path records = tests_folder() / "judge" / "verdicts.json";

/// Of all that the judge says: what tests hold against our figures.
constexpr const char* figures[] = {"/counts/quads",
                                   "/counts/triangles",
                                   "/counts/nodes",
                                   "/topology/unused_nodes",
                                   "/topology/edge_middle_node_mismatch",
                                   "/topology/edges_on_one_element",
                                   "/topology/edges_on_more",
                                   "/valence/face_interior_vertices",
                                   "/valence/irregular_fraction_face_interior",
                                   "/shape/all/scaled_jacobian/min",
                                   "/shape/all/scaled_jacobian/mean",
                                   "/shape/all/fraction_sj_below_0.3",
                                   "/shape/quads/scaled_jacobian/mean",
                                   "/shape/tris/scaled_jacobian/min",
                                   "/edges/chord/mean_rel",
                                   "/edges/chord/cov",
                                   "/area/mesh",
                                   "/curved/invalid",
                                   "/curved/undecided",
                                   "/curved/min_jacobian_ratio/min"};

std::string content(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// FNV-1a.
std::string checksum(const std::string& bytes) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return fmt::format("{:016x}", hash);
}

Json ask_judge(const fs::path& judge, const fs::path& mesh, double target_length) {
  std::string command = fmt::format("/usr/bin/python3 -B '{}' '{}'", judge.string(), mesh.string());
  if (target_length > 0) command += fmt::format(" --size {}", target_length);
  std::FILE* pipe = popen(command.c_str(), "r");
  std::string text;
  char part[4096];
  while (std::size_t n = std::fread(part, 1, sizeof part, pipe)) text.append(part, n);
  if (pclose(pipe) != 0) throw std::runtime_error(fmt::format("{} fails on {}", judge.string(), mesh.string()));
  const Json all = Json::parse(text);
  Json verdict;
  for (const char* figure : figures) verdict[figure] = all.at(Json::json_pointer(figure));
  return verdict;
}

/// The judge writes six digits; the last one is not the same on every machine.
bool is_same(const Json& a, const Json& b) {
  if (!a.is_number() || !b.is_number()) return a == b;
  const double x = a.get<double>(), y = b.get<double>();
  return std::fabs(x - y) <= 1.1e-5 * std::fmax(std::fabs(x), std::fabs(y));
}

void record(const std::string& name, const Json& entry) {
  Json all = fs::exists(records) ? Json::parse(content(records)) : Json::object();
  all[name] = entry;
  std::ofstream(records) << all.dump(1) << '\n';
}

}  // namespace

Json verdict_on(const std::string& name, const fs::path& mesh, double target_length) {
  const fs::path judge = shared_folder() / "tools" / "quality.py";
  Json verdict = fs::exists(judge) ? ask_judge(judge, mesh, target_length) : Json();
  if (std::getenv("PAVER_RECORD_VERDICTS")) {
    if (verdict.is_null()) throw std::runtime_error(judge.string() + " is missing: nothing can be recorded");
    record(name, {{"checksum", checksum(content(mesh))}, {"verdict", verdict}});
  }
  const Json all = Json::parse(content(records));
  if (!all.contains(name) || all[name]["checksum"] != checksum(content(mesh))) {
    throw std::runtime_error(fmt::format(
        "{} has no verdict on this file of \"{}\": tests/judge/record asks the judge afresh", records.string(), name));
  }
  for (const auto& [figure, value] : verdict.items()) {
    if (is_same(value, all[name]["verdict"].value(figure, Json()))) continue;
    throw std::runtime_error(fmt::format("the judge says {} {} of \"{}\", {} says otherwise: see tests/judge/record",
                                         figure, value.dump(), name, records.string()));
  }
  return all[name]["verdict"];
}

}  // namespace paver::test
