// Names and exit codes of the error codes, and what to do about each.
#include "paver/error.h"

#include <fmt/format.h>

#include <exception>
#include <new>
#include <system_error>

namespace paver {
namespace {

struct CodeInfo {
  const char* name;
  int exit_code;
  const char* remedy;
};

constexpr CodeInfo codes[] = {
    {"bad_option", 2, "correct the option"},
    {"file_missing", 3, "check the path"},
    {"not_a_cad_file", 3, "export the model again as STEP, IGES or BREP"},
    {"damaged_file", 3, "export the model again as STEP, IGES or BREP"},
    {"no_faces", 3, "use a model that has surfaces"},
    {"too_many_elements", 5, "choose a larger target length"},
    {"unwritable_output", 6, "choose another folder or free some space"},
    {"cancelled", 130, "start again"},
    {"out_of_memory", 1, "choose a larger target length or fewer threads"},
    {"face_failed", 4, "repair the face in the CAD program or choose a smaller target length"},
    {"internal", 1, "report it with the model"},
};
static_assert(std::size(codes) == static_cast<std::size_t>(ErrorCode::internal) + 1);

const CodeInfo& info_of(ErrorCode code) { return codes[static_cast<std::size_t>(code)]; }

}  // namespace

const char* code_name(ErrorCode code) { return info_of(code).name; }

int exit_code(ErrorCode code) { return info_of(code).exit_code; }

std::string Error::remedy() const {
  std::string text = what();
  std::size_t start = text.rfind("; ");
  if (start == std::string::npos || code_ == ErrorCode::cancelled) return info_of(code_).remedy;
  text = text.substr(start + 2);
  bool is_opened = text.find('(') != std::string::npos;
  while (text.ends_with('.') || (text.ends_with(')') && !is_opened)) text.pop_back();
  return text;
}

Error current_error() {
  try {
    throw;
  } catch (const Error& error) {
    return error;
  } catch (const std::bad_alloc&) {
    return Error(ErrorCode::out_of_memory,
                 "Out of memory; choose a larger target length, fewer ranks or fewer threads.");
  } catch (const std::exception& error) {
    const auto* system = dynamic_cast<const std::system_error*>(&error);
    if (system && system->code() == std::errc::resource_unavailable_try_again)  // no more threads
      return Error(
          ErrorCode::out_of_memory,
          fmt::format("The system gives no more means ({}); choose fewer ranks or fewer threads.", error.what()));
    return Error(ErrorCode::internal, fmt::format("Internal error ({}); report it with the model.", error.what()));
  } catch (...) {
    return Error(ErrorCode::internal, "Internal error of an unknown kind; report it with the model.");
  }
}

}  // namespace paver
