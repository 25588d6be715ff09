// Settings of OpenCASCADE's STEP and IGES readers, put back afterwards: they are global, and a host may use them too.
#pragma once

#include <Interface_Static.hxx>
#include <string>

namespace paver {

/// Holds as long as it lives. Make it after the reader, which registers the settings; one that it does not know is
/// left.
class ReaderSetting {
 public:
  ReaderSetting(const char* name, const char* value) : name_(name) {
    if (const char* saved = Interface_Static::CVal(name)) saved_ = saved;
    Interface_Static::SetCVal(name, value);
  }
  ~ReaderSetting() {
    if (!saved_.empty()) Interface_Static::SetCVal(name_, saved_.c_str());
  }
  ReaderSetting(const ReaderSetting&) = delete;
  ReaderSetting& operator=(const ReaderSetting&) = delete;

 private:
  const char* name_;
  std::string saved_;
};

/// Lengths come in millimetres.
class MillimetreReading : ReaderSetting {
 public:
  MillimetreReading() : ReaderSetting("xstep.cascade.unit", "MM") {}
};

}  // namespace paver
