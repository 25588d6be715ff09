// A face as read may be several of the model: divided at creases, or connected with others. Where its surface is still
// the one of before, its (u, v) tell how far it turns there; else only lengths of parts count.
#include "sizing/point_lengths.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "topology/named_parts.h"

namespace paver {
namespace {

constexpr double same_place = 1e-3;      // of the target length: how near a point must be to be that of its (u, v)
constexpr double probe = 1e-3;           // of the target length: step over which turns are measured
constexpr double sharpest = M_PI / 0.4;  // by the target length: turns within less than 0.4 of it are spread over that

/// Largest curvature of the surface, 1 / mm; `step`: mm.
double largest_curvature(const Surface& surface, Vec2 uv, Vec3 xu, Vec3 xv, double step) {
  auto slope = [&](Vec2 d) { return 0.5 * (surface.normal(uv + d) - surface.normal(uv - d)); };
  const double du = step / std::max(norm(xu), 1e-300), dv = step / std::max(norm(xv), 1e-300);
  const Vec3 nu = (1 / du) * slope({du, 0}), nv = (1 / dv) * slope({0, dv});
  const double e = dot(xu, xu), f = dot(xu, xv), g = dot(xv, xv), a = dot(nu, nu), b = dot(nu, nv), c = dot(nv, nv);
  const double det = e * g - f * f;
  if (!(det > 0)) return 0;
  const double half_trace = (a * g - 2 * b * f + c * e) / (2 * det), product = (a * c - b * b) / det;
  return std::sqrt(std::max(0.0, half_trace + std::sqrt(std::max(0.0, half_trace * half_trace - product))));
}

double length_on(const Face& face, const FaceSize& size, const FacePoint& point) {
  const Vec2 uv = face.converted ? face.converted(point.uv) : point.uv;
  const auto [x, xu, xv] = face.surface->slope(uv);
  if (!(norm(x - point.x) < same_place * size.own())) return size.given_at(point.x);
  const double h = size.at(uv, *face.surface);
  if (!size.normals() || !(size.turn_weight() > 0)) return h;
  const double curvature = largest_curvature(*face.surface, uv, xu, xv, probe * h);
  const double turn = size.turn_weight() * std::min(curvature * h, sharpest);
  return h / std::sqrt(1 + turn * turn);
}

}  // namespace

std::vector<double> point_lengths(const Model& model, const SizeField& size, const std::vector<FacePoint>& points) {
  std::vector<std::vector<std::size_t>> pieces(static_cast<std::size_t>(model.read_faces));
  std::map<const Surface*, std::size_t> meshed;  // the last one: of those that are merged it has the surface
  for (std::size_t f = 0; f < model.faces.size(); ++f)
    if (model.faces[f].is_meshed()) meshed[model.faces[f].surface.get()] = f;
  for (std::size_t f = 0; f < model.faces.size(); ++f) {
    const Face& face = model.faces[f];
    const auto of_surface = meshed.find(face.surface.get());
    if (!face.is_meshed() && !(face.is_merged && of_surface != meshed.end())) continue;
    for (int of : model.faces_as_read(face.origin)) pieces[of].push_back(face.is_meshed() ? f : of_surface->second);
  }
  std::vector<double> lengths;
  for (const FacePoint& point : points) {
    double least = std::numeric_limits<double>::infinity();
    if (point.face >= 0 && point.face < model.read_faces)
      for (std::size_t f : pieces[point.face]) least = std::min(least, length_on(model.faces[f], size.faces[f], point));
    lengths.push_back(std::isfinite(least) ? least : 0);
  }
  return lengths;
}

}  // namespace paver
