// Prints the largest distance of points from a model, by OpenCASCADE's own search:  paver_farthest
// MODEL.brep|MODEL.step Standard input: three coordinates per point. For models whose parametrisation the judge cannot
// follow.
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <string>

namespace {

TopoDS_Shape read(const std::string& path) {
  TopoDS_Shape shape;
  if (path.ends_with(".brep")) {
    BRepTools::Read(shape, path.c_str(), BRep_Builder());
  } else {
    STEPControl_Reader reader;
    reader.ReadFile(path.c_str());
    reader.TransferRoots();
    shape = reader.OneShape();
  }
  return shape;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  // The faces alone: points inside of a solid would have no distance.
  BRepExtrema_DistShapeShape search;
  TopoDS_Compound faces;
  BRep_Builder builder;
  builder.MakeCompound(faces);
  for (TopExp_Explorer each(read(argv[1]), TopAbs_FACE); each.More(); each.Next()) builder.Add(faces, each.Current());
  search.LoadS2(faces);
  double farthest = 0;
  for (double x, y, z; std::cin >> x >> y >> z;) {
    search.LoadS1(BRepBuilderAPI_MakeVertex(gp_Pnt(x, y, z)));
    if (!search.Perform() || search.NbSolution() == 0) return 1;
    farthest = std::max(farthest, search.Value());
  }
  std::printf("farthest %.17g\n", farthest);
  return 0;
}
