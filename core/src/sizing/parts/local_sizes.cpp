// In: model, options, tips. Out: lengths on faces and edges, sources around which the length grows.
// Steps: every part to its faces, edges or point; the least length on each edge, its faces' included; edges as straight
// pieces, finer than the length asked for. A face's length spreads over its edges: through them it reaches its
// neighbours, and not through the thickness of a plate.
#include "sizing/parts/local_sizes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/local_parts.h"
#include "paver/error.h"
#include "sizing/parts/find_places.h"
#include "sizing/sample_box.h"
#include "topology/named_parts.h"

namespace paver {
namespace {

constexpr int fewest_pieces = 32, most_pieces = 20000;  // of an edge
constexpr double piece_share = 2;                       // of the length asked for
constexpr double narrowest_gap = 0.02;                  // of the target length: narrower ones count as that
constexpr double hole_intervals = 6;                    // a small round hole is divided into about so many
constexpr double small_hole = 0.1;                      // of the face's extent: interval of a hole that counts as small
constexpr double small_interval = 0.5;                  // of the target length: the same
constexpr double least_length = 1e-6;                   // of the model's diagonal
constexpr double same_point = 1e-3;                     // of the length at a tip: what lies nearer is the tip

void add_pieces(const Edge& edge, double length, int count, std::vector<SizeSource>& sources) {
  if (edge.is_degenerate || !edge.curve) return;
  Vec3 last = edge.curve->point(edge.t0);
  for (int i = 1; i <= count; ++i) {
    const double share = static_cast<double>(i) / count;
    const Vec3 next = edge.curve->point(edge.parameter(share));
    sources.push_back({last, next, length});
    last = next;
  }
}

bool is_straight(const Edge& edge) {
  constexpr double straight = 0.999;
  return edge.curve && norm(edge.curve->point(edge.t1) - edge.curve->point(edge.t0)) >= straight * edge.length;
}

std::vector<std::vector<SizeSource>> pieces_of_loops(const Model& model, const Face& face) {
  std::vector<std::vector<SizeSource>> loops(face.loops.size());
  for (std::size_t l = 0; l < loops.size(); ++l) {
    for (const Coedge& coedge : face.loops[l].coedges) {
      const Edge& edge = edge_of(model, coedge);
      add_pieces(edge, 0, is_straight(edge) ? 1 : fewest_pieces, loops[l]);
    }
  }
  return loops;
}

/// About what a loop is divided into where the target length is far longer: its sides, turns of 60 degrees, six at
/// most.
double longest_interval(const Model& model, const Loop& loop) {
  double straight = 0, bent = 0;
  int sides = 0;
  for (const Coedge& coedge : loop.coedges) {
    const Edge& edge = edge_of(model, coedge);
    (is_straight(edge) ? straight : bent) += edge.length;
    sides += is_straight(edge);
  }
  const double around = straight + bent;
  return around > 0 ? around / std::min(sides + std::ceil(hole_intervals * bent / around), hole_intervals) : 0;
}

/// Shorter ones are no geometry, and counts along edges were beyond all numbers.
void check_length(const Model& model, const LocalSize& local, double length) {
  if (length >= least_length * model.report.diagonal) return;
  throw Error(ErrorCode::bad_option,
              fmt::format("local: {:.6g} mm of {} is below a millionth of the model's diagonal, {:.6g} mm; choose a "
                          "longer one.",
                          length, local.part, model.report.diagonal));
}

}  // namespace

LocalSizes::LocalSizes(const Model& model, const Options& options, double h)
    : of_face_(model.faces.size(), none),
      of_edge_(static_cast<std::size_t>(model.read_edges), none),
      of_part_(model.parts.size(), none),
      gradation_(options.gradation) {
  for (const LocalSize& local : options.local) {
    double length = local_length(options, local);
    check_length(model, local, length);
    put(model, local, length);
    if (length < h) note_inside(model, local);
    if (length >= h)
      notes_.push_back(fmt::format("The length {:.6g} mm of {} has no effect: the target length is {:.6g} mm.", length,
                                   local.part, h));
  }
  if (options.grade_edges > 1) put_on_sharp_edges(model, options, h);
  if (options.tip > 1) put_on_tips(model, options, h);
  if (options.gap_elements > 1) put_on_gaps(model, options, h);
  put_on_holes(model, h);
  if (is_empty()) return;
  put_on_edges(model);
  nearest_ = NearestSegment(sources_, gradation_);
}

void LocalSizes::add(const std::vector<SizeSource>& sources) {
  if (sources.empty()) return;
  for (const SizeSource& source : sources) least_ = std::min(least_, source.value);
  sources_.insert(sources_.end(), sources.begin(), sources.end());
  nearest_ = NearestSegment(sources_, gradation_);
}

double LocalSizes::least_on(const std::vector<int>& faces, double most) const {
  for (int face : faces) most = std::min(most, on_face(face));
  return most;
}

// A length that is given for the vertex itself holds. Where all edges are shorter anyway there is nothing to do.
void LocalSizes::put_on_tips(const Model& model, const Options& options, double h) {
  const std::vector<std::pair<Vec3, double>> given = points_;
  for (const Tip& tip : find_tips(model)) {
    const double length = least_on(tip.faces, h) / options.tip;
    const Vec3 x = model.vertices[tip.vertex];
    auto is_at_tip = [&](const auto& point) { return norm(point.first - x) < same_point * length; };
    if (length >= tip.room || std::ranges::any_of(given, is_at_tip)) continue;
    points_.push_back({x, length});
    tips_of_face_.resize(model.faces.size());
    for (int face : std::set<int>(tip.faces.begin(), tip.faces.end())) ++tips_of_face_[face];
    least_ = std::min(least_, length);
  }
}

void LocalSizes::put_on_sharp_edges(const Model& model, const Options& options, double h) {
  const std::vector<bool> is_sharp = find_sharp_edges(model);
  for (std::size_t e = 0; e < is_sharp.size(); ++e) {
    if (!is_sharp[e]) continue;
    const double length = least_on(model.edges[e].faces, h) / options.grade_edges;
    least_ = std::min(least_, length);
    for (int origin : model.edges[e].origins) of_edge_[origin] = std::min(of_edge_[origin], length);
  }
}

// Lines along the gap as far apart as elements are to be, for the length grows between them.
void LocalSizes::put_on_gaps(const Model& model, const Options& options, double h) {
  auto length_on = [&](int face) { return std::min(h, on_face(face)); };
  const int lines = options.gap_elements;
  for (const GapPiece& gap : find_gaps(model, length_on)) {
    const double length = std::max(gap.width, narrowest_gap * h) / lines;
    for (int i = 0; i <= lines; ++i) {
      const double share = static_cast<double>(i) / lines;
      sources_.push_back(
          {(1 - share) * gap.from + share * gap.to, (1 - share) * gap.next_from + share * gap.next_to, length});
    }
    least_ = std::min(least_, length);
  }
}

// Where holes lie nearer to each other than h is long, or the face is smaller than h: what is divided about them would
// meet sides that are not divided. A single hole gets a ring of quads instead.
void LocalSizes::put_on_holes(const Model& model, double h) {
  for (const Face& face : model.faces) {
    if (!face.has_area || face.is_merged || face.loops.size() < 3) continue;
    const double extent = face_extent(model, face), holes = static_cast<double>(face.loops.size() - 1);
    if (extent >= h && std::sqrt(face.area / holes) >= h) continue;
    std::vector<std::vector<SizeSource>> loops = pieces_of_loops(model, face);
    const NearestSegment borders(loops, 1);
    for (std::size_t l = 0; l < face.loops.size(); ++l) {
      const double length = longest_interval(model, face.loops[l]);
      if (!(length > 0) || length > std::min(small_hole * extent, small_interval * h)) continue;
      for (SizeSource& piece : loops[l]) piece.value = length;
      start_where_rings_end(loops[l], l, borders);
      for (const SizeSource& source : loops[l]) {
        least_ = std::min(least_, source.value);
        sources_.push_back(source);
      }
    }
  }
}

// No rows need start at a face's own periodic edge.
void LocalSizes::note_inside(const Model& model, const LocalSize& local) {
  const PartName part = *parse_part(local.part);
  if (part.kind != PartKind::edge) return;
  for (const Edge& edge : model.edges) {
    bool is_meant = std::find(edge.origins.begin(), edge.origins.end(), part.index) != edge.origins.end();
    if (is_meant && (edge.is_periodic || edge.is_degenerate))
      notes_.push_back(fmt::format("The length of {} is only come near to: it is no border of its face.", local.part));
  }
}

// Every part in its own way; a solid is its faces and what lies inside.
void LocalSizes::put(const Model& model, const LocalSize& local, double length) {
  const PartName part = *parse_part(local.part);
  const auto index = static_cast<std::size_t>(part.index);
  check_part(model, local.part, "local");
  auto put_on_face = [&](int origin) {
    for (std::size_t f = 0; f < model.faces.size(); ++f)
      if (is_of_face(model, model.faces[f].origin, origin)) of_face_[f] = std::min(of_face_[f], length);
  };
  least_ = std::min(least_, length);
  switch (part.kind) {
    case PartKind::face:
      return put_on_face(part.index);
    case PartKind::edge:
      of_edge_[part.index] = std::min(of_edge_[part.index], length);
      return;
    case PartKind::vertex:
      points_.push_back({model.read_vertices[index], length});
      return;
    case PartKind::solid:
      for (int face : model.solid_faces[index]) put_on_face(face);
      return put_inside(model, part.index, length);
  }
}

/// On what lies inside of a solid, and on its own faces in whichever entry of the report they are.
void LocalSizes::put_inside(const Model& model, int solid, double length) {
  for (std::size_t p = 0; p < model.parts.size(); ++p) {
    if (model.part_solid[p] != solid) continue;
    of_part_[p] = std::min(of_part_[p], length);
    for (std::size_t f = 0; f < model.faces.size(); ++f)
      for (const std::vector<int>* side : {&model.faces[f].front, &model.faces[f].back})
        if (std::ranges::find(*side, static_cast<int>(p)) != side->end()) of_face_[f] = std::min(of_face_[f], length);
  }
}

double LocalSizes::on_edge(const Edge& edge) const {
  double least = none;
  if (is_empty()) return least;
  for (int origin : edge.origins) least = std::min(least, of_edge_[origin]);
  for (int face : edge.faces) least = std::min(least, of_face_[face]);
  for (int part : edge.inside_of) least = std::min(least, of_part_[part]);
  return least;
}

void LocalSizes::put_on_edges(const Model& model) {
  for (auto [point, length] : points_) sources_.push_back({point, point, length});
  for (const Edge& edge : model.edges) {
    const double length = on_edge(edge);
    if (!(length < none)) continue;
    if (edge.is_degenerate || !edge.curve) {
      Vec3 point = model.vertices[edge.start];
      sources_.push_back({point, point, length});
      continue;
    }
    int count = std::clamp(static_cast<int>(std::min(edge.length / (piece_share * length), 1.0 * most_pieces)),
                           fewest_pieces, most_pieces);
    add_pieces(edge, length, count, sources_);
  }
}

}  // namespace paver
