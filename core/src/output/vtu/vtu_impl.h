// What a .vtu file consists of.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/element_table.h"
#include "output/byte_sink_impl.h"

namespace paver {

/// The arrays of the file, in its order. Cells are quads, then triangles, then lines of wires.
enum class VtuArray { face, sj, points, connectivity, offsets, types };
inline constexpr std::array vtu_arrays{VtuArray::face,         VtuArray::sj,      VtuArray::points,
                                       VtuArray::connectivity, VtuArray::offsets, VtuArray::types};

/// What the entries of an array are.
struct VtuEntry {
  std::string_view type, name;
  int bytes, components;  ///< of one component; of an entry
};

/// Sizes of the whole file.
struct VtuSize {
  int order = 1;
  long points = 0, quads = 0, triangles = 0, lines = 0;

  long cells() const { return quads + triangles + lines; }
  bool has_wide_points() const;  ///< point numbers take 64 bits
  /// The number of a point, from 1, as the connectivity has it: from 0.
  void write_point(long number, ByteSink& sink) const;
  VtuEntry entry(VtuArray array) const;
  long entry_bytes(VtuArray array) const { return long{entry(array).bytes} * entry(array).components; }
  long entries(VtuArray array) const;
  /// Entries of a cell array before those of an element, `number` being its place among the elements of its kind.
  long entries_before(VtuArray array, bool is_quad, long number) const;
  /// The same of a line.
  long entries_before_line(VtuArray array, long number) const;
  long bytes(VtuArray array) const { return entries(array) * entry_bytes(array); }
};

/// The XML element of an array up to its name and components, without the end of the tag.
std::string vtu_declaration(VtuArray array, const VtuSize& size);

/// The file from its first byte to the last before the appended data; `declare` writes the element of an array.
void write_vtu_xml(const VtuSize& size, ByteSink& sink, const std::function<void(VtuArray)>& declare);

/// The same for raw appended data, which begins right behind it: per array its size as 64 bits, then its bytes.
std::string vtu_beginning(const VtuSize& size);
inline constexpr const char* vtu_ending = "\n</AppendedData>\n</VTKFile>\n";

/// Quads or triangles of a mesh as cells.
class VtuCells {
 public:
  /// `point`: per node its number among the points, from 1.
  VtuCells(const SurfaceMesh& mesh, bool is_quad, const VtuSize& size, const std::vector<long>& point);

  std::size_t count() const { return table_.count(); }
  /// Cell data, connectivity, offsets or types of elements begin to end - 1 of the mesh. `number`: that of the first
  /// one among all elements of its kind.
  void write(VtuArray array, std::size_t begin, std::size_t end, long number, ByteSink& sink) const;

 private:
  double sj(std::size_t element) const;

  const SurfaceMesh& mesh_;
  const bool is_quad_;
  const VtuSize size_;
  const std::vector<long>& point_;
  const ElementTable table_;
  std::vector<int> positions_;  // per VTK position: the position in Gmsh's order
};

/// Lines of wires as cells.
class VtuLines {
 public:
  /// Which of the mesh's lines those are.
  explicit VtuLines(const MeshResult& result);

  long count() const { return static_cast<long>(lines_.size()); }
  /// Marks the nodes in a list, one entry per node.
  template <class T>
  void mark_nodes(std::vector<T>& nodes) const {
    for (std::size_t line : lines_)
      for (int node : mesh_.line(line)) nodes[node] = 1;
  }
  /// Cell data, connectivity, offsets or types of all.
  void write(VtuArray array, const VtuSize& size, const std::vector<long>& point, ByteSink& sink) const;

 private:
  const SurfaceMesh& mesh_;
  std::vector<std::size_t> lines_;
};

}  // namespace paver
