// Normals of a surface over the box of a face, as lengths count their turn.
#pragma once

#include <vector>

#include "brep/surfaces/surface.h"
#include "sizing/sample_box.h"

namespace paver {

/// Normals on lines of constant u about `spacing.x` mm apart, and of constant v `spacing.y`, bilinear between. Where
/// the surface turns within one spacing its turn is spread over it: lengths across a ridge are stretched no further,
/// however sharp it is, and ripples of a spline that are finer than that count for nothing.
class NormalTable {
 public:
  /// `spacing` and the reach of derivatives are in mm. `is_least`: no turn is spread over less than the spacing, so
  /// that opposite normals are 2 / spacing apart per mm at most.
  NormalTable(const Surface& surface, const SampleBox& box, Vec2 spacing, double reach, bool is_least = false);

  /// Of length one where the surface turns little; beyond the box that of its border, or of the image a period away.
  Vec3 at(Vec2 uv) const;
  /// Its derivatives by u and v, over the reach to either side. `speed`: lengths of the surface's derivatives there.
  void slopes(Vec2 uv, Vec2 speed, Vec3& by_u, Vec3& by_v) const;
  /// Area of the box with lengths stretched by turns, over its plain area; `weight` is what a radian counts, mm.
  double stretched_area(double weight) const;

 private:
  struct Lines {
    std::vector<double> at;
    double period = 0;

    /// Cell and share within it.
    std::size_t cell(double value, double& share) const;
    double inside(double value) const;
  };
  void flatten(std::size_t first, std::size_t step, std::size_t count, double share);
  const Vec3& normal(std::size_t i, std::size_t j) const { return normals_[j * u_.at.size() + i]; }

  Lines u_, v_;
  double reach_;
  std::vector<Vec3> normals_;
  std::vector<Vec3> points_;
};

}  // namespace paver
