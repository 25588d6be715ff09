// VTK unstructured grid (.vtu), arrays appended raw or as text. Surface elements only, lines are left out.
//
// VTK orders the nodes of a Lagrange quad differently from Gmsh beyond order 2: its third and fourth side run from low
// to high, the inside runs row by row. Triangles agree.
#include <fmt/format.h>

#include <cstdint>
#include <iterator>
#include <map>

#include "output/mesh_writers_impl.h"
#include "quality/lattice.h"
#include "quality/metrics.h"

namespace paver {
namespace {

constexpr std::uint8_t vtk_triangle = 5, vtk_quad = 9, vtk_lagrange_triangle = 69, vtk_lagrange_quad = 70;

/// What the file holds, in the order quads, triangles.
struct Grid {
  std::vector<Vec3> points;
  std::vector<std::int32_t> connectivity;
  std::vector<std::int64_t> offsets;
  std::vector<std::uint8_t> types;
  std::vector<std::int32_t> face;
  std::vector<double> sj;
};

std::vector<LatticePoint> vtk_quad_nodes(int p) {
  std::vector<LatticePoint> nodes{{0, 0}, {p, 0}, {p, p}, {0, p}};
  for (int i = 1; i < p; ++i) nodes.emplace_back(i, 0);
  for (int i = 1; i < p; ++i) nodes.emplace_back(p, i);
  for (int i = 1; i < p; ++i) nodes.emplace_back(i, p);
  for (int i = 1; i < p; ++i) nodes.emplace_back(0, i);
  for (int j = 1; j < p; ++j) {
    for (int i = 1; i < p; ++i) nodes.emplace_back(i, j);
  }
  return nodes;
}

/// Per VTK position: the position in Gmsh's order.
std::vector<int> positions(bool is_quad, int p) {
  std::vector<LatticePoint> ours = lagrange_nodes(is_quad ? ElementShape::quad : ElementShape::triangle, p);
  std::map<LatticePoint, int> at;
  for (std::size_t i = 0; i < ours.size(); ++i) at[ours[i]] = static_cast<int>(i);
  std::vector<int> result;
  for (LatticePoint point : is_quad ? vtk_quad_nodes(p) : ours) result.push_back(at.at(point));
  return result;
}

void add_elements(const SurfaceMesh& mesh, bool is_quad, std::vector<int>& number, Grid& grid) {
  const std::vector<int>& elements = is_quad ? mesh.quads : mesh.triangles;
  const std::vector<int>& face_of = is_quad ? mesh.quad_face : mesh.triangle_face;
  std::vector<int> order = positions(is_quad, mesh.order);
  bool is_straight = mesh.order == 1;
  std::uint8_t type =
      is_quad ? (is_straight ? vtk_quad : vtk_lagrange_quad) : (is_straight ? vtk_triangle : vtk_lagrange_triangle);
  for (std::size_t e = 0; e < face_of.size(); ++e) {
    const int* nodes = elements.data() + e * order.size();
    for (int position : order) {
      int node = nodes[position];
      if (number[node] < 0) {
        number[node] = static_cast<int>(grid.points.size());
        grid.points.push_back(mesh.nodes[node]);
      }
      grid.connectivity.push_back(number[node]);
    }
    Vec3 a = mesh.nodes[nodes[0]], b = mesh.nodes[nodes[1]], c = mesh.nodes[nodes[2]];
    grid.offsets.push_back(static_cast<std::int64_t>(grid.connectivity.size()));
    grid.types.push_back(type);
    grid.face.push_back(face_of[e] + 1);
    grid.sj.push_back(is_quad ? scaled_jacobian(a, b, c, mesh.nodes[nodes[3]]) : scaled_jacobian(a, b, c));
  }
}

Grid build_grid(const SurfaceMesh& mesh) {
  Grid grid;
  std::size_t elements = mesh.quad_count() + mesh.triangle_count();
  grid.points.reserve(mesh.nodes.size());
  grid.connectivity.reserve(mesh.quads.size() + mesh.triangles.size());
  grid.offsets.reserve(elements);
  std::vector<int> number(mesh.nodes.size(), -1);
  add_elements(mesh, true, number, grid);
  add_elements(mesh, false, number, grid);
  return grid;
}

/// Writes the XML element of each array; raw data follows in the same order at the end.
class Arrays {
 public:
  Arrays(AtomicFile& file, bool is_ascii) : file_(file), is_ascii_(is_ascii) {}

  /// `type` as VTK names it; `components` numbers per entry.
  template <class T>
  void declare(const char* type, const char* name, int components, const T* data, std::size_t count) {
    file_.write(fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"", type, name, components));
    if (is_ascii_) {
      file_.write(" format=\"ascii\">\n");
      write_text(data, count, static_cast<std::size_t>(components));
      file_.write("</DataArray>\n");
      return;
    }
    file_.write(fmt::format(" format=\"appended\" offset=\"{}\"/>\n", offset_));
    blocks_.push_back({data, count * sizeof(T)});
    offset_ += sizeof(std::uint64_t) + count * sizeof(T);
  }

  void write_appended() {
    if (is_ascii_) return;
    file_.write("<AppendedData encoding=\"raw\">\n_");
    for (const Block& block : blocks_) {
      file_.write_packed<std::uint64_t>(block.bytes);
      file_.write(block.data, block.bytes);
    }
    file_.write("\n</AppendedData>\n");
  }

 private:
  struct Block {
    const void* data;
    std::size_t bytes;
  };

  template <class T>
  void write_text(const T* data, std::size_t count, std::size_t per_line) {
    fmt::memory_buffer line;
    for (std::size_t i = 0; i < count; ++i) {
      bool is_last = (i + 1) % per_line == 0;
      fmt::format_to(std::back_inserter(line), "{}{}", +data[i], is_last ? '\n' : ' ');
      if (is_last) file_.write(line.data(), line.size()), line.clear();
    }
  }

  AtomicFile& file_;
  bool is_ascii_;
  std::size_t offset_ = 0;
  std::vector<Block> blocks_;
};

}  // namespace

void write_vtu(const MeshResult& result, bool is_ascii, AtomicFile& file) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double), "points are written as they lie in memory");
  Grid grid = build_grid(result.mesh);
  Arrays arrays(file, is_ascii);
  file.write(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<UnstructuredGrid>\n");
  file.write(
      fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n", grid.points.size(), grid.types.size()));
  file.write("<CellData Scalars=\"sj\">\n");
  arrays.declare("Int32", "face", 1, grid.face.data(), grid.face.size());
  arrays.declare("Float64", "sj", 1, grid.sj.data(), grid.sj.size());
  file.write("</CellData>\n<Points>\n");
  arrays.declare("Float64", "Points", 3, reinterpret_cast<const double*>(grid.points.data()), 3 * grid.points.size());
  file.write("</Points>\n<Cells>\n");
  arrays.declare("Int32", "connectivity", 1, grid.connectivity.data(), grid.connectivity.size());
  arrays.declare("Int64", "offsets", 1, grid.offsets.data(), grid.offsets.size());
  arrays.declare("UInt8", "types", 1, grid.types.data(), grid.types.size());
  file.write("</Cells>\n</Piece>\n</UnstructuredGrid>\n");
  arrays.write_appended();
  file.write("</VTKFile>\n");
}

}  // namespace paver
