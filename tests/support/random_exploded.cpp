// A random clean solid, and the same exploded into loose faces:  paver_random_exploded SEED FOLDER STEP
// Writes FOLDER/SEED.brep, the solid, and FOLDER/SEED_exploded.brep or, with STEP 1, .step: each face by itself, moved
// by up to a gap, turned over or not, and with some of its edges cut in two or three, without regard to its neighbours.
// Prints one line of JSON: the number of faces and edges, the cuts, the diagonal and the gap. Lengths in mm.
#include <BRepAdaptor_Curve.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <STEPControl_Writer.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <string>
#include <vector>

namespace {

const double pi = std::acos(-1.0);

/// The same numbers on every machine.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(mixed(seed)) {}
  double between(double low, double high) {
    state_ += 0x9E3779B97F4A7C15u;
    return low + (high - low) * static_cast<double>(mixed(state_) >> 11) / 9007199254740992.0;
  }
  /// 0 to count - 1.
  int pick(int count) { return static_cast<int>(between(0, count)); }
  bool is_true(double share) { return between(0, 1) < share; }
  gp_Dir direction() {
    const double z = between(-1, 1), angle = between(0, 2 * pi), r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
  }

 private:
  static std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

gp_Ax2 up(double x, double y, double z) { return {gp_Pnt(x, y, z), gp_Dir(0, 0, 1)}; }

TopoDS_Shape unified(const TopoDS_Shape& shape) {
  ShapeUpgrade_UnifySameDomain unify(shape);
  unify.Build();
  return unify.Shape();
}

TopoDS_Wire star(Random& random, int corners, double radius, double z) {
  BRepBuilderAPI_MakePolygon polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * pi * i / corners, r = radius * random.between(0.6, 1.3);
    polygon.Add(gp_Pnt(r * std::cos(angle), r * std::sin(angle), z));
  }
  polygon.Close();
  return polygon.Wire();
}

TopoDS_Shape box(Random& random) {
  return BRepPrimAPI_MakeBox(random.between(20, 100), random.between(20, 100), random.between(10, 80));
}

TopoDS_Shape prism(Random& random) {
  const TopoDS_Wire outline = star(random, 3 + random.pick(6), 50, 0);
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline, true), gp_Vec(0, 0, random.between(15, 90)));
}

TopoDS_Shape drilled(Random& random) {
  const double r = random.between(6, 12);
  return BRepAlgoAPI_Cut(prism(random),
                         BRepPrimAPI_MakeCylinder(up(random.between(-8, 8), random.between(-8, 8), -5), r, 200));
}

TopoDS_Shape stepped(Random& random) {
  const TopoDS_Shape low = BRepPrimAPI_MakeBox(gp_Pnt(-50, -40, 0), gp_Pnt(50, 40, random.between(20, 40)));
  const TopoDS_Shape top =
      random.is_true(0.5) ? BRepPrimAPI_MakeBox(gp_Pnt(-20, -15, 10), gp_Pnt(random.between(0, 30), 20, 80)).Shape()
                          : BRepPrimAPI_MakeCylinder(up(random.between(-15, 15), 0, 10), 20, 70).Shape();
  return unified(random.is_true(0.6) ? BRepAlgoAPI_Fuse(low, top).Shape() : BRepAlgoAPI_Cut(low, top).Shape());
}

TopoDS_Shape round(Random& random) {
  const double r = random.between(15, 50), h = random.between(20, 90);
  switch (random.pick(4)) {
    case 0:
      return BRepPrimAPI_MakeCylinder(r, h, random.is_true(0.5) ? 2 * pi : random.between(1, 5));
    case 1:
      return BRepPrimAPI_MakeCone(r, r * random.between(0.3, 0.7), h);
    case 2:
      return BRepPrimAPI_MakeSphere(gp_Pnt(0, 0, 0), r, random.between(-0.9, -0.3), random.between(0.3, 0.9));
    default:
      return BRepPrimAPI_MakeTorus(2.5 * r, r, random.between(1.5, 4.5));
  }
}

TopoDS_Shape slotted_tube(Random& random) {
  const double r = random.between(25, 40);
  const TopoDS_Shape tube =
      BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(r, 100), BRepPrimAPI_MakeCylinder(up(0, 0, -1), 0.7 * r, 102));
  const double w = random.between(6, 12), z = random.between(20, 40);
  const TopoDS_Shape slot = BRepPrimAPI_MakeBox(gp_Pnt(0, -w, z), gp_Pnt(2 * r, w, z + random.between(20, 40)));
  return BRepAlgoAPI_Cut(tube, slot);
}

