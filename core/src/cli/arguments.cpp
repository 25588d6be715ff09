// Reads the command line with CLI11. The options of a run come from the core's table, which also reads their values.
#include "arguments.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <string_view>

#include "paver/error.h"
#include "paver/option_table.h"

namespace paver {
namespace {

constexpr const char* footer = R"(FILE is a STEP, IGES or BREP model; lengths are millimetres unless a unit follows.
Example: paver mesh antenna.step --frequency 3GHz --divisions 10 -o antenna.msh

Exit codes: 0 every face with an area is meshed, 2 bad usage or option, 3 bad input file, 4 some face
failed (the rest is written), 5 too many elements, 6 output not writable, 130 cancelled, 1 internal error.)";

/// "max_turn" -> "--max-turn".
std::string command_line_name(std::string name) {
  std::replace(name.begin(), name.end(), '_', '-');
  return "--" + name;
}

/// What CLI11 fills as it stands on the command line.
struct Texts {
  std::map<std::string, std::vector<std::string>> options;  ///< by name; CLI11 keeps pointers into it
  std::string msh_version = "4.1";
};

/// The options of a run, in the order of the table.
void add_options(CLI::App& mesh, Texts& texts) {
  for (const OptionInfo& info : option_table()) {
    if (info.kind == OptionKind::flag) {
      mesh.add_flag_callback(
          command_line_name(info.name), [&list = texts.options[info.name]] { list = {"on"}; }, info.help);
      continue;
    }
    CLI::Option* option = mesh.add_option(command_line_name(info.name), texts.options[info.name], info.help);
    option->type_name(info.letter)->allow_extra_args(false);
    if (is_repeated(info.kind)) {
      option->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    } else {
      option->expected(1);
    }
    if (!info.default_text.empty()) option->default_str(info.default_text);
  }
}

/// As from a variable of a script that is not set: nothing would be written, and nobody told.
std::string has_name(const std::string& file) { return file.empty() ? "the name of the file is empty" : ""; }

void add_output_options(CLI::App& mesh, Arguments& arguments, Texts& texts) {
  mesh.add_option("--report", arguments.files.report, "Write a report with all figures (JSON)")
      ->type_name("FILE")
      ->check(has_name);
  mesh.add_option("--repaired", arguments.files.repaired, "Write the model as meshed: repaired, sewn, connected (BREP)")
      ->type_name("FILE")
      ->check(has_name);
  mesh.add_option("--msh-version", texts.msh_version, "Version of a .msh file, 4.1 or 2.2")
      ->type_name("V")
      ->check(CLI::IsMember({"4.1", "2.2"}))
      ->capture_default_str();
  mesh.add_flag("--ascii", arguments.files.is_ascii, "Write the mesh as text instead of binary");
  mesh.add_flag("--quiet", arguments.is_quiet, "Print errors only");
}

void convert(const Texts& texts, Arguments& arguments) {
  for (const OptionInfo& info : option_table())
    for (const std::string& text : texts.options.at(info.name)) arguments.given.emplace_back(info.name, text);
  arguments.options = read_options(arguments.given);
  arguments.files.msh_version = *msh_version(texts.msh_version);
}

/// CLI11's message as one sentence.
std::string sentence(std::string text) {
  text.resize(std::min(text.find_last_not_of(" \n\r") + 1, text.size()));
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text + (text.ends_with('.') ? "" : ".");
}

/// CLI11 would only say that a subcommand is missing.
void check_command(int argc, const char* const* argv) {
  std::string command = argc > 1 ? argv[1] : "";
  if (command == "mesh" || command.starts_with('-')) return;
  throw Error(ErrorCode::bad_option,
              fmt::format("{}; write 'paver mesh FILE -o OUT --size H', or 'paver mesh --help' for all options.",
                          command.empty() ? "No command is given" : "There is no command '" + command + "'"));
}

/// The library only counts.
std::string told(const std::string& found) {
  const std::size_t at = found.find(": At Most 1 required");
  return at == std::string::npos ? sentence(found) : found.substr(0, at) + " is given more than once; give it once.";
}

}  // namespace

std::optional<int> read_arguments(int argc, const char* const* argv, Arguments& arguments) {
  check_command(argc, argv);
  CLI::App app("Paver cuts the surfaces of a CAD model into curved quadrilaterals and few triangles.", "paver");
  app.set_version_flag("--version", "paver " PAVER_VERSION);
  app.require_subcommand(1);
  app.footer(std::string("All options of a run: paver mesh --help\n\n") + footer);
  CLI::App& mesh = *app.add_subcommand("mesh", "Mesh a CAD file");
  mesh.footer(footer);
  mesh.add_option("file", arguments.input, "CAD file: STEP, IGES or BREP")->required()->type_name("FILE");
  mesh.add_option("-o,--output", arguments.files.mesh, "Mesh to write: .msh (Gmsh) or .vtu (VTK)")
      ->required()
      ->type_name("OUT");
  Texts texts;
  add_options(mesh, texts);
  add_output_options(mesh, arguments, texts);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& finished) {
    return app.exit(finished);
  } catch (const CLI::ParseError& error) {
    throw Error(ErrorCode::bad_option, told(error.what()));
  }
  if (arguments.files.mesh.empty()) throw Error(ErrorCode::bad_option, "The name of the mesh file is empty.");
  arguments.files.input = arguments.input;
  convert(texts, arguments);
  return std::nullopt;
}

std::string with_command_line_names(std::string text) {
  for (const OptionInfo& info : option_table()) {
    std::string option = command_line_name(info.name);
    bool is_plain_word = info.name.find('_') == std::string::npos;
    for (std::size_t at = 0; (at = text.find(info.name, at)) != std::string::npos; at += option.size()) {
      std::string_view before = std::string_view(text).substr(0, at), after = std::string_view(text).substr(at);
      after.remove_prefix(info.name.size());
      bool is_subject = before.empty() && after.starts_with(" ");
      bool is_object = before.ends_with(" needs ") || before.ends_with(" excludes ") || before.ends_with(" leave ");
      if (is_plain_word && !is_subject && !is_object) continue;
      text.replace(at, info.name.size(), option);
    }
  }
  return text;
}

}  // namespace paver
