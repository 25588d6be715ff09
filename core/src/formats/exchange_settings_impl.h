// Settings of OpenCASCADE's STEP and IGES readers, put back afterwards: they are global, and a host may use them too.
#pragma once

#include <Interface_Static.hxx>
#include <string>

namespace paver {

/// Asks the readers for millimetres as long as it lives. Make it after the reader, which registers the setting.
class MillimetreReading {
 public:
  MillimetreReading() {
    if (const char* unit = Interface_Static::CVal(setting)) saved_ = unit;
    Interface_Static::SetCVal(setting, "MM");
  }
  ~MillimetreReading() {
    if (!saved_.empty()) Interface_Static::SetCVal(setting, saved_.c_str());
  }
  MillimetreReading(const MillimetreReading&) = delete;
  MillimetreReading& operator=(const MillimetreReading&) = delete;

 private:
  static constexpr const char* setting = "xstep.cascade.unit";
  std::string saved_;
};

}  // namespace paver
