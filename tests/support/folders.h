// Where tests find their files.
#pragma once

#include <filesystem>

namespace paver::test {

/// The folder of all tests.
std::filesystem::path tests_folder();

/// The shipped example models.
std::filesystem::path examples_folder();

/// The folder of $PAVER_SHARED, else the one beside the project. It need not be there.
std::filesystem::path shared_folder();

}  // namespace paver::test
