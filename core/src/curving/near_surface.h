// Where the surface is near points that are nearly on it: from what a part's mesh knows of its nodes.
#pragma once

#include <cmath>

#include "mesh/region_mesh.h"
#include "regions/region.h"

namespace paver {

/// Whether a step is not long against the way from a node to another.
inline bool is_short(Vec2 step, Vec2 way) {
  constexpr double most_step = 0.25;
  return dot(step, step) <= most_step * most_step * dot(way, way);
}

/// The cubic through two nodes of a mesh that has the surface's derivatives at both.
struct SideCubic {
  Vec3 a, b;         ///< nodes
  Vec3 first, last;  ///< derivatives there, by a parameter from 0 to 1

  SideCubic(const RegionMesh& mesh, int v, int w) : a(mesh.x[v]), b(mesh.x[w]) {
    const Vec2 way = mesh.p[w] - mesh.p[v];
    first = way.x * mesh.xp[v] + way.y * mesh.xq[v];
    last = way.x * mesh.xp[w] + way.y * mesh.xq[w];
  }
  /// Not where the derivatives differ by more than this share of the chord: across a crease, at an apex.
  bool is_smooth(double most_turn = 0.5) const {
    const Vec3 turn = last - first, chord = b - a;
    return dot(turn, turn) <= most_turn * most_turn * dot(chord, chord);
  }
};

/// Half of the chart's walk from p to q.
inline Vec2 half_way(const Region& region, Vec2 p, Vec2 q) { return region.chart->between(p, q, 0.5); }

/// About where the surface is nearest to a point that lies `off` the middle of the chord from node v to w. Just half
/// way where the cubic does not tell.
Vec2 guess_middle(const Region& region, const RegionMesh& mesh, int v, int w, Vec3 off);

/// The same for the centre of a quad: corners, and the places of the middles of its sides.
Vec2 guess_centre(const Region& region, const RegionMesh& mesh, const Corners& corners,
                  const std::array<Vec2, 4>& middles);

/// Moves p by Gauss-Newton in the chart to where the surface is nearest to `target`, up to 1e-4 of `scale`, or to the
/// nearest on the way where that does not settle. Gives the point there.
Vec3 nearest_point(const Region& region, Vec2& p, Vec3 target, double scale);

struct SideEnd {
  Vec2 p;
  Vec3 x, normal;   ///< the normal of any length; none at an apex
  double h = 0;     ///< target length
  int global = -1;  ///< its number in the boundary stage
};

/// Node v of a mesh, which is at x.
inline SideEnd side_end(const RegionMesh& mesh, int v, Vec3 x) {
  return {mesh.p[v], x, cross(mesh.xp[v], mesh.xq[v]), mesh.h[v], mesh.global[v]};
}

/// What is known of sides beside one inside, along which it is to run.
struct Beside {
  Vec3 bulge;               ///< how far its middle should leave that of its chord
  double width = INFINITY;  ///< mm, least distance to them at an end
};

/// The middle node of a curved side: the point of the surface nearest to the middle of the chord or, where its normal
/// leans to the side there against those at the ends, the one beside it that does not. Where the parabola through that
/// would leave the surface steeply at one end, up to 0.15 of the chord nearer to this end. `p`: where it may be and is
/// in the chart.
Vec3 side_middle(const Region& region, const SideEnd& a, const SideEnd& b, const Beside& beside, Vec2& p);

/// When a search for a foot point may end.
struct FootSearch {
  double known = 0;            ///< mm: any bound of the distance that is not above it will do
  double most_turn = 1e-4;     ///< of the distance, as far as the surface turns by one on the scale
  double least_step = 0;       ///< of the scale: a shorter step to the foot is not taken
  double least_halved = 1e-6;  ///< the same of a step that was halved, as the surface bends or is stretched on the way
};

struct Foot {
  double distance = INFINITY;  ///< mm
  Vec3 normal;                 ///< xp x xq at the point found
};

/// From `target`, of an element as large as `scale`, to the surface near p. Ends where the surface turns too little on
/// the rest of the way to the foot to matter: that way then counts by Pythagoras.
Foot foot_on_surface(const Region& region, Vec2 p, Vec3 target, double scale, const FootSearch& search);

/// Its distance; where that is not above `known`, any bound that is not either.
double distance_to_surface(const Region& region, Vec2 p, Vec3 target, double scale, double known);

}  // namespace paver