TopoDS_Shape rounded_box(Random& random) {
  const TopoDS_Shape plain = box(random);
  BRepFilletAPI_MakeFillet fillet(plain);
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(plain, TopAbs_EDGE, edges);
  fillet.Add(random.between(3, 4.5), TopoDS::Edge(edges(1 + random.pick(edges.Extent()))));
  return fillet.Shape();
}

TopoDS_Shape loft(Random& random) {
  BRepOffsetAPI_ThruSections sections(true, false);
  const int corners = 3 + random.pick(3);
  for (int i = 0; i < 3; ++i) sections.AddWire(star(random, corners, 40, 40.0 * i));
  sections.Build();
  return sections.Shape();
}

TopoDS_Shape any_solid(Random& random) {
  TopoDS_Shape (*const kinds[])(Random&) = {box, prism, drilled, stepped, round, slotted_tube, rounded_box, loft};
  return kinds[random.pick(8)](random);
}

double length_of(const TopoDS_Edge& edge) { return GCPnts_AbscissaPoint::Length(BRepAdaptor_Curve(edge)); }

struct Clean {
  TopoDS_Shape shape;
  int faces = 0, edges = 0;
  double diagonal = 0, shortest = 1e300;
};

Clean measured(const TopoDS_Shape& shape) {
  Clean clean;
  clean.shape = shape;
  TopTools_IndexedMapOfShape faces, edges, solids;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  TopExp::MapShapes(shape, TopAbs_SOLID, solids);
  if (solids.Extent() != 1 || !BRepCheck_Analyzer(shape).IsValid()) return clean;
  clean.faces = faces.Extent();
  for (int i = 1; i <= edges.Extent(); ++i) {
    if (BRep_Tool::Degenerated(TopoDS::Edge(edges(i)))) continue;
    ++clean.edges;
    clean.shortest = std::min(clean.shortest, length_of(TopoDS::Edge(edges(i))));
  }
  Bnd_Box box;
  BRepBndLib::AddOptimal(shape, box, false, false);
  clean.diagonal = std::sqrt(box.SquareExtent());
  return clean;
}

/// Valid, and without edges so short that a gap would be like them.
Clean clean_solid(Random& random) {
  for (int i = 0; i < 100; ++i) {
    Clean clean = measured(any_solid(random));
    if (clean.faces >= 2 && clean.shortest > 0.04 * clean.diagonal) return clean;
  }
  throw Standard_Failure("no solid comes out valid");
}

/// Pieces shorter than this many gaps are not made: nobody could tell them from the gaps.
constexpr double least_gaps = 30;
/// Nor cuts of neighbours so near each other that one vertex would do for both.
constexpr double apart_gaps = 20;

class Exploder {
 public:
  Exploder(const Clean& clean, double gap, Random& random) : gap_(gap), random_(random) {
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(clean.shape, TopAbs_FACE, faces);
    for (int i = 1; i <= faces.Extent(); ++i) faces_.push_back(TopoDS::Face(faces(i)));
    for (std::size_t i = faces_.size(); i > 1; --i) std::swap(faces_[i - 1], faces_[pick(i)]);
  }

  TopoDS_Compound explode() {
    TopoDS_Compound loose;
    BRep_Builder().MakeCompound(loose);
    for (const TopoDS_Face& face : faces_) {
      TopoDS_Shape part = moved(BRepBuilderAPI_Copy(with_cuts(face)).Shape());
      if (random_.is_true(0.5)) part.Reverse();
      BRep_Builder().Add(loose, part);
    }
    return loose;
  }

  int cuts = 0;

 private:
  std::size_t pick(std::size_t count) { return static_cast<std::size_t>(random_.pick(static_cast<int>(count))); }

  /// By up to the gap anywhere on it: shifted, and turned a little.
  TopoDS_Shape moved(const TopoDS_Shape& face) {
    Bnd_Box box;
    BRepBndLib::AddOptimal(face, box, false, false);
    double x0 = 0, y0 = 0, z0 = 0, x1 = 0, y1 = 0, z1 = 0;
    box.Get(x0, y0, z0, x1, y1, z1);
    const gp_Pnt middle((x0 + x1) / 2, (y0 + y1) / 2, (z0 + z1) / 2);
    gp_Trsf shift, turn;
    shift.SetTranslation(gp_Vec(random_.direction()) * (gap_ * random_.between(0, 0.6)));
    turn.SetRotation(gp_Ax1(middle, random_.direction()),
                     gap_ * random_.between(0, 0.4) / (0.5 * std::sqrt(box.SquareExtent())));
    return BRepBuilderAPI_Transform(face, shift * turn, true).Shape();
  }

