// Writes a random assembly of parts that touch, cross or keep apart:  paver_random_assembly SEED OUT.brep|OUT.step
// [OUT2] The same seed gives the same model everywhere: numbers are drawn as integers, rotations are of whole
// quaternions. Prints how many parts it has, how many sets of parts that hang together by touching (by distances of the
// kernel, which nothing is fused for), and its diagonal in mm.
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <STEPControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Quaternion.hxx>
#include <gp_Trsf.hxx>
#include <iostream>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "base/union_find.h"

namespace {

constexpr double touching = 1e-6;  // mm

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  /// From 0 to count - 1.
  int below(int count) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(count)); }
  int between(int low, int high) { return low + below(high - low + 1); }
  bool one_in(int count) { return below(count) == 0; }
  template <class T>
  const T& pick(const std::vector<T>& list) {
    return list[static_cast<std::size_t>(below(static_cast<int>(list.size())))];
  }

 private:
  std::mt19937_64 engine_;
};

/// A place in mm by axis.
struct Place {
  std::array<double, 3> at{};
  double& operator[](int axis) { return at[static_cast<std::size_t>(axis)]; }
  double operator[](int axis) const { return at[static_cast<std::size_t>(axis)]; }
  gp_Pnt point() const { return {at[0], at[1], at[2]}; }
};

gp_Dir direction(int axis) { return {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0}; }

/// A box along the axes; a rectangle where it has no thickness.
struct Slab {
  Place low, high;
};

struct Rod {
  Place base;
  int axis = 2;
  double radius = 0, height = 0;
  int side(int k) const { return (axis + k) % 3; }
};

TopoDS_Shape shape_of(const Slab& slab) {
  for (int a = 0; a < 3; ++a) {
    if (slab.low[a] != slab.high[a]) continue;
    Place corner = slab.low, across = slab.high;
    corner[(a + 1) % 3] = slab.high[(a + 1) % 3];
    across[(a + 1) % 3] = slab.low[(a + 1) % 3];
    return BRepBuilderAPI_MakeFace(
        BRepBuilderAPI_MakePolygon(slab.low.point(), corner.point(), slab.high.point(), across.point(), true).Wire(),
        true);
  }
  return BRepPrimAPI_MakeBox(slab.low.point(), slab.high.point()).Solid();
}

gp_Ax2 frame_of(const Rod& rod) { return {rod.base.point(), direction(rod.axis), direction(rod.side(1))}; }

TopoDS_Shape shape_of(const Rod& rod) {
  return BRepPrimAPI_MakeCylinder(frame_of(rod), rod.radius, rod.height).Solid();
}

/// A side of a slab that something is put on.
struct Ground {
  Slab slab;
  int axis;
  double level, out;  // where along the axis, and 1 or -1: which way is off the slab
  int along(int k) const { return (axis + k) % 3; }
};

class Assembly {
 public:
  explicit Assembly(std::uint64_t seed) : dice_(seed) {}

  std::vector<TopoDS_Shape> build() {
    const int wanted = dice_.between(2, 30);
    while (static_cast<int>(parts_.size()) < wanted) {
      const int left = wanted - static_cast<int>(parts_.size());
      build_group(std::min(left, dice_.one_in(3) ? dice_.between(1, 3) : dice_.between(2, 20)));
    }
    return std::move(parts_);
  }

 private:
  /// Parts on a lattice and on each other; the group is then placed as a whole.
  void build_group(int count) {
    slabs_.clear();
    rods_.clear();
    const std::size_t first = parts_.size();
    const int room = 20 + 5 * count;
    while (parts_.size() < first + static_cast<std::size_t>(count)) {
      if (slabs_.empty() && rods_.empty()) {
        add_alone(room);
      } else if (dice_.one_in(4)) {
        add_alone(room);
      } else if (!slabs_.empty() && (rods_.empty() || !dice_.one_in(3))) {
        add_on_slab();
      } else {
        add_on_rod();
      }
    }
    const gp_Trsf placement = make_placement(first > 0);
    for (std::size_t i = first; i < parts_.size(); ++i)
      parts_[i] = BRepBuilderAPI_Transform(parts_[i], placement, false).Shape();
  }

  /// None, a quarter turn that rounds, or any rotation; beside what is there, or through it.
  gp_Trsf make_placement(bool is_moved) {
    gp_Trsf placement;
    const int kind = dice_.below(3);
    gp_Quaternion turn;
    if (kind == 1) turn = gp_Quaternion(gp_Vec(direction(dice_.below(3))), std::acos(0.0));
    if (kind == 2) {
      const int x = dice_.between(-9, 9), y = dice_.between(-9, 9), z = dice_.between(-9, 9);
      turn = gp_Quaternion(x, y, z, dice_.between(1, 9));
      turn.Normalize();
    }
    placement.SetRotation(turn);
    if (is_moved) {
      gp_Vec move(5 * dice_.between(-8, 8), 5 * dice_.between(-8, 8), 5 * dice_.between(-8, 8));
      placement.SetTranslationPart(move);
    }
    return placement;
  }

