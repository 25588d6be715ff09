// Parts that touch are made to share faces, edges and vertices.
#pragma once

#include <TopoDS_Edge.hxx>
#include <algorithm>
#include <array>
#include <gp_Pnt.hxx>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "brep/connecting/workpiece_impl.h"
#include "paver/options.h"
#include "paver/progress.h"
#include "paver/result.h"

namespace paver {

/// Fills in the parts, and which faces, wires and points they have: solids in the order of the shape as read, then
/// sheets, wires, points. Edges that faces share hang them together.
void list_parts(Workpiece& work, const TopoDS_Shape& as_read);

/// Parts are called as the object that all they have is labelled with ("Board/Face3"), where no other part is of it.
/// `labels`: of the shape as read (Shape::labels).
void name_parts(Workpiece& work, const std::vector<std::string>& labels);

/// "Face12" of a face as read, "Face3 + Face9" of what these have in common.
std::string entry_name(const Workpiece& work, int origin);

/// Two parts of the work, the first one's index being less; one of a part with itself where that is loose.
using PartPair = std::array<int, 2>;

struct NearParts {
  std::vector<PartPair> pairs;
  /// Pairs whose free-form faces may touch or cross where at least one part is no solid: for these the kernel's fuse
  /// takes minutes or has no end, so it is not tried.
  std::vector<PartPair> free_form;
};

/// Parts that may touch within `tolerance`, by boxes of small pieces of their faces, wires and points.
NearParts find_near_parts(const Workpiece& work, double tolerance);

/// Parts whose faces were written differently where they touch, up to `gap` (mm) apart, and were made one.
struct MergedParts {
  std::set<int> parts;
  double gap = 0;

