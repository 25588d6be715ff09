// Gmsh .msh 4.1, binary, by several ranks. All records of a block have one size, so that the number of records before
// one is its place.
//
// All ranks know the whole layout. Rank 0 writes the beginning and what stands between the sections; blocks of curves,
// whose nodes and lines all ranks hold, are dealt in turn; of the blocks of surfaces each rank writes its own runs, the
// first run with the head of the block.
#include <algorithm>
#include <array>

#include "output/mesh_writers_impl.h"
#include "output/msh/msh4_impl.h"
#include "output/share_numbering_impl.h"
#include "output/share_writers_impl.h"

namespace paver {
namespace {

constexpr long head_bytes = 3 * sizeof(int) + sizeof(std::uint64_t);
constexpr long tag_bytes = sizeof(std::uint64_t);

/// Where the blocks of one table begin, -1 for entities without one, and the number of records before each.
struct Blocks {
  std::vector<long> offset, before;
  std::size_t present = 0;
};

/// Lays blocks one behind the other from `at` on, which moves behind the last; `records` counts on.
Blocks lay_out(const std::vector<long>& size, long record_bytes, long& at, long& records) {
  Blocks blocks;
  for (long count : size) {
    blocks.offset.push_back(count > 0 ? at : -1);
    blocks.before.push_back(records);
    if (count == 0) continue;
    at += head_bytes + count * record_bytes;
    records += count;
    ++blocks.present;
  }
  return blocks;
}

/// One kind of element.
struct Table {
  int dimension, type;
  std::size_t stride;
  const std::vector<int>* nodes;
  PlacedRows rows;
  Blocks blocks;

  long record_bytes() const { return tag_bytes * (1 + static_cast<long>(stride)); }
};

class Msh4Share : public ShareWriter {
 public:
  Msh4Share(const MeshShare& share, Ranks& ranks)
      : share_(share), mesh_(share.result.mesh), rank_(ranks.rank()), ranks_(ranks.count()) {
    int faces = static_cast<int>(greatest(face_count(share.result), ranks));
    make_tables(faces, ranks);
    number_nodes_and_place(faces, ranks);
    lay_out_file(entities(faces, ranks));
  }

  long file_bytes() const override { return end_ + static_cast<long>(ending_.size()); }

  void write(SharedFile& file) const override {
    if (rank_ == 0) {
      file.write(beginning_);
      file.seek(middle_at_);
      file.write(middle_);
      file.seek(end_);
      file.write(ending_);
    }
    for (std::size_t edge = 0; edge < curve_nodes_.size.size(); ++edge) {
      if (curve_nodes_.size[edge] > 0 && is_dealt_here(edge))
        write_nodes(1, curve_nodes_, curve_blocks_, whole_group(curve_nodes_, edge), file);
    }
    for (const PlacedRun& run : surface_nodes_.runs) write_nodes(2, surface_nodes_, surface_blocks_, run, file);
    for (std::size_t edge = 0; edge < lines_.rows.size.size(); ++edge) {
      if (lines_.rows.size[edge] > 0 && is_dealt_here(edge))
        write_elements(lines_, whole_group(lines_.rows, edge), file);
    }
    for (const Table* table : {&triangles_, &quads_}) {
      for (const PlacedRun& run : table->rows.runs) write_elements(*table, run, file);
    }
  }

 private:
  bool is_dealt_here(std::size_t edge) const {
    return static_cast<int>(edge % static_cast<std::size_t>(ranks_)) == rank_;
  }

  static PlacedRun whole_group(const PlacedRows& rows, std::size_t group) {
    return {static_cast<int>(group), 0, rows.held.start[group], rows.held.start[group + 1]};
  }

  /// Rows that every rank holds.
  static PlacedRows common_rows(const std::vector<int>& group_of, int groups) {
    PlacedRows rows;
    rows.held = group_rows(group_of, groups);
    for (std::size_t group = 0; group < rows.held.count(); ++group)
      rows.size.push_back(static_cast<long>(rows.held.size(group)));
    return rows;
  }

