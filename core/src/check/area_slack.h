// How far the area of a mesh may be from that of its face.
#pragma once

#include <vector>

#include "paver/ranks.h"
#include "quality/exact_sum.h"
#include "topology/model.h"

namespace paver {

/// What the area of one element may lack: its own area, mm^2; the cosine of the largest angle from its normal to the
/// surface's at a corner; whether its sides are curved as the surface is.
double element_slack(double area, double least_along, bool is_curved);

/// Whether a mesh of this area, whose elements may lack `slack` of it, can be one of the face, or of
/// the part of it that has the area `own_area`.
bool can_be_area(double mesh_area, const Face& face, double own_area, double slack);

/// Per face of the model; sums that do not depend on the order of their terms. mm^2.
class AreaSlack {
 public:
  explicit AreaSlack(const Model& model);

  void add(int face, double area) { faces_[face].add(area); }
  void add(int face, const ExactSum& sum) { faces_[face].add(sum); }
  /// A sum of a face's to add to and then to add here.
  ExactSum none(int face) const { return units_[face]; }
  /// Collective: the sums of all ranks.
  void unite(Ranks& ranks);

  /// Whether a mesh of this area can be one of the face.
  bool allows(const Face& face, int index, double mesh_area) const {
    return can_be_area(mesh_area, face, face.area, faces_[index].total());
  }

 private:
  std::vector<ExactSum> faces_, units_;
};

}  // namespace paver
