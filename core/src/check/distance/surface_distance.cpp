// In: parts with their charts, the mesh. Out: figures per face.
// Steps: of a small part all elements at several points; of a large one each at one point, not the same in neighbours,
// and those that are farthest there at all points; then sides on B-rep edges against their curves; then all ranks.
// An element of order 2 misses a smooth surface by s (s^2 - 1) along either parameter from -1 to 1, most at 0.577. One
// of order 1 misses it by s^2 - 1: at its centre, or at middles of sides. Where the surface is not smooth over an
// element a grid of points finds what these do not.
#include "check/distance/surface_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "base/tasks/gather.h"
#include "base/tasks/tasks.h"
#include "check/distance/deviation.h"
#include "curving/near_surface.h"
#include "mesh/element_table.h"
#include "quality/reduction.h"

namespace paver {
namespace {

constexpr std::size_t small_part = 2048, farthest = 64;  // elements
constexpr double half_step = 0.2113;                     // (1 - 0.577) / 2
constexpr double other_step = 1 - half_step;
constexpr Vec2 inside_quad[] = {
    {half_step, half_step}, {other_step, other_step}, {other_step, half_step}, {half_step, other_step}};
constexpr Vec2 inside_triangle[] = {{0.2, 0.2}, {0.6, 0.2}, {0.2, 0.6}};
constexpr Vec2 middles_of_quad[] = {{0.5, 0.5}, {0.5, 0}, {1, 0.5}, {0.5, 1}, {0, 0.5}};
constexpr Vec2 middles_of_triangle[] = {{1.0 / 3, 1.0 / 3}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}};
constexpr Vec2 on_sides_of_quad[] = {{half_step, 0}, {other_step, 0}, {1, half_step}, {1, other_step},
                                     {half_step, 1}, {other_step, 1}, {0, half_step}, {0, other_step}};
constexpr Vec2 on_sides_of_triangle[] = {{half_step, 0},  {other_step, 0},         {0, half_step},
                                         {0, other_step}, {half_step, other_step}, {other_step, half_step}};
constexpr double doubtful = 0.1;  // of the target length or the element's own: the search may have ended elsewhere
constexpr double bent = 0.1;      // radians from the surface: its points may miss what an element bridges
constexpr int few_steps = 4, many_steps = 8;  // of a grid of points

struct Totals {
  double largest = 0, angle = 0;
  ExactSum sum;
  long count = 0;

  explicit Totals(double unit = 1) : sum(unit) {}
  void add(const Totals& other) {
    largest = std::max(largest, other.largest), angle = std::max(angle, other.angle);
    sum.add(other.sum), count += other.count;
  }
};

class PartSampler {
 public:
  PartSampler(const DistanceTask& task, const MeshPart& part, PartRows first)
      : task_(task),
        part_(part),
        is_reversed_(task.model.faces[part.region->face].is_reversed),
        totals_(task.target_length) {
    for (const Element& e : part.mesh->elements)
      if (e.is_alive()) rows_.push_back({&e, e.corners() == 4 ? first.quad++ : first.triangle++, 0});
  }

  // A plane's elements lie in it; only its sides may miss their curves.
  Totals run() {
    totals_.count = static_cast<long>(rows_.size());
    if (part_.region->surface->kind() == SurfaceKind::plane) return totals_;
    std::vector<std::pair<double, std::size_t>> found;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      take(i);
      if (rows_.size() > small_part) {
        found.push_back({-sample(points_inside()[i % points_inside().size()]), i});
        totals_.sum.add(-found.back().first);
      } else {
        totals_.sum.add(sample_all());
      }
    }
    if (!found.empty()) std::nth_element(found.begin(), found.begin() + farthest, found.end());
    for (std::size_t k = 0; k < std::min(farthest, found.size()); ++k) {
      take(found[k].second);
      sample_all();
    }
    return totals_;
  }

