// Mesh edges by counting: sides of all elements are dealt into one bucket per lower node, and each small bucket is
// sorted by the upper node. Linear in the number of elements, no hashing.
//
// Each thread has a range of nodes and deals the sides whose lower node is there. It looks only at those chunks of
// elements that have corners in its range: numbers of neighbours are near each other, so these are few.
//
// The elements around a node tell its valence: 2 per corner is the number of elements its edges have together, and all
// but few edges have two.

#include <algorithm>

#include "base/tasks/tasks.h"
#include "mesh/element_table.h"
#include "quality/mesh_edges_impl.h"

namespace paver {
namespace {

constexpr std::size_t chunk_elements = 512;
constexpr std::size_t most_samples = 4096;

/// Corners of consecutive elements of one kind.
struct Chunk {
  const int* elements;
  std::size_t count;
  int corners;
  std::size_t stride;
  int lowest = 0, highest = -1;  ///< corner nodes
};

std::vector<Chunk> chunks_of(const SurfaceMesh& mesh) {
  std::vector<Chunk> chunks;
  for (const ElementTable& table : {ElementTable(mesh, true), ElementTable(mesh, false)})
    for (std::size_t first = 0; first < table.count(); first += chunk_elements)
      chunks.push_back(
          {table.row(first), std::min(chunk_elements, table.count() - first), table.corners, table.stride});
  run_stretches(chunks.size(), 1, [&](std::size_t i, std::size_t) {
    Chunk& chunk = chunks[i];
    chunk.lowest = chunk.highest = chunk.elements[0];
    const int* element = chunk.elements;
    for (std::size_t e = 0; e < chunk.count; ++e, element += chunk.stride) {
      for (int k = 0; k < chunk.corners; ++k) {
        chunk.lowest = std::min(chunk.lowest, element[k]);
        chunk.highest = std::max(chunk.highest, element[k]);
      }
    }
  });
  return chunks;
}

/// Bounds of `ranges` ranges of nodes with about as many corners each.
std::vector<int> divide_nodes(const SurfaceMesh& mesh, const std::vector<Chunk>& chunks, std::size_t ranges) {
  std::vector<int> samples, bounds{0};
  std::size_t step = chunks.size() * chunk_elements / most_samples + 1;
  for (const Chunk& chunk : chunks) {
    for (std::size_t e = 0; e < chunk.count; e += step) samples.push_back(chunk.elements[e * chunk.stride]);
  }
  std::sort(samples.begin(), samples.end());
  for (std::size_t i = 1; i < ranges && !samples.empty(); ++i) bounds.push_back(samples[i * samples.size() / ranges]);
  bounds.push_back(static_cast<int>(mesh.nodes.size()));
  return bounds;
}

/// The edges whose lower node is from `begin` on and below `end`.
class RangeOfNodes {
 public:
  RangeOfNodes(const SurfaceMesh& mesh, const std::vector<char>& is_shared, int begin, int end)
      : mesh_(mesh), is_shared_(is_shared), begin_(begin), end_(end) {}

  std::vector<double> chords;
  std::vector<EdgeUse> odd, shared;

  void measure(const std::vector<Chunk>& chunks, std::vector<int>& twice_valence) {
    start_.assign(static_cast<std::size_t>(end_ - begin_) + 1, 0);
    for_each_side(chunks, [&](int a, int b) {
      if (has(a)) twice_valence[a] += 2;
      if (has(std::min(a, b))) ++start_[std::min(a, b) - begin_ + 1];
    });
    for (std::size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
    upper_.resize(start_.back());
    std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
    for_each_side(chunks, [&](int a, int b) {
      if (has(std::min(a, b))) upper_[next[std::min(a, b) - begin_]++] = std::max(a, b);
    });
    chords.reserve(upper_.size() / 2 + 1);
    for (int low = begin_; low < end_; ++low) list_edges(low);
  }

 private:
  bool has(int node) const { return begin_ <= node && node < end_; }
  bool is_shared(int node) const { return !is_shared_.empty() && is_shared_[node]; }

  /// Calls f(a, b) for the sides, from corner to corner, of all chunks with corners in the range.
  template <class Function>
  void for_each_side(const std::vector<Chunk>& chunks, Function f) const {
    for (const Chunk& chunk : chunks) {
      if (chunk.highest < begin_ || chunk.lowest >= end_) continue;
      const int* element = chunk.elements;
      for (std::size_t e = 0; e < chunk.count; ++e, element += chunk.stride) {
        for (int k = 0; k < chunk.corners; ++k) f(element[k], element[k + 1 < chunk.corners ? k + 1 : 0]);
      }
    }
  }

  void list_edges(int low) {
    int* begin = upper_.data() + start_[low - begin_];
    int* end = upper_.data() + start_[low - begin_ + 1];
    std::sort(begin, end);
    while (begin != end) {
      int high = *begin;
      int* next = begin + 1;
      while (next != end && *next == high) ++next;
      EdgeUse edge{low, high, static_cast<int>(next - begin)};
      begin = next;
      if (is_shared(low) && is_shared(high)) {
        shared.push_back(edge);
        continue;
      }
      chords.push_back(norm(mesh_.nodes[low] - mesh_.nodes[high]));
      if (edge.uses != 2) odd.push_back(edge);
    }
  }

  const SurfaceMesh& mesh_;
  const std::vector<char>& is_shared_;
  const int begin_, end_;
  std::vector<std::size_t> start_;  // buckets: those of node i are upper_[start_[i]] to upper_[start_[i + 1]]
  std::vector<int> upper_;
};

}  // namespace

EdgeFigures measure_edges(const SurfaceMesh& mesh, const std::vector<char>& is_shared, const Progress& progress) {
  EdgeFigures figures;
  figures.twice_valence.assign(mesh.nodes.size(), 0);
  std::vector<Chunk> chunks = chunks_of(mesh);
  std::vector<int> bounds = divide_nodes(mesh, chunks, static_cast<std::size_t>(thread_count(0)));
  std::vector<RangeOfNodes> ranges;
  for (std::size_t i = 0; i + 1 < bounds.size(); ++i) ranges.emplace_back(mesh, is_shared, bounds[i], bounds[i + 1]);
  run_stretches(ranges.size(), 1, [&](std::size_t i, std::size_t) {
    progress.check();
    ranges[i].measure(chunks, figures.twice_valence);
  });
  for (RangeOfNodes& range : ranges) {
    figures.chords.push_back(std::move(range.chords));
    figures.odd.insert(figures.odd.end(), range.odd.begin(), range.odd.end());
    figures.shared.insert(figures.shared.end(), range.shared.begin(), range.shared.end());
  }
  for (const EdgeUse& edge : figures.odd) {
    figures.twice_valence[edge.low] += 2 - edge.uses;
    figures.twice_valence[edge.high] += 2 - edge.uses;
  }
  return figures;
}

}  // namespace paver
