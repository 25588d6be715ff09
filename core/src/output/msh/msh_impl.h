// The sections of a .msh file: how numbers are written, and what stands before the nodes.
#pragma once

#include <fmt/format.h>

#include <iterator>

#include "output/byte_sink_impl.h"
#include "output/numbering_impl.h"

namespace paver {

/// Numbers of a section as text with blanks between them, or packed.
class MshNumbers {
 public:
  MshNumbers(ByteSink& sink, bool is_ascii) : sink_(sink), is_ascii_(is_ascii) {}

  bool is_ascii() const { return is_ascii_; }
  ByteSink& sink() { return sink_; }
  /// Where the next number belongs; text goes on where it is.
  void seek(long offset) {
    if (!is_ascii_) sink_.seek(offset);
  }
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

/// What both Gmsh formats start with: the format and its version, and the names of the groups where there are any.
void write_msh_beginning(const char* version, const Groups& groups, MshNumbers& out);

/// Collective. The file down to the head of its section for nodes: format, physical names, entities.
void write_msh4_beginning(const MeshResult& result, const Numbering& numbering, Ranks& ranks, MshNumbers& out);

/// Blocks, total, lowest and highest tag: how the sections for nodes and elements begin.
void write_msh4_head(std::size_t blocks, long total, MshNumbers& out);

}  // namespace paver
