// Writers of one file by several ranks, byte for byte what the writers for one process give.
#pragma once

#include <memory>

#include "output/shared_file_impl.h"
#include "paver/mesher.h"

namespace paver {

/// A file whose layout is known and of which each rank writes what it holds.
class ShareWriter {
 public:
  virtual ~ShareWriter() = default;
  virtual long file_bytes() const = 0;
  /// Not collective.
  virtual void write(SharedFile& file) const = 0;
};

/// Collective. Gmsh 4.1, binary. `share` must outlive the writer.
std::unique_ptr<ShareWriter> msh4_share_writer(const MeshShare& share, Ranks& ranks);

/// Collective. VTK unstructured grid, appended raw.
std::unique_ptr<ShareWriter> vtu_share_writer(const MeshShare& share, Ranks& ranks);

}  // namespace paver
