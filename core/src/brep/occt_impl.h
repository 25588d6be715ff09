// Shared between the files that talk to OpenCASCADE: conversions, error translation, progress, silence.
#pragma once

#include <Message_ProgressIndicator.hxx>
#include <Message_ProgressScope.hxx>
#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>
#include <gp_XYZ.hxx>
#include <string>
#include <utility>

#include "paver/error.h"
#include "paver/progress.h"
#include "paver/vec.h"

namespace paver {

inline Vec3 to_vec(const gp_XYZ& a) { return {a.X(), a.Y(), a.Z()}; }
inline Vec3 to_vec(const gp_Pnt& a) { return {a.X(), a.Y(), a.Z()}; }
inline Vec3 to_vec(const gp_Vec& a) { return {a.X(), a.Y(), a.Z()}; }
inline gp_Pnt to_point(Vec3 a) { return {a.x, a.y, a.z}; }

/// What OpenCASCADE says about a failure: its message, else the name of its exception.
inline std::string failure_text(const Standard_Failure& failure) {
  const char* message = failure.GetMessageString();
  return message && *message ? message : failure.DynamicType()->Name();
}

/// Calls `f` and turns OpenCASCADE's exceptions into Error{code, text}; `text` is the sentence to say. What the kernel
/// leaves unfinished when it is cancelled may fail later on: then that is what is said.
template <class F>
auto guard_occt(ErrorCode code, const std::string& text, const Progress& progress, F&& f) {
  try {
    return f();
  } catch (const Standard_OutOfMemory&) {
    throw Error(ErrorCode::out_of_memory, "Out of memory in the CAD kernel; use a smaller model or more memory.");
  } catch (const Standard_Failure& failure) {
    progress.check();
    throw Error(code, text + " (the CAD kernel says: " + failure_text(failure) + ").");
  }
}

/// Passes OpenCASCADE's progress on to `units` of a Progress, and its cancel flag back.
class OcctProgress : public Message_ProgressIndicator {
 public:
  OcctProgress(Progress& progress, long units) : progress_(progress), units_(units) {}
  /// Credits what is left of the units.
  void finish() {
    progress_.advance(units_ - credited_);
    credited_ = units_;
  }

 protected:
  Standard_Boolean UserBreak() override { return progress_.is_cancelled(); }
  void Show(const Message_ProgressScope&, const Standard_Boolean) override {
    long now = static_cast<long>(GetPosition() * static_cast<double>(units_));
    if (now <= credited_ || progress_.is_cancelled()) return;
    try {
      progress_.advance(now - credited_);
    } catch (const Error&) {
      // Cancelled in between: no foreign exception may pass through the kernel, UserBreak() tells it next.
    }
    credited_ = now;
  }

 private:
  Progress& progress_;
  long units_;
  long credited_ = 0;
};

/// Silences the printers of OpenCASCADE's messenger as long as one lives. The messenger is the whole process's: only
/// levels of its printers change, never their list, which a host program may be walking through.
class QuietMessages {
 public:
  QuietMessages();
  ~QuietMessages();
  QuietMessages(const QuietMessages&) = delete;
  QuietMessages& operator=(const QuietMessages&) = delete;
};

}  // namespace paver
