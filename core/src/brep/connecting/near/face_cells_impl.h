// Faces as cells, to tell whether they may touch.
#pragma once

#include <BRepAdaptor_Surface.hxx>
#include <Bnd_Box.hxx>
#include <array>
#include <vector>

#include "brep/occt_shapes_impl.h"

namespace paver {

/// A part of a face between lines of its (u, v).
struct FaceCell {
  gp_Pnt2d lo, hi;
  std::array<gp_XYZ, 4> corners;
  gp_XYZ normal;   ///< of the corners' diagonals, of any length
  double sag = 0;  ///< how far it may bulge from its corners' hull, and half of what counts as touching
  Bnd_Box box;
};

/// The border of a face in (u, v), as chords.
class FaceBorder {
 public:
  FaceBorder() = default;
  explicit FaceBorder(const TopoDS_Face& face);

  /// Whether the face has nothing between two lines of u and two of v; never where its border does not tell.
  bool is_outside(const gp_Pnt2d& lo, const gp_Pnt2d& hi) const;

 private:
  struct Chord {
    gp_Pnt2d a, b;
    double bulge = 0;  // the border is no farther from it
  };

  static bool comes_near(const Chord& chord, const gp_Pnt2d& lo, const gp_Pnt2d& hi);
  static std::vector<Chord> chords_of(const EdgeImage& image, int count);
  static bool are_flat(const std::vector<Chord>& line);
  void add(const EdgeImage& image, int most);
  bool is_closed() const;

  std::vector<Chord> chords_;
  std::vector<gp_Pnt2d> ends_;  // of edges
  bool is_whole_ = true;
};

/// A face, wire or point of a part. Wires and points are boxes.
class PartPiece {
 public:
  PartPiece(const TopoDS_Shape& shape, double margin);

  const Bnd_Box& box() const { return box_; }
  bool is_free_form() const { return is_free_form_; }
  bool is_elementary() const { return surface_.GetType() <= GeomAbs_Torus; }
  /// An edge or vertex of it may be so far off that the kernel would take it for others.
  bool is_vague() const { return is_vague_; }
  bool is_face() const { return shape_.ShapeType() == TopAbs_FACE; }
  /// Both are flat, and in one plane.
  bool is_level_with(const PartPiece& other) const;
  /// As far as boxes tell: the kernel finds copies by their edges, whatever their surface.
  bool may_be_copy_of(const PartPiece& other) const;
  /// Whether both are pieces of one surface in one parametrisation, as a patch cut out of a skin is: likewise.
  bool is_on_surface_of(const PartPiece& other) const;

  const std::vector<FaceCell>& cells();
  /// Whether the cell lies beside the face.
  bool is_outside(const FaceCell& cell) const { return border_.is_outside(cell.lo, cell.hi); }
  /// Across the way in which it is longer.
  std::array<FaceCell, 2> halves(const FaceCell& whole) const;

 private:
  bool is_simple() const;
  std::array<int, 2> divisions(const gp_Pnt2d& lo, const gp_Pnt2d& hi) const;
  FaceCell cell(gp_Pnt2d lo, gp_Pnt2d hi) const;

  TopoDS_Shape shape_;
  double margin_;
  Bnd_Box box_;
  BRepAdaptor_Surface surface_;
  bool is_free_form_ = false, is_vague_ = false;
  std::vector<FaceCell> cells_;
  FaceBorder border_;
};

/// As far as boxes of cells tell, and slabs along them.
bool may_touch(PartPiece& one, PartPiece& two);

/// Whether two faces that may touch do so at an angle, everywhere: not along each other.
bool crosses(PartPiece& one, PartPiece& two);

}  // namespace paver
