// Writes a random B-rep: primitives, prisms, revolutions and lofts that are cut, fused, filleted, chamfered and moved.
//   paver_random_brep SEED MODEL.brep|MODEL.step
// The same seed gives the same model with every standard library: only the engine's integers are used. An operation
// that fails, or leaves what BRepCheck_Analyzer calls invalid, is left out.
#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_GTransform.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepFilletAPI_MakeChamfer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepGProp.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepPrimAPI_MakeWedge.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <STEPControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shape.hxx>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <gp_Ax2.hxx>
#include <gp_GTrsf.hxx>
#include <random>
#include <string>

namespace {

const double pi = std::acos(-1.0);

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  /// 0 to count - 1.
  int choose(int count) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(count)); }
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(choose(1 << 20)) / (1 << 20);
  }
  bool happens(double share) { return between(0, 1) < share; }
  gp_Pnt point(double reach) { return {between(-reach, reach), between(-reach, reach), between(-reach, reach)}; }
  gp_Dir direction() {
    static const std::array<gp_Dir, 3> axes{gp_Dir(1, 0, 0), gp_Dir(0, 1, 0), gp_Dir(0, 0, 1)};
    if (happens(0.6)) return axes[static_cast<std::size_t>(choose(3))];
    gp_Vec v(between(-1, 1), between(-1, 1), between(-1, 1));
    return v.Magnitude() > 0.1 ? gp_Dir(v) : gp_Dir(0, 0, 1);
  }
  gp_Ax2 frame(double reach) {
    gp_Pnt origin = point(reach);
    return {origin, direction()};
  }

 private:
  std::mt19937_64 engine_;
};

TopoDS_Wire star(Dice& dice, double z, int corners, double size, bool is_smooth) {
  Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, corners);
  for (int k = 0; k < corners; ++k) {
    const double radius = size * dice.between(0.5, 1), angle = 2 * pi * k / corners;
    points->SetValue(k + 1, gp_Pnt(radius * std::cos(angle), radius * std::sin(angle), z));
  }
  if (is_smooth) {
    GeomAPI_Interpolate curve(points, true, 1e-9);
    curve.Perform();
    return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(curve.Curve()));
  }
  BRepBuilderAPI_MakePolygon polygon;
  for (const gp_Pnt& point : *points) polygon.Add(point);
  polygon.Close();
  return polygon;
}

TopoDS_Shape moved(const TopoDS_Shape& shape, const gp_Ax2& frame) {
  gp_Trsf move;
  move.SetTransformation(gp_Ax3(frame), gp_Ax3());
  return BRepBuilderAPI_Transform(shape, move, true);
}

TopoDS_Shape prism(Dice& dice, const gp_Ax2& frame) {
  const TopoDS_Wire wire = star(dice, 0, 3 + dice.choose(5), dice.between(2, 6), dice.happens(0.5));
  return moved(BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire, true), gp_Vec(0, 0, dice.between(0.5, 8))), frame);
}

TopoDS_Shape revolution(Dice& dice, const gp_Ax2& frame) {
  const TopoDS_Wire wire = star(dice, 0, 3 + dice.choose(4), dice.between(1, 3), dice.happens(0.5));
  const gp_Ax1 axis(gp_Pnt(-dice.between(3.2, 6), 0, 0), gp_Dir(0, 1, 0));
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(wire, true);
  if (dice.happens(0.5)) return moved(BRepPrimAPI_MakeRevol(face, axis), frame);
  return moved(BRepPrimAPI_MakeRevol(face, axis, dice.between(0.5, 6)), frame);
}

TopoDS_Shape loft(Dice& dice, const gp_Ax2& frame) {
  const int corners = 3 + dice.choose(4), sections = 2 + dice.choose(3);
  const bool is_smooth = dice.happens(0.5);
  BRepOffsetAPI_ThruSections skin(true, dice.happens(0.3));
  for (int k = 0; k < sections; ++k) skin.AddWire(star(dice, 4.0 * k, corners, dice.between(1, 5), is_smooth));
  skin.Build();
  return moved(skin.Shape(), frame);
}

