// The fields of results, in one place for all that packs them (base/packing.h).
#pragma once

#include "base/packing.h"
#include "paver/mesher.h"

namespace paver {

PAVER_FIELDS(Contact, parts, kind, faces, size, gap)
PAVER_FIELDS(Gap, parts, distance, where)
PAVER_FIELDS(Crossing, faces, where)
PAVER_FIELDS(Repair, kind, count, distance, faces)
PAVER_FIELDS(ModelReport, file, format, unit, solids, shells, faces, edges, vertices, free_edges, nonmanifold_edges,
             sewn_edges, sew_tolerance, diagonal, area, free_edge_names, nonmanifold_edge_names, contacts, unconnected,
             merged_parts, merged_gap, one_sided, curve_distance, stray_edges, unread, open_solids, holes, repairs)
PAVER_FIELDS(FaceReport, name, front, back, wavelength, front_medium, back_medium, status, stage, reason, where, quads,
             triangles, worst_sj, longest_side, cad_area, mesh_area, distance, closed_by_triangulation)
PAVER_FIELDS(ElementRepair, kind, entity, where)
PAVER_FIELDS(Merge, kind, name, into, size, where)
PAVER_FIELDS(Medium, name, parts, eps_r, mu_r, loss_tangent, is_conductor)
PAVER_FIELDS(Port, name, parts)
PAVER_FIELDS(Wire, name, parts, radius)
PAVER_FIELDS(Volume, name, medium, sides)
PAVER_FIELDS(RunReport, model, components, gaps, crossings, target_length, off_edge, order, threads, elements, quality,
             faces, media, ports, wires, wavelength, least_segment, lost_parts, merges, element_repairs, notes,
             stage_seconds, stage_runs, tasks, peak_memory_mib)
PAVER_FIELDS(SurfaceMesh, order, nodes, quads, quad_face, triangles, triangle_face, lines, line_edge, node_edge,
             further_edges, node_target, points)
PAVER_FIELDS(MeshResult, mesh, report, face_names, face_groups, edge_names, edge_groups, point_names, volumes)
PAVER_FIELDS(RowNumbers, list, whole_rows)
PAVER_FIELDS(ShareNumbers, node_number, quad_number, triangle_number, is_own_node, is_shared_node, nodes, quads,
             triangles)

}  // namespace paver
