// Shapes are handed to the kernel in a row and taken back in the same order, whatever they are.
#include <BRepBuilderAPI_Transform.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>

#include "brep/connecting/workpiece_impl.h"
#include "brep/occt_impl.h"
#include "brep/occt_shapes_impl.h"

namespace paver {
namespace {

/// Calls `visit` for every shape of the work, in a fixed order, to be looked at or changed.
template <class Visit>
void for_shapes(Workpiece& work, std::vector<TopoDS_Shape>& edges, std::vector<TopoDS_Shape>& replaced, Visit visit) {
  visit(work.shape);
  for (WorkFace& face : work.faces) visit(face.face);
  for (WorkWire& wire : work.wires) visit(wire.edge);
  for (WorkPoint& point : work.points) visit(point.vertex);
  for (TopoDS_Shape& edge : edges) visit(edge);
  for (TopoDS_Shape& edge : replaced) visit(edge);
}

}  // namespace

bool move_work(Workpiece& work, Vec3 by, double scale) {
  std::vector<TopoDS_Shape> edges, replaced;
  std::vector<std::vector<int>> origins;  // of those that replaced others
  for (int i = 1; i <= work.read_edges.Extent(); ++i) edges.push_back(work.read_edges(i));
  for (auto at = decltype(work.replaced_edges)::Iterator(work.replaced_edges); at.More(); at.Next()) {
    replaced.push_back(at.Key());
    origins.push_back(at.Value());
  }
  BRep_Builder builder;
  TopoDS_Compound row;
  builder.MakeCompound(row);
  for_shapes(work, edges, replaced, [&](const TopoDS_Shape& shape) { builder.Add(row, shape); });
  TopoDS_Shape moved;
  try {
    gp_Trsf shift, resize;
    shift.SetTranslation(gp_Vec(by.x, by.y, by.z));
    resize.SetScaleFactor(scale);
    moved = BRepBuilderAPI_Transform(row, resize * shift, Standard_True).Shape();
  } catch (const Standard_Failure&) {
    return false;
  }
  TopoDS_Iterator next(moved);
  for_shapes(work, edges, replaced, [&](auto& shape) {
    static_cast<TopoDS_Shape&>(shape) = next.Value();
    next.Next();
  });
  work.read_edges.Clear();
  for (const TopoDS_Shape& edge : edges) work.read_edges.Add(edge);
  work.replaced_edges.Clear();
  for (std::size_t i = 0; i < replaced.size(); ++i) work.replaced_edges.Bind(replaced[i], origins[i]);
  work.centre = scale * (work.centre + by);
  work.diagonal *= scale;
  for (WorkFace& face : work.faces) face.area *= scale * scale, face.gap *= scale;
  work.is_copied = true;
  return true;
}

}  // namespace paver
