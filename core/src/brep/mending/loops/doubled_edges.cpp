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

/// An edge as its loop walks it.
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

class LoopJoiner {
 public:
  LoopJoiner(const TopoDS_Face& face, double most) : face_(face), most_(most) {}

  /// False where a loop cannot be walked as a whole.
  bool add_loop(const TopoDS_Wire& wire) {
    std::vector<TopoDS_Edge> edges;
    for (BRepTools_WireExplorer at(wire, face_); at.More(); at.Next()) edges.push_back(at.Current());
    if (edges.size() != static_cast<std::size_t>(wire.NbChildren())) return false;
    // Readers turn loops that touch at random; which is right is seen by the border that they are together.
    if (std::ranges::any_of(edges, [&](const TopoDS_Edge& edge) { return double_of(edge, false).has_value(); })) {
      std::reverse(edges.begin(), edges.end());
      for (TopoDS_Edge& edge : edges) edge.Reverse();
    }
    const std::size_t first = uses_.size();
    for (const TopoDS_Edge& edge : edges) add(edge);
    if (!edges.empty()) uses_.back().next = first;
    return true;
  }

  std::vector<Use> uses() { return has_doubles_ ? std::move(uses_) : std::vector<Use>{}; }

 private:
  /// From and to.
  std::array<int, 2> ends_of(const TopoDS_Edge& edge) {
    return {vertices_.Add(TopExp::FirstVertex(edge, Standard_True)),
            vertices_.Add(TopExp::LastVertex(edge, Standard_True))};
  }

  /// A use of another edge along an edge, there or back.
  std::optional<std::size_t> double_of(const TopoDS_Edge& edge, bool is_back) {
    auto [from, to] = ends_of(edge);
    if (from == to || BRep_Tool::Degenerated(edge)) return std::nullopt;
    if (is_back) std::swap(from, to);
    for (const std::size_t other : between_[{from, to}])
      if (!uses_[other].back && !uses_[other].edge.IsSame(edge) && runs_along(edge, uses_[other].edge, most_))
        return other;
    return std::nullopt;
  }

  void add(const TopoDS_Edge& edge) {
    const std::size_t use = uses_.size();
    uses_.push_back({edge, use + 1, double_of(edge, true)});
    if (uses_[use].back) uses_[*uses_[use].back].back = use, has_doubles_ = true;
    between_[ends_of(edge)].push_back(use);
  }

  const TopoDS_Face& face_;
  double most_;
  TopTools_IndexedMapOfShape vertices_;
  std::map<std::array<int, 2>, std::vector<std::size_t>> between_;
  std::vector<Use> uses_;
  bool has_doubles_ = false;
};

}  // namespace

std::optional<TopoDS_Face> without_doubled_edges(const TopoDS_Face& face, double diagonal) {
  const std::vector<TopoDS_Wire> loops = wires_of(face);
  if (loops.size() < 2) return std::nullopt;
  LoopJoiner finder(face, most_share * diagonal);
  for (const TopoDS_Wire& loop : loops)
    if (!finder.add_loop(loop)) return std::nullopt;
  const std::vector<Use> uses = finder.uses();
  if (uses.empty()) return std::nullopt;
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
