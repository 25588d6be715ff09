// A model that went through all stages up to its mesh, which tests then break.
#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "check/check_mesh.h"
#include "curving/place_nodes.h"
#include "support/boundary_use.h"
#include "support/fake_model.h"
#include "support/measure_quality.h"
#include "support/paved_model.h"
#include "support/thread_ranks.h"

namespace paver::fake {

/// Two rectangles that meet at a right angle along edge 1, 4 by 3 and 3 by 2; the second is reversed.
inline Model angle() {
  Builder builder;
  for (Vec3 corner : {Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{4, 3, 0}, Vec3{0, 3, 0}, Vec3{4, 3, 2}, Vec3{4, 0, 2}})
    builder.vertex(corner);
  for (int i = 0; i < 4; ++i) builder.line(i, (i + 1) % 4);
  const int up = builder.line(2, 4), back = builder.line(4, 5), down = builder.line(5, 1);
  builder.face(std::make_shared<Plane>(Vec3{}, Vec3{1, 0, 0}, Vec3{0, 1, 0}), 12,
               {{builder.use(0, false, {0, 0}, {4, 0}), builder.use(1, false, {4, 0}, {4, 3}),
                 builder.use(2, false, {4, 3}, {0, 3}), builder.use(3, false, {0, 3}, {0, 0})}});
  builder.face(std::make_shared<Plane>(Vec3{4, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}), 6,
               {{builder.use(1, false, {0, 0}, {3, 0}), builder.use(up, false, {3, 0}, {3, 2}),
                 builder.use(back, false, {3, 2}, {0, 2}), builder.use(down, false, {0, 2}, {0, 0})}});
  Model model = builder.take();
  model.faces[1].is_reversed = true;
  return model;
}

/// Each region is one part; of several ranks each has every so many of them. `mesh` may be changed at will as long as
/// the tables keep their lengths.
class CheckedModel : public test::PavedModel {
 public:
  CheckedModel(Model m, double h, int order, int rank = 0, int ranks = 1) : PavedModel(std::move(m), options_of(h)) {
    is_meshed.assign(model.faces.size(), 1);
    join(rank, ranks);
    mesh = joined.mesh;
    if (order == 2)
      mesh = curve_elements(joined.mesh, {joined.sizes, edges, model, Cuts(regions, {}), parts, 1}, Progress()).mesh;
    figures.resize(model.faces.size());
  }

  /// With the areas that the mesh has now.
  MeshFaults check(Ranks& ranks) {
    const CheckedMesh checked{model,   edges, mesh,       parts,     joined.sizes,
                              numbers, moved, boundary(), is_meshed, target_length};
    MeshCheck check = check_mesh(checked, {}, 1, Progress(), ranks);
    if (ranks.count() == 1) {
      measure_quality(mesh, 1, std::vector<bool>(model.edges.size()), figures, Progress());
      check_areas(model, figures, check);
    }
    return check.faults;
  }
  MeshFaults check() {
    SingleRank alone;
    return check(alone);
  }

  /// A quad of the face without nodes on its boundary; throws where there is none here.
  int* inner_quad(int face) {
    for (std::size_t q = 0; q < mesh.quad_count(); ++q) {
      int* v = &mesh.quads[q * static_cast<std::size_t>(mesh.nodes_per_quad())];
      if (mesh.quad_face[q] == face && *std::min_element(v, v + 4) >= boundary()) return v;
    }
    throw std::runtime_error("no such quad");
  }
  int boundary() const { return static_cast<int>(edges.nodes.size()); }
  bool has(int face) const { return std::count(mesh.quad_face.begin(), mesh.quad_face.end(), face) > 0; }

  JoinedMesh joined;
  std::vector<MeshPart> parts;
  std::vector<int> moved;
  std::vector<char> is_meshed;
  RowNumbers numbers;  // of nodes in the whole mesh of order 1; on one rank none
  std::vector<FaceReport> figures;
  SurfaceMesh mesh;
  double target_length = INFINITY;

 private:
  static Options options_of(double h) {
    Options options;
    options.size = h;
    return options;
  }

  void join(int rank, int ranks) {
    for (std::size_t i = 0; i < regions.size(); ++i)
      parts.push_back({&regions[i], static_cast<int>(i) % ranks == rank ? &paved[i] : nullptr});
    joined = join_regions(model, edges, test::all_of(edges), parts);
    for (int v = 0; ranks > 1 && v < boundary(); ++v) numbers.list.push_back(v);
    for (std::size_t i = 0; i < regions.size(); ++i) {
      parts[i].node_of = &joined.node_of[i];
      for (long v = 0; ranks > 1 && v < joined.sizes[i].nodes; ++v)
        numbers.list.push_back(boundary() + 1000 * static_cast<long>(i) + v);
    }
  }
};

}  // namespace paver::fake
