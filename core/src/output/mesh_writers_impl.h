// One writer per mesh format, all into an AtomicFile.
#pragma once

#include "output/atomic_file_impl.h"
#include "paver/result.h"

namespace paver {

/// Gmsh 4.1: a curve entity per B-rep edge, a surface entity per B-rep face, a physical group per face name and
/// per group of edges.
void write_msh4(const MeshResult& result, bool is_ascii, AtomicFile& file);

/// Gmsh 2.2: the same numbers as element tags (physical group, entity); lines in no physical group have 0.
void write_msh2(const MeshResult& result, bool is_ascii, AtomicFile& file);

/// VTK unstructured grid: surface elements, Lagrange cells from order 2 on; cell data "face" (Face12: 12) and "sj".
void write_vtu(const MeshResult& result, bool is_ascii, AtomicFile& file);

/// What both Gmsh formats start with: the format and its version, and the names of the groups where there are any.
struct Groups;
void write_msh_beginning(const char* version, const Groups& groups, bool is_ascii, ByteSink& sink);

}  // namespace paver
