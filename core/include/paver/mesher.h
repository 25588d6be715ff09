// The whole job in a few calls: read a model, predict, mesh.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "paver/options.h"
#include "paver/progress.h"
#include "paver/ranks.h"
#include "paver/result.h"

namespace paver {

struct Shape;  // the CAD kernel's data

/// A CAD model as read. Cheap to copy; it never changes, and may be meshed any number of times, in many threads at
/// once. Faces and edges are numbered as TopExp::MapShapes finds them, which is how FreeCAD names them: 0 is Face1,
/// Edge1.
struct CadModel {
  std::shared_ptr<const Shape> shape;
  ModelReport report;       ///< what reading found: file, format, unit
  double read_seconds = 0;  ///< wall time
};

/// Reads a STEP, IGES or BREP file, or what FreeCAD's exportBinary writes; the content decides which. `name` stands for
/// the file in messages and in the report; empty: its path. Throws Error{file_missing, not_a_cad_file, damaged_file,
/// no_faces, cancelled}.
CadModel read_file(const std::string& path, Progress& progress, const std::string& name = {});

/// The same from the content of such a file. `labels`: names for its faces, in their order, then for edges that bound
/// no face and for vertices that end no edge, empty text where one has none; an empty list: those that the content
/// gives them.
CadModel read_bytes(std::span<const char> bytes, const std::string& name, Progress& progress,
                    const std::vector<std::string>& labels = {});

/// The content of a file that read_file would look at, for read_bytes in other processes. Throws
/// Error{file_missing, not_a_cad_file, damaged_file}.
std::string file_content(const std::string& path, const std::string& name = {});

/// One direct member of a compound: its faces, edges, vertices and solids as 0-based numbers in the whole model, in the
/// member's own order. Members may share some.
struct ModelPart {
  std::vector<int> faces, edges, vertices, solids;
};

/// The members of a model that is a compound, else the model itself as its only part.
std::vector<ModelPart> model_parts(const CadModel& model);

/// Meshes all faces. A face that fails is named in result.report.faces and the others are delivered; shortfall() says
/// so. Throws Error for bad options, cancel and limits.
MeshResult mesh_model(const CadModel& model, const Options& options, Progress& progress);

/// read_file and mesh_model; bad options are found before the file is read.
MeshResult mesh_file(const std::string& path, const Options& options, Progress& progress);

/// The model as mesh_model meshes it with these options, repaired, sewn and connected, as the text of a BREP file.
std::string repaired_model(const CadModel& model, const Options& options, Progress& progress);

/// Per row of a share's table its number in the whole mesh, rising. A table that is whole has no list: row i is number
/// i.
struct RowNumbers {
  std::vector<long> list;
  long whole_rows = 0;  ///< of a table that is whole: how many

  long operator[](std::size_t row) const { return list.empty() ? static_cast<long>(row) : list[row]; }
  /// The row that has a number; -1: none here.
  int row_of(long number) const;
};

/// How a share lies in the whole mesh. Where one rank has all of it every list is empty.
struct ShareNumbers {
  RowNumbers node_number, quad_number, triangle_number;
  std::vector<char> is_own_node;             ///< of all ranks that hold a node exactly one owns it; empty: this one
  std::vector<char> is_shared_node;          ///< per node: true wherever other ranks hold it, too; empty: nowhere
  long nodes = 0, quads = 0, triangles = 0;  ///< of the whole mesh

  bool is_own(std::size_t node) const { return is_own_node.empty() || is_own_node[node] != 0; }
  bool is_shared(std::size_t node) const { return !is_shared_node.empty() && is_shared_node[node] != 0; }
};

/// Of a mesh that one process has all of.
ShareNumbers whole_numbers(const SurfaceMesh& mesh);

/// What one rank holds of a mesh: the elements that it made, with all nodes they use, all lines of the whole mesh, and
/// their nodes. Each table of `result.mesh` is a subsequence of the whole mesh's: the numbers tell which.
struct MeshShare : ShareNumbers {
  MeshResult result;  ///< the report is that of the whole mesh, the same on all ranks
};

/// mesh_model on several processes, collective. The shares together are the mesh of mesh_model, bit for bit, for every
/// number of ranks.
MeshShare mesh_share(const CadModel& model, const Options& options, Progress& progress, Ranks& ranks);

/// What a run with the same arguments will come to, from areas, perimeters and curvatures alone.
struct Prediction {
  double target_length = 0;           ///< mm
  double elements = 0;                ///< all faces together; see core/docs/prediction.md for how near it comes
  double memory_mib = 0;              ///< that the run takes on top of what the process already has
  std::vector<double> face_elements;  ///< per face; 0 for faces that will not be meshed
  std::vector<Merge> merges;          ///< as the run will make them
  std::vector<Contact> contacts;
};

/// Costs a small part of meshing: topology and sizing only. Options::max_elements is no limit here.
Prediction predict(const CadModel& model, const Options& options, Progress& progress);

/// A point on a face as read.
struct FacePoint {
  int face = -1;  ///< 0-based
  Vec2 uv;        ///< on its surface
  Vec3 x;         ///< mm
};

/// Target length at each point, mm: how short elements get there, across the strongest turn of the surface. 0: on a
/// face that will not be meshed. Costs what predict() does.
std::vector<double> target_lengths(const CadModel& model, const Options& options, const std::vector<FacePoint>& points,
                                   Progress& progress);

}  // namespace paver
