// VTK unstructured grid (.vtu), arrays appended raw or as text. Of the lines only those of wires. Points are the nodes
// that elements and these use, in their order. An element's number in the whole is its place in every array, a node's
// tag its place among the points. All ranks hold the lines, the first one writes them.
#include <fmt/format.h>

#include <cstring>
#include <iterator>

#include "base/tasks/tasks.h"
#include "output/numbering_impl.h"
#include "output/vtu/vtu_impl.h"

namespace paver {
namespace {

static_assert(sizeof(Vec3) == 3 * sizeof(double), "points are written as they lie in memory");
constexpr long size_bytes = sizeof(std::uint64_t);  // before each array

/// Rows of this rank that follow each other here and in the file.
struct Stretch {
  std::size_t begin, end;
  long number;  ///< of the first in the file
};

/// Of the rows that have a number, no longer than a thread is to write at a time. `number(i)`: from 0, or -1.
template <class Number>
std::vector<Stretch> stretches_of(std::size_t rows, Number number) {
  constexpr std::size_t most = 1 << 15;
  std::vector<Stretch> stretches;
  for (std::size_t i = 0; i < rows; ++i) {
    const long own = number(i);
    if (own < 0) continue;
    const bool follows = !stretches.empty() && stretches.back().end == i && i - stretches.back().begin < most &&
                         own == stretches.back().number + static_cast<long>(i - stretches.back().begin);
    if (!follows) stretches.push_back({i, i, own});
    stretches.back().end = i + 1;
  }
  return stretches;
}

class VtuWriter : public MeshWriter {
 public:
  VtuWriter(HeldMesh held, bool is_ascii, Ranks& ranks)
      : mesh_(held.result.mesh),
        numbers_(held.numbers),
        lines_(held.result),
        is_ascii_(is_ascii),
        is_first_(ranks.rank() == 0) {
    const std::vector<int> face = faces_of_nodes(held, {}, ranks);
    std::vector<char> is_used(face.size());
    for (std::size_t node = 0; node < face.size(); ++node) is_used[node] = face[node] >= 0;
    lines_.mark_nodes(is_used);
    tags_ = number_nodes(numbers_, is_used, ranks);
    size_ = {mesh_.order, tags_.count, numbers_.quads, numbers_.triangles, lines_.count()};
    beginning_ = vtu_beginning(size_);
    end_ = static_cast<long>(beginning_.size());
    for (VtuArray array : vtu_arrays) {
      data_at_.push_back(end_ + size_bytes);
      end_ = data_at_.back() + size_.bytes(array);
    }
  }

  long file_bytes() const override {
    return is_ascii_ ? 0 : end_ + static_cast<long>(std::string_view(vtu_ending).size());
  }

  void write(AtomicFile& file) const override { is_ascii_ ? write_ascii(file) : write_binary(file); }

 private:
  void write_binary(AtomicFile& file) const {
    if (is_first_) file.write(beginning_);
    for (VtuArray array : vtu_arrays) {
      if (is_first_) {
        file.seek(at(array, 0) - size_bytes);
        file.write_packed<std::uint64_t>(static_cast<std::uint64_t>(size_.bytes(array)));
      }
      for_stretches(array, [&](const std::vector<Stretch>& stretches, auto write) {
        run_stretches(stretches.size(), 1, [&](std::size_t i, std::size_t) {
          FilePiece piece(file);
          write(stretches[i], piece);
          piece.finish();
        });
      });
      if (is_first_ && array != VtuArray::points) write_lines(array, file);
    }
    if (!is_first_) return;
    file.seek(end_);
    file.write(vtu_ending);
  }

  void write_ascii(AtomicFile& file) const {
    write_vtu_xml(size_, file, [&](VtuArray array) {
      file.write(vtu_declaration(array, size_) + " format=\"ascii\">\n");
      write_as_text(array, file);
      file.write("</DataArray>\n");
    });
    file.write("</VTKFile>\n");
  }

  long at(VtuArray array, long entry) const {
    return data_at_[static_cast<std::size_t>(array)] + entry * size_.entry_bytes(array);
  }

  /// visit(stretches, write) for the points, or for quads, then triangles; write(stretch, sink).
  template <class Visit>
  void for_stretches(VtuArray array, Visit visit) const {
    if (array == VtuArray::points) {
      auto number = [&](std::size_t node) { return numbers_.is_own(node) ? tags_.of_node[node] - 1 : -1; };
      visit(stretches_of(mesh_.nodes.size(), number), [&](const Stretch& stretch, ByteSink& sink) {
        sink.seek(at(array, stretch.number));
        sink.write(&mesh_.nodes[stretch.begin], (stretch.end - stretch.begin) * sizeof(Vec3));
      });
      return;
    }
    for (bool is_quad : {true, false}) {
      const VtuCells cells(mesh_, is_quad, size_, tags_.of_node);
      const RowNumbers& numbers = is_quad ? numbers_.quad_number : numbers_.triangle_number;
      auto number = [&](std::size_t i) { return numbers[i]; };
      visit(stretches_of(cells.count(), number), [&](const Stretch& stretch, ByteSink& sink) {
        sink.seek(at(array, size_.entries_before(array, is_quad, stretch.number)));
        cells.write(array, stretch.begin, stretch.end, stretch.number, sink);
      });
    }
  }

  void write_lines(VtuArray array, ByteSink& sink) const {
    sink.seek(at(array, size_.entries_before_line(array, 0)));
    lines_.write(array, size_, tags_.of_node, sink);
  }

  void write_as_text(VtuArray array, AtomicFile& file) const {
    MemorySink sink;
    for_stretches(array, [&](const std::vector<Stretch>& stretches, auto write) {
      for (const Stretch& stretch : stretches) write(stretch, sink);
    });
    if (array != VtuArray::points) write_lines(array, sink);
    const auto [type, name, bytes, per_line] = size_.entry(array);
    if (type == "Float64") return write_numbers<double>(sink.content(), per_line, file);
    if (bytes == 8) return write_numbers<std::int64_t>(sink.content(), per_line, file);
    if (bytes == 4) return write_numbers<std::int32_t>(sink.content(), per_line, file);
    write_numbers<std::uint8_t>(sink.content(), per_line, file);
  }

  template <class T>
  static void write_numbers(const std::string& bytes, int per_line, AtomicFile& file) {
    fmt::memory_buffer line;
    for (std::size_t i = 0; i < bytes.size() / sizeof(T); ++i) {
      T value;
      std::memcpy(&value, bytes.data() + i * sizeof(T), sizeof(T));
      bool is_last = (i + 1) % static_cast<std::size_t>(per_line) == 0;
      fmt::format_to(std::back_inserter(line), "{}{}", +value, is_last ? '\n' : ' ');
      if (is_last) file.write(line.data(), line.size()), line.clear();
    }
  }

  const SurfaceMesh& mesh_;
  const ShareNumbers& numbers_;
  const VtuLines lines_;
  const bool is_ascii_, is_first_;
  NodeTags tags_;
  VtuSize size_;
  std::string beginning_;
  std::vector<long> data_at_;  // per array
  long end_ = 0;
};

}  // namespace

std::unique_ptr<MeshWriter> vtu_writer(HeldMesh held, bool is_ascii, Ranks& ranks) {
  return std::make_unique<VtuWriter>(held, is_ascii, ranks);
}

}  // namespace paver
