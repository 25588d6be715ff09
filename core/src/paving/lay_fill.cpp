// In: region with its loop. Out: the loop's nodes on the outline of a grid, one surface evaluation for each one inside.
#include "paving/lay_fill.h"

#include <algorithm>

namespace paver {
namespace {

class Filler {
 public:
  explicit Filler(const Region& region)
      : region_(region),
        fill_(*region.fill),
        columns_(fill_.columns()),
        node_(static_cast<std::size_t>(columns_ + 1) * (fill_.rows() + 1), -1) {}

  std::optional<RegionMesh> run() {
    mesh_.reserve(node_.size());
    add_outline();
    for (int j = 1; j < fill_.rows(); ++j)
      for (int i = 1; i < columns_; ++i)
        at(i, j) = add_node(fill_.block->place(fill_.first[0] + i, fill_.first[1] + j));
    for (int j = 0; j < fill_.rows(); ++j)
      for (int i = 0; i < columns_; ++i) add_quad({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    if (!are_all_positive(mesh_)) return std::nullopt;
    return std::move(mesh_);
  }

 private:
  int& at(int i, int j) { return node_[static_cast<std::size_t>(j) * (columns_ + 1) + i]; }

  void add_outline() {
    const std::vector<LoopNode>& loop = region_.loops[0];
    const auto outline = fill_.outline();
    for (std::size_t k = 0; k < loop.size(); ++k) {
      at(outline[k][0] - fill_.first[0], outline[k][1] - fill_.first[1]) = paver::add_node(region_, loop[k], mesh_);
    }
  }

  int add_node(Vec2 p) {
    NodePlace at;
    at.p = p;
    const Vec2 uv = region_.evaluate(p, at.x, at.xp, at.xq);
    return mesh_.add_node(at, region_.size.at(uv, *region_.surface));
  }

  void add_quad(Corners quad) {
    if (fill_.block->is_clockwise) std::swap(quad[1], quad[3]);
    mesh_.add_element(quad);
  }

  const Region& region_;
  const MappedFill& fill_;
  const int columns_;
  std::vector<int> node_;  // row by row
  RegionMesh mesh_;
};

}  // namespace

std::optional<RegionMesh> lay_fill(const Region& region) {
  if (!region.fill) return std::nullopt;
  return Filler(region).run();
}

}  // namespace paver
