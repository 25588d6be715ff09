// Loops of one face that run along each other for a stretch. Where a hole touches a side of its face, readers cut both
// at the ends of the stretch that lies within their tolerance: two edges between the same vertices, with nothing of the
// face between them. Without these the two loops are one, which passes there twice; what bounds the neighbours there
// is sewn to each other.
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "brep/mending/mend_impl.h"
#include "brep/occt_shapes_impl.h"
#include "brep/surfaces/evaluators_impl.h"

namespace paver {
namespace {

/// Edges claim to lie no farther off than their tolerance, of which no more than this share of the diagonal is
/// believed.
constexpr double most_share = 1e-6;
constexpr int chords = 16, foot_steps = 6;

/// All edges of the face as its loops walk them.
struct Use {
  TopoDS_Edge edge;
  std::size_t next = 0;             ///< in its loop
  std::optional<std::size_t> back;  ///< the use that runs back along it, of another edge
};

bool runs_along(const TopoDS_Edge& edge, const TopoDS_Edge& other, double most) {
  const auto curve = make_curve(edge), second = make_curve(other);
  if (!curve || !second || !range_of(edge).is_finite() || !range_of(other).is_finite()) return false;
  const double allowed = std::min(most, BRep_Tool::Tolerance(edge) + BRep_Tool::Tolerance(other));
  const auto [t0, t1] = range_of(other);
  const SampledCurve line = sampled(second, t0, t1, chords);
  return std::ranges::all_of(std::array{0.2, 0.5, 0.8}, [&](double share) {
    return distance_to(line, foot_steps, curve->point(range_of(edge).at(share))) <= allowed;
  });
}

/// None where a loop cannot be walked as a whole.
std::vector<Use> uses_of(const TopoDS_Face& face) {
  std::vector<Use> uses;
  for (const TopoDS_Wire& wire : wires_of(face)) {
    const std::size_t first = uses.size();
    for (BRepTools_WireExplorer at(wire, face); at.More(); at.Next())
      uses.push_back({at.Current(), uses.size() + 1, {}});
    if (uses.size() - first != static_cast<std::size_t>(wire.NbChildren())) return {};
    if (uses.size() > first) uses.back().next = first;
  }
  return uses;
}

bool find_doubles(std::vector<Use>& uses, double most) {
  TopTools_IndexedMapOfShape vertices;
  std::map<std::array<int, 2>, std::vector<std::size_t>> between;
  bool has_doubles = false;
  for (std::size_t i = 0; i < uses.size(); ++i) {
    const TopoDS_Edge& edge = uses[i].edge;
    if (BRep_Tool::Degenerated(edge)) continue;
    const int from = vertices.Add(TopExp::FirstVertex(edge, Standard_True)),
              to = vertices.Add(TopExp::LastVertex(edge, Standard_True));
    if (from == to) continue;
    for (const std::size_t other : between[{to, from}]) {
      if (uses[other].back || uses[other].edge.IsSame(edge) || !runs_along(edge, uses[other].edge, most)) continue;
      uses[i].back = other, uses[other].back = i;
      has_doubles = true;
      break;
    }
    between[{from, to}].push_back(i);
  }
  return has_doubles;
}

}  // namespace

std::optional<TopoDS_Face> without_doubled_edges(const TopoDS_Face& face, double diagonal) {
  if (wires_of(face).size() < 2) return std::nullopt;
  std::vector<Use> uses = uses_of(face);
  if (!find_doubles(uses, most_share * diagonal)) return std::nullopt;
  TopoDS_Face made = TopoDS::Face(face.EmptyCopied());
  BRep_Builder builder;
  std::vector<char> is_walked(uses.size(), 0);
  for (std::size_t start = 0; start < uses.size(); ++start) {
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    for (std::size_t i = start; !is_walked[i];) {
      is_walked[i] = 1;
      if (!uses[i].back) builder.Add(wire, uses[i].edge);
      i = uses[i].back ? uses[*uses[i].back].next : uses[i].next;
    }
    if (wire.NbChildren() > 0) builder.Add(made, wire);
  }
  return wires_of(made).empty() ? std::nullopt : std::optional(made);
}

}  // namespace paver
