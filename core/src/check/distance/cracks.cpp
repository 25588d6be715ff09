// In: model, target length. Out: cracks. Steps: free edges with boxes; pairs of one part whose boxes meet, by a sweep
// along x; places of the one from which the other is near, in a row.
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

struct FreeEdge {
  const Edge* edge = nullptr;
  int part = -1;
  double reach = 0;  ///< nearer than this is near
  std::array<Vec3, chords + 1> points;
  Box box;

  Vec3 at(double share) const { return edge->curve->point(edge->parameter(share)); }
};

std::vector<FreeEdge> free_edges(const Model& model, double h) {
  std::vector<FreeEdge> list;
  for (const Edge& edge : model.edges) {
    if (edge.faces.size() != 1 || edge.is_degenerate || !edge.curve || !(edge.length > 0)) continue;
    const int face = edge.faces[0];
    if (!model.faces[face].is_meshed() || model.face_parts[face].size() != 1) continue;
    FreeEdge& one = list.emplace_back();
    one.edge = &edge, one.part = model.face_parts[face][0];
    one.reach = near_share * std::min(h, edge.length);
    double bulge = one.reach;
    for (int i = 0; i <= chords; ++i) {
      one.points[i] = one.at(static_cast<double>(i) / chords);
      one.box.add(one.points[i]);
      if (i > 0) bulge = std::max(bulge, norm(one.at((i - 0.5) / chords) - 0.5 * (one.points[i - 1] + one.points[i])));
    }
    const Vec3 more{2 * bulge, 2 * bulge, 2 * bulge};
    one.box = {one.box.low - more, one.box.high + more};
  }
  std::ranges::stable_sort(list, {}, [](const FreeEdge& one) { return one.box.low.x; });
  return list;
}

/// From the curve: on both sides of the nearest of its points the distance is taken to fall to one place and rise.
double distance_from(const FreeEdge& edge, Vec3 x) {
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
void look_along(const FreeEdge& one, const FreeEdge& other, std::map<int, Gap>& cracks) {
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

}  // namespace

std::vector<Gap> find_cracks(const Model& model, double h) {
  const std::vector<FreeEdge> edges = free_edges(model, h);
  std::map<int, Gap> cracks;
  long pairs = 0;
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = i + 1; j < edges.size() && edges[j].box.low.x <= edges[i].box.high.x; ++j) {
      if (++pairs > most_pairs) break;
      // Both sides of a strip or slot are of one face.
      if (edges[i].part != edges[j].part || edges[i].edge->faces == edges[j].edge->faces) continue;
      if (!edges[i].box.meets(edges[j].box)) continue;
      look_along(edges[i], edges[j], cracks);
      look_along(edges[j], edges[i], cracks);
    }
  std::vector<Gap> result;
  for (auto& [part, crack] : cracks) {
    crack.parts = {model.parts[part], model.parts[part]};
    result.push_back(crack);
  }
  return result;
}

}  // namespace paver
