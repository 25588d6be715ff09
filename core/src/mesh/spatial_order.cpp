// Morton's order: the bits of both coordinates interleaved. Paving numbers nodes row by row; of a million nodes
// two rows no longer fit in a processor's second-level cache, and clean-up waits for memory.
#include "mesh/spatial_order.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "base/box.h"

namespace paver {
namespace {

constexpr double cells = 65535;  // along each coordinate

std::uint64_t spread_bits(std::uint64_t k) {
  k = (k | (k << 8)) & 0x00FF00FFu;
  k = (k | (k << 4)) & 0x0F0F0F0Fu;
  k = (k | (k << 2)) & 0x33333333u;
  return (k | (k << 1)) & 0x55555555u;
}

std::vector<int> number_along_curve(const std::vector<Vec2>& p) {
  Box box;
  for (Vec2 q : p) box.add(q);
  const auto& [low, high] = box;
  const double scale = cells / std::max({high.x - low.x, high.y - low.y, 1e-300});
  std::vector<std::uint64_t> order;  // place on the curve, then old number
  order.reserve(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) {
    auto x = static_cast<std::uint64_t>((p[i].x - low.x) * scale),
         y = static_cast<std::uint64_t>((p[i].y - low.y) * scale);
    order.push_back((spread_bits(x) | (spread_bits(y) << 1)) << 32 | i);
  }
  std::sort(order.begin(), order.end());
  std::vector<int> number(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) number[order[i] & 0xFFFFFFFFu] = static_cast<int>(i);
  return number;
}

template <class T>
void permute(std::vector<T>& values, const std::vector<int>& number) {
  std::vector<T> old;
  old.reserve(values.capacity());
  old.swap(values);
  values.resize(old.size());
  for (std::size_t i = 0; i < old.size(); ++i) values[number[i]] = old[i];
}

// By their smallest node.
std::vector<Element> ordered(const std::vector<Element>& elements, std::size_t node_count) {
  auto key = [](const Element& e) { return std::ranges::min(e.nodes()); };
  std::vector<int> start(node_count + 1, 0);
  for (const Element& e : elements)
    if (e.is_alive()) ++start[key(e) + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<Element> result;
  result.reserve(elements.capacity());
  result.resize(start.back());
  for (const Element& e : elements)
    if (e.is_alive()) result[start[key(e)]++] = e;
  return result;
}

}  // namespace

std::vector<int> order_spatially(RegionMesh& mesh) {
  if (mesh.p.empty()) return {};
  std::vector<int> number = number_along_curve(mesh.p);
  permute(mesh.p, number), permute(mesh.x, number), permute(mesh.xp, number), permute(mesh.xq, number);
  if (mesh.has_turns()) permute(mesh.turn, number);
  permute(mesh.drift, number), permute(mesh.h, number), permute(mesh.is_fixed, number), permute(mesh.global, number);
  for (Element& e : mesh.elements)
    for (int& v : e.v)
      if (v >= 0) v = number[v];
  mesh.elements = ordered(mesh.elements, mesh.p.size());
  mesh.find_stars();
  return number;
}

}  // namespace paver
