// In: model, limits. Out: faces that go round and end in a rim which is nothing against the target length end in a
// pole: blunt noses, and those whose outline was drawn a little beside the axis. On the other side of such a rim is a
// tiny face within it, which goes, or another face that goes round. Holes that a tiny face closes go with it.
// Rims and holes to nothing do so only where no mesh could show them, and nothing comes near: a probe may go through.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/boxes/box_tree.h"
#include "sizing/merging/merge_steps.h"
#include "sizing/sample_box.h"

namespace paver {
namespace {

constexpr int samples = 8;     // of an edge
constexpr int cells = 16;      // along a face
constexpr double bulge = 0.1;  // of a cell's diagonal: more than it rises above its corners

class TinyRims {
 public:
  TinyRims(ModelEdits& edits, const MergeLimits& limits, std::vector<Merge>& merges)
      : edits_(edits), limits_(limits), merges_(merges) {}

  void run() {
    for (std::size_t e = 0, n = edits_.model().edges.size(); e < n; ++e)
      if (const int rim = static_cast<int>(e); is_tiny(rim)) close(rim);
  }

 private:
  bool is_tiny(int e) const {
    const Edge& edge = edits_.edge(e);
    return edge.curve && edge.start == edge.end && !edge.is_periodic && !edge.faces.empty() && edge.length > 0 &&
           !limits_.is_protected(e) && !edits_.is_fixed(edge.start) && edge.length < M_PI * limits_.tiny(e);
  }

  void close(int e) {
    const std::vector<int> faces = edits_.edge(e).faces;
    if (faces.size() == 2 && (faces[0] == faces[1] || limits_.separates_parts(faces[0], faces[1]))) return;
    int cap = -1, round = -1;
    for (int f : faces) (is_cap(f, e) ? cap : round) = f;
    const auto ends_here = [&](int f) {
      const bool may_be_hole = cap >= 0 || faces.size() == 1;  // else what meets there would come apart
      return f == cap || ends_at(f, e) || (may_be_hole && is_hole_of(f, e));
    };
    if (round < 0 || !std::ranges::all_of(faces, ends_here)) return;
    const Edge& edge = edits_.edge(e);
    if (faces.size() == 1 && (edge.length > M_PI * hairline * limits_.length(e) || !is_alone(edge, round))) return;
    merges_.push_back({cap < 0 ? MergeKind::edge : MergeKind::face, cap < 0 ? edge.name : edits_.face(cap).name,
                       edits_.face(round).name, edge.length / M_PI, edits_.point(edge.start)});
    if (cap >= 0) edits_.leave_out(cap);
    for (int f : faces) edits_.face(f).merged_area += edge.length * edge.length;
    Vec3 centre;
    const std::vector<Vec3> places = places_on(edge);  // the last is the first
    for (int i = 0; i < samples; ++i) centre += (1.0 / samples) * places[i];
    edits_.model().vertices[edge.start] = centre;
    edits_.collapse({e});
  }

  /// Whether all else is farther from a rim of the face than that is wide.
  bool is_alone(const Edge& rim, int face) {
    if (boxes_.empty()) list_boxes();
    bool is_alone = true;
    const Box near = box_about(places_on(rim)).grown(rim.length / M_PI);
    tree_.each_meeting(near, [&](int i) { is_alone = is_alone && owners_[i] == face; });
    return is_alone;
  }

  void list_boxes() {
    const Model& model = edits_.model();
    for (std::size_t f = 0; f < model.faces.size(); ++f) add_cells(static_cast<int>(f));
    for (const Edge& edge : model.edges)
      if (edge.is_wire()) add_box(places_on(edge), -1);
    for (const PartPoint& point : model.points) add_box({model.vertices[point.vertex]}, -1);
    tree_ = BoxTree(boxes_);
  }

  /// Of its surface, over all that its border encloses in (u, v).
  void add_cells(int f) {
    const Face& face = edits_.face(f);
    const SampleBox uv = sample_box(edits_.model(), face);
    if (!face.surface || !uv.has_area()) return;
    auto at = [&](int i, int j) { return face.surface->point(uv.at(i / double{cells}, j / double{cells})); };
    for (int i = 0; i < cells; ++i)
      for (int j = 0; j < cells; ++j) add_box({at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)}, f);
  }

  void add_box(const std::vector<Vec3>& places, int owner) {
    const Box box = box_about(places);
    boxes_.push_back(box.grown(bulge * norm(box.high - box.low)));
    owners_.push_back(owner);
  }

  static Box box_about(const std::vector<Vec3>& places) {
    Box box;
    for (Vec3 x : places) box.add(x);
    return box;
  }

  static std::vector<Vec3> places_on(const Edge& edge) {
    std::vector<Vec3> places;
    for (int i = 0; i <= samples; ++i) places.push_back(edge.curve->point(edge.parameter(i / double{samples})));
    return places;
  }

  /// Whether nothing but the rim bounds the face, which is tiny.
  bool is_cap(int f, int e) const {
    const Face& face = edits_.face(f);
    const auto is_inner = [&](const Coedge& coedge) {
      return coedge.edge == e || edits_.edge(coedge.edge).is_periodic || edits_.edge(coedge.edge).is_degenerate;
    };
    const double extent = limits_.extent(f) / std::numbers::sqrt2;  // the diagonal of a box
    return face.loops.size() == 1 && std::ranges::all_of(face.loops.front().coedges, is_inner) &&
           !limits_.is_protected_face(f) && extent < limits_.tiny(e);
  }

  /// Whether it is a loop by itself, and not the only one.
  bool is_hole_of(int f, int e) const {
    const Edge& edge = edits_.edge(e);
    const auto is_alone = [&](const Loop& loop) {
      if (loop.coedges.size() != 1 || loop.coedges.front().edge != e || !loop.coedges.front().pcurve) return false;
      const ParameterCurve& image = *loop.coedges.front().pcurve;
      const double way = norm(image.uv(edge.t1) - image.uv(edge.t0)),
                   across = norm(image.uv(edge.parameter(0.5)) - image.uv(edge.t0));
      return way < across;  // else it goes round the surface
    };
    const std::vector<Loop>& loops = edits_.face(f).loops;
    return loops.size() > 1 && std::ranges::any_of(loops, is_alone);
  }

  /// Whether the face goes round from its periodic edge and back to it along the rim.
  bool ends_at(int f, int e) const {
    for (const Loop& loop : edits_.face(f).loops)
      for (std::size_t i = 0, n = loop.coedges.size(); i < n; ++i) {
        if (loop.coedges[i].edge != e) continue;
        const int before = loop.coedges[(i + n - 1) % n].edge, after = loop.coedges[(i + 1) % n].edge;
        return n > 2 && before == after && edits_.edge(before).is_periodic && edits_.narrows_to(f, loop.coedges[i]);
      }
    return false;
  }

  ModelEdits& edits_;
  const MergeLimits& limits_;
  std::vector<Merge>& merges_;
  std::vector<Box> boxes_;   // of pieces of faces, of wires and points, as they were at first
  std::vector<int> owners_;  // the face, per box
  BoxTree tree_;
};

}  // namespace

void close_tiny_rims(ModelEdits& edits, const MergeLimits& limits, std::vector<Merge>& merges) {
  TinyRims(edits, limits, merges).run();
}

}  // namespace paver
