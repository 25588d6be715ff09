// Parts cut at each other, as CAD programs leave them that do so ("boolean fragments").
#pragma once

#include <BRepAlgoAPI_BuilderAlgo.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

namespace paver::test {

inline TopoDS_Shape fragments_of(const std::vector<TopoDS_Shape>& parts) {
  TopTools_ListOfShape arguments;
  for (const TopoDS_Shape& part : parts) arguments.Append(part);
  BRepAlgoAPI_BuilderAlgo fuse;
  fuse.SetArguments(arguments);
  fuse.Build();
  return fuse.Shape();
}

}  // namespace paver::test
