#include "brep/kernel_guard.h"

#include "brep/occt_impl.h"

namespace paver {

void guard_kernel(const Where& where, const std::function<void()>& task) {
  try {
    task();
  } catch (const Standard_Failure& failure) {
    throw Error(ErrorCode::face_failed,
                "the CAD kernel cannot evaluate it (" + failure_text(failure) + "); repair it in the CAD program",
                where);
  }
}

}  // namespace paver