  void make_tables(int faces, Ranks& ranks) {
    int p = mesh_.order;
    edges_ = mesh_.line_edge.empty() ? 0 : 1 + *std::max_element(mesh_.line_edge.begin(), mesh_.line_edge.end());
    std::size_t quad = static_cast<std::size_t>(mesh_.nodes_per_quad());
    std::size_t triangle = static_cast<std::size_t>(mesh_.nodes_per_triangle());
    lines_ = {1, gmsh_line_type(p), static_cast<std::size_t>(p) + 1, &mesh_.lines, common_rows(mesh_.line_edge, edges_),
              {}};
    triangles_ = {2,
                  gmsh_triangle_type(p),
                  triangle,
                  &mesh_.triangles,
                  place_rows(mesh_.triangle_face, faces, share_.triangle_number, nullptr, ranks),
                  {}};
    quads_ = {2,
              gmsh_quad_type(p),
              quad,
              &mesh_.quads,
              place_rows(mesh_.quad_face, faces, share_.quad_number, nullptr, ranks),
              {}};
  }

  void number_nodes_and_place(int faces, Ranks& ranks) {
    curve_ = curve_of_nodes(mesh_, lines_.rows.held);
    std::vector<char> is_on_curve(curve_.size()), is_written(curve_.size());
    for (std::size_t i = 0; i < curve_.size(); ++i) is_on_curve[i] = curve_[i] >= 0;
    std::vector<int> face = faces_of_nodes(share_, is_on_curve, ranks);
    for (std::size_t i = 0; i < curve_.size(); ++i) is_written[i] = is_on_curve[i] || face[i] >= 0;
    tags_ = number_nodes(share_, is_written, ranks);
    curve_nodes_ = common_rows(curve_, edges_);
    surface_nodes_ = place_rows(face, faces, share_.node_number, &share_.is_own_node, ranks);
  }

  /// Boxes and edges of faces, put together from those of all ranks.
  Msh4Entities entities(int faces, Ranks& ranks) const {
    std::size_t n = static_cast<std::size_t>(faces);
    Msh4Entities entities{std::vector<Box>(static_cast<std::size_t>(edges_)), std::vector<Box>(n), {}, {}};
    add_boxes(mesh_, mesh_.lines, mesh_.line_edge, entities.curves);
    std::vector<Box> own(n);
    add_boxes(mesh_, mesh_.triangles, mesh_.triangle_face, own);
    add_boxes(mesh_, mesh_.quads, mesh_.quad_face, own);
    struct BoxRecord {
      long face;
      Vec3 low, high;
    };
    struct EdgeRecord {
      long face, edge;
    };
    std::vector<BoxRecord> boxes;
    std::vector<EdgeRecord> sides;
    entities.face_edges = edges_of_faces(mesh_, curve_, faces);
    for (std::size_t face = 0; face < n; ++face) {
      long number = static_cast<long>(face);
      if (!own[face].is_empty()) boxes.push_back({number, own[face].low, own[face].high});
      for (int edge : entities.face_edges[face]) sides.push_back({number, edge});
    }
    for (const BoxRecord& box : gather_all(boxes, ranks)) {
      entities.surfaces[static_cast<std::size_t>(box.face)].add(box.low);
      entities.surfaces[static_cast<std::size_t>(box.face)].add(box.high);
    }
    for (const EdgeRecord& side : gather_all(sides, ranks))
      entities.face_edges[static_cast<std::size_t>(side.face)].push_back(static_cast<int>(side.edge));
    for (std::vector<int>& list : entities.face_edges) {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
    }
    std::vector<char> has_elements(n);
    for (std::size_t face = 0; face < n; ++face)
      has_elements[face] = triangles_.rows.size[face] + quads_.rows.size[face] > 0;
    entities.groups = find_groups(share_.result, has_elements);
    return entities;
  }

