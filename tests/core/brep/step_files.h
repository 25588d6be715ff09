// Shapes as STEP files, written by the kernel, and what it finds of their area.
#pragma once

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <TopoDS_Shape.hxx>
#include <string>

#include "brep/occt_impl.h"

namespace paver::test {

/// mm^2, as the kernel finds it.
inline double area_of(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(shape, properties);
  return properties.Mass();
}

inline void write_step(const TopoDS_Shape& shape, const std::string& path) {
  QuietMessages quiet;
  STEPControl_Controller::Init();
  STEPControl_Writer writer;
  writer.Transfer(shape, STEPControl_AsIs);
  writer.Write(path.c_str());
}

}  // namespace paver::test
