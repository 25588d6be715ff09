// Which CAD format a file has, and whether its end is there.
// By content, because endings lie: .step, .stp, .p21, .igs, .iges, .brp, .brep are all in use.
// STEP starts with ISO-10303-21 and ends with END-ISO-10303-21; IGES has its section letter in column 73 of every
// line, S in the first and T in the last; OpenCASCADE's own texts name themselves in their first words.
#include "brep/reading/file_format.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "base/trimmed.h"
#include "paver/error.h"

namespace paver {
namespace {

constexpr std::size_t head_bytes = 4096;
constexpr std::size_t tail_bytes = 65536;
constexpr std::size_t iges_section_column = 72;  // 0-based: column 73

struct FileEnds {
  std::string head, tail;
};

std::string quoted(const std::string& name) { return "'" + name + "'"; }

void check_regular_file(const std::string& path, const std::string& name) {
  std::error_code error;
  auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found)
    throw Error(ErrorCode::file_missing, quoted(name) + " does not exist; check the path.");
  if (status.type() == std::filesystem::file_type::directory)
    throw Error(ErrorCode::file_missing, quoted(name) + " is a folder; name a STEP, IGES or BREP file in it.");
  if (status.type() == std::filesystem::file_type::none)
    throw Error(ErrorCode::file_missing,
                quoted(name) + " cannot be reached (" + error.message() + "); check the path.");
  if (status.type() != std::filesystem::file_type::regular)
    throw Error(ErrorCode::file_missing, quoted(name) + " is not a file but a device or pipe; name a file.");
}

FileEnds read_ends(const std::string& path, const std::string& name) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw Error(ErrorCode::file_missing, quoted(name) + " may not be read; change its permissions or copy it.");
  FileEnds ends;
  ends.head.resize(head_bytes);
  in.read(ends.head.data(), static_cast<std::streamsize>(head_bytes));
  ends.head.resize(static_cast<std::size_t>(in.gcount()));
  in.clear();
  in.seekg(0, std::ios::end);
  auto size = static_cast<std::size_t>(std::max<std::streamoff>(0, in.tellg()));
  auto length = std::min(size, tail_bytes);
  in.seekg(static_cast<std::streamoff>(size - length));
  ends.tail.resize(length);
  in.read(ends.tail.data(), static_cast<std::streamsize>(length));
  if (!in) throw Error(ErrorCode::file_missing, quoted(name) + " could not be read to its end; check the disk.");
  return ends;
}

constexpr std::string_view space = " \t\r\n";

/// The text after a byte order mark, white space and comments of the form /* */.
std::string_view first_words(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  for (;;) {
    text.remove_prefix(std::min(text.find_first_not_of(space), text.size()));
    if (!text.starts_with("/*")) return text;
    auto end = text.find("*/");
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + 2);
  }
}

bool has_section_letter(std::string_view line, char letter) {
  if (line.size() <= iges_section_column || line[iges_section_column] != letter) return false;
  auto number = trimmed(line.substr(iges_section_column + 1), space);
  return !number.empty() && std::all_of(number.begin(), number.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// The last line of an IGES file states how many lines each section has, as in S0000001G0000003D0000042P0000077; fewer
/// directory or parameter lines than that make the reader crash.
bool has_all_iges_lines(const std::string& path, std::string_view tail) {
  auto last = trimmed(tail, space);
  last = last.substr(last.find_last_of("\r\n") + 1);
  auto stated = [&](char section) {
    auto at = last.substr(0, iges_section_column).find(section);
    return at == std::string_view::npos ? 0 : std::atol(std::string(last.substr(at + 1, 7)).c_str());
  };
  long directory = 0, parameter = 0;
  std::ifstream in(path, std::ios::binary);
  for (std::string line; std::getline(in, line);) {
    directory += has_section_letter(line, 'D');
    parameter += has_section_letter(line, 'P');
  }
  return directory >= stated('D') && parameter >= stated('P');
}

bool is_iges(std::string_view head) { return has_section_letter(head.substr(0, head.find_first_of("\r\n")), 'S'); }

bool is_iges_complete(std::string_view tail) {
  tail = tail.substr(0, tail.find_last_not_of(std::string_view(" \t\r\n\0", 5)) + 1);
  auto start = tail.find_last_of("\r\n");
  return has_section_letter(start == std::string_view::npos ? tail : tail.substr(start + 1), 'T');
}

[[noreturn]] void throw_foreign(const std::string& name, std::string_view head) {
  if (head.starts_with("PK\x03\x04"))
    throw Error(ErrorCode::not_a_cad_file, quoted(name) +
                                               " is a FreeCAD document or another zip archive; "
                                               "open it in FreeCAD and export the shape as STEP.");
  if (head.starts_with("\x1f\x8b"))
    throw Error(ErrorCode::not_a_cad_file, quoted(name) + " is compressed with gzip; unpack it first.");
  throw Error(ErrorCode::not_a_cad_file,
              quoted(name) + " is not a STEP, IGES or BREP file; export the model in one of these formats.");
}

[[noreturn]] void throw_cut_off(const std::string& name, const char* what) {
  throw Error(ErrorCode::damaged_file, quoted(name) + " is cut off: " + what + " is missing; copy or export it again.");
}

}  // namespace

const char* format_name(FileFormat format) {
  static constexpr const char* names[] = {"STEP", "IGES", "BREP", "BREP"};
  static_assert(std::size(names) == static_cast<std::size_t>(FileFormat::binary_brep) + 1);
  return names[static_cast<std::size_t>(format)];
}

FileFormat find_format(const std::string& path, const std::string& name) {
  check_regular_file(path, name);
  FileEnds ends = read_ends(path, name);
  if (trimmed(ends.head, space).empty())
    throw Error(ErrorCode::not_a_cad_file, quoted(name) + " is empty; export the model again.");
  std::string_view words = first_words(ends.head);
  if (words.starts_with("ISO-10303-21")) {
    if (ends.tail.find("END-ISO-10303-21") == std::string::npos) throw_cut_off(name, "the line END-ISO-10303-21");
    return FileFormat::step;
  }
  if (words.starts_with("DBRep_DrawableShape") || words.starts_with("CASCADE Topology")) return FileFormat::brep;
  if (words.starts_with("Open CASCADE Topology")) return FileFormat::binary_brep;
  if (is_iges(ends.head)) {
    if (!is_iges_complete(ends.tail)) throw_cut_off(name, "the terminate section of the IGES file");
    if (!has_all_iges_lines(path, ends.tail)) throw_cut_off(name, "part of the IGES sections");
    return FileFormat::iges;
  }
  throw_foreign(name, ends.head);
}

}  // namespace paver
