// VTK unstructured grid (.vtu), arrays appended raw or as text. Of the lines only those of wires. Points are the nodes
// that elements and these use, in their order.
#include <fmt/format.h>

#include <cstring>
#include <iterator>

#include "output/atomic_file_impl.h"
#include "output/mesh_writers_impl.h"
#include "output/vtu/vtu_impl.h"

namespace paver {
namespace {

class VtuFile {
 public:
  VtuFile(const MeshResult& result, AtomicFile& file)
      : mesh_(result.mesh),
        file_(file),
        lines_(result),
        point_(number_points()),
        quads_(mesh_, true, size_, point_),
        triangles_(mesh_, false, size_, point_) {}

  void write_binary() {
    file_.write(vtu_beginning(size_));
    for (VtuArray array : vtu_arrays) {
      file_.write_packed<std::uint64_t>(static_cast<std::uint64_t>(size_.bytes(array)));
      write_array(array, file_);
    }
    file_.write(vtu_ending);
  }

  void write_ascii() {
    write_vtu_xml(size_, file_, [&](VtuArray array) {
      file_.write(vtu_declaration(array, size_) + " format=\"ascii\">\n");
      write_as_text(array);
      file_.write("</DataArray>\n");
    });
    file_.write("</VTKFile>\n");
  }

 private:
  /// Per node its number, from 1; 0: no cell uses it.
  std::vector<long> number_points() {
    std::vector<long> number(mesh_.nodes.size(), 0);
    for (const std::vector<int>* table : {&mesh_.quads, &mesh_.triangles})
      for (int node : *table) number[static_cast<std::size_t>(node)] = 1;
    lines_.mark_nodes(number);
    long points = 0;
    for (long& value : number)
      if (value) value = ++points;
    size_ = {mesh_.order, points, static_cast<long>(mesh_.quad_count()), static_cast<long>(mesh_.triangle_count()),
             lines_.count()};
    return number;
  }

  void write_array(VtuArray array, ByteSink& sink) const {
    if (array == VtuArray::points) {
      for (std::size_t node = 0; node < point_.size(); ++node)
        if (point_[node]) sink.write_packed(mesh_.nodes[node]);
      return;
    }
    quads_.write(array, 0, quads_.count(), 0, sink);
    triangles_.write(array, 0, triangles_.count(), 0, sink);
    lines_.write(array, size_, point_, sink);
  }

  void write_as_text(VtuArray array) {
    MemorySink sink;
    write_array(array, sink);
    switch (array) {
      case VtuArray::sj:
        return write_numbers<double>(sink.content(), 1);
      case VtuArray::points:
        return write_numbers<double>(sink.content(), 3);
      case VtuArray::types:
        return write_numbers<std::uint8_t>(sink.content(), 1);
      case VtuArray::offsets:
        return write_numbers<std::int64_t>(sink.content(), 1);
      default:
        return write_numbers<std::int32_t>(sink.content(), 1);
    }
  }

  template <class T>
  void write_numbers(const std::string& bytes, std::size_t per_line) {
    fmt::memory_buffer line;
    for (std::size_t i = 0; i < bytes.size() / sizeof(T); ++i) {
      T value;
      std::memcpy(&value, bytes.data() + i * sizeof(T), sizeof(T));
      bool is_last = (i + 1) % per_line == 0;
      fmt::format_to(std::back_inserter(line), "{}{}", +value, is_last ? '\n' : ' ');
      if (is_last) file_.write(line.data(), line.size()), line.clear();
    }
  }

  const SurfaceMesh& mesh_;
  AtomicFile& file_;
  const VtuLines lines_;
  VtuSize size_;
  std::vector<long> point_;
  VtuCells quads_, triangles_;
};

}  // namespace

void write_vtu(const MeshResult& result, bool is_ascii, AtomicFile& file) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double), "points are written as they lie in memory");
  VtuFile vtu(result, file);
  is_ascii ? vtu.write_ascii() : vtu.write_binary();
}

}  // namespace paver
