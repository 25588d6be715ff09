// Part by part, with what the part knows of its nodes: places in the chart and derivatives there. What these say of an
// element comes first; the surface is asked where that leaves a doubt.
#include <algorithm>
#include <mutex>

#include "base/tasks/tasks.h"
#include "check/checked_mesh.h"
#include "check/direction.h"
#include "check/distance/element_patch.h"
#include "check/vector_area.h"
#include "curving/near_surface.h"
#include "mesh/element_table.h"

namespace paver {
namespace {

constexpr double off_corner = 1e-6;   // of the target length; corners are placed on the surface itself
constexpr double off_inner = 1e-4;    // of the chord or diagonal
constexpr double steep = 0.7;         // cosine between an element's normal and that of the surface at a corner
constexpr double most_inside = 0.25;  // of the target length, and of the element's own

class PartElementCheck {
 public:
  PartElementCheck(const CheckedMesh& checked, std::size_t part, const PartRows& first, MeshFaults& faults,
                   ExactSum& slack)
      : checked_(checked),
        mesh_(checked.mesh),
        part_(checked.parts[part]),
        region_(*part_.mesh),
        first_(first),
        is_reversed_(checked.model.faces[part_.region->face].is_reversed),
        faults_(faults),
        slack_(slack) {}

  void run() {
    check_corners();
    std::size_t quad = first_.quad, triangle = first_.triangle;
    for (const Element& element : region_.elements) {
      if (!element.is_alive()) continue;
      n_ = element.corners();
      v_ = ElementTable(mesh_, n_ == 4).row(n_ == 4 ? quad++ : triangle++);
      for (int k = 0; k < n_; ++k) c_[k] = element.v[is_reversed_ ? (n_ - k) % n_ : k];
      check_element();
    }
  }

 private:
  int face() const { return part_.region->face; }
  int next(int k) const { return k + 1 < n_ ? k + 1 : 0; }
  Vec3 node(int k) const { return mesh_.nodes[v_[k]]; }

  void check_corners() {
    normals_.resize(region_.p.size());
    for (int v = 0; v < region_.node_count(); ++v) {
      if (region_.star[v].size() == 0) continue;
      normals_[v] = (is_reversed_ ? -1 : 1) * region_.normal(v);
      if (region_.global[v] >= 0) continue;
      const Vec3 x = mesh_.nodes[(*part_.node_of)[v]];
      if (!(norm(part_.region->point(region_.p[v]) - x) <= off_corner * region_.h[v]))
        faults_.add(face(), FaultKind::off_surface, x);
    }
  }

  void check_element() {
    const Vec3 area = twice_area(n_, mesh_.order > 1, [&](int k) { return node(k); });
    is_moved_ = false;
    least_along_ = least_along(unit(area));
    if (mesh_.order > 1) {
      check_inner_nodes();
      if (least_along_ < steep) check_inside();
    } else {
      check_chords();
    }
    check_direction(area);
    slack_.add(element_slack(0.5 * norm(area), least_along_, mesh_.order > 1 && !is_moved_));
  }

  void check_direction(Vec3 area) {
    ElementNormals normals{area, mesh_.order == 1 ? area : centre_normal(n_, [&](int k) { return node(k); }), {}};
    std::array<Vec2, 4> places;
    for (int k = 0; k < n_; ++k) {
      normals.corners += normals_[c_[k]];
      places[k] = region_.p[c_[k]];
    }
    if (is_reversed_) normals = {-1 * normals.area, -1 * normals.centre, -1 * normals.corners};
    if (!runs_with_surface(*part_.region, n_, places, normals))
      faults_.add(face(), FaultKind::turned, 0.5 * (node(0) + node(2)));
  }

  Vec2 middle_of_corners() const {
    Vec2 p;
    for (int k = 0; k < n_; ++k) p = p + (1.0 / n_) * region_.p[c_[k]];
    return p;
  }

  /// Cosine of the largest angle from the element's normal to the surface's at a corner.
  double least_along(Vec3 normal) const {
    double least = 1;
    for (int k = 0; k < n_; ++k)
      if (const Vec3 at = normals_[c_[k]]; dot(at, at) > 0) least = std::min(least, dot(normal, at));
    return least;
  }

  /// At order 1. Sides between nodes of the boundary are as far off as the division of edges lets them be.
  void check_chords() {
    if (least_along_ >= nearly_flat) return;
    const double h = part_.region->h;
    Vec3 centre;
    for (int k = 0; k < n_; ++k) {
      const int a = c_[k], b = c_[next(k)];
      centre += (1.0 / n_) * node(k);
      if (v_[k] > v_[next(k)] || (region_.global[a] >= 0 && region_.global[b] >= 0)) continue;
      const SideCubic side(region_, a, b);
      const Vec3 x = 0.5 * (side.a + side.b);
      if (side.is_smooth() && norm(middle_of(side) - x) <= 0.5 * most_off_side * h) continue;
      if (!is_near_surface(x, guess_middle(*part_.region, region_, a, b, {}), norm(side.b - side.a), most_off_side * h))
        add_chord(x);
    }
    if (!is_near_surface(centre, middle_of_corners(), norm(node(2) - node(0)), most_off_centre * h)) add_chord(centre);
  }

  /// Of order 2, where the surface turns far from it: its nodes may lie on the surface and all between elsewhere.
  void check_inside() {
    ElementPatch patch;
    patch.corners = n_, patch.order = mesh_.order;
    for (int k = 0; k < (n_ == 4 ? 9 : 6); ++k) patch.nodes[k] = node(k);
    const double size = std::max(norm(node(2) - node(0)), norm(node(n_ - 1) - node(1)));
    const double most = most_inside * std::min(part_.region->h, size);
    for (double s : {0.25, 0.75})
      for (double t : {0.25, 0.75}) {
        if (n_ == 3 && s + t > 1) continue;
        const Vec3 x = patch.at({s, t});
        if (!is_near_surface(x, place(s, t), norm(node(2) - node(0)), most)) return add_chord(x);
      }
  }

