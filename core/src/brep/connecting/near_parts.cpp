// Which parts may touch: boxes of parts, then of faces, then boxes and slabs of the cells of a grid over each bent
// face, halved where they meet: a face within the bulge of another one, or along it, is not taken for touching it.
#include <algorithm>
#include <vector>

#include "brep/connecting/connect_impl.h"
#include "brep/connecting/face_cells_impl.h"

namespace paver {
namespace {

enum class Nearness { apart, near, free_form };

}  // namespace

NearParts find_near_parts(const Workpiece& work, double tolerance) {
  std::vector<Bnd_Box> whole(work.parts.size());
  std::vector<std::vector<PartPiece>> pieces(work.parts.size());
  auto add = [&](const TopoDS_Shape& shape, int part) {
    pieces[part].emplace_back(shape, 0.5 * tolerance);
    whole[part].Add(pieces[part].back().box());
  };
  for (const WorkFace& face : work.faces)
    if (face.is_usable())
      for (const FaceUse& use : face.uses) add(face.face, use.part);
  for (const WorkWire& wire : work.wires) add(wire.edge, wire.part);
  for (const WorkPoint& point : work.points)
    if (!point.is_end) add(point.vertex, point.part);
  auto has_copy = [](const PartPiece& piece, const std::vector<PartPiece>& others) {
    return std::ranges::any_of(others, [&](const PartPiece& other) { return piece.may_be_copy_of(other); });
  };
  auto nearness = [&](std::size_t a, std::size_t b) {
    if (whole[a].IsVoid() || whole[b].IsVoid() || whole[a].IsOut(whole[b])) return Nearness::apart;
    const bool are_solids = work.parts[a].solid >= 0 && work.parts[b].solid >= 0;
    Nearness found = Nearness::apart;
    for (PartPiece& one : pieces[a]) {
      if (one.box().IsOut(whole[b])) continue;
      for (PartPiece& two : pieces[b]) {
        const bool is_hard = !are_solids && one.is_free_form() && two.is_free_form() && !has_copy(one, pieces[b]) &&
                             !has_copy(two, pieces[a]) && !one.is_on_surface_of(two);
        if (found == Nearness::near && !is_hard) continue;
        if (!may_touch(one, two)) continue;
        if (is_hard) return Nearness::free_form;
        found = Nearness::near;
      }
    }
    return found;
  };
  NearParts near;
  for (std::size_t a = 0; a < work.parts.size(); ++a)
    for (std::size_t b = a + 1; b < work.parts.size(); ++b) {
      const Nearness found = nearness(a, b);
      if (found == Nearness::apart) continue;
      (found == Nearness::near ? near.pairs : near.free_form).push_back({static_cast<int>(a), static_cast<int>(b)});
    }
  return near;
}

}  // namespace paver
