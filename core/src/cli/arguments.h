// The command line as data.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "paver/option_table.h"
#include "paver/options.h"
#include "paver/output.h"

namespace paver {

struct Arguments {
  std::string input;  ///< CAD file
  Options options;
  std::vector<GivenOption> given;  ///< the same as they were given
  OutputFiles files;
  bool is_quiet = false;  ///< neither progress nor table
};

/// Reads `paver mesh ...`. Fills `arguments` and gives nothing, or, after --help or --version, gives the exit code.
/// Throws Error{bad_option} for bad usage. Values are not checked against their ranges: check(Options) does that.
std::optional<int> read_arguments(int argc, const char* const* argv, Arguments& arguments);

/// `text` with the options named as on the command line: "max_turn" becomes "--max-turn".
std::string with_command_line_names(std::string text);

}  // namespace paver
