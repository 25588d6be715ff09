// Sides with a node that only one part has are looked at part by part: dealt into one bucket per upper node, which is
// the part's own, and sorted there. Linear in the number of elements. The others are listed for check_shared().
#include <algorithm>
#include <mutex>

#include "base/tasks/tasks.h"
#include "check/sides/sides_impl.h"
#include "mesh/element_table.h"

namespace paver {
namespace {

/// Elements of one part, quads first.
class PartSideCheck {
 public:
  PartSideCheck(const CheckedMesh& checked, std::size_t part, const PartRows& first, MeshFaults& faults,
                SharedLists& shared)
      : checked_(checked),
        mesh_(checked.mesh),
        sizes_(checked.sizes[part]),
        first_(first),
        face_(checked.parts[part].region->face),
        faults_(faults),
        shared_(shared) {}

  void run() {
    deal();
    for (std::size_t v = 0; v + 1 < start_.size(); ++v) check_bucket(static_cast<int>(v) + first_.node);
  }

 private:
  /// Of the side from corner k on.
  struct Use {
    int low, element, k;
  };
  struct Corners {
    const int* v;
    int n;
    int next(int k) const { return v[k + 1 < n ? k + 1 : 0]; }
    int middle(int k, int order) const { return order == 1 ? -1 : v[n + k]; }
  };

  Corners corners_of(int element) const {
    const bool is_quad = element < sizes_.quads;
    const auto row = static_cast<std::size_t>(is_quad ? element : element - sizes_.quads);
    const ElementTable table(mesh_, is_quad);
    return {table.row(row + (is_quad ? first_.quad : first_.triangle)), table.corners};
  }

  template <class Function>
  void for_each_side(Function f) const {
    for (int e = 0; e < static_cast<int>(sizes_.quads + sizes_.triangles); ++e) {
      const Corners c = corners_of(e);
      for (int k = 0; k < c.n; ++k) f(e, k, std::min(c.v[k], c.next(k)), std::max(c.v[k], c.next(k)));
    }
  }