  void add(const MergedParts& others) {
    parts.insert(others.parts.begin(), others.parts.end());
    gap = std::max(gap, others.gap);
  }
};

struct ConnectResult {
  std::vector<Contact> contacts;
  /// Pairs of parts that may touch but could not be connected.
  std::vector<PartPair> failed;
  MergedParts merged;
};

/// Fuses parts whose faces, wires or points may touch: what they have in common exists once afterwards, in
/// `work.common`, and edges that lie in other parts' faces divide these or stay inside them. Parts that come nowhere
/// near each other cost nothing. With Connect::none the contacts are found and the work stays as it is; with
/// Connect::united what lies within the union of the solids is dropped. Parts that cannot be fused stay as they are and
/// are named. `tolerance`: largest gap that is closed, mm. Credits connect_units per face.
ConnectResult connect(Workpiece& work, Connect how, double tolerance, Progress& progress);
inline constexpr long connect_units = 2;

/// What a fusion of parts gives: images in the order of what they are images of.
struct Fusion {
  struct Image {
    TopoDS_Face face;
    std::vector<int> of;  ///< indices of the work's faces that it is a piece of, rising
  };
  std::vector<Image> images;                                  ///< in the order of the first face each is a piece of
  std::vector<std::pair<TopoDS_Shape, TopoDS_Shape>> edges;   ///< edge and one of its images, where these differ
  std::vector<std::pair<TopoDS_Shape, TopoDS_Shape>> points;  ///< point and its image, where these differ
  double tolerance = 0;                                       ///< mm
  MergedParts merged;
  std::set<int> doubled;  ///< parts with pieces along each other that are still two
};

/// Fuses these parts of the work at one of several tolerances, `tolerance` first; nothing when none of them works.
/// Whether it works is checked: every face has images that cover it. Where pieces of different parts lie along each
/// other and are two, again at the distance between them, as long as that connects no parts that were apart.
/// `points`: in which parts touch, besides.
std::optional<Fusion> fuse(const Workpiece& work, const std::vector<int>& parts, double tolerance, Progress& progress,
                           const std::vector<TopoDS_Vertex>& points = {});

/// Points, few a pair, in which faces of two parts, not both free-form ones, touch, within `tolerance`. `pairs`: of
/// parts that may touch and have nothing in common after a fuse.
std::vector<TopoDS_Vertex> find_touching_points(const Workpiece& work, const std::vector<PartPair>& pairs,
                                                double tolerance, const Progress& progress);

/// The same of parts that match, without a fuse: flat convex faces that in each of `pairs`, which are all that may
/// touch, have nothing in common but whole faces, edges and vertices. Nothing where there is more, or it cannot be
/// told.
std::optional<Fusion> match_parts(const Workpiece& work, const std::vector<int>& parts,
                                  const std::vector<PartPair>& pairs, double tolerance, const Progress& progress);

/// Half way along an edge.
gp_Pnt middle_of(const TopoDS_Edge& edge);

/// A part that was drawn in the place of another one.
struct Twin {
  int part = -1, of = -1;
  std::vector<std::array<int, 2>> faces;  ///< (the part's, the other's that it lies on)
};

/// Among pairs of parts that may touch; `of` is no twin of another.
std::vector<Twin> find_twins(const Workpiece& work, const std::vector<PartPair>& pairs);

/// What a fusion says of the faces and edges of Twin::of it then says of the twin's, too.
void add_twin(const Workpiece& work, const Twin& twin, Fusion& fusion);

/// Of the diagonal: strips as wide where parts overlap, and gaps as wide beside these, come from rounded coordinates.
constexpr double most_misfit = 1e-5;

/// Pieces of different parts that lie along each other but are two: a surface and its approximation cross along many
/// lines, two planes of which one is turned by rounding along one, and the kernel keeps both.
struct DoubledPieces {
  double gap = 0;       ///< the largest distance between such pieces, or width of what is left beside common ones, mm
  std::set<int> parts;  ///< with such pieces
  std::set<int> in_lenses;  ///< likewise, along each other between two common edges
};
DoubledPieces find_doubled_pieces(const Workpiece& work, const Fusion& fusion, const Progress& progress);

/// Pairs of parts that have a vertex in common after a fusion.
std::set<PartPair> touching_parts(const Workpiece& work, const Fusion& fusion);

/// Gives solids, those with faces in common together, faces, edges and vertices of their own where they share vertices
/// with sheets, wires or solids before them; false where none does.
bool unshare_parts(Workpiece& work, const std::vector<int>& parts);

/// Whether a face of the parts has a vertex or an edge inside, as files have them that were written after a fuse. Where
/// such a vertex is the pole of another part the kernel garbles its face; where such an edge bounds a face of another
/// part that face may stay open.
bool have_inner_shapes(const Workpiece& work, const std::vector<int>& parts);

/// Gives whole balls among the parts another axis, where a pole lies on a bent face that may touch them, or all of
/// them; false where there are none. `pairs`: that may touch.
bool turn_balls(Workpiece& work, const std::vector<int>& parts, const std::vector<PartPair>& pairs, bool are_all);

/// Lets the loops of tori among the parts begin where the kernel finds two on each other to be one.
void order_tori(Workpiece& work, const std::vector<int>& parts);

/// Marks parts that touch themselves: WorkPart::is_loose.
void find_loose_parts(Workpiece& work, double tolerance);

/// What a tolerance tells of the gap closed there, mm: the kernel widens tolerances so far; its own accuracy is no gap.
double closed_gap(double tolerance);

/// Between the faces of the work that this is an image of, mm. Of what is wider than `fusion_tolerance` (mm) the
/// distance is measured: where faces meet at a small angle the kernel's tolerances are larger than any gap.
double closed_gap(const Fusion::Image& image, const Workpiece& work, double fusion_tolerance);

/// Contacts between connected parts.
std::vector<Contact> find_contacts(const Workpiece& work);

/// Notes for every face and wire which solids it lies inside of, among those whose boxes hold it.
void find_insides(Workpiece& work);

}  // namespace paver
