// Gmsh .msh 4.1, ASCII and binary. Sections: format, physical names, entities (points that end no edge, curves,
// surfaces), nodes by entity, elements by entity and kind. In binary all counts and tags of nodes and elements are
// 64-bit, and all records of a block have one size, so that the number of records before one is its place.
//
// All ranks know the whole layout. Rank 0 writes the beginning and what stands between the sections; of the blocks each
// rank writes its own runs, the first run with the head of the block; its threads share these out.
#include <algorithm>

#include "base/tasks/tasks.h"
#include "output/mesh_writers_impl.h"
#include "output/msh/msh_impl.h"

namespace paver {
namespace {

constexpr long head_bytes = 3 * sizeof(int) + sizeof(std::uint64_t), tag_bytes = sizeof(std::uint64_t),
               point_bytes = sizeof(Vec3);

/// Where the blocks of one table begin, and the number of records before each.
struct Blocks {
  std::vector<long> offset, before;
};

/// Lays blocks one behind the other from `at` on, which moves behind the last; `records` counts on.
Blocks lay_out(const PlacedRows& rows, long record_bytes, long& at, long& records) {
  Blocks blocks;
  for (long count : rows.size) {
    blocks.offset.push_back(at);
    blocks.before.push_back(records);
    if (count > 0) at += head_bytes + count * record_bytes;
    records += count;
  }
  return blocks;
}

/// Runs, long ones in parts, some at a time that have about as many rows together.
std::vector<std::vector<PlacedRun>> shares_of(const std::vector<PlacedRun>& runs) {
  constexpr std::size_t most = 1 << 15;  // rows
  std::vector<std::vector<PlacedRun>> shares;
  std::size_t left = 0;  // rows that the last share has room for
  for (PlacedRun run : runs)
    while (run.begin < run.end) {
      if (left == 0) {
        shares.emplace_back();
        left = most;
      }
      const std::size_t rows = std::min(left, run.end - run.begin);
      shares.back().push_back({run.group, run.position, run.begin, run.begin + rows});
      run.position += static_cast<long>(rows), run.begin += rows, left -= rows;
    }
  return shares;
}

/// One kind of element.
struct Table {
  int dimension, type, stride;
  const std::vector<int>& nodes;
  const PlacedRows& rows;
  Blocks blocks{};

  long record_bytes() const { return tag_bytes * (1 + stride); }
};

class Msh4Writer : public MeshWriter {
 public:
  Msh4Writer(HeldMesh held, bool is_ascii, Ranks& ranks)
      : result_(held.result),
        mesh_(held.result.mesh),
        is_ascii_(is_ascii),
        is_first_(ranks.rank() == 0),
        numbering_(held, ranks) {
    lay_out_file(ranks);
  }

  long file_bytes() const override { return is_ascii_ ? 0 : end_ + static_cast<long>(ending_.size()); }

  void write(AtomicFile& file) const override {
    MshNumbers out(file, is_ascii_);
    write_text(0, beginning_, out);
    auto nodes = [&](int dimension, const PlacedRows& rows, const Blocks& blocks) {
      write_runs(rows.runs, file, out,
                 [&](const PlacedRun& run, MshNumbers& to) { write_nodes(dimension, rows, blocks, run, to); });
    };
    nodes(1, numbering_.curve_nodes, curve_blocks_);
    nodes(2, numbering_.surface_nodes, surface_blocks_);
    write_text(middle_at_, middle_, out);
    for (const Table* table : {&points_, &lines_, &triangles_, &quads_})
      write_runs(table->rows.runs, file, out,
                 [&](const PlacedRun& run, MshNumbers& to) { write_elements(*table, run, to); });
    write_text(end_, ending_, out);
  }

 private:
  /// Text from the first run to the last; else threads write some of them each, wherever these are.
  template <class Write>
  void write_runs(const std::vector<PlacedRun>& runs, const AtomicFile& file, MshNumbers& out, Write write) const {
    if (is_ascii_) {
      for (const PlacedRun& run : runs) write(run, out);
      return;
    }
    const std::vector<std::vector<PlacedRun>> shares = shares_of(runs);
    run_stretches(shares.size(), 1, [&](std::size_t i, std::size_t) {
      FilePiece piece(file);
      MshNumbers to(piece, false);
      for (const PlacedRun& run : shares[i]) write(run, to);
      piece.finish();
    });
  }