  TopoDS_Face with_cuts(const TopoDS_Face& face) {
    Handle(ShapeBuild_ReShape) context = new ShapeBuild_ReShape;
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(face, TopAbs_EDGE, edges);
    for (int i = 1; i <= edges.Extent(); ++i) {
      const TopoDS_Edge edge = TopoDS::Edge(edges(i).Oriented(TopAbs_FORWARD));
      if (BRep_Tool::Degenerated(edge) || BRep_Tool::IsClosed(edge, face) || !random_.is_true(0.4)) continue;
      const int pieces = 2 + random_.pick(2);
      if (length_of(edge) < 3 * pieces * least_gaps * gap_) continue;
      context->Replace(edge, cut(edge, pieces));
    }
    return TopoDS::Face(context->Apply(face));
  }

  /// Nowhere near a cut of the neighbour's.
  double place_to_cut(const TopoDS_Edge& edge, double middle, double reach) {
    for (;;) {
      const double t = middle + reach * random_.between(-1, 1);
      const gp_Pnt point = BRepAdaptor_Curve(edge).Value(t);
      if (std::any_of(cut_at_.begin(), cut_at_.end(),
                      [&](const gp_Pnt& other) { return point.Distance(other) < apart_gaps * gap_; }))
        continue;
      cut_at_.push_back(point);
      return t;
    }
  }

  /// The same curves in pieces, cut about evenly but nowhere exactly.
  TopoDS_Wire cut(const TopoDS_Edge& edge, int pieces) {
    BRep_Builder builder;
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    double first = 0, last = 0;
    BRep_Tool::Range(edge, first, last);
    TopoDS_Vertex before = TopExp::FirstVertex(edge);
    double from = first;
    for (int k = 1; k <= pieces; ++k) {
      const double share = (last - first) / pieces, middle = first + k * share;
      const double to = k == pieces ? last : place_to_cut(edge, middle, 0.3 * share);
      TopoDS_Vertex after = TopExp::LastVertex(edge);
      if (k < pieces) builder.MakeVertex(after, BRepAdaptor_Curve(edge).Value(to), BRep_Tool::Tolerance(edge));
      TopoDS_Edge piece = TopoDS::Edge(edge.EmptyCopied());
      builder.Add(piece, before.Oriented(TopAbs_FORWARD));
      builder.Add(piece, after.Oriented(TopAbs_REVERSED));
      builder.Range(piece, from, to);
      builder.Add(wire, piece);
      before = after;
      from = to;
    }
    cuts += pieces - 1;
    return wire;
  }

  double gap_;
  Random& random_;
  std::vector<TopoDS_Face> faces_;
  std::vector<gp_Pnt> cut_at_;
};

void write_brep(const TopoDS_Shape& shape, const std::string& path) {
  if (!BRepTools::Write(shape, path.c_str())) throw Standard_Failure("not written");
}

void write_step(const TopoDS_Shape& shape, const std::string& path) {
  STEPControl_Writer writer;
  writer.Transfer(shape, STEPControl_AsIs);
  if (writer.Write(path.c_str()) != IFSelect_RetDone) throw Standard_Failure("not written");
}

void run(const std::string& seed, const std::string& folder, bool is_step) {
  Random random(std::strtoull(seed.c_str(), nullptr, 10));
  const Clean clean = clean_solid(random);
  const double gap = clean.diagonal * std::pow(10, random.between(-6, -3));
  Exploder exploder(clean, gap, random);
  const TopoDS_Compound loose = exploder.explode();
  write_brep(clean.shape, folder + "/" + seed + ".brep");
  const std::string path = folder + "/" + seed + "_exploded";
  is_step ? write_step(loose, path + ".step") : write_brep(loose, path + ".brep");
  std::printf("{\"faces\": %d, \"edges\": %d, \"cuts\": %d, \"diagonal\": %.17g, \"gap\": %.17g}\n", clean.faces,
              clean.edges, exploder.cuts, clean.diagonal, gap);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: paver_random_exploded SEED FOLDER 0|1\n");
    return 2;
  }
  try {
    run(argv[1], argv[2], std::string(argv[3]) == "1");
  } catch (const Standard_Failure& failure) {
    std::fprintf(stderr, "paver_random_exploded: %s\n", failure.GetMessageString());
    return 1;
  }
  return 0;
}
