// What an independent judge, tools/quality.py of the shared folder, says of mesh files that tests write.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace paver::test {

/// The judge's figures of a mesh file by their JSON pointers, as recorded in tests/judge/verdicts.json under `name`;
/// `target_length` 0: the file's mean length of edges. Throws std::runtime_error unless the file is, byte for byte, the
/// one that was judged. Where the shared folder is there, the judge is asked as well and must say what is recorded;
/// with PAVER_RECORD_VERDICTS set (tests/judge/record) it is recorded.
nlohmann::json verdict_on(const std::string& name, const std::filesystem::path& mesh, double target_length = 0);

}  // namespace paver::test
