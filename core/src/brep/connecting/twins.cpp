// Parts that were drawn twice in one place: the later one has the faces of the earlier one, so it needs no fuse, which
// takes long where all faces and edges coincide, or fails.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/box.h"
#include "brep/connecting/connect_impl.h"
#include "brep/mending/mend_impl.h"
#include "brep/occt_impl.h"
#include "brep/occt_shapes_impl.h"

namespace paver {
namespace {

/// What tells most parts apart at no cost; no faces where the part is no candidate.
struct Extent {
  int faces = 0;
  double area = 0;
  Box middles;  ///< of the middles of its edges
};

/// Boxes of parts in one place differ by less of themselves: their edges may start elsewhere.
constexpr double alike = 1e-3;

bool may_be_twins(const Extent& a, const Extent& b) {
  if (a.faces == 0 || a.faces != b.faces || std::abs(a.area - b.area) > doubled_area_share * a.area) return false;
  const double most = alike * norm(a.middles.high - a.middles.low);
  return norm(a.middles.low - b.middles.low) <= most && norm(a.middles.high - b.middles.high) <= most;
}

std::vector<Extent> extents_of(const Workpiece& work) {
  std::vector<Extent> extents(work.parts.size());
  for (const WorkFace& face : work.faces) {
    Box middles;
    for (const TopoDS_Edge& edge : edges_of(face.face))
      if (!BRep_Tool::Degenerated(edge)) middles.add(to_vec(middle_of(edge)));
    for (const FaceUse& use : face.uses) {
      ++extents[use.part].faces, extents[use.part].area += face.area;
      extents[use.part].middles.add(middles);
    }
  }
  auto leave_out = [&](int part) { extents[part].faces = 0; };
  for (const WorkFace& face : work.faces)
    if (!face.is_usable() || face.uses.size() > 1)
      for (const FaceUse& use : face.uses) leave_out(use.part);
  for (const WorkWire& wire : work.wires) leave_out(wire.part);
  for (std::size_t part = 0; part < work.parts.size(); ++part)
    if (work.parts[part].is_loose) leave_out(static_cast<int>(part));
  return extents;
}

}  // namespace

std::vector<Twin> find_twins(const Workpiece& work, const std::vector<PartPair>& pairs) {
  const std::vector<Extent> extents = extents_of(work);
  std::map<PartPair, std::vector<std::array<int, 2>>> doubles;
  for (const PartPair& pair : pairs)
    if (may_be_twins(extents[pair[0]], extents[pair[1]])) doubles[pair];
  if (doubles.empty()) return {};
  auto pair_of = [](const WorkFace& one, const WorkFace& two) {
    const auto [first, second] = std::minmax(one.uses[0].part, two.uses[0].part);
    return PartPair{first, second};
  };
  auto may_be_one = [&](const WorkFace& one, const WorkFace& two) {
    return !one.uses.empty() && !two.uses.empty() && doubles.contains(pair_of(one, two));
  };
  for (auto [face, other] : find_doubles(work, may_be_one)) {
    if (work.faces[face].uses[0].part < work.faces[other].uses[0].part) std::swap(face, other);
    doubles[pair_of(work.faces[face], work.faces[other])].push_back({face, other});
  }
  std::vector<Twin> twins;
  std::set<int> known;  // of three that are one the first has both others
  for (const auto& [pair, faces] : doubles)
    if (static_cast<int>(faces.size()) == extents[pair[0]].faces && !known.contains(pair[0]) &&
        known.insert(pair[1]).second)
      twins.push_back({pair[1], pair[0], faces});
  return twins;
}

void add_twin(const Workpiece& work, const Twin& twin, Fusion& fusion) {
  std::map<int, int> later;
  for (const auto& [face, first] : twin.faces) later[first] = face;
  for (Fusion::Image& image : fusion.images) {
    const std::vector<int> of = image.of;
    for (int face : of)
      if (const auto found = later.find(face); found != later.end()) image.of.push_back(found->second);
    std::sort(image.of.begin(), image.of.end());
  }
  const std::size_t known = fusion.edges.size();
  for (const auto& [face, first] : twin.faces)
    for (const TopoDS_Edge& edge : edges_of(work.faces[face].face))
      for (const TopoDS_Edge& other : edges_of(work.faces[first].face)) {
        if (BRep_Tool::Degenerated(edge) || BRep_Tool::Degenerated(other)) continue;
        if (middle_of(edge).Distance(middle_of(other)) > doubled_share * work.diagonal) continue;
        bool is_whole = true;
        for (std::size_t i = 0; i < known; ++i)
          if (fusion.edges[i].first.IsSame(other))
            fusion.edges.push_back({edge, fusion.edges[i].second}), is_whole = false;
        if (is_whole) fusion.edges.push_back({edge, other});
      }
}

}  // namespace paver
