// VTK unstructured grid, appended raw, by several ranks. An element's number in the whole is its place in every array,
// a node's tag its place among the points. All ranks hold the lines, the first one writes them.
#include "output/share_numbering_impl.h"
#include "output/share_writers_impl.h"
#include "output/vtu/vtu_impl.h"

namespace paver {
namespace {

/// Rows of this rank that follow each other here and in the file.
struct Stretch {
  std::size_t begin, end;
  long number;  ///< of the first in the file
};

/// `number`: per row, rising.
std::vector<Stretch> stretches_of(const std::vector<long>& number) {
  std::vector<Stretch> stretches;
  for (std::size_t i = 0; i < number.size(); ++i) {
    bool follows = i > 0 && number[i] == number[i - 1] + 1;
    if (!follows) stretches.push_back({i, i, number[i]});
    stretches.back().end = i + 1;
  }
  return stretches;
}

class VtuShare : public ShareWriter {
 public:
  VtuShare(const MeshShare& share, Ranks& ranks)
      : share_(share), mesh_(share.result.mesh), lines_(share.result), rank_(ranks.rank()) {
    std::vector<char> is_used(mesh_.nodes.size(), 0);
    std::vector<int> face = faces_of_nodes(share, is_used, ranks);
    for (std::size_t node = 0; node < face.size(); ++node) is_used[node] = face[node] >= 0;
    lines_.mark_nodes(is_used);
    tags_ = number_nodes(share, is_used, ranks);
    size_ = {mesh_.order, tags_.count, share.quads, share.triangles, lines_.count()};
    beginning_ = vtu_beginning(size_);
    end_ = static_cast<long>(beginning_.size());
    for (VtuArray array : vtu_arrays) {
      data_at_.push_back(end_ + static_cast<long>(sizeof(std::uint64_t)));
      end_ = data_at_.back() + size_.bytes(array);
    }
  }

  long file_bytes() const override { return end_ + static_cast<long>(std::string_view(vtu_ending).size()); }

  void write(SharedFile& file) const override {
    if (rank_ == 0) file.write(beginning_);
    for (VtuArray array : vtu_arrays) {
      if (rank_ == 0) {
        file.seek(at(array, 0) - static_cast<long>(sizeof(std::uint64_t)));
        file.write_packed<std::uint64_t>(static_cast<std::uint64_t>(size_.bytes(array)));
      }
      if (array == VtuArray::points) {
        write_points(file);
        continue;
      }
      write_cells(array, true, file);
      write_cells(array, false, file);
      if (rank_ > 0) continue;
      file.seek(at(array, size_.entries_before_line(array, 0)));
      lines_.write(array, size_, tags_.of_node, file);
    }
    if (rank_ == 0) {
      file.seek(end_);
      file.write(std::string_view(vtu_ending));
    }
  }

 private:
  long at(VtuArray array, long entry) const {
    return data_at_[static_cast<std::size_t>(array)] + entry * size_.entry_bytes(array);
  }

  void write_points(SharedFile& file) const {
    for (std::size_t node = 0; node < mesh_.nodes.size(); ++node) {
      if (!share_.is_own_node[node] || tags_.of_node[node] == 0) continue;
      file.seek(at(VtuArray::points, tags_.of_node[node] - 1));
      file.write_packed(mesh_.nodes[node]);
    }
  }

  void write_cells(VtuArray array, bool is_quad, SharedFile& file) const {
    VtuCells cells(mesh_, is_quad, size_, tags_.of_node);
    for (const Stretch& stretch : stretches_of(is_quad ? share_.quad_number : share_.triangle_number)) {
      file.seek(at(array, size_.entries_before(array, is_quad, stretch.number)));
      cells.write(array, stretch.begin, stretch.end, stretch.number, file);
    }
  }

  const MeshShare& share_;
  const SurfaceMesh& mesh_;
  const VtuLines lines_;
  const int rank_;
  NodeTags tags_;
  VtuSize size_;
  std::string beginning_;
  std::vector<long> data_at_;  // per array
  long end_ = 0;
};

}  // namespace

std::unique_ptr<ShareWriter> vtu_share_writer(const MeshShare& share, Ranks& ranks) {
  return std::make_unique<VtuShare>(share, ranks);
}

}  // namespace paver
