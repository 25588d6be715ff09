// Which parts may touch: boxes of parts, then of faces, then boxes and slabs of the cells of a grid over each bent
// face, halved where they meet: a face within the bulge of another one, or along it, is not taken for touching it.
#include <algorithm>
#include <vector>

#include "brep/connecting/connect_impl.h"
#include "brep/connecting/near/face_cells_impl.h"

namespace paver {
namespace {

enum class Nearness { apart, near, crossing, free_form };

}  // namespace

NearParts find_near_parts(const Workpiece& work, double tolerance) {
  std::vector<Bnd_Box> whole(work.parts.size());
  std::vector<std::vector<PartPiece>> pieces(work.parts.size());
  std::vector<char> is_vague(work.parts.size(), 0);
  auto add = [&](const TopoDS_Shape& shape, int part) {
    pieces[part].emplace_back(shape, 0.5 * tolerance);
    whole[part].Add(pieces[part].back().box());
    is_vague[part] |= pieces[part].back().is_vague();
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
        if ((found != Nearness::apart && !is_hard) || !may_touch(one, two)) continue;
        if (is_hard && (is_vague[a] || is_vague[b] || !crosses(one, two))) return Nearness::free_form;
        if (is_hard || found == Nearness::apart) found = is_hard ? Nearness::crossing : Nearness::near;
      }
    }
    return found;
  };
  NearParts near;
  std::vector<PartPair> crossing;
  std::vector<char> is_left(work.parts.size(), 0);  // not all of what touches it is connected
  for (std::size_t a = 0; a < work.parts.size(); ++a)
    for (std::size_t b = a + 1; b < work.parts.size(); ++b) {
      const Nearness found = nearness(a, b);
      if (found == Nearness::apart) continue;
      const PartPair pair{static_cast<int>(a), static_cast<int>(b)};
      (found == Nearness::near ? near.pairs : found == Nearness::crossing ? crossing : near.free_form).push_back(pair);
      if (found == Nearness::free_form) is_left[a] = is_left[b] = 1;
    }
  // To connect a part by halves takes long and helps nobody.
  for (auto [a, b] : crossing) (is_left[a] || is_left[b] ? near.free_form : near.pairs).push_back({a, b});
  std::ranges::sort(near.pairs);
  std::ranges::sort(near.free_form);
  return near;
}

}  // namespace paver
