// Reads the command line with CLI11. Lengths, frequencies and angles come as text with units or in degrees and leave
// as the core wants them: mm, Hz, radians.
#include "arguments.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <numbers>

#include "paver/error.h"
#include "units.h"

#ifndef PAVER_VERSION
#define PAVER_VERSION "0.1.0"
#endif

namespace paver {
namespace {

/// What CLI11 fills as it stands on the command line.
struct Texts {
  std::string size, frequency, sew_tolerance, msh_version = "4.1", elements = elements_name(Elements::quad_dominant);
  double max_turn_deg = 0;
};

constexpr const char* footer = R"(FILE is a STEP, IGES or BREP model; lengths are millimetres unless a unit follows.
Example: paver mesh antenna.step --frequency 3GHz --divisions 10 -o antenna.msh

Exit codes: 0 every face with an area is meshed, 2 bad usage or option, 3 bad input file, 4 some face
failed (the rest is written), 5 too many elements, 6 output not writable, 130 cancelled, 1 internal error.)";

void add_size_options(CLI::App& mesh, Arguments& arguments, Texts& texts) {
  Options& options = arguments.options;
  auto* size = mesh.add_option("--size", texts.size, "Target length of the element edges, e.g. 30, \"30 mm\", 1.5in")
                   ->type_name("H");
  auto* frequency = mesh.add_option("--frequency", texts.frequency,
                                    "Working frequency instead of --size, e.g. 3GHz, \"300 MHz\", 9e9")
                        ->type_name("F")
                        ->excludes(size);
  mesh.add_option("--divisions", options.divisions, "Elements per wavelength")
      ->type_name("N")
      ->needs(frequency)
      ->capture_default_str();
  mesh.add_option("--eps-r", options.eps_r, "Relative permittivity of the medium")
      ->type_name("E")
      ->needs(frequency)
      ->capture_default_str();
  mesh.add_option("--mu-r", options.mu_r, "Relative permeability of the medium")
      ->type_name("M")
      ->needs(frequency)
      ->capture_default_str();
  mesh.add_option("--max-turn", texts.max_turn_deg,
                  "Largest turn of the surface per element edge, degrees [45, at order 1 30]")
      ->type_name("DEG");
  mesh.add_option("--gradation", options.gradation, "Largest growth of the element size per unit of length")
      ->type_name("G")
      ->capture_default_str();
  mesh.add_option("--max-elements", options.max_elements, "Stop before meshing when more elements are predicted")
      ->type_name("N")
      ->capture_default_str();
}

void add_other_options(CLI::App& mesh, Arguments& arguments, Texts& texts) {
  mesh.add_option("--order", arguments.options.order, "Order of the elements, 1 or 2")
      ->type_name("P")
      ->capture_default_str();
  mesh.add_option("--elements", texts.elements,
                  "quad-dominant; all-quad: triangles only where nothing else is possible; all-triangle")
      ->type_name("KIND")
      ->check(CLI::IsMember({"quad-dominant", "all-quad", "all-triangle"}))
      ->capture_default_str();
  mesh.add_option("--threads", arguments.options.threads, "Threads to work on; 0: all cores")
      ->type_name("T")
      ->capture_default_str();
  mesh.add_option("--sew-tolerance", texts.sew_tolerance,
                  "Largest gap between faces that is sewn; 0: never sew [from the target length]")
      ->type_name("T");
  mesh.add_option("--report", arguments.files.report, "Write a report with all figures (JSON)")->type_name("FILE");
  mesh.add_option("--msh-version", texts.msh_version, "Version of a .msh file, 4.1 or 2.2")
      ->type_name("V")
      ->check(CLI::IsMember({"4.1", "2.2"}))
      ->capture_default_str();
  mesh.add_flag("--ascii", arguments.files.is_ascii, "Write the mesh as text instead of binary");
  mesh.add_flag("--quiet", arguments.is_quiet, "Print errors only");
}

template <class Parse>
double quantity(const char* option, const std::string& text, Parse parse, const char* examples) {
  if (auto value = parse(text)) return *value;
  throw Error(ErrorCode::bad_option, fmt::format("{} is '{}'; write it like {}.", option, text, examples));
}

void convert(const CLI::App& mesh, const Texts& texts, Arguments& arguments) {
  Options& options = arguments.options;
  if (mesh.count("--size")) options.size = quantity("--size", texts.size, parse_length, "30, 30mm, 1.5in or 2m");
  if (mesh.count("--frequency")) {
    options.frequency = quantity("--frequency", texts.frequency, parse_frequency, "3GHz, 300MHz or 9e9");
  }
  if (mesh.count("--sew-tolerance")) {
    options.sew_tolerance = quantity("--sew-tolerance", texts.sew_tolerance, parse_length, "0.01, 0.01mm or 10um");
  }
  if (mesh.count("--max-turn")) options.max_turn = texts.max_turn_deg * std::numbers::pi / 180;
  for (Elements kind : {Elements::all_quad, Elements::all_triangle})
    if (texts.elements == elements_name(kind)) options.elements = kind;
  arguments.files.msh_version = texts.msh_version == "2.2" ? MshVersion::v2_2 : MshVersion::v4_1;
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
              fmt::format("{}; write 'paver mesh FILE -o OUT --size H', or 'paver --help' for all options.",
                          command.empty() ? "No command is given" : "There is no command '" + command + "'"));
}

}  // namespace

std::optional<int> read_arguments(int argc, const char* const* argv, Arguments& arguments) {
  check_command(argc, argv);
  CLI::App app("Paver cuts the surfaces of a CAD model into curved quadrilaterals and few triangles.", "paver");
  app.set_version_flag("--version", "paver " PAVER_VERSION);
  app.require_subcommand(1);
  app.footer(footer);
  CLI::App& mesh = *app.add_subcommand("mesh", "Mesh a CAD file");
  mesh.footer(footer);
  mesh.add_option("file", arguments.input, "CAD file: STEP, IGES or BREP")->required()->type_name("FILE");
  mesh.add_option("-o,--output", arguments.files.mesh, "Mesh to write: .msh (Gmsh) or .vtu (VTK)")
      ->required()
      ->type_name("OUT");
  Texts texts;
  add_size_options(mesh, arguments, texts);
  add_other_options(mesh, arguments, texts);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& finished) {
    return app.exit(finished);
  } catch (const CLI::ParseError& error) {
    throw Error(ErrorCode::bad_option, sentence(error.what()));
  }
  if (arguments.files.mesh.empty()) throw Error(ErrorCode::bad_option, "The name of the mesh file is empty.");
  convert(mesh, texts, arguments);
  return std::nullopt;
}

std::string with_command_line_names(std::string text) {
  for (std::string name : {"max_turn", "max_elements", "sew_tolerance", "eps_r", "mu_r"}) {
    std::string option = "--" + name;
    std::replace(option.begin(), option.end(), '_', '-');
    for (std::size_t at = 0; (at = text.find(name, at)) != std::string::npos; at += option.size()) {
      text.replace(at, name.size(), option);
    }
  }
  return text;
}

}  // namespace paver
