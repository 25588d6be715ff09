// Names and exit codes of the error codes, and what to do about each.
#include "paver/error.h"

namespace paver {
namespace {

const char* general_remedy(ErrorCode code) {
  switch (code) {
    case ErrorCode::bad_option:
      return "correct the option";
    case ErrorCode::file_missing:
      return "check the path";
    case ErrorCode::not_a_cad_file:
    case ErrorCode::damaged_file:
      return "export the model again as STEP, IGES or BREP";
    case ErrorCode::no_faces:
      return "use a model that has surfaces";
    case ErrorCode::too_many_elements:
      return "choose a larger target length";
    case ErrorCode::unwritable_output:
      return "choose another folder or free some space";
    case ErrorCode::cancelled:
      return "start again";
    case ErrorCode::out_of_memory:
      return "choose a larger target length or fewer threads";
    case ErrorCode::face_failed:
      return "repair the face in the CAD program or choose a smaller target length";
    case ErrorCode::internal:
      break;
  }
  return "report it with the model";
}

}  // namespace

const char* code_name(ErrorCode code) {
  switch (code) {
    case ErrorCode::bad_option:
      return "bad_option";
    case ErrorCode::file_missing:
      return "file_missing";
    case ErrorCode::not_a_cad_file:
      return "not_a_cad_file";
    case ErrorCode::damaged_file:
      return "damaged_file";
    case ErrorCode::no_faces:
      return "no_faces";
    case ErrorCode::too_many_elements:
      return "too_many_elements";
    case ErrorCode::unwritable_output:
      return "unwritable_output";
    case ErrorCode::cancelled:
      return "cancelled";
    case ErrorCode::out_of_memory:
      return "out_of_memory";
    case ErrorCode::face_failed:
      return "face_failed";
    case ErrorCode::internal:
      break;
  }
  return "internal";
}

int exit_code(ErrorCode code) {
  switch (code) {
    case ErrorCode::bad_option:
      return 2;
    case ErrorCode::file_missing:
    case ErrorCode::not_a_cad_file:
    case ErrorCode::damaged_file:
    case ErrorCode::no_faces:
      return 3;
    case ErrorCode::face_failed:
      return 4;
    case ErrorCode::too_many_elements:
      return 5;
    case ErrorCode::unwritable_output:
      return 6;
    case ErrorCode::cancelled:
      return 130;
    case ErrorCode::out_of_memory:
    case ErrorCode::internal:
      break;
  }
  return 1;
}

std::string Error::remedy() const {
  std::string text = what();
  std::size_t start = text.rfind("; ");
  if (start == std::string::npos || code_ == ErrorCode::cancelled) return general_remedy(code_);
  text = text.substr(start + 2);
  bool is_opened = text.find('(') != std::string::npos;
  while (text.ends_with('.') || (text.ends_with(')') && !is_opened)) text.pop_back();
  return text;
}

}  // namespace paver
