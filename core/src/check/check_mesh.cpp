#include "check/check_mesh.h"

namespace paver {

MeshCheck check_mesh(const CheckedMesh& checked, MeshFaults folded, int threads, const Progress& progress,
                     Ranks& ranks) {
  MeshCheck check{std::move(folded), AreaSlack(checked.model)};
  check_elements(checked, threads, progress, check.faults, check.slack);
  check_boundary_nodes(checked, ranks, check.faults, check.slack);
  check_sides(checked, threads, progress, ranks, check.faults);
  check.faults.unite(ranks);
  check.slack.unite(ranks);
  return check;
}

void check_areas(const Model& model, const std::vector<FaceReport>& faces, MeshCheck& check) {
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const int face = static_cast<int>(f);
    if (faces[f].status != FaceStatus::meshed || check.slack.allows(model.faces[f], face, faces[f].mesh_area)) continue;
    Vec3 where;
    for (const Coedge& coedge : coedges_of(model.faces[f].loops))
      where = model.vertices[model.edges[coedge.edge].start];
    check.faults.add(face, FaultKind::area, where);
  }
}

}  // namespace paver
