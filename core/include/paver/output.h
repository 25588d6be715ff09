// Files and text made from a result: mesh files, the report as JSON, the table for a terminal.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "paver/mesher.h"
#include "paver/progress.h"
#include "paver/result.h"

namespace paver {

enum class MshVersion { v2_2, v4_1 };

/// Of "2.2" and "4.1".
std::optional<MshVersion> msh_version(std::string_view text);

/// What to write and how. The format of the mesh follows from its file name: .msh (Gmsh) or .vtu (VTK).
struct OutputFiles {
  std::string mesh;                           ///< path; empty: no mesh
  std::string report;                         ///< path of the report (JSON); empty: none
  MshVersion msh_version = MshVersion::v4_1;  ///< for .msh
  bool is_ascii = false;                      ///< text instead of binary
  std::string input{};                        ///< path of the model: never written over; empty: it came from no file
  std::string repaired{};                     ///< path of the model as meshed (.brep); empty: none
  std::string repaired_text{};                ///< what to write there: repaired_model()
  int threads = 0;                            ///< of this process; 0: all cores

  /// Of all files that there are to write.
  std::vector<std::string> paths() const;
};

/// Throws Error{bad_option} for a file name with another ending, two equal paths, the model's own path, or what several
/// `ranks` cannot write, and Error{unwritable_output} when a file could not be created in its folder. Leaves nothing
/// behind. Call it before the work, on one process.
void check_outputs(const OutputFiles& files, int ranks = 1);

/// Writes all files under temporary names in their folders, then renames them: a reader sees whole files or none, and
/// an old file stays until it is replaced. Adds "write" to the report's stage_seconds. On Error{unwritable_output} or
/// Error{cancelled} nothing is left.
void write_outputs(MeshResult& result, const OutputFiles& files, Progress& progress);

/// The same for a mesh that ranks hold together, collective: one file, written by all at once, byte for byte that of
/// the whole mesh. Several ranks write binary .msh 4.1 and .vtu only, on a file system that all of them see; rank 0
/// writes the report. An Error on one rank is thrown on all, and nothing is left.
void write_outputs(MeshShare& share, const OutputFiles& files, Progress& progress, Ranks& ranks);

/// The temporary name that write_outputs uses on rank 0 for `path` in this process or, where it is named, another; to
/// remove it when that must end.
std::string temporary_name(const std::string& path, long process = 0);

/// A result as bytes, for another process of the same build.
std::string pack_result(const MeshResult& result);
MeshResult unpack_result(std::string_view bytes);
std::string pack_share(const MeshShare& share);
MeshShare unpack_share(std::string_view bytes);

/// Puts a share where it belongs in the whole mesh; after all of them, in any order, `whole` is the result of one
/// process, bit for bit.
void add_share(const MeshShare& share, MeshResult& whole);

/// The report as JSON text. Keys: core/docs/quality.md.
std::string report_json(const MeshResult& result);

/// The same with the checksum of a mesh that `result` holds only a share of.
std::string report_json(const MeshResult& result, std::uint64_t mesh_checksum);

/// The report as lines of at most about 100 columns for a terminal; of the faces only failed ones and the worst.
std::string report_table(const RunReport& report);

/// 64 bits from the elements with their faces, orientation and the exact coordinates of their nodes, the lines with
/// their edges, and the number of nodes. Does not depend on the order of elements or nodes, nor on the corner at which
/// an element starts: equal for meshes that are the same but for that.
std::uint64_t checksum(const SurfaceMesh& mesh);

/// The same of the mesh that all ranks hold together, collective.
std::uint64_t checksum(const SurfaceMesh& mesh, const ShareNumbers& numbers, Ranks& ranks);

}  // namespace paver
