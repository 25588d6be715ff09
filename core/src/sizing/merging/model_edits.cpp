#include "sizing/merging/model_edits.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "base/cells.h"
#include "sizing/sample_box.h"

namespace paver {
namespace {

template <class F>
void for_uses(Model& model, const Edge& edge, int index, F&& f) {
  for (int face : std::set<int>(edge.faces.begin(), edge.faces.end()))
    for (Loop& loop : model.faces[face].loops)
      for (std::size_t i = 0; i < loop.coedges.size(); ++i)
        if (loop.coedges[i].edge == index) f(loop.coedges, i);
}

}  // namespace

double ParameterMatch::operator()(double t) const {
  const std::size_t i = cell_of(from, t);
  const double step = from[i + 1] - from[i];
  const double share = step > 0 ? std::clamp((t - from[i]) / step, 0.0, 1.0) : 0;
  return (1 - share) * to[i] + share * to[i + 1];
}

Side reversed(Side side) {
  std::reverse(side.begin(), side.end());
  for (SideEdge& e : side) e.is_reversed = !e.is_reversed;
  return side;
}

Vec3 direction_out(const Edge& edge, bool at_end) {
  // A chord, as curves may stand still at their ends.
  constexpr double chord = 1e-3;
  const double step = chord * (edge.t1 - edge.t0);
  const Vec3 from = edge.curve->point(at_end ? edge.t1 : edge.t0);
  return unit(edge.curve->point(at_end ? edge.t1 - step : edge.t0 + step) - from);
}

double bend_between(const Edge& one, const Edge& other, int vertex) {
  return angle_between(-1 * direction_out(one, one.end == vertex), direction_out(other, other.end == vertex));
}

ModelEdits::ModelEdits(Model& model)
    : model_(model), edges_at_(model.vertices.size()), is_fixed_(model.vertices.size(), 0) {
  for (std::size_t e = 0; e < model.edges.size(); ++e) {
    const Edge& edge = model.edges[e];
    if (edge.is_degenerate) poles_.push_back(static_cast<int>(e));
    if (!edge.curve) continue;
    for (int vertex : {edge.start, edge.end}) {
      edges_at_[vertex].push_back(static_cast<int>(e));
      if (edge.is_wire()) fix(vertex);
    }
  }
  for (const PartPoint& point : model.points) fix(point.vertex);
  for (const Face& face : model.faces)
    for (const InnerPoint& point : face.points) fix(point.vertex);
}

void ModelEdits::unlink(int e) {
  for (int vertex : {edge(e).start, edge(e).end}) std::erase(edges_at_[vertex], e);
}

void ModelEdits::link(int e) {
  for (int vertex : {edge(e).start, edge(e).end}) {
    std::vector<int>& edges = edges_at_[vertex];
    edges.insert(std::upper_bound(edges.begin(), edges.end(), e), e);
  }
}

bool ModelEdits::narrows_to(int f, const Coedge& coedge) const {
  constexpr int samples = 8;
  constexpr double least_share = 0.2;  // of a side of the image
  constexpr double least_growth = 10;  // times the edge: strips and wires are no wider elsewhere
  const Edge& end = edge(coedge.edge);
  if (!end.curve || !coedge.pcurve) return false;
  const SampleBox box = sample_box(model_, face(f));
  const Vec2 size = box.hi - box.lo, way = coedge.pcurve->uv(end.t1) - coedge.pcurve->uv(end.t0);
  const double along_u = std::fabs(way.x) / size.x, along_v = std::fabs(way.y) / size.y;
  if (!(std::max(along_u, along_v) > least_share)) return false;
  auto halfway = [&](double share) {
    return face(f).surface->point(along_u > along_v ? box.at(share, 0.5) : box.at(0.5, share));
  };
  double reach = 0;
  for (int i = 1; i <= samples; ++i) reach = std::max(reach, norm(halfway(i / double{samples}) - halfway(0)));
  return M_PI * reach >= least_growth * end.length;
}

void ModelEdits::make_pole(int f, Coedge& coedge) {
  Edge pole = edge(coedge.edge);
  pole.curve.reset();
  pole.is_degenerate = true;
  pole.length = 0;
  pole.end = pole.start;
  pole.faces = {f};
  coedge.edge = static_cast<int>(model_.edges.size());
  poles_.push_back(coedge.edge);
  model_.edges.push_back(std::move(pole));
  model_.edge_part.resize(model_.edges.size(), -1);
}

void ModelEdits::take_out(const std::vector<int>& edges) {
  const std::set<int> gone(edges.begin(), edges.end());
  std::set<int> faces;
  for (int e : edges) {
    unlink(e);
    faces.insert(edge(e).faces.begin(), edge(e).faces.end());
    edge(e).curve.reset();
    edge(e).faces.clear();
  }
  for (int f : faces) {
    std::vector<Loop>& loops = face(f).loops;
    for (Loop& loop : loops) std::erase_if(loop.coedges, [&](const Coedge& c) { return gone.contains(c.edge); });
    std::erase_if(loops, [](const Loop& loop) { return loop.coedges.empty(); });
  }
}

void ModelEdits::collapse(const std::vector<int>& edges) {
  for (int e : edges)
    for (int f : std::set<int>(edge(e).faces.begin(), edge(e).faces.end()))
      for (Coedge& coedge : coedges_of(face(f).loops))
        if (coedge.edge == e && narrows_to(f, coedge)) make_pole(f, coedge);
  take_out(edges);
}

void ModelEdits::set(int index, const Edge& changed) {
  unlink(index);
  edge(index) = changed;
  link(index);
}

void ModelEdits::move_vertex(int from, int to, double reach) {
  const double moved = norm(point(to) - point(from));
  for (int e : edges_at(from))
    for (int face : edge(e).faces) model_.faces[face].merged_area += moved * reach;
  std::vector<int>& old = edges_at_[from];
  std::vector<int>& now = edges_at_[to];
  for (int e : old) {
    if (edge(e).start == from) edge(e).start = to;
    if (edge(e).end == from) edge(e).end = to;
    now.push_back(e);
  }
  old.clear();
  std::sort(now.begin(), now.end());
  for (int pole : poles_)
    if (edge(pole).start == from) edge(pole).start = edge(pole).end = to;
}

int ModelEdits::split(int e, double t) {
  const int behind = static_cast<int>(model_.edges.size()), vertex = static_cast<int>(model_.vertices.size());
  model_.vertices.push_back(edge(e).curve->point(t));
  edges_at_.emplace_back();
  is_fixed_.push_back(0);
  unlink(e);
  model_.edges.push_back(edge(e));
  if (was_smooth(e)) note_smooth(behind);
  model_.edge_part.resize(model_.edges.size(), -1);
  Edge &first = edge(e), &second = edge(behind);
  const double share = (t - first.t0) / (first.t1 - first.t0);
  first.t1 = second.t0 = t;
  first.end = second.start = vertex;
  second.length *= 1 - share;
  first.length *= share;
  link(e);
  link(behind);
  for_uses(model_, edge(e), e, [&](std::vector<Coedge>& coedges, std::size_t& i) {
    Coedge other = coedges[i];
    other.edge = behind;
    coedges.insert(coedges.begin() + static_cast<std::ptrdiff_t>(coedges[i].is_reversed ? i : i + 1), other);
    ++i;
  });
  return behind;
}

void ModelEdits::replace(int gone, int kept, bool same_direction, const ParameterMatch& match) {
  for_uses(model_, edge(gone), gone, [&](std::vector<Coedge>& coedges, std::size_t i) {
    Coedge& coedge = coedges[i];
    coedge.edge = kept;
    coedge.is_reversed = coedge.is_reversed == same_direction;
    coedge.pcurve = image_by([image = coedge.pcurve, match](double t) { return image->uv(match(t)); });
  });
  Edge &from = edge(gone), &to = edge(kept);
  to.faces.insert(to.faces.end(), from.faces.begin(), from.faces.end());
  std::sort(to.faces.begin(), to.faces.end());
  to.origins.insert(to.origins.end(), from.origins.begin(), from.origins.end());
  unlink(gone);
  from.curve.reset();
  from.faces.clear();
}

void ModelEdits::leave_out(int f) {
  face(f).has_area = false;
  face(f).is_merged = true;
  face(f).loops.clear();
}

}  // namespace paver
