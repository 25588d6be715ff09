#include "support/folders.h"

#include <cstdlib>

namespace paver::test {

std::filesystem::path tests_folder() { return PAVER_TESTS_FOLDER; }

std::filesystem::path examples_folder() { return PAVER_EXAMPLES; }

std::filesystem::path shared_folder() {
  const char* shared = std::getenv("PAVER_SHARED");
  return shared && *shared ? shared : PAVER_SHARED;
}

}  // namespace paver::test