TopoDS_Shape primitive(Dice& dice) {
  const gp_Ax2 frame = dice.frame(4);
  const double a = dice.between(1, 8), b = dice.between(1, 8), c = dice.between(0.3, 8);
  switch (dice.choose(10)) {
    case 0:
      return BRepPrimAPI_MakeBox(frame, a, b, c);
    case 1:
      return BRepPrimAPI_MakeCylinder(frame, a / 2, c);
    case 2:
      return BRepPrimAPI_MakeCylinder(frame, a / 2, c, dice.between(0.3, 6));
    case 3:
      return BRepPrimAPI_MakeCone(frame, a / 2, dice.happens(0.3) ? 0 : std::abs(a - b) / 2 + 0.1, c);
    case 4:
      return BRepPrimAPI_MakeSphere(frame, a / 2);
    case 5:
      return BRepPrimAPI_MakeTorus(frame, 2 + a / 2, dice.between(0.2, 1.8));
    case 6:
      return BRepPrimAPI_MakeWedge(frame, a, b, c, a * dice.between(0, 0.9));
    case 7:
      return prism(dice, frame);
    case 8:
      return revolution(dice, frame);
    default:
      return loft(dice, frame);
  }
}

double volume(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties);
  return properties.Mass();
}

bool is_sound(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  return faces.Extent() > 0 && faces.Extent() < 200 && BRepCheck_Analyzer(shape).IsValid() && volume(shape) > 1e-3;
}

TopoDS_Shape rounded(Dice& dice, const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  const double radius = dice.between(0.05, 0.5);
  const int count = 1 + dice.choose(4);
  if (dice.happens(0.6)) {
    BRepFilletAPI_MakeFillet fillet(shape);
    for (int k = 0; k < count; ++k) fillet.Add(radius, TopoDS::Edge(edges(1 + dice.choose(edges.Extent()))));
    return fillet.Shape();
  }
  BRepFilletAPI_MakeChamfer chamfer(shape);
  for (int k = 0; k < count; ++k) chamfer.Add(radius, TopoDS::Edge(edges(1 + dice.choose(edges.Extent()))));
  return chamfer.Shape();
}

TopoDS_Shape transformed(Dice& dice, const TopoDS_Shape& shape) {
  gp_Trsf move;
  switch (dice.choose(3)) {
    case 0:
      move.SetMirror(dice.frame(2));
      break;
    case 1:
      move.SetScale(gp_Pnt(), std::pow(10, dice.between(-2, 2)));
      break;
    default: {
      gp_GTrsf stretch;
      for (int k = 1; k <= 3; ++k) stretch.SetValue(k, k, dice.between(0.4, 2.5));
      return BRepBuilderAPI_GTransform(shape, stretch, true);
    }
  }
  return BRepBuilderAPI_Transform(shape, move, true);
}

TopoDS_Shape changed(Dice& dice, const TopoDS_Shape& shape) {
  switch (dice.choose(8)) {
    case 0:
    case 1:
      return BRepAlgoAPI_Fuse(shape, primitive(dice));
    case 2:
    case 3:
    case 4:
      return BRepAlgoAPI_Cut(shape, primitive(dice));
    case 5:
      return BRepAlgoAPI_Common(shape, primitive(dice));
    case 6:
      return rounded(dice, shape);
    default:
      return dice.happens(0.6) ? rounded(dice, shape) : transformed(dice, shape);
  }
}

/// `make` where it works and is sound, or else what there was.
TopoDS_Shape if_sound(const std::function<TopoDS_Shape()>& make, const TopoDS_Shape& before) {
  try {
    TopoDS_Shape shape = make();
    if (!shape.IsNull() && is_sound(shape)) return shape;
  } catch (const Standard_Failure&) {
  }
  return before;
}

TopoDS_Shape random_brep(std::uint64_t seed) {
  Dice dice(seed);
  TopoDS_Shape shape = BRepPrimAPI_MakeBox(dice.between(1, 8), dice.between(1, 8), dice.between(1, 8));
  shape = if_sound([&] { return primitive(dice); }, shape);
  for (int operations = dice.choose(6); operations > 0; --operations)
    shape = if_sound([&] { return changed(dice, shape); }, shape);
  return shape;
}

bool write(const TopoDS_Shape& shape, const std::string& path) {
  if (path.ends_with(".brep")) return BRepTools::Write(shape, path.c_str());
  STEPControl_Writer writer;
  return writer.Transfer(shape, STEPControl_AsIs) == IFSelect_RetDone && writer.Write(path.c_str()) == IFSelect_RetDone;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: paver_random_brep SEED MODEL.brep|MODEL.step\n");
    return 2;
  }
  const TopoDS_Shape shape = random_brep(std::strtoull(argv[1], nullptr, 10));
  Bnd_Box box;
  BRepBndLib::AddOptimal(shape, box, true, false);
  std::printf("diagonal %.17g\n", std::sqrt(box.SquareExtent()));
  return write(shape, argv[2]) ? 0 : 1;
}
