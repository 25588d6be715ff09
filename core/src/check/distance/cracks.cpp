// In: model, target length. Out: cracks. Steps: edges with boxes; pairs of one part, one of them free, whose boxes
// meet, by a sweep along x; places of the free one from which the other is near, in a row.
#include "check/distance/cracks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/box.h"

namespace paver {
namespace {

constexpr double near_share = 1e-3;      // of the target length and of the edge
constexpr int chords = 32, places = 16;  // of an edge
constexpr int places_in_a_row = 4;
constexpr int search_steps = 40;
constexpr long most_pairs = 1000000;  // of loose edges in a heap nobody wants to know all

struct Side {
  const Edge* edge = nullptr;
  int part = -1;
  bool is_free = false;
  double reach = 0;  ///< nearer than this is near
  std::array<Vec3, chords + 1> points;
  Box box;

  Vec3 at(double share) const { return edge->curve->point(edge->parameter(share)); }
};

/// Edges of faces that one part has alone; none where all have a face on both sides.
std::vector<Side> sides(const Model& model, double h) {
  std::vector<Side> list;
  if (std::ranges::none_of(model.edges, [](const Edge& edge) { return edge.faces.size() == 1; })) return list;
  for (const Edge& edge : model.edges) {
    if (edge.faces.empty() || edge.is_degenerate || !edge.curve || !(edge.length > 0)) continue;
    const int face = edge.faces[0];
    if (!model.faces[face].is_meshed() || model.face_parts[face].size() != 1) continue;
    Side& one = list.emplace_back();
    one.edge = &edge, one.part = model.face_parts[face][0];
    one.is_free = edge.faces.size() == 1;
    one.reach = near_share * std::min(h, edge.length);
    double bulge = one.reach;
    for (int i = 0; i <= chords; ++i) {
      one.points[i] = one.at(static_cast<double>(i) / chords);
      one.box.add(one.points[i]);
      if (i > 0) bulge = std::max(bulge, norm(one.at((i - 0.5) / chords) - 0.5 * (one.points[i - 1] + one.points[i])));
    }
    one.box = one.box.grown(2 * bulge);
  }
  std::ranges::stable_sort(list, {}, [](const Side& one) { return one.box.low.x; });
  return list;
}

/// From the curve: on both sides of the nearest of its points the distance is taken to fall to one place and rise.
double distance_from(const Side& edge, Vec3 x) {
  const auto nearest = std::ranges::min_element(edge.points, {}, [&](Vec3 p) { return norm(p - x); });
  const auto k = static_cast<double>(nearest - edge.points.begin());
  double low = std::max(k - 1, 0.0) / chords, high = std::min(k + 1, 1.0 * chords) / chords;
  for (int i = 0; i < search_steps; ++i) {
    const double third = (high - low) / 3;
    if (norm(edge.at(low + third) - x) < norm(edge.at(high - third) - x))
      high -= third;
    else
      low += third;
  }
  return norm(edge.at(0.5 * (low + high)) - x);
}

/// Where `one` runs along `other`: the place in such a row that is farthest from it, which tells how wide the crack is.
void look_along(const Side& one, const Side& other, std::map<int, Gap>& cracks) {
  if (!one.is_free) return;
  const double reach = std::min(one.reach, other.reach);
  int row = 0;
  Gap widest;
  for (int i = 0; i < places; ++i) {
    const Vec3 x = one.at((i + 0.5) / places);
    const double d = other.box.meets({x, x}) ? distance_from(other, x) : INFINITY;
    if (d > reach) {
      row = 0, widest = {};
      continue;
    }
    if (++row == 1 || d > widest.distance) widest.distance = d, widest.where = x;
    if (row < places_in_a_row) continue;
    const auto [known, is_new] = cracks.try_emplace(one.part, widest);
    if (!is_new && widest.distance > known->second.distance) known->second = widest;
  }
}

bool have_common_face(const Edge& one, const Edge& other) {
  return std::ranges::find_first_of(one.faces, other.faces) != one.faces.end();
}

}  // namespace

std::vector<Gap> find_cracks(const Model& model, double h) {
  const std::vector<Side> edges = sides(model, h);
  std::map<int, Gap> cracks;
  long pairs = 0;
  std::vector<int> all, free;  // in the order of `edges`
  for (int i = 0; i < static_cast<int>(edges.size()); ++i) {
    all.push_back(i);
    if (edges[i].is_free) free.push_back(i);
  }
  for (const int i : all) {
    const std::vector<int>& others = edges[i].is_free ? all : free;
    for (auto j = std::ranges::upper_bound(others, i); j != others.end(); ++j) {
      const Side &one = edges[i], &other = edges[*j];
      if (other.box.low.x > one.box.high.x || ++pairs > most_pairs) break;
      // Both sides of a strip or slot are of one face.
      if (one.part != other.part || have_common_face(*one.edge, *other.edge) || !one.box.meets(other.box)) continue;
      look_along(one, other, cracks);
      look_along(other, one, cracks);
    }
  }
  std::vector<Gap> result;
  for (auto& [part, crack] : cracks) {
    crack.parts = {model.parts[part], model.parts[part]};
    result.push_back(crack);
  }
  return result;
}

}  // namespace paver