  void lay_out_file(const Msh4Entities& entities) {
    MemorySink beginning, middle, ending;
    write_msh4_beginning(entities, false, beginning);
    auto present = [](const std::vector<long>& sizes) {
      return static_cast<std::size_t>(std::count_if(sizes.begin(), sizes.end(), [](long size) { return size > 0; }));
    };
    Msh4Numbers numbers(beginning, false);
    write_msh4_head(present(curve_nodes_.size) + present(surface_nodes_.size), static_cast<std::size_t>(tags_.count),
                    numbers);
    beginning_ = beginning.content();

    long at = static_cast<long>(beginning_.size()), nodes = 0, elements = 0;
    constexpr long node_bytes = tag_bytes + static_cast<long>(sizeof(Vec3));
    curve_blocks_ = lay_out(curve_nodes_.size, node_bytes, at, nodes);
    surface_blocks_ = lay_out(surface_nodes_.size, node_bytes, at, nodes);

    std::size_t blocks = 0;
    long total = 0;
    for (const Table* table : {&lines_, &triangles_, &quads_}) {
      blocks += present(table->rows.size);
      for (long size : table->rows.size) total += size;
    }
    Msh4Numbers between(middle, false), last(ending, false);
    between.end_section("Nodes");
    middle.write("$Elements\n");
    write_msh4_head(blocks, static_cast<std::size_t>(total), between);
    last.end_section("Elements");
    middle_ = middle.content();
    ending_ = ending.content();
    middle_at_ = at;
    at += static_cast<long>(middle_.size());
    for (Table* table : {&lines_, &triangles_, &quads_})
      table->blocks = lay_out(table->rows.size, table->record_bytes(), at, elements);
    end_ = at;
  }

  static void write_head(int dimension, int entity, int kind, long count, SharedFile& file) {
    for (int value : {dimension, entity + 1, kind}) file.write_packed(value);
    file.write_packed<std::uint64_t>(static_cast<std::uint64_t>(count));
  }

  void write_nodes(int dimension, const PlacedRows& rows, const Blocks& blocks, const PlacedRun& run,
                   SharedFile& file) const {
    std::size_t group = static_cast<std::size_t>(run.group);
    long tags_at = blocks.offset[group] + head_bytes;
    file.seek(run.position == 0 ? blocks.offset[group] : tags_at + run.position * tag_bytes);
    if (run.position == 0) write_head(dimension, run.group, 0, rows.size[group], file);
    for (std::size_t i = run.begin; i < run.end; ++i)
      file.write_packed<std::uint64_t>(
          static_cast<std::uint64_t>(tags_.of_node[static_cast<std::size_t>(rows.held.rows[i])]));
    file.seek(tags_at + rows.size[group] * tag_bytes + run.position * static_cast<long>(sizeof(Vec3)));
    for (std::size_t i = run.begin; i < run.end; ++i)
      file.write_packed(mesh_.nodes[static_cast<std::size_t>(rows.held.rows[i])]);
  }

  void write_elements(const Table& table, const PlacedRun& run, SharedFile& file) const {
    std::size_t group = static_cast<std::size_t>(run.group);
    long at = table.blocks.offset[group];
    file.seek(run.position == 0 ? at : at + head_bytes + run.position * table.record_bytes());
    if (run.position == 0) write_head(table.dimension, run.group, table.type, table.rows.size[group], file);
    std::uint64_t number = static_cast<std::uint64_t>(table.blocks.before[group] + run.position);
    std::array<std::uint64_t, 1 + 25> record;
    for (std::size_t i = run.begin; i < run.end; ++i) {
      const int* nodes = table.nodes->data() + static_cast<std::size_t>(table.rows.held.rows[i]) * table.stride;
      record[0] = ++number;
      for (std::size_t k = 0; k < table.stride; ++k)
        record[k + 1] = static_cast<std::uint64_t>(tags_.of_node[static_cast<std::size_t>(nodes[k])]);
      file.write(record.data(), (table.stride + 1) * sizeof(std::uint64_t));
    }
  }

  const MeshShare& share_;
  const SurfaceMesh& mesh_;
  const int rank_, ranks_;
  int edges_ = 0;
  std::vector<int> curve_;  // per node: its edge or -1
  NodeTags tags_;
  PlacedRows curve_nodes_, surface_nodes_;
  Blocks curve_blocks_, surface_blocks_;
  Table lines_, triangles_, quads_;
  std::string beginning_, middle_, ending_;
  long middle_at_ = 0, end_ = 0;
};

}  // namespace

std::unique_ptr<ShareWriter> msh4_share_writer(const MeshShare& share, Ranks& ranks) {
  return std::make_unique<Msh4Share>(share, ranks);
}

}  // namespace paver