  /// Elements that are farther off, after run().
  void list_far(double most, std::vector<FarPlace>& far) {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (!(rows_[i].largest > most)) continue;
      take(i);
      FarPlace& place = far.emplace_back();
      place.face = part_.region->face, place.corners = n_, place.distance = rows_[i].largest;
      std::copy_n(patch_.nodes.begin(), n_, place.x.begin());
    }
  }

 private:
  struct Row {
    const Element* element;
    std::size_t row;
    double largest;
  };

  void take(std::size_t i) {
    const Row& row = rows_[i];
    taken_ = i, n_ = row.element->corners(), angle_ = 0;
    const ElementTable table(task_.mesh, n_ == 4);
    patch_.corners = n_, patch_.order = task_.mesh.order;
    for (std::size_t k = 0; k < table.stride; ++k) patch_.nodes[k] = task_.mesh.nodes[table.row(row.row)[k]];
    size_ = norm(patch_.nodes[2] - patch_.nodes[0]);
    for (int k = 0; k < n_; ++k) {
      const int corner = row.element->v[is_reversed_ ? (n_ - k) % n_ : k];
      places_[k] = part_.mesh->p[corner];
    }
  }

  /// Of a point of the element, looked for from another one's place.
  Foot foot_from(Vec2 start, Vec2 uv) const {
    constexpr FootSearch search{.most_turn = 0.01, .least_step = 1e-7, .least_halved = 1e-7};
    return foot_on_surface(*part_.region, place_at(*part_.region, n_, places_, start), patch_.at(uv), size_, search);
  }

  double sample(Vec2 uv) {
    Foot foot = foot_from(uv, uv);
    if (!std::isfinite(foot.distance)) return 0;
    if (foot.distance > doubtful * std::min(part_.region->h, size_))
      for_grid(few_steps, [&](Vec2 start) {
        if (const Foot other = foot_from(start, uv); other.distance < foot.distance) foot = other;
      });
    const std::array<Vec3, 2> slopes = patch_.slopes(uv);
    const Vec3 normal = cross(slopes[0], slopes[1]), wanted = is_reversed_ ? -1 * foot.normal : foot.normal;
    const bool is_inside = uv.x > 0 && uv.y > 0 && (n_ == 4 ? std::max(uv.x, uv.y) : uv.x + uv.y) < 1;
    if (is_inside && norm(wanted) > 0)
      angle_ = std::max(angle_, std::atan2(norm(cross(normal, wanted)), dot(normal, wanted)));
    totals_.angle = std::max(totals_.angle, angle_);
    totals_.largest = std::max(totals_.largest, foot.distance);
    rows_[taken_].largest = std::max(rows_[taken_].largest, foot.distance);
    return foot.distance;
  }

  /// The mean of the points inside.
  double sample_all() {
    double sum = 0;
    const std::span<const Vec2> inside = points_inside();
    for (Vec2 uv : inside) sum += sample(uv);
    for (Vec2 uv : further_points()) sample(uv);
    if (angle_ > bent) for_grid(many_steps, [&](Vec2 uv) { sample(uv); });
    return sum / static_cast<double>(inside.size());
  }

  template <class Visit>
  void for_grid(int steps, Visit visit) const {
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; j <= (n_ == 4 ? steps : steps - i); ++j)
        visit(Vec2{static_cast<double>(i) / steps, static_cast<double>(j) / steps});
  }

  std::span<const Vec2> points_inside() const { return n_ == 4 ? std::span<const Vec2>(inside_quad) : inside_triangle; }

  std::span<const Vec2> further_points() const {
    if (patch_.order == 1) return n_ == 4 ? std::span<const Vec2>(middles_of_quad) : middles_of_triangle;
    return n_ == 4 ? std::span<const Vec2>(on_sides_of_quad) : on_sides_of_triangle;
  }

  const DistanceTask& task_;
  const MeshPart& part_;
  const bool is_reversed_;
  std::vector<Row> rows_;
  Totals totals_;
  std::size_t taken_ = 0;  // of rows_
  int n_ = 4;
  double size_ = 0, angle_ = 0;  // of the element
  ElementPatch patch_;
  std::array<Vec2, 4> places_{};
};

/// Largest distance between an edge's curve and a side on it.
double side_distance(const Edge& edge, const EdgeDivision& division, std::size_t interval, int order) {
  const double* t = &division.t[2 * interval];
  const Vec3* x = &division.x[2 * interval];
  ElementPatch side;
  side.corners = 2, side.order = order, side.nodes = {x[0], x[2], x[1]};
  auto off = [&](Vec3 point, double start) { return norm(point - side.at(side.nearest(point, {start, 0}))); };
  if (order == 1) return off(x[1], 0.5);
  return std::max(off(edge.curve->point(0.5 * (t[0] + t[1])), 0.25), off(edge.curve->point(0.5 * (t[1] + t[2])), 0.75));
}

