// Shapes as bad writers of CAD files make them: each has one kind of fault, all over.
#pragma once

#include <TopoDS_Shape.hxx>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace paver::test {

/// A tube of radius 30 and 21, 100 long, with slots through its wall, two of them across the periodic edges.
TopoDS_Shape slotted_tube();

/// A cone on a half ball: two poles.
TopoDS_Shape cone_on_ball();

/// Every edge with vertices of its own, up to `gap` off: all loops are open.
TopoDS_Shape with_loose_vertices(const TopoDS_Shape& shape, double gap);

/// Faces that go round without their periodic edge: loops around, and nothing between them.
TopoDS_Shape without_periodic_edges(const TopoDS_Shape& shape);

/// Images of every third edge a period aside.
TopoDS_Shape with_shifted_images(const TopoDS_Shape& shape);

/// Images of every fifth edge on curved faces somewhere else.
TopoDS_Shape with_wrong_images(const TopoDS_Shape& shape);

/// Images on curved faces that run at another pace than their edges.
TopoDS_Shape with_uneven_images(const TopoDS_Shape& shape);

/// A truncated cone: a ring between two flat ends.
TopoDS_Shape frustum();

/// A quarter of a ring with a rounded rim.
TopoDS_Shape quarter_ring();

/// Rings that use the periodic edge once, with images of the two borders a period apart and vertices that take what is
/// off; `has_poles`: with poles in place of the second use.
TopoDS_Shape with_garbled_rings(const TopoDS_Shape& shape, bool has_poles);

/// Images on round faces whose starts lie half a period aside, and tolerances that allow it.
TopoDS_Shape with_allowed_images(const TopoDS_Shape& shape);

/// Poles without an edge.
TopoDS_Shape without_poles(const TopoDS_Shape& shape);

/// Edges of loops out of order.
TopoDS_Shape with_shuffled_loops(const TopoDS_Shape& shape);

/// Every second face inside out.
TopoDS_Shape with_turned_faces(const TopoDS_Shape& shape);

/// A compound of the faces, every third of them twice, none with an edge of another.
TopoDS_Shape with_doubled_faces(const TopoDS_Shape& shape);

/// A solid with its shell twice, nothing in common.
TopoDS_Shape with_doubled_shell(const TopoDS_Shape& shape);

/// A square plate of 20 whose corners lie `aside` beside the ends of their edges, in both directions.
TopoDS_Shape plate_with_corners_aside(double aside);

/// One face lacks an edge of its border.
TopoDS_Shape without_an_edge(const TopoDS_Shape& shape);

/// Two caps with a common border, equal but for their side.
TopoDS_Shape lens();

struct FaultyShape {
  std::string name;
  TopoDS_Shape (*clean)() = nullptr;
  std::function<TopoDS_Shape(const TopoDS_Shape&)> damage;
  std::vector<std::string> repairs;  ///< kinds that it takes
  TopoDS_Shape shape() const { return damage(clean()); }
  double area() const;  ///< of the clean shape
  friend void PrintTo(const FaultyShape& shape, std::ostream* out) { *out << shape.name; }
};

/// All of these that can be made whole.
std::vector<FaultyShape> faulty_shapes();

}  // namespace paver::test
