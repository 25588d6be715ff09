// In: model, limits. Out: faces that go round and end in a rim which is nothing against the target length end in a
// pole: blunt noses, and those whose outline was drawn a little beside the axis. On the other side of such a rim is
// nothing, a tiny face within it, which goes, or another face that goes round. Holes to nothing, or to a tiny face, go.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "sizing/merging/merge_steps.h"

namespace paver {
namespace {

constexpr int samples = 8;

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
    merges_.push_back({MergeKind::edge, edge.name, edits_.face(round).name, edge.length, edits_.point(edge.start)});
    if (cap >= 0) edits_.leave_out(cap);
    for (int f : faces) edits_.face(f).merged_area += edge.length * edge.length;
    Vec3 centre;
    for (int i = 0; i < samples; ++i)
      centre += (1.0 / samples) * edge.curve->point(edge.parameter(i / double{samples}));
    edits_.model().vertices[edge.start] = centre;
    edits_.collapse({e});
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
};

}  // namespace

void close_tiny_rims(ModelEdits& edits, const MergeLimits& limits, std::vector<Merge>& merges) {
  TinyRims(edits, limits, merges).run();
}

}  // namespace paver