  void add(const TopoDS_Shape& shape) { parts_.push_back(shape); }

  void add(const Slab& slab) {
    slabs_.push_back(slab);
    add(shape_of(slab));
  }

  void add(const Rod& rod) {
    rods_.push_back(rod);
    add(shape_of(rod));
  }

  void add_wire(const std::vector<Place>& places) {
    BRepBuilderAPI_MakePolygon polygon;
    for (const Place& place : places) polygon.Add(place.point());
    if (polygon.IsDone()) add(polygon.Wire());
  }

  double extent() { return dice_.pick<int>({5, 10, 10, 20, 20, 30, 40}); }
  double radius() { return 0.5 * dice_.pick<int>({5, 8, 10, 10, 15, 20}); }

  void add_alone(int room) {
    Place low;
    for (double& x : low.at) x = 5 * dice_.between(0, room / 5);
    if (dice_.one_in(4)) {
      add(Rod{low, dice_.below(3), radius(), extent()});
    } else if (!parts_.empty() && dice_.one_in(8)) {
      Place end = low;
      for (double& x : end.at) x += 5 * dice_.between(-4, 4);
      add_wire({low, end});
    } else {
      Slab slab{low, low};
      for (int a = 0; a < 3; ++a) slab.high[a] += extent();
      if (dice_.one_in(3)) {  // a plate or a sheet
        const int flat = dice_.below(3);
        for (int k : {1, 2}) slab.high[(flat + k) % 3] += 20;
        slab.high[flat] = slab.low[flat] + dice_.pick<int>({0, 0, 2});
      }
      add(slab);
    }
  }

  Ground pick_ground() {
    const Slab& slab = dice_.pick(slabs_);
    int axis = dice_.below(3);
    for (int a = 0; a < 3; ++a)
      if (slab.low[a] == slab.high[a]) axis = a;
    const bool is_high = dice_.one_in(2);
    return {slab, axis, is_high ? slab.high[axis] : slab.low[axis], is_high ? 1.0 : -1.0};
  }

  /// Somewhere on the ground: in its inside, on its border, or a little off it.
  Place spot(const Ground& ground) {
    Place place;
    place[ground.axis] = ground.level;
    for (int k : {1, 2}) {
      const int b = ground.along(k);
      const double low = ground.slab.low[b], length = ground.slab.high[b] - low;
      place[b] = dice_.one_in(4) ? low + 0.5 * length : low + 5 * dice_.between(-1, static_cast<int>(length) / 5 + 1);
    }
    return place;
  }

  static Slab slab_between(Place a, Place b) {
    for (int k = 0; k < 3; ++k)
      if (a[k] > b[k]) std::swap(a[k], b[k]);
    return {a, b};
  }

  void add_on_slab() {
    const Ground ground = pick_ground();
    using Adder = void (Assembly::*)(const Ground&);
    static const std::vector<Adder> adders{&Assembly::add_box_on,   &Assembly::add_box_on,  &Assembly::add_twin_on,
                                           &Assembly::add_patch_on, &Assembly::add_fin_on,  &Assembly::add_fin_on,
                                           &Assembly::add_rod_on,   &Assembly::add_rod_on,  &Assembly::add_rod_along,
                                           &Assembly::add_wire_to,  &Assembly::add_wire_on, &Assembly::add_ring_on};
    (this->*dice_.pick(adders))(ground);
  }

  /// How deep something goes into the ground: it mostly stands on it.
  double depth() { return dice_.pick<int>({0, 0, 0, 0, 5, 1}); }

  void add_box_on(const Ground& ground) {
    Place low = spot(ground), high = low;
    low[ground.axis] -= ground.out * depth();
    high[ground.axis] += ground.out * (dice_.one_in(4) ? 2 : extent());
    for (int k : {1, 2}) high[ground.along(k)] += extent();
    add(slab_between(low, high));
  }

  /// Face on face exactly.
  void add_twin_on(const Ground& ground) {
    Place low = ground.slab.low, high = ground.slab.high;
    low[ground.axis] = ground.level;
    high[ground.axis] = ground.level + ground.out * extent();
    add(slab_between(low, high));
  }

