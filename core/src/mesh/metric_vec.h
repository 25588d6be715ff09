// Vectors of the metric: a step in space, and the turn of the surface's normal along it as a length.
#pragma once

#include "paver/vec.h"

namespace paver {

/// The surface is paved as if it lay at (x, s n), n its normal and s what a radian counts, mm [Levy12]: where it turns
/// the normal's way adds to lengths, and elements come out narrow across a ridge and long along it.
struct MetricVec {
  Vec3 x;  ///< in space, mm
  Vec3 n;  ///< of the normal, mm
};

inline MetricVec operator+(const MetricVec& a, const MetricVec& b) { return {a.x + b.x, a.n + b.n}; }
inline MetricVec operator-(const MetricVec& a, const MetricVec& b) { return {a.x - b.x, a.n - b.n}; }
inline MetricVec operator*(double s, const MetricVec& a) { return {s * a.x, s * a.n}; }
inline MetricVec& operator+=(MetricVec& a, const MetricVec& b) { return a = a + b; }
inline double dot(const MetricVec& a, const MetricVec& b) { return dot(a.x, b.x) + dot(a.n, b.n); }
inline double norm(const MetricVec& a) { return std::sqrt(dot(a, a)); }
inline MetricVec unit(const MetricVec& a) {
  const double length = norm(a);
  return length > 0 ? (1 / length) * a : a;
}

/// Orthonormal vectors in the plane of two others, counter-clockwise from the first to the second.
struct MetricFrame {
  MetricVec first, second;

  MetricFrame(const MetricVec& a, const MetricVec& b) : first(unit(a)), second(unit(b - dot(b, first) * first)) {}
  Vec2 of(const MetricVec& v) const { return {dot(v, first), dot(v, second)}; }
  MetricVec at(Vec2 p) const { return p.x * first + p.y * second; }
};

}  // namespace paver
