// Distances from a model by OpenCASCADE's own search, and points of it, for models whose parametrisation the judge
// cannot follow:  paver_farthest MODEL.brep|MODEL.step Standard input: three coordinates per point. Prints "farthest"
// and the largest distance of one of them from the model, then points all over the model's faces, one per line.
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
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

/// Nodes of OpenCASCADE's triangles: on the faces, inside their loops.
void print_points(const TopoDS_Shape& faces) {
  const BRepMesh_IncrementalMesh triangles(faces, 1e-3, true, 0.1);
  for (TopExp_Explorer each(faces, TopAbs_FACE); each.More(); each.Next()) {
    TopLoc_Location location;
    const auto found = BRep_Tool::Triangulation(TopoDS::Face(each.Current()), location);
    for (int i = 1; !found.IsNull() && i <= found->NbNodes(); ++i) {
      const gp_Pnt x = found->Node(i).Transformed(location);
      std::printf("%.17g %.17g %.17g\n", x.X(), x.Y(), x.Z());
    }
  }
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
  print_points(faces);
  return 0;
}
