// 64-bit checksum of a mesh: the sum, modulo 2^64, of one well mixed number per element and per line, so that neither
// the order of elements nor who holds them matters.
//
// The number of an element follows from its kind, order, face and the exact bits of its nodes' coordinates, from its
// lowest corner on, the way round it runs. Products of 64-bit numbers, folded from 128 bits, mix them.

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstdint>

#include "base/tasks/tasks.h"
#include "mesh/element_table.h"
#include "paver/output.h"
#include "quality/jacobian/lattice.h"

namespace paver {
namespace {

using Word = std::uint64_t;
using Bits = std::array<Word, 3>;
__extension__ typedef unsigned __int128 DoubleWord;

enum class Kind : Word { quad = 1, triangle, line, further_edge, nodes, point };

// Odd numbers without pattern: the fraction digits of the golden ratio and of square roots.
constexpr Word key_a = 0x9e3779b97f4a7c15, key_b = 0x6a09e667f3bcc909, key_c = 0xbb67ae8584caa73b;

Word fold(Word a, Word b) {
  DoubleWord product = static_cast<DoubleWord>(a) * b;
  return static_cast<Word>(product) ^ static_cast<Word>(product >> 64);
}

/// Takes words in their order.
class Mix {
 public:
  Mix(Kind kind, int order, int place)
      : state_(fold(static_cast<Word>(kind) * key_a ^ key_b, static_cast<Word>(order) << 32 ^ key_c)) {
    add(static_cast<Word>(place));
  }
  void add(Word word) { state_ = fold(state_ ^ key_a, word ^ key_b) + key_c; }
  void add(const Bits& x) { state_ = fold(state_ ^ fold(x[0] ^ key_a, x[1] ^ key_b), x[2] ^ key_c) + key_a; }
  Word value() const { return fold(state_ ^ key_b, state_ ^ std::rotl(state_, 29) ^ key_c); }

 private:
  Word state_;
};

Bits bits_of(Vec3 x) { return {std::bit_cast<Word>(x.x), std::bit_cast<Word>(x.y), std::bit_cast<Word>(x.z)}; }

/// Node positions of an element as they follow each other when it starts at its second corner.
std::vector<int> turned(ElementShape shape, int p) {
  std::vector<LatticePoint> lattice = lagrange_nodes(shape, p);
  std::vector<int> positions;
  for (auto [i, j] : lattice) {
    LatticePoint from = shape == ElementShape::quad ? LatticePoint{p - j, i} : LatticePoint{p - i - j, i};
    positions.push_back(static_cast<int>(std::find(lattice.begin(), lattice.end(), from) - lattice.begin()));
  }
  return positions;
}

/// One table of elements.
class ElementNumbers {
 public:
  ElementNumbers(const SurfaceMesh& mesh, bool is_quad)
      : mesh_(mesh), kind_(is_quad ? Kind::quad : Kind::triangle), table_(mesh, is_quad) {
    ElementShape shape = is_quad ? ElementShape::quad : ElementShape::triangle;
    std::vector<int> turn = turned(shape, mesh.order), start(turn.size());
    for (std::size_t k = 0; k < start.size(); ++k) start[k] = static_cast<int>(k);
    for (int corner = 0; corner < table_.corners; ++corner) {
      starts_.push_back(start);
      std::vector<int> next;
      for (int position : turn) next.push_back(start[position]);
      start = next;
    }
  }

  Word sum() const {
    std::atomic<Word> all = 0;
    run_stretches(table_.count(), 4096, [&](std::size_t begin, std::size_t end) {
      Word sum = 0;
      for (std::size_t i = begin; i < end; ++i) sum += number(i);
      all += sum;
    });
    return all;
  }

 private:
  Word number(std::size_t element) const {
    const int* nodes = table_.row(element);
    std::array<Bits, JacobianForm::max_nodes> x;
    for (std::size_t k = 0; k < table_.stride; ++k) x[k] = bits_of(mesh_.nodes[nodes[k]]);
    auto lowest = std::min_element(x.begin(), x.begin() + table_.corners) - x.begin();
    Mix mix(kind_, mesh_.order, table_.face[element]);
    for (int position : starts_[lowest]) mix.add(x[position]);
    return mix.value();
  }

  const SurfaceMesh& mesh_;
  const Kind kind_;
  const ElementTable table_;
  std::vector<std::vector<int>> starts_;  // per corner: node positions from there on
};

Word line_number(const SurfaceMesh& mesh, Kind kind, std::size_t line, int edge) {
  Mix mix(kind, mesh.order, edge);
  for (int node : mesh.line(line)) mix.add(bits_of(mesh.nodes[node]));
  return mix.value();
}

/// Lines, points, and the number of nodes: it tells joined elements from such that only lie side by side.
Word sum_of_rest(const SurfaceMesh& mesh, long nodes) {
  Mix count(Kind::nodes, mesh.order, 0);
  count.add(static_cast<Word>(nodes));
  Word sum = count.value();
  for (std::size_t i = 0; i < mesh.line_edge.size(); ++i) sum += line_number(mesh, Kind::line, i, mesh.line_edge[i]);
  for (auto [line, edge] : mesh.further_edges)
    sum += line_number(mesh, Kind::further_edge, static_cast<std::size_t>(line), edge);
  for (int node : mesh.points) {
    Mix mix(Kind::point, mesh.order, 0);
    mix.add(bits_of(mesh.nodes[node]));
    sum += mix.value();
  }
  return sum;
}

}  // namespace

std::uint64_t checksum(const SurfaceMesh& mesh) {
  SingleRank alone;
  return checksum(mesh, whole_numbers(mesh), alone);
}

std::uint64_t checksum(const SurfaceMesh& mesh, const ShareNumbers& numbers, Ranks& ranks) {
  Word sum = ElementNumbers(mesh, true).sum() + ElementNumbers(mesh, false).sum();
  if (ranks.rank() == 0) sum += sum_of_rest(mesh, numbers.nodes);
  constexpr Word low = 0xffffffff;  // in two halves: sums over ranks must not overflow
  std::array<long, 2> halves{static_cast<long>(sum & low), static_cast<long>(sum >> 32)};
  ranks.add_up(halves);
  return static_cast<Word>(halves[0]) + (static_cast<Word>(halves[1]) << 32);
}

}  // namespace paver
