// What the writers of .msh 4.1 have in common, for one process and for several.
#pragma once

#include <fmt/format.h>

#include <limits>

#include "output/byte_sink_impl.h"
#include "output/numbering_impl.h"

namespace paver {

/// Numbers of a section as text with blanks between them, or packed.
class Msh4Numbers {
 public:
  Msh4Numbers(ByteSink& sink, bool is_ascii) : sink_(sink), is_ascii_(is_ascii) {}

  void count(std::size_t value) { is_ascii_ ? text(value) : sink_.write_packed<std::uint64_t>(value); }
  void integer(int value) { is_ascii_ ? text(value) : sink_.write_packed(value); }
  void real(double value) { is_ascii_ ? text(value) : sink_.write_packed(value); }
  void point(Vec3 x) { real(x.x), real(x.y), real(x.z); }

  /// Ends a line of text; nothing in binary.
  void end_line() {
    if (!is_ascii_) return;
    line_.push_back('\n');
    sink_.write(line_.data(), line_.size());
    line_.clear();
  }
  void end_section(const char* name) { sink_.write(fmt::format("{}$End{}\n", is_ascii_ ? "" : "\n", name)); }

 private:
  template <class T>
  void text(T value) {
    if (line_.size()) line_.push_back(' ');
    fmt::format_to(std::back_inserter(line_), "{}", value);
  }

  ByteSink& sink_;
  bool is_ascii_;
  fmt::memory_buffer line_;
};

/// Range of coordinates; none at first.
struct Box {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  Vec3 low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};

  bool is_empty() const { return low.x > high.x; }
  void add(Vec3 x) {
    low = {std::min(low.x, x.x), std::min(low.y, x.y), std::min(low.z, x.z)};
    high = {std::max(high.x, x.x), std::max(high.y, x.y), std::max(high.z, x.z)};
  }
};

/// Grows the box of each row's entity by the nodes of the row. `entity_of`: 0-based face or edge per row.
void add_boxes(const SurfaceMesh& mesh, const std::vector<int>& table, const std::vector<int>& entity_of,
               std::vector<Box>& boxes);

/// Curves and surfaces of the file.
struct Msh4Entities {
  std::vector<Box> curves, surfaces;  ///< per edge, per face; empty: no such entity
  Groups groups;
  std::vector<std::vector<int>> face_edges;
};

/// The file down to the head of its section for nodes: format, physical names, entities.
void write_msh4_beginning(const Msh4Entities& entities, bool is_ascii, ByteSink& sink);

/// Blocks, total, lowest and highest tag: how the sections for nodes and elements begin.
void write_msh4_head(std::size_t blocks, std::size_t total, Msh4Numbers& out);

}  // namespace paver
