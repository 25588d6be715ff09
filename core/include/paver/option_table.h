// Every option of a run by its name: what the command line, the Python module and a user interface offer, from one
// list.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "paver/options.h"

namespace paver {

/// How the text of an option is read.
enum class OptionKind {
  length,     ///< mm, or with a unit
  frequency,  ///< Hz, or with a unit
  angle,      ///< degrees, or with a unit
  number,
  integer,
  choice,  ///< one of OptionInfo::choices
  flag,    ///< "on" or "off"; on the command line "on" where it is named
  local,   ///< parts of the model with their lengths; may be given repeatedly
  named,   ///< parts of the model under a name; may be given repeatedly
};

/// "length", "frequency", "angle", "number", "integer", "choice", "flag", "local", "named".
const char* kind_name(OptionKind kind);

struct OptionInfo {
  std::string name;  ///< of the field of Options, e.g. "max_turn"; --max-turn on the command line
  OptionKind kind;
  std::string letter;                  ///< stands for the value in help texts, e.g. "DEG"
  std::string help;                    ///< one line, without the default
  std::string default_text{};          ///< as the text of a value; empty: none, or as `help` says
  std::string needs{}, excludes{};     ///< name of another option, or empty
  std::vector<std::string> choices{};  ///< of OptionKind::choice
  bool may_be_zero = false;  ///< without a default: 0 is a value of its own, which a form must not use for "none"
};

/// All options, in the order in which they are listed to users.
const std::vector<OptionInfo>& option_table();

/// An option that was given: its name and the text of its value.
using GivenOption = std::pair<std::string, std::string>;

/// Whether options of a kind add up; of others the last one counts.
bool is_repeated(OptionKind kind);

/// Options as given, the others at their defaults. Throws Error{bad_option} for an unknown name, for text that is not
/// of the option's kind, and for options that need or exclude others. Options that is_repeated() names add up. Ranges
/// are left to check(Options).
Options read_options(const std::vector<GivenOption>& given);

}  // namespace paver