  void add_patch_on(const Ground& ground) {
    Place low = spot(ground), high = low;
    if (dice_.one_in(4)) {
      add(BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(circle(low, ground.axis, radius())).Wire(), true).Face());
      return;
    }
    for (int k : {1, 2}) high[ground.along(k)] += extent();
    add(slab_between(low, high));
  }

  void add_fin_on(const Ground& ground) {
    Place low = spot(ground), high = low;
    low[ground.axis] -= ground.out * depth();
    high[ground.axis] += ground.out * extent();
    high[ground.along(dice_.between(1, 2))] += extent();
    add(slab_between(low, high));
  }

  void add_rod_on(const Ground& ground) {
    Place base = spot(ground);
    const double height = extent(), down = dice_.one_in(3) ? height - 2 : depth();
    base[ground.axis] = ground.level + (ground.out > 0 ? -down : down - height);
    add(Rod{base, ground.axis, radius(), height});
  }

  /// Lies on the ground along a line.
  void add_rod_along(const Ground& ground) {
    const double r = radius();
    Place base = spot(ground);
    base[ground.axis] += ground.out * r;
    add(Rod{base, ground.along(dice_.between(1, 2)), r, extent()});
  }

  void add_wire_to(const Ground& ground) {
    Place foot = spot(ground), top = foot;
    top[ground.axis] += ground.out * extent();
    foot[ground.axis] -= ground.out * depth();
    std::vector<Place> places{foot, top};
    if (dice_.one_in(2)) {
      places.push_back(top);
      places.back()[ground.along(dice_.between(1, 2))] += extent();
    }
    if (places.size() > 2 && dice_.one_in(2)) {
      places.push_back(places.back());
      places.back()[ground.axis] = ground.level;
    }
    add_wire(places);
  }

  void add_wire_on(const Ground& ground) {
    Place from = spot(ground), to = spot(ground);
    if (dice_.one_in(2)) {  // along a border
      const int across = ground.along(dice_.between(1, 2));
      from[across] = to[across] = ground.slab.low[across];
    }
    if (from.point().Distance(to.point()) < 1) to[ground.along(1)] += 10;
    add_wire({from, to});
  }

  static TopoDS_Edge circle(const Place& center, int axis, double r) {
    return BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(center.point(), direction(axis), direction((axis + 1) % 3)), r));
  }

  void add_ring_on(const Ground& ground) {
    add(BRepBuilderAPI_MakeWire(circle(spot(ground), ground.axis, radius())).Wire());
  }

  void add_on_rod() {
    const Rod rod = dice_.pick(rods_);
    using Adder = void (Assembly::*)(const Rod&);
    static const std::vector<Adder> adders{
        &Assembly::add_stacked, &Assembly::add_beside,   &Assembly::add_crossing_rod, &Assembly::add_fin_at,
        &Assembly::add_fin_at,  &Assembly::add_disc_in,  &Assembly::add_plate_around, &Assembly::add_wire_at,
        &Assembly::add_beside,  &Assembly::add_sheet_in, &Assembly::add_wire_at};
    (this->*dice_.pick(adders))(rod);
  }

  /// On the same axis, with the same radius or another one; now and then inside.
  void add_stacked(const Rod& rod) {
    Rod other = rod;
    if (dice_.one_in(2)) other.radius = radius();
    other.height = extent();
    other.base[rod.axis] += dice_.one_in(4) ? 0 : dice_.one_in(2) ? rod.height : -other.height;
    add(other);
  }

  /// Two rods that touch along a line, from outside or from inside.
  void add_beside(const Rod& rod) {
    Rod other = rod;
    other.radius = radius();
    other.height = extent();
    const bool is_inside = dice_.one_in(4) && other.radius != rod.radius;
    const double apart = is_inside ? rod.radius - other.radius : rod.radius + other.radius;
    other.base[rod.side(dice_.between(1, 2))] += dice_.one_in(2) ? apart : -apart;
    other.base[rod.axis] += 5 * dice_.between(-1, 1);
    add(other);
  }

  void add_crossing_rod(const Rod& rod) {
    Rod other = rod;
    other.axis = rod.side(dice_.between(1, 2));
    other.radius = radius();
    other.height = 10 * dice_.between(1, 4);
    other.base[other.axis] -= 5 * dice_.between(0, 4);
    other.base[rod.axis] += 5 * dice_.between(0, static_cast<int>(rod.height) / 5);
    add(other);
  }

  /// A place on the mantle, in one of the four directions of the axes.
  Place mantle(const Rod& rod, int& across, double& out) {
    across = rod.side(dice_.between(1, 2));
    out = dice_.one_in(2) ? 1 : -1;
    Place place = rod.base;
    place[across] += out * rod.radius;
    place[rod.axis] += 5 * dice_.between(0, static_cast<int>(rod.height) / 5);
    return place;
  }

  /// A fin on the mantle: it stands on it, or touches it along a line.
  void add_fin_at(const Rod& rod) {
    int across = 0;
    double out = 0;
    Place low = mantle(rod, across, out), high = low;
    high[rod.axis] += extent();
    if (dice_.one_in(4)) {
      const int beside = 3 - rod.axis - across;
      low[beside] -= extent();
      high[beside] += extent();
    } else {
      low[across] -= out * depth();
      high[across] += out * extent();
    }
    add(slab_between(low, high));
  }

  void add_disc_in(const Rod& rod) {
    Place center = rod.base;
    center[rod.axis] += 5 * dice_.between(0, static_cast<int>(rod.height) / 5);
    const double r = dice_.one_in(2) ? rod.radius : radius();
    add(BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(circle(center, rod.axis, r)).Wire(), true).Face());
  }

  void add_plate_around(const Rod& rod) {
    Place low = rod.base, high = rod.base;
    high[rod.axis] += dice_.one_in(2) ? 0 : 2;
    const double up = 5 * dice_.between(0, static_cast<int>(rod.height) / 5);
    for (Place* place : {&low, &high}) (*place)[rod.axis] += up;
    for (int k : {1, 2}) {
      low[rod.side(k)] -= extent();
      high[rod.side(k)] += extent();
    }
    add(slab_between(low, high));
  }

  /// A sheet through the axis.
  void add_sheet_in(const Rod& rod) {
    Place low = rod.base, high = rod.base;
    const int across = rod.side(dice_.between(1, 2));
    low[across] -= extent();
    high[across] += extent();
    low[rod.axis] -= 5 * dice_.between(0, 2);
    high[rod.axis] += rod.height;
    add(slab_between(low, high));
  }

  /// A wire to the mantle or on it.
  void add_wire_at(const Rod& rod) {
    int across = 0;
    double out = 0;
    Place from = mantle(rod, across, out), to = from;
    if (dice_.one_in(3)) {
      to[rod.axis] += extent();
    } else {
      to[across] += out * extent();
      from[across] -= out * depth();
    }
    add_wire({from, to});
  }

  Dice dice_;
  std::vector<TopoDS_Shape> parts_;
  std::vector<Slab> slabs_;  // of the group
  std::vector<Rod> rods_;
};