  void lay_out_file(Ranks& ranks) {
    MemorySink beginning, middle, ending;
    MshNumbers first(beginning, is_ascii_), between(middle, is_ascii_), last(ending, is_ascii_);
    write_msh4_beginning(result_, numbering_, ranks, first);
    const PlacedRows &curve_nodes = numbering_.curve_nodes, &surface_nodes = numbering_.surface_nodes;
    write_msh4_head(curve_nodes.used_groups() + surface_nodes.used_groups(), numbering_.tags.count, first);
    beginning_ = beginning.content();
    between.end_section("Nodes");
    middle.write("$Elements\n");
    std::size_t blocks = 0;
    long total = 0;
    for (const Table* table : {&points_, &lines_, &triangles_, &quads_})
      blocks += table->rows.used_groups(), total += table->rows.total();
    write_msh4_head(blocks, total, between);
    middle_ = middle.content();
    last.end_section("Elements");
    ending_ = ending.content();

    long nodes = 0, elements = 0;
    end_ = static_cast<long>(beginning_.size());
    curve_blocks_ = lay_out(curve_nodes, tag_bytes + point_bytes, end_, nodes);
    surface_blocks_ = lay_out(surface_nodes, tag_bytes + point_bytes, end_, nodes);
    middle_at_ = end_;
    end_ += static_cast<long>(middle_.size());
    for (Table* table : {&points_, &lines_, &triangles_, &quads_})
      table->blocks = lay_out(table->rows, table->record_bytes(), end_, elements);
  }

  void write_text(long at, const std::string& text, MshNumbers& out) const {
    if (!is_first_) return;
    out.seek(at);
    out.sink().write(text);
  }

  static void write_head(int dimension, int entity, int kind, long count, MshNumbers& out) {
    for (int value : {dimension, entity + 1, kind}) out.integer(value);
    out.count(static_cast<std::size_t>(count));
    out.end_line();
  }

  void write_nodes(int dimension, const PlacedRows& rows, const Blocks& blocks, const PlacedRun& run,
                   MshNumbers& out) const {
    const auto group = static_cast<std::size_t>(run.group);
    const long tags_at = blocks.offset[group] + head_bytes;
    out.seek(run.position == 0 ? blocks.offset[group] : tags_at + run.position * tag_bytes);
    if (run.position == 0) write_head(dimension, run.group, 0, rows.size[group], out);
    for (std::size_t i = run.begin; i < run.end; ++i) {
      out.count(static_cast<std::size_t>(numbering_.tags.of_node[rows.held.rows[i]]));
      out.end_line();
    }
    out.seek(tags_at + rows.size[group] * tag_bytes + run.position * point_bytes);
    for (std::size_t i = run.begin; i < run.end; ++i) {
      out.point(mesh_.nodes[rows.held.rows[i]]);
      out.end_line();
    }
  }

  void write_elements(const Table& table, const PlacedRun& run, MshNumbers& out) const {
    const auto group = static_cast<std::size_t>(run.group);
    const long at = table.blocks.offset[group];
    out.seek(run.position == 0 ? at : at + head_bytes + run.position * table.record_bytes());
    if (run.position == 0) write_head(table.dimension, run.group, table.type, table.rows.size[group], out);
    auto number = static_cast<std::size_t>(table.blocks.before[group] + run.position);
    for (std::size_t i = run.begin; i < run.end; ++i) {
      const int* nodes = table.nodes.data() + static_cast<std::ptrdiff_t>(table.rows.held.rows[i]) * table.stride;
      out.count(++number);
      for (int k = 0; k < table.stride; ++k) out.count(static_cast<std::size_t>(numbering_.tags.of_node[nodes[k]]));
      out.end_line();
    }
  }

  const MeshResult& result_;
  const SurfaceMesh& mesh_;
  const bool is_ascii_, is_first_;
  const Numbering numbering_;
  Table points_{0, gmsh_point_type, 1, mesh_.points, numbering_.points};
  Table lines_{1, gmsh_line_type(mesh_.order), mesh_.order + 1, mesh_.lines, numbering_.lines};
  Table triangles_{2, gmsh_triangle_type(mesh_.order), mesh_.nodes_per_triangle(), mesh_.triangles,
                   numbering_.triangles};
  Table quads_{2, gmsh_quad_type(mesh_.order), mesh_.nodes_per_quad(), mesh_.quads, numbering_.quads};
  Blocks curve_blocks_, surface_blocks_;
  std::string beginning_, middle_, ending_;
  long middle_at_ = 0, end_ = 0;
};

}  // namespace

std::unique_ptr<MeshWriter> msh4_writer(HeldMesh held, bool is_ascii, Ranks& ranks) {
  return std::make_unique<Msh4Writer>(held, is_ascii, ranks);
}

}  // namespace paver
