#include "check/area_slack.h"

#include <algorithm>
#include <cmath>

#include "quality/reduction.h"

namespace paver {
namespace {

constexpr double cad_share =
    0.05;  // of a face's area: how well the CAD kernel knows it, which integrates across creases
constexpr double most_turned = 0.5;   // cosine: more turn costs no more area
constexpr double chords_share = 1.5;  // of 1 / cosine - 1, what chords cost of an area; 1.25 of a sphere's
constexpr double curved_share = 0.1;  // of its square, at order 2, where a sphere of 120 degrees across lacks 0.03

}  // namespace

double element_slack(double area, double least_along, bool is_curved) {
  const double turn = 1 / std::max(least_along, most_turned) - 1;
  return area * (is_curved ? curved_share * turn * turn : chords_share * turn);
}

bool can_be_area(double mesh_area, const Face& face, double own_area, double slack) {
  return std::fabs(mesh_area - own_area) <= cad_share * own_area + face.merged_area + face.gap_area + slack;
}

AreaSlack::AreaSlack(const Model& model) {
  for (const Face& face : model.faces) units_.emplace_back(face.area > 0 && std::isfinite(face.area) ? face.area : 1);
  faces_ = units_;
}

void AreaSlack::unite(Ranks& ranks) {
  Reduction all;
  for (ExactSum& sum : faces_) all.sum(sum);
  all.run(ranks);
}

}  // namespace paver