/// Faces and edges: what is inside a solid does not touch it.
TopoDS_Shape skin_of(const TopoDS_Shape& part) {
  TopExp_Explorer shells(part, TopAbs_SHELL);
  return shells.More() ? shells.Current() : part;
}

/// Sets of parts that hang together by touching.
int count_components(const std::vector<TopoDS_Shape>& parts) {
  paver::UnionFind together(parts.size());
  std::vector<Bnd_Box> boxes(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) BRepBndLib::Add(parts[i], boxes[i], false);
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t j = i + 1; j < parts.size(); ++j) {
      if (boxes[i].IsOut(boxes[j])) continue;
      BRepExtrema_DistShapeShape distance(skin_of(parts[i]), skin_of(parts[j]));
      if (distance.IsDone() && distance.Value() < touching) together.merge(static_cast<int>(i), static_cast<int>(j));
    }
  std::set<int> roots;
  for (std::size_t i = 0; i < parts.size(); ++i) roots.insert(together.find(static_cast<int>(i)));
  return static_cast<int>(roots.size());
}

double diagonal_of(const std::vector<TopoDS_Shape>& parts) {
  Bnd_Box box;
  for (const TopoDS_Shape& part : parts) BRepBndLib::Add(part, box, false);
  return std::sqrt(box.SquareExtent());
}

std::vector<TopoDS_Shape> without_wires(std::vector<TopoDS_Shape> parts) {
  std::erase_if(parts, [](const TopoDS_Shape& part) { return part.ShapeType() == TopAbs_WIRE; });
  return parts;
}

void write(const std::vector<TopoDS_Shape>& parts, const std::string& path) {
  if (path.ends_with(".brep")) {
    TopoDS_Compound compound;
    BRep_Builder builder;
    builder.MakeCompound(compound);
    for (const TopoDS_Shape& part : parts) builder.Add(compound, part);
    if (!BRepTools::Write(compound, path.c_str())) throw Standard_Failure("not written");
    return;
  }
  STEPControl_Writer writer;
  for (const TopoDS_Shape& part : parts) writer.Transfer(part, STEPControl_AsIs);
  if (writer.Write(path.c_str()) != IFSelect_RetDone) throw Standard_Failure("not written");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3 && argc != 4) {
    std::fprintf(stderr, "usage: paver_random_assembly SEED OUT.brep|OUT.step [OUT2]\n");
    return 2;
  }
  try {
    const std::vector<TopoDS_Shape> parts = Assembly(std::stoull(argv[1])).build();
    write(parts, argv[2]);
    if (argc == 4) write(without_wires(parts), argv[3]);
    std::cout << std::flush;  // the STEP writer's own words; ours are the last line
    std::printf("%zu %d %.6g\n", parts.size(), count_components(parts), diagonal_of(parts));
  } catch (const Standard_Failure& failure) {
    std::fprintf(stderr, "paver_random_assembly: %s\n", failure.GetMessageString());
    return 1;
  }
  return 0;
}