class Measurer {
 public:
  Measurer(const DistanceTask& task, const Progress& progress, Ranks& ranks)
      : task_(task), progress_(progress), ranks_(ranks), faces_(task.model.faces.size(), Totals(task.target_length)) {}

  MeshDistances run() {
    add_parts();
    exchange();
    add_edges();
    MeshDistances result;
    result.far = std::move(far_);
    for (const Totals& face : faces_)
      result.faces.push_back(
          {face.largest, face.count > 0 ? face.sum.total() / static_cast<double>(face.count) : 0, face.angle});
    return result;
  }

 private:
  void add_parts() {
    const std::vector<PartRows> first = part_rows(task_.sizes);
    std::vector<Totals> totals(task_.parts.size(), Totals(task_.target_length));
    std::vector<std::vector<FarPlace>> far(task_.parts.size());
    run_tasks(task_.threads, part_costs(task_.sizes), [&](int i) {
      progress_.check();
      const auto part = static_cast<std::size_t>(i);
      if (!task_.parts[part].mesh) return;
      PartSampler sampler(task_, task_.parts[part], first[part]);
      totals[part] = sampler.run();
      sampler.list_far(task_.most, far[part]);
    });
    for (const std::vector<FarPlace>& places : far) far_.insert(far_.end(), places.begin(), places.end());
    for (std::size_t i = 0; i < totals.size(); ++i)
      if (task_.parts[i].mesh) faces_[task_.parts[i].region->face].add(totals[i]);
  }

  void exchange() {
    Reduction reduction;
    for (Totals& face : faces_) {
      reduction.sum(face.count), reduction.sum(face.sum);
      face.largest = -face.largest, face.angle = -face.angle;
      reduction.least(face.largest), reduction.least(face.angle);
    }
    reduction.run(ranks_);
    for (Totals& face : faces_) face.largest = -face.largest, face.angle = -face.angle;
    if (std::isfinite(task_.most)) far_ = gather_all(far_, ranks_);
  }

  // Every rank has all edges.
  void add_edges() {
    const std::vector<Edge>& edges = task_.model.edges;
    std::vector<std::vector<double>> distances(edges.size());  // of the sides
    std::vector<double> costs;
    for (std::size_t e = 0; e < edges.size(); ++e)
      costs.push_back(edges[e].curve && !edges[e].is_periodic ? task_.edges.edges[e].intervals() : 0);
    run_tasks(task_.threads, costs, [&](int i) {
      const auto e = static_cast<std::size_t>(i);
      const EdgeDivision& division = task_.edges.edges[e];
      for (std::size_t k = 0; costs[e] > 0 && k < static_cast<std::size_t>(division.intervals()); ++k)
        distances[e].push_back(side_distance(edges[e], division, k, task_.mesh.order));
    });
    for (std::size_t e = 0; e < edges.size(); ++e)
      for (int face : edges[e].faces)
        if (faces_[face].count > 0) add_sides(task_.edges.edges[e], distances[e], face);
  }

  void add_sides(const EdgeDivision& division, const std::vector<double>& distances, int face) {
    Totals& totals = faces_[face];
    for (std::size_t k = 0; k < distances.size(); ++k) {
      totals.largest = std::max(totals.largest, distances[k]);
      if (distances[k] > task_.most)
        far_.push_back({face, 2, distances[k], 0, {division.x[2 * k], division.x[2 * k + 2]}});
    }
  }

  const DistanceTask& task_;
  const Progress& progress_;
  Ranks& ranks_;
  std::vector<Totals> faces_;
  std::vector<FarPlace> far_;
};

}  // namespace

MeshDistances measure_distances(const DistanceTask& task, const Progress& progress, Ranks& ranks) {
  return Measurer(task, progress, ranks).run();
}

SurfaceDistance join_distances(const SurfaceDistance& a, long a_elements, const SurfaceDistance& b, long b_elements) {
  const auto m = static_cast<double>(a_elements), n = static_cast<double>(b_elements);
  return {std::max(a.largest, b.largest), m + n > 0 ? (m * a.mean + n * b.mean) / (m + n) : 0,
          std::max(a.angle, b.angle)};
}

}  // namespace paver
