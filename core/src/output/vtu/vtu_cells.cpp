// VTK orders the nodes of a Lagrange quad differently from Gmsh beyond order 2: its third and fourth side run from low
// to high, the inside runs row by row. Triangles agree.
#include <fmt/format.h>

#include <limits>
#include <map>

#include "output/vtu/vtu_impl.h"
#include "quality/jacobian/lattice.h"
#include "quality/metrics.h"

namespace paver {
namespace {

constexpr std::uint8_t vtk_triangle = 5, vtk_quad = 9, vtk_lagrange_triangle = 69, vtk_lagrange_quad = 70, vtk_line = 3,
                       vtk_lagrange_curve = 68;

long nodes_per_quad(int p) { return static_cast<long>(p + 1) * (p + 1); }
long nodes_per_triangle(int p) { return static_cast<long>(p + 1) * (p + 2) / 2; }

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

}  // namespace

bool VtuSize::has_wide_points() const { return points > std::numeric_limits<std::int32_t>::max(); }

void VtuSize::write_point(long number, ByteSink& sink) const {
  if (has_wide_points())
    sink.write_packed<std::int64_t>(number - 1);
  else
    sink.write_packed(static_cast<std::int32_t>(number - 1));
}

VtuEntry VtuSize::entry(VtuArray array) const {
  static constexpr std::array<VtuEntry, vtu_arrays.size()> entries{{{"Int32", "face", 4, 1},
                                                                    {"Float64", "sj", 8, 1},
                                                                    {"Float64", "Points", 8, 3},
                                                                    {"Int32", "connectivity", 4, 1},
                                                                    {"Int64", "offsets", 8, 1},
                                                                    {"UInt8", "types", 1, 1}}};
  if (array == VtuArray::connectivity && has_wide_points()) return {"Int64", "connectivity", 8, 1};
  return entries[static_cast<std::size_t>(array)];
}

long VtuSize::entries(VtuArray array) const {
  if (array == VtuArray::points) return points;
  return entries_before_line(array, lines);
}

long VtuSize::entries_before_line(VtuArray array, long number) const {
  return entries_before(array, false, triangles) + number * (array == VtuArray::connectivity ? order + 1 : 1);
}

long VtuSize::entries_before(VtuArray array, bool is_quad, long number) const {
  bool has_nodes = array == VtuArray::connectivity;
  long per_quad = has_nodes ? nodes_per_quad(order) : 1, per_triangle = has_nodes ? nodes_per_triangle(order) : 1;
  return is_quad ? number * per_quad : quads * per_quad + number * per_triangle;
}

std::string vtu_declaration(VtuArray array, const VtuSize& size) {
  const auto [type, name, bytes, components] = size.entry(array);
  return fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"", type, name, components);
}

void write_vtu_xml(const VtuSize& size, ByteSink& sink, const std::function<void(VtuArray)>& declare) {
  sink.write(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<UnstructuredGrid>\n");
  sink.write(fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n", size.points, size.cells()));
  sink.write("<CellData Scalars=\"sj\">\n");
  declare(VtuArray::face);
  declare(VtuArray::sj);
  sink.write("</CellData>\n<Points>\n");
  declare(VtuArray::points);
  sink.write("</Points>\n<Cells>\n");
  declare(VtuArray::connectivity);
  declare(VtuArray::offsets);
  declare(VtuArray::types);
  sink.write("</Cells>\n</Piece>\n</UnstructuredGrid>\n");
}

std::string vtu_beginning(const VtuSize& size) {
  MemorySink sink;
  long offset = 0;
  write_vtu_xml(size, sink, [&](VtuArray array) {
    sink.write(vtu_declaration(array, size) + fmt::format(" format=\"appended\" offset=\"{}\"/>\n", offset));
    offset += static_cast<long>(sizeof(std::uint64_t)) + size.bytes(array);
  });
  sink.write("<AppendedData encoding=\"raw\">\n_");
  return sink.content();
}

VtuCells::VtuCells(const SurfaceMesh& mesh, bool is_quad, const VtuSize& size, const std::vector<long>& point)
    : mesh_(mesh),
      is_quad_(is_quad),
      size_(size),
      point_(point),
      table_(mesh, is_quad),
      positions_(positions(is_quad, mesh.order)) {}

void VtuCells::write(VtuArray array, std::size_t begin, std::size_t end, long number, ByteSink& sink) const {
  long at = size_.entries_before(VtuArray::connectivity, is_quad_, number);
  std::uint8_t type = is_quad_ ? (size_.order == 1 ? vtk_quad : vtk_lagrange_quad)
                               : (size_.order == 1 ? vtk_triangle : vtk_lagrange_triangle);
  for (std::size_t e = begin; e < end; ++e) {
    if (array == VtuArray::face) sink.write_packed<std::int32_t>(table_.face[e] + 1);
    if (array == VtuArray::sj) sink.write_packed(sj(e));
    if (array == VtuArray::offsets) sink.write_packed<std::int64_t>(at += static_cast<long>(table_.stride));
    if (array == VtuArray::types) sink.write_packed(type);
    if (array != VtuArray::connectivity) continue;
    const int* nodes = table_.row(e);
    for (int k : positions_) size_.write_point(point_[nodes[k]], sink);
  }
}

VtuLines::VtuLines(const MeshResult& result) : mesh_(result.mesh) {
  for (std::size_t line = 0; line < mesh_.line_edge.size(); ++line) {
    const auto edge = static_cast<std::size_t>(mesh_.line_edge[line]);
    if (edge >= result.edge_groups.size()) continue;
    if (const std::string& group = result.edge_groups[edge]; !group.empty() && group != junctions)
      lines_.push_back(line);
  }
}

void VtuLines::write(VtuArray array, const VtuSize& size, const std::vector<long>& point, ByteSink& sink) const {
  long at = size.entries_before_line(VtuArray::connectivity, 0);
  for (std::size_t line : lines_) {
    if (array == VtuArray::face) sink.write_packed<std::int32_t>(-1 - mesh_.line_edge[line]);
    if (array == VtuArray::sj) sink.write_packed(1.0);
    if (array == VtuArray::offsets) sink.write_packed<std::int64_t>(at += size.order + 1);
    if (array == VtuArray::types) sink.write_packed(size.order == 1 ? vtk_line : vtk_lagrange_curve);
    if (array != VtuArray::connectivity) continue;
    for (int node : mesh_.line(line)) size.write_point(point[node], sink);
  }
}

double VtuCells::sj(std::size_t element) const {
  const int* nodes = table_.row(element);
  auto x = [&](int k) { return mesh_.nodes[nodes[k]]; };
  return is_quad_ ? scaled_jacobian(x(0), x(1), x(2), x(3)) : scaled_jacobian(x(0), x(1), x(2));
}

}  // namespace paver
