#include "sizing/merging/merge_limits.h"

#include <algorithm>
#include <cmath>

#include "base/local_parts.h"
#include "sizing/sample_box.h"

namespace paver {

MergeLimits::MergeLimits(const ModelEdits& edits, const Options& options, const std::vector<int>& lasting)
    : edits_(edits),
      lasting_(lasting),
      h_(paver::target_length(options)),
      edge_share_(options.merge),
      face_share_(options.merge_width),
      local_(edits.model(), options, h_),
      extent_(edits.model().faces.size(), -1),
      is_local_face_(static_cast<std::size_t>(edits.model().read_faces), 0),
      is_local_edge_(static_cast<std::size_t>(edits.model().read_edges), 0) {
  for (const LocalSize& local : options.local) {
    const PartName part = *parse_part(local.part);
    if (part.kind == PartKind::face) is_local_face_[part.index] = 1;
    if (part.kind == PartKind::edge) is_local_edge_[part.index] = 1;
  }
  const Model& model = edits.model();
  for (std::size_t f = 0; f < is_local_face_.size() && f < model.face_group.size(); ++f)
    if (!model.face_group[f].empty()) is_local_face_[f] = 1;
  for (std::size_t e = 0; e < is_local_edge_.size() && e < model.edge_group.size(); ++e)
    if (!model.edge_group[e].empty()) is_local_edge_[e] = 1;
}

double MergeLimits::extent(int face) const {
  double& known = extent_[face];
  if (known < 0) known = face_extent(edits_.model(), edits_.face(face));
  return known;
}

int MergeLimits::longest_edge(int face) const {
  int longest = -1;
  for (const Coedge& coedge : coedges_of(edits_.face(face).loops)) {
    const Edge& edge = edits_.edge(coedge.edge);
    if (!edge.is_periodic && (longest < 0 || edge.length > edits_.edge(longest).length)) longest = coedge.edge;
  }
  return longest;
}

double MergeLimits::width(int index) const {
  const Face& face = edits_.face(index);
  double perimeter = 0;
  for (const Coedge& coedge : coedges_of(face.loops))
    if (!edits_.edge(coedge.edge).is_periodic) perimeter += edits_.edge(coedge.edge).length;
  return perimeter > 0 ? face.area / (0.5 * perimeter) : INFINITY;
}

bool MergeLimits::is_thin(int face) const {
  const int longest = longest_edge(face);
  return longest >= 0 && edits_.edge(longest).curve && width(face) < thin_face(longest);
}

bool MergeLimits::may_be_merged(int f) const {
  constexpr double long_share = 0.5;
  if (!is_thin(f) || lasts(f)) return false;
  const double longest = edits_.edge(longest_edge(f)).length;
  for (const Coedge& coedge : coedges_of(edits_.face(f).loops)) {
    if (edits_.edge(coedge.edge).length < long_share * longest) continue;
    const std::optional<double> corner = corner_across(f, coedge.edge);
    if (corner && *corner <= smooth_angle * M_PI / 180) return true;
  }
  return false;
}

int MergeLimits::neighbour(int face, int edge) const {
  const std::vector<int>& faces = edits_.edge(edge).faces;
  return faces.size() == 2 && faces[0] != faces[1] ? faces[faces[0] == face ? 1 : 0] : -1;
}

std::optional<double> MergeLimits::corner_across(int f, int edge) const {
  const int other = neighbour(f, edge);
  if (other < 0 || is_protected(edge) || edits_.edge(edge).is_periodic || separates_parts(f, other))
    return std::nullopt;
  const Face& next = edits_.face(other);
  if (!next.has_area || !next.fault.empty()) return std::nullopt;
  return angle_along(f, other, edge);
}

double MergeLimits::angle_along(int one, int two, int edge) const {
  double most = 0;
  constexpr double beside_ends = 0.02;
  for (double share : {beside_ends, 0.25, 0.5, 0.75, 1 - beside_ends})
    most = std::max(most, angle_between(normal(one, edge, share), normal(two, edge, share)));
  return most;
}

Vec3 MergeLimits::normal(int f, int e, double share) const {
  const Edge& edge = edits_.edge(e);
  const Face& face = edits_.face(f);
  for (const Coedge& coedge : coedges_of(face.loops)) {
    if (coedge.edge != e || !coedge.pcurve) continue;
    return (face.is_reversed ? -1 : 1) * face.surface->normal(coedge.pcurve->uv(edge.parameter(share)));
  }
  return {};
}

bool MergeLimits::sharpens(int index, int e) const {
  // What is nothing keeps no point from its sharpness, only faces from ending in a line.
  const double sharp = (edits_.edge(e).length < tiny(e) ? 10 : 45) * M_PI / 180;
  for (const Loop& loop : edits_.face(index).loops)
    for (std::size_t i = 0, n = loop.coedges.size(); i < n; ++i) {
      if (loop.coedges[i].edge != e) continue;
      const Coedge &before = loop.coedges[(i + n - 1) % n], &after = loop.coedges[(i + 1) % n];
      const Edge &in = edits_.edge(before.edge), &out = edits_.edge(after.edge);
      if (!in.curve || !out.curve) return true;
      if (angle_between(direction_out(in, !before.is_reversed), direction_out(out, after.is_reversed)) < sharp)
        return true;
    }
  return false;
}

double MergeLimits::length(int index) const {
  const Edge& edge = edits_.edge(index);
  double largest = 0;
  for (int vertex : {edge.start, edge.end})
    for (int e : edits_.edges_at(vertex))
      for (int face : edits_.edge(e).faces) largest = std::max(largest, std::min(extent(face), local_.on_face(face)));
  double h = std::min({h_, largest, local_.on_edge(edge)});
  if (!local_.is_empty())
    for (Vec3 x :
         {edge.curve->point(edge.t0), edge.curve->point(0.5 * (edge.t0 + edge.t1)), edge.curve->point(edge.t1)})
      h = std::min(h, local_.at(x));
  return h;
}

bool MergeLimits::is_protected(int index) const {
  const Edge& edge = edits_.edge(index);
  return edge.is_degenerate || edge.faces.size() > 2 || has_own_length(index);
}

bool MergeLimits::has_own_length(int index) const {
  return is_of_wire(edits_.model(), index) ||
         std::ranges::any_of(edits_.edge(index).origins, [&](int origin) { return is_local_edge_[origin] != 0; });
}

bool MergeLimits::is_protected_face(int index) const {
  const Face& face = edits_.face(index);
  return !face.points.empty() || !face.fault.empty() ||
         (face.origin < edits_.model().read_faces && is_local_face_[face.origin]);
}

bool MergeLimits::is_sharp(int e) const {
  constexpr double corner = 5 * M_PI / 180;
  const std::vector<int>& faces = edits_.edge(e).faces;
  if (faces.size() == 2 && separates_parts(faces[0], faces[1])) return true;
  if (edits_.was_smooth(e)) return false;
  if (faces.size() != 2) return true;
  if (edits_.edge(e).is_periodic || faces[0] == faces[1]) return false;
  return angle_along(faces[0], faces[1], e) > corner;
}

bool MergeLimits::holds(int vertex, const std::vector<int>& ignored, double distance) const {
  constexpr double nothing = 0.1;  // of a short edge
  const std::vector<int>& edges = edits_.edges_at(vertex);
  return std::any_of(edges.begin(), edges.end(), [&](int e) {
    if (std::find(ignored.begin(), ignored.end(), e) != ignored.end()) return false;
    const double limit = short_edge(e);
    return edits_.edge(e).length >= limit && distance > nothing * limit && is_sharp(e);
  });
}

bool MergeLimits::separates_parts(int a, int b) const {
  const Face &one = edits_.face(a), &two = edits_.face(b);
  const Model& model = edits_.model();
  auto has_sheet = [&](int face) {
    const auto f = static_cast<std::size_t>(face);
    return f < model.face_parts.size() &&
           std::ranges::any_of(model.face_parts[f], [&](int part) { return model.part_solid[part] < 0; });
  };
  return one.front != two.front || one.back != two.back || has_sheet(a) != has_sheet(b);
}

}  // namespace paver