  void add_chord(Vec3 x) { faults_.add(face(), FaultKind::chord, x); }

  void check_inner_nodes() {
    Vec3 blend = -0.25 * (node(0) + node(1) + node(2) + (n_ == 4 ? node(3) : Vec3{}));
    for (int k = 0; k < n_; ++k) {
      const SideCubic side(region_, c_[k], c_[next(k)]);
      if (n_ == 4) blend += 0.5 * middle_of(side);
      // A side inside is looked at with one of its two elements.
      if (v_[k] < v_[next(k)] && mesh_.node_edge[v_[n_ + k]] < 0) check_middle(k, side);
    }
    if (n_ == 4) check_centre(blend);
    for (int k = n_; k < (n_ == 4 ? 9 : 6); ++k) is_moved_ = is_moved_ || is_moved(v_[k]);
  }

  bool is_moved(int node) const {
    return !checked_.moved.empty() && std::binary_search(checked_.moved.begin(), checked_.moved.end(), node);
  }

  static Vec3 middle_of(const SideCubic& side) { return 0.5 * (side.a + side.b) + 0.125 * (side.first - side.last); }

  void check_middle(int k, const SideCubic& side) {
    const Vec3 x = node(n_ + k);
    const double length = norm(side.b - side.a);
    const Vec3 normal = normals_[c_[k]] + normals_[c_[next(k)]];
    if (is_near(x - middle_of(side), normal, length)) return;
    const Vec2 guess = guess_middle(*part_.region, region_, c_[k], c_[next(k)], x - 0.5 * (side.a + side.b));
    check_distance(v_[n_ + k], guess, length);
  }

  void check_centre(Vec3 blend) {
    Vec3 normal;
    for (int k = 0; k < 4; ++k) normal += normals_[c_[k]];
    const double length = norm(node(2) - node(0));
    if (!is_near(node(8) - blend, normal, length)) check_distance(v_[8], guess_centre(), length);
  }

  /// As the centre of the sides' middles, in the chart.
  Vec2 guess_centre() const {
    std::array<Vec2, 4> middles;
    for (int k = 0; k < 4; ++k)
      middles[k] =
          guess_middle(*part_.region, region_, c_[k], c_[next(k)], node(4 + k) - 0.5 * (node(k) + node(next(k))));
    return paver::guess_centre(*part_.region, region_, c_, middles);
  }

  /// Near what the corners let expect, and along the surface from there.
  static bool is_near(Vec3 off, Vec3 normal, double length) {
    constexpr double most_along = 0.25;
    const double across = dot(off, normal);
    return across * across <= off_inner * off_inner * length * length * dot(normal, normal) &&
           dot(off, off) <= most_along * most_along * length * length;
  }

  void check_distance(int node, Vec2 guess, double length) {
    const Vec3 x = mesh_.nodes[node];
    if (is_moved(node)) {
      if (!is_near_surface(x, guess, length, most_off_moved * part_.region->h))
        faults_.add(face(), FaultKind::chord, x);
    } else if (!is_near_surface(x, guess, length, off_inner * length)) {
      faults_.add(face(), FaultKind::off_surface, x);
    }
  }

  /// Looks from all over the element, too: where the surface bends much, or the chart, as at an apex, the way from the
  /// guess may lead elsewhere.
  bool is_near_surface(Vec3 x, Vec2 guess, double length, double most) const {
    auto is_found_from = [&](Vec2 start) { return distance_to_surface(*part_.region, start, x, length, most) <= most; };
    if (is_found_from(guess) || is_found_from(middle_of_corners())) return true;
    for (double s : {0.0, 0.25, 0.5, 0.75, 1.0})
      for (double t : {0.0, 0.25, 0.5, 0.75, 1.0})
        if (is_found_from(place(s, t))) return true;
    return false;
  }

  /// In the chart, bilinear between the corners.
  Vec2 place(double s, double t) const {
    auto p = [&](int k) { return region_.p[c_[std::min(k, n_ - 1)]]; };
    return (1 - t) * ((1 - s) * p(0) + s * p(1)) + t * ((1 - s) * p(3) + s * p(2));
  }

  const CheckedMesh& checked_;
  const SurfaceMesh& mesh_;
  const MeshPart& part_;
  const RegionMesh& region_;
  const PartRows first_;  // of the part in the mesh
  const bool is_reversed_;
  MeshFaults& faults_;
  ExactSum& slack_;
  std::vector<Vec3> normals_;  // per node of the part, zero where it has none
  // The element that is looked at: nodes in the mesh, corners in the part, whether a node was moved to mend it.
  const int* v_ = nullptr;
  int n_ = 0;
  std::array<int, 4> c_{};
  bool is_moved_ = false;
  double least_along_ = 1;  // see least_along()
};

}  // namespace

void check_elements(const CheckedMesh& checked, int threads, const Progress& progress, MeshFaults& faults,
                    AreaSlack& slack) {
  const std::vector<PartRows> first = part_rows(checked.sizes);
  std::mutex mutex;
  run_tasks(threads, part_costs(checked.sizes), [&](int i) {
    progress.check();
    if (!checked.parts[i].mesh) return;
    MeshFaults found;
    ExactSum sum = slack.none(checked.parts[i].region->face);
    PartElementCheck(checked, static_cast<std::size_t>(i), first[i], found, sum).run();
    std::lock_guard lock(mutex);
    faults.add(found);
    slack.add(checked.parts[i].region->face, sum);
  });
}

}  // namespace paver
