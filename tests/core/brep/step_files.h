// Shapes as STEP files, written by the kernel.
#pragma once

#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <TopoDS_Shape.hxx>
#include <string>

#include "brep/occt_impl.h"

namespace paver::test {

inline void write_step(const TopoDS_Shape& shape, const std::string& path) {
  QuietMessages quiet;
  STEPControl_Controller::Init();
  STEPControl_Writer writer;
  writer.Transfer(shape, STEPControl_AsIs);
  writer.Write(path.c_str());
}

}  // namespace paver::test
