// One writer per mesh format, for one process and for several ranks that write one file together.
#pragma once

#include <memory>

#include "output/atomic_file_impl.h"
#include "paver/mesher.h"

namespace paver {

/// What this rank holds of the mesh to write. References are kept.
struct HeldMesh {
  const MeshResult& result;
  const ShareNumbers& numbers;
};

/// Of a file whose layout is known; each rank writes what it holds. Text has places for nothing: it is written from the
/// first byte to the last, by a rank that has all of the mesh. In binary such a rank does so, too.
class MeshWriter {
 public:
  virtual ~MeshWriter() = default;
  /// Of the whole file; 0: known only once it is written.
  virtual long file_bytes() const { return 0; }
  /// Not collective.
  virtual void write(AtomicFile& file) const = 0;
};

/// Collective. Gmsh 4.1: a curve entity per B-rep edge, a surface entity per B-rep face, a physical group per face name
/// and per group of edges.
std::unique_ptr<MeshWriter> msh4_writer(HeldMesh held, bool is_ascii, Ranks& ranks);

/// Gmsh 2.2, by one rank: the same numbers as element tags (physical group, entity); lines in no physical group have 0.
std::unique_ptr<MeshWriter> msh2_writer(HeldMesh held, bool is_ascii, Ranks& ranks);

/// Collective. VTK unstructured grid: surface elements, Lagrange cells from order 2 on; cell data "face" (Face12: 12)
/// and "sj".
std::unique_ptr<MeshWriter> vtu_writer(HeldMesh held, bool is_ascii, Ranks& ranks);

}  // namespace paver