  void deal() {
    start_.assign(static_cast<std::size_t>(sizes_.nodes) + 1, 0);
    for_each_side([&](int e, int k, int, int high) {
      if (high >= checked_.shared_nodes)
        ++start_[static_cast<std::size_t>(high - first_.node) + 1];
      else
        list_shared(e, k);
    });
    for (std::size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
    uses_.resize(static_cast<std::size_t>(start_.back()));
    std::vector<int> next(start_.begin(), start_.end() - 1);
    for_each_side([&](int e, int k, int low, int high) {
      if (high < checked_.shared_nodes) return;
      uses_[next[high - first_.node]++] = {low, e, k};
    });
  }

  void list_shared(int e, int k) {
    const Corners c = corners_of(e);
    const int a = c.v[k], b = c.next(k), middle = c.middle(k, mesh_.order);
    const long from = checked_.number(a), to = checked_.number(b);
    shared_.sides.push_back({std::min(from, to), std::max(from, to), middle < 0 ? -1 : checked_.number(middle), face_,
                             from < to ? 1 : -1, checked_.middle(a, b), heading(c, k)});
    if (k > 0 || *std::max_element(c.v, c.v + c.n) >= checked_.shared_nodes) return;
    SharedElement element;
    for (int i = 0; i < c.n; ++i) element.corners[i] = checked_.number(c.v[i]);
    std::sort(element.corners.begin(), element.corners.end());
    element.face = face_;
    element.where = checked_.middle(c.v[0], c.v[2]);
    shared_.elements.push_back(element);
  }

  /// From the middle of side k of an element towards what lies opposite, as curved.
  Heading heading(const Corners& c, int k) const {
    const Vec3 from = mesh_.nodes[c.v[k]], to = mesh_.nodes[c.next(k)], along = unit(to - from);
    Vec3 start, half, end;
    if (mesh_.order == 1) {
      start = 0.5 * (from + to);
      end = c.n == 3 ? mesh_.nodes[c.v[(k + 2) % 3]]
                     : 0.5 * (mesh_.nodes[c.v[(k + 2) % 4]] + mesh_.nodes[c.v[(k + 3) % 4]]);
      half = 0.5 * (start + end);
    } else {
      auto middle = [&](int side) { return mesh_.nodes[c.v[c.n + side % c.n]]; };
      start = middle(k);
      end = c.n == 3 ? mesh_.nodes[c.v[(k + 2) % 3]] : middle(k + 2);
      half =
          c.n == 4 ? mesh_.nodes[c.v[8]] : 0.25 * start + 0.5 * (middle(k + 1) + middle(k + 2)) - 0.125 * (from + to);
    }
    const Vec3 slope = 4 * half - 3 * start - end, across = slope - dot(slope, along) * along, way = half - start;
    Heading found{unit(across), 0};
    const double reach = dot(way, found.inward);
    found.bend = dot(way, cross(along, found.inward)) / (reach * reach) * norm(to - from);
    return found;
  }

  void check_bucket(int high) {
    Use* begin = uses_.data() + start_[high - first_.node];
    Use* end = uses_.data() + start_[static_cast<std::size_t>(high - first_.node) + 1];
    std::sort(begin, end, [](const Use& a, const Use& b) { return a.low < b.low; });
    while (begin != end) {
      Use* next = std::find_if(begin, end, [&](const Use& use) { return use.low != begin->low; });
      if (next - begin != 2 || !is_pair(begin[0], begin[1]))
        faults_.add(face_, FaultKind::side, checked_.middle(begin->low, high));
      else if (is_top(begin[0], high) && has_same_corners(begin[0].element, begin[1].element))
        faults_.add(face_, FaultKind::same_element, checked_.middle(begin->low, high));
      begin = next;
    }
  }

  bool is_pair(const Use& one, const Use& other) const {
    const Corners a = corners_of(one.element), b = corners_of(other.element);
    return a.v[one.k] == b.next(other.k) && a.middle(one.k, mesh_.order) == b.middle(other.k, mesh_.order);
  }

  /// Of an element's sides one: so that two elements are compared once.
  bool is_top(const Use& use, int high) const {
    const Corners c = corners_of(use.element);
    const int at = c.v[use.k] == high ? use.k : (use.k + 1) % c.n;
    return *std::max_element(c.v, c.v + c.n) == high && std::min(c.next(at), c.v[(at + c.n - 1) % c.n]) == use.low;
  }

  bool has_same_corners(int one, int other) const {
    const Corners a = corners_of(one), b = corners_of(other);
    return a.n == b.n && std::is_permutation(a.v, a.v + a.n, b.v);
  }

  const CheckedMesh& checked_;
  const SurfaceMesh& mesh_;
  const PartSizes& sizes_;
  const PartRows first_;  // of the part in the mesh
  const int face_;
  MeshFaults& faults_;
  SharedLists& shared_;
  std::vector<int> start_;  // buckets: those of the part's node i are uses_[start_[i]] to uses_[start_[i + 1]]
  std::vector<Use> uses_;
};

}  // namespace

void check_sides(const CheckedMesh& checked, int threads, const Progress& progress, Ranks& ranks, MeshFaults& faults) {
  const std::vector<PartRows> first = part_rows(checked.sizes, checked.shared_nodes);
  std::mutex mutex;
  SharedLists shared;
  run_tasks(threads, part_costs(checked.sizes), [&](int i) {
    progress.check();
    if (!checked.parts[i].mesh) return;
    MeshFaults found;
    SharedLists lists;
    PartSideCheck(checked, static_cast<std::size_t>(i), first[i], found, lists).run();
    std::lock_guard lock(mutex);
    faults.add(found);
    shared.sides.insert(shared.sides.end(), lists.sides.begin(), lists.sides.end());
    shared.elements.insert(shared.elements.end(), lists.elements.begin(), lists.elements.end());
  });
  check_shared(checked, shared, ranks, faults);
}

}  // namespace paver
