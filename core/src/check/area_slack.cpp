#include "check/area_slack.h"

#include <cmath>

namespace paver {
namespace {

constexpr double cad_share =
    0.05;  // of a face's area: how well the CAD kernel knows it, which integrates across creases

}  // namespace

AreaSlack::AreaSlack(const Model& model) {
  for (const Face& face : model.faces) units_.emplace_back(face.area > 0 && std::isfinite(face.area) ? face.area : 1);
  faces_ = units_;
}

void AreaSlack::unite(Ranks& ranks) {
  std::vector<long> parts;
  for (const ExactSum& sum : faces_)
    for (long part : sum.parts()) parts.push_back(part);
  ranks.add_up(parts);
  const long* at = parts.data();
  for (ExactSum& sum : faces_) sum.set_parts(at), at += ExactSum::part_count;
}

bool AreaSlack::allows(const Face& face, int index, double mesh_area) const {
  const double slack = cad_share * face.area + face.merged_area + faces_[static_cast<std::size_t>(index)].total();
  return std::fabs(mesh_area - face.area) <= slack;
}

}  // namespace paver
