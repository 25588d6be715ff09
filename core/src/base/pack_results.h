// The fields of results, in one place for all that packs them (base/packing.h).
#pragma once

#include "base/packing.h"
#include "paver/mesher.h"

namespace paver {

template <class A>
void fields(A& archive, Is<Contact> auto& contact) {
  auto& [parts, kind, faces, size, gap] = contact;
  archive(parts, kind, faces, size, gap);
}

template <class A>
void fields(A& archive, Is<Gap> auto& gap) {
  auto& [parts, distance, where] = gap;
  archive(parts, distance, where);
}

template <class A>
void fields(A& archive, Is<Repair> auto& repair) {
  auto& [kind, count, distance, faces] = repair;
  archive(kind, count, distance, faces);
}

template <class A>
void fields(A& archive, Is<ModelReport> auto& model) {
  auto& [file, format, unit, solids, shells, faces, edges, vertices, free_edges, nonmanifold_edges, sewn_edges,
         sew_tolerance, diagonal, area, free_edge_names, nonmanifold_edge_names, contacts, unconnected, one_sided,
         curve_distance, stray_edges, repairs] = model;
  archive(file, format, unit, solids, shells, faces, edges, vertices, free_edges, nonmanifold_edges, sewn_edges,
          sew_tolerance, diagonal, area, free_edge_names, nonmanifold_edge_names, contacts, unconnected, one_sided,
          curve_distance, stray_edges, repairs);
}

template <class A>
void fields(A& archive, Is<FaceReport> auto& face) {
  auto& [name, front, back, wavelength, front_medium, back_medium, status, stage, reason, where, quads, triangles,
         worst_sj, longest_side, cad_area, mesh_area, distance, closed_by_triangulation] = face;
  archive(name, front, back, wavelength, front_medium, back_medium, status, stage, reason, where, quads, triangles,
          worst_sj, longest_side, cad_area, mesh_area, distance, closed_by_triangulation);
}

template <class A>
void fields(A& archive, Is<ElementRepair> auto& repair) {
  auto& [kind, entity, where] = repair;
  archive(kind, entity, where);
}

template <class A>
void fields(A& archive, Is<Merge> auto& merge) {
  auto& [kind, name, into, size, where] = merge;
  archive(kind, name, into, size, where);
}

template <class A>
void fields(A& archive, Is<Medium> auto& medium) {
  auto& [name, parts, eps_r, mu_r, loss_tangent, is_conductor] = medium;
  archive(name, parts, eps_r, mu_r, loss_tangent, is_conductor);
}

template <class A>
void fields(A& archive, Is<Port> auto& port) {
  auto& [name, parts] = port;
  archive(name, parts);
}

template <class A>
void fields(A& archive, Is<Wire> auto& wire) {
  auto& [name, parts, radius] = wire;
  archive(name, parts, radius);
}

template <class A>
void fields(A& archive, Is<Volume> auto& volume) {
  auto& [name, medium, sides] = volume;
  archive(name, medium, sides);
}

template <class A>
void fields(A& archive, Is<RunReport> auto& run) {
  auto& [model, components, gaps, target_length, order, threads, elements, quality, faces, media, ports, wires,
         wavelength, least_segment, lost_parts, merges, element_repairs, notes, stage_seconds, stage_runs, tasks,
         peak_memory_mib] = run;
  archive(model, components, gaps, target_length, order, threads, elements, quality, faces, media, ports, wires,
          wavelength, least_segment, lost_parts, merges, element_repairs, notes, stage_seconds, stage_runs, tasks,
          peak_memory_mib);
}

template <class A>
void fields(A& archive, Is<SurfaceMesh> auto& mesh) {
  auto& [order, nodes, quads, quad_face, triangles, triangle_face, lines, line_edge, node_edge, further_edges,
         node_target, points] = mesh;
  archive(order, nodes, quads, quad_face, triangles, triangle_face, lines, line_edge, node_edge, further_edges,
          node_target, points);
}

template <class A>
void fields(A& archive, Is<MeshResult> auto& result) {
  auto& [mesh, report, face_names, face_groups, edge_names, edge_groups, point_names, volumes] = result;
  archive(mesh, report, face_names, face_groups, edge_names, edge_groups, point_names, volumes);
}

template <class A>
void fields(A& archive, Is<RowNumbers> auto& numbers) {
  auto& [list, whole_rows] = numbers;
  archive(list, whole_rows);
}

template <class A>
void fields(A& archive, Is<ShareNumbers> auto& share) {
  auto& [node_number, quad_number, triangle_number, is_own_node, is_shared_node, nodes, quads, triangles] = share;
  archive(node_number, quad_number, triangle_number, is_own_node, is_shared_node, nodes, quads, triangles);
}

}  // namespace paver
