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

/// How far the readers may move what does not meet, mm. As ReaderSetting.
class LargestTolerance {
 public:
  explicit LargestTolerance(double value) : saved_(Interface_Static::RVal(name)) {
    Interface_Static::SetRVal(name, value);
  }
  ~LargestTolerance() { Interface_Static::SetRVal(name, saved_); }
  LargestTolerance(const LargestTolerance&) = delete;
  LargestTolerance& operator=(const LargestTolerance&) = delete;

 private:
  static constexpr const char* name = "read.maxprecision.val";
  double saved_;
};

/// Lengths come in millimetres.
class MillimetreReading : ReaderSetting {
 public:
  MillimetreReading() : ReaderSetting("xstep.cascade.unit", "MM") {}
};

}  // namespace paver
