// 64-bit FNV-1a of a mesh, eight bytes at a step: every number of the mesh in its order.
#include <bit>

#include "paver/output.h"

namespace paver {
namespace {

class Fnv {
 public:
  void add(std::uint64_t value) { hash_ = (hash_ ^ value) * prime; }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(const std::vector<int>& values) {
    add(static_cast<std::uint64_t>(values.size()));
    for (int value : values) add(static_cast<std::uint64_t>(value));
  }
  std::uint64_t value() const { return hash_; }

 private:
  static constexpr std::uint64_t prime = 0x100000001b3;
  std::uint64_t hash_ = 0xcbf29ce484222325;
};

}  // namespace

std::uint64_t checksum(const SurfaceMesh& mesh) {
  Fnv hash;
  hash.add(static_cast<std::uint64_t>(mesh.order));
  for (Vec3 x : mesh.nodes) hash.add(x.x), hash.add(x.y), hash.add(x.z);
  for (const std::vector<int>* table :
       {&mesh.quads, &mesh.quad_face, &mesh.triangles, &mesh.triangle_face, &mesh.lines, &mesh.line_edge}) {
    hash.add(*table);
  }
  return hash.value();
}

}  // namespace paver
