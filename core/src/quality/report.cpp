// Measures a mesh: the elements one by one, then its edges, then the nodes inside faces, all on all threads; then what
// several ranks hold. Sums are exact and the rest are counts and least values, so the figures are the same for any
// number of threads and ranks.
#include "quality/report.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <mutex>

#include "base/tasks/tasks.h"
#include "mesh/element_table.h"
#include "paver/quality.h"
#include "quality/element_figures.h"
#include "quality/mesh_edges_impl.h"
#include "quality/reduction.h"
#include "quality/shared_edges.h"

namespace paver {
namespace {

constexpr double poor_sj = 0.3;
constexpr double band_low = 0.7, band_high = 1.4;  // edge length over target length
constexpr std::size_t task_elements = 1024, task_nodes = 65536;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Of one kind of element; `poor` counts those below poor_sj.
struct Totals {
  double least_sj = infinity, least_ratio = infinity;
  ExactSum sj;
  long count = 0, poor = 0, inverted = 0, undecided = 0;

  void add(const Totals& other) {
    least_sj = std::min(least_sj, other.least_sj);
    least_ratio = std::min(least_ratio, other.least_ratio);
    sj.add(other.sj);
    count += other.count, poor += other.poor, inverted += other.inverted, undecided += other.undecided;
  }
};

struct FaceTotals {
  long quads = 0, triangles = 0;
  double least_sj = infinity, minus_longest2 = 0;  // of the squared sides
  ExactSum area;
};

struct EdgeTotals {
  long count = 0, in_band = 0, border = 0, nonmanifold = 0;
  double shortest = infinity, minus_longest = infinity;
  ExactSum length, squares;  ///< of the lengths, and of their distances from the mean
};

struct NodeTotals {
  long used = 0, face_interior = 0, irregular = 0;
};

class Measurement {
 public:
  Measurement(const SurfaceMesh& mesh, const ShareNumbers& numbers, double h, const Progress& progress)
      : mesh_(mesh), numbers_(numbers), h_(h), progress_(progress), is_used_(mesh.nodes.size(), 0) {
    edge_totals_.length = ExactSum(h);
    edge_totals_.squares = ExactSum(h * h);
  }

  QualityReport measure(const std::vector<bool>& edge_is_periodic, std::vector<FaceReport>& faces, Ranks& ranks) {
    for (const FaceReport& face : faces) {
      FaceTotals totals;
      totals.area = ExactSum(face.cad_area > 0 && face.cad_area < infinity ? face.cad_area : h_ * h_);
      faces_.push_back(totals);
    }
    add_elements(true);
    add_elements(false);
    EdgeFigures edges = measure_edges(mesh_, numbers_.is_shared_node, progress_);
    progress_.check();
    add_nodes(edges, edge_is_periodic, ranks);
    add_lengths(edges, ranks);
    return report(faces);
  }

 private:
  void add_elements(bool is_quad) {
    run_stretches(ElementTable(mesh_, is_quad).count(), task_elements, [&](std::size_t begin, std::size_t end) {
      progress_.check();
      add_elements(is_quad, begin, end);
    });
  }

  void add_elements(bool is_quad, std::size_t begin, std::size_t end) {
    std::array<ElementFigures, task_elements> figures;
    measure_elements(mesh_, is_quad, begin, end, figures.data());
    mark_used(is_quad, begin, end);
    Totals totals;
    for (std::size_t i = 0; i < end - begin; ++i) {
      const ElementFigures& f = figures[i];
      totals.least_sj = std::min(totals.least_sj, f.sj);
      totals.least_ratio = std::min(totals.least_ratio, f.ratio);
      totals.sj.add(f.sj);
      totals.poor += f.sj < poor_sj;
      totals.inverted += f.validity == Validity::invalid;
      totals.undecided += f.validity == Validity::undecided;
    }
    totals.count = static_cast<long>(end - begin);
    std::lock_guard lock(mutex_);
    (is_quad ? quads_ : triangles_).add(totals);
    credit_faces(is_quad, begin, end, figures.data());
  }

  void credit_faces(bool is_quad, std::size_t begin, std::size_t end, const ElementFigures* f) {
    const ElementTable table(mesh_, is_quad);
    for (std::size_t i = begin; i < end; ++i, ++f) {
      FaceTotals& face = faces_.at(static_cast<std::size_t>(table.face[i]));
      ++(is_quad ? face.quads : face.triangles);
      face.least_sj = std::min(face.least_sj, f->sj);
      face.minus_longest2 = std::min(face.minus_longest2, -longest_side2(table, i));
      face.area.add(f->area);
    }
  }

  double longest_side2(const ElementTable& table, std::size_t element) const {
    const int* node = table.row(element);
    auto at = [&](int k) { return mesh_.nodes[node[k % table.corners]]; };
    double longest2 = 0;
    for (int k = 0; k < table.corners; ++k) {
      const Vec3 side = at(k + 1) - at(k);
      longest2 = std::max(longest2, dot(side, side));
    }
    return longest2;
  }

  void mark_used(bool is_quad, std::size_t begin, std::size_t end) {
    const ElementTable table(mesh_, is_quad);
    for (const int* node = table.row(begin); node != table.row(end); ++node)
      std::atomic_ref(is_used_[*node]).store(1, std::memory_order_relaxed);
  }

  /// Per node: whether it lies on the border by an edge of this rank, or on a B-rep edge that is not periodic. Poles
  /// have no lines and count as inside.
  std::vector<char> find_outside(const EdgeFigures& edges, const std::vector<bool>& edge_is_periodic) const {
    std::vector<char> is_outside(mesh_.nodes.size(), 0);
    for (std::size_t i = 0; i < mesh_.line_edge.size(); ++i) {
      if (edge_is_periodic.at(static_cast<std::size_t>(mesh_.line_edge[i]))) continue;
      for (int node : mesh_.line(i)) is_outside[node] = 1;
    }
    for (const EdgeUse& edge : edges.odd) {
      if (edge.uses == 1) is_outside[edge.low] = is_outside[edge.high] = 1;
    }
    return is_outside;
  }

  // Nodes, and the edges by their number of elements.
  void add_nodes(EdgeFigures& edges, const std::vector<bool>& edge_is_periodic, Ranks& ranks) {
    std::vector<char> is_outside = find_outside(edges, edge_is_periodic);
    for (const EdgeUse& edge : edges.odd) ++(edge.uses == 1 ? edge_totals_.border : edge_totals_.nonmanifold);
    std::size_t count = mesh_.nodes.size();
    run_stretches(count, task_nodes, [&](std::size_t begin, std::size_t end) {
      NodeTotals totals;
      for (std::size_t node = begin; node < end; ++node) {
        if (numbers_.is_shared(node)) continue;
        totals.used += is_used_[node];
        int twice_valence = edges.twice_valence[node];
        if (twice_valence == 0 || is_outside[node]) continue;
        ++totals.face_interior;
        totals.irregular += twice_valence != 8;
      }
      add(totals);
    });
    SharedFigures shared = measure_shared(mesh_, numbers_, edges, is_used_, is_outside, ranks);
    add({shared.nodes, shared.face_interior_nodes, shared.irregular_nodes});
    edge_totals_.border += shared.border;
    edge_totals_.nonmanifold += shared.nonmanifold;
    edges.chords.push_back(std::move(shared.chords));
  }

  void add(const NodeTotals& totals) {
    std::lock_guard lock(mutex_);
    nodes_.used += totals.used;
    nodes_.face_interior += totals.face_interior;
    nodes_.irregular += totals.irregular;
  }

  // Lengths of all ranks, and with them all that was counted before.
  void add_lengths(const EdgeFigures& edges, Ranks& ranks) {
    run_stretches(edges.chords.size(), 1, [&](std::size_t i, std::size_t) {
      ExactSum length(h_);
      long in_band = 0;
      double shortest = infinity, minus_longest = infinity;
      for (double chord : edges.chords[i]) {
        length.add(chord);
        shortest = std::min(shortest, chord), minus_longest = std::min(minus_longest, -chord);
        in_band += chord >= band_low * h_ && chord <= band_high * h_;
      }
      std::lock_guard lock(mutex_);
      edge_totals_.length.add(length);
      edge_totals_.in_band += in_band;
      edge_totals_.shortest = std::min(edge_totals_.shortest, shortest);
      edge_totals_.minus_longest = std::min(edge_totals_.minus_longest, minus_longest);
      edge_totals_.count += static_cast<long>(edges.chords[i].size());
    });
    reduce(ranks);
    double mean = edge_totals_.length.total() / static_cast<double>(std::max(edge_totals_.count, 1L));
    run_stretches(edges.chords.size(), 1, [&](std::size_t i, std::size_t) {
      ExactSum squares(h_ * h_);
      for (double chord : edges.chords[i]) squares.add((chord - mean) * (chord - mean));
      std::lock_guard lock(mutex_);
      edge_totals_.squares.add(squares);
    });
    Reduction reduction;
    reduction.sum(edge_totals_.squares);
    reduction.run(ranks);
  }

  void reduce(Ranks& ranks) {
    Reduction reduction;
    for (Totals* t : {&quads_, &triangles_}) {
      reduction.least(t->least_sj), reduction.least(t->least_ratio), reduction.sum(t->sj);
      for (long* count : {&t->count, &t->poor, &t->inverted, &t->undecided}) reduction.sum(*count);
    }
    for (FaceTotals& face : faces_) {
      reduction.sum(face.quads), reduction.sum(face.triangles), reduction.sum(face.area);
      reduction.least(face.least_sj), reduction.least(face.minus_longest2);
    }
    for (long* count : {&nodes_.used, &nodes_.face_interior, &nodes_.irregular}) reduction.sum(*count);
    EdgeTotals& e = edge_totals_;
    for (long* count : {&e.count, &e.in_band, &e.border, &e.nonmanifold}) reduction.sum(*count);
    reduction.sum(e.length);
    reduction.least(e.shortest), reduction.least(e.minus_longest);
    reduction.run(ranks);
  }

  static ScaledJacobianStats stats_of(const Totals& t) {
    if (t.count == 0) return {};
    double n = static_cast<double>(t.count);
    return {t.least_sj, t.sj.total() / n, static_cast<double>(t.poor) / n};
  }

  QualityReport report(std::vector<FaceReport>& faces) const {
    QualityReport report;
    Totals all = quads_;
    all.add(triangles_);
    report.quads = quads_.count;
    report.triangles = triangles_.count;
    report.sj_quads = stats_of(quads_);
    report.sj_triangles = stats_of(triangles_);
    report.sj_all = stats_of(all);
    report.inverted = all.inverted;
    report.undecided = all.undecided;
    report.min_jacobian_ratio = all.count ? all.least_ratio : 0;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      faces[i].quads = faces_[i].quads;
      faces[i].triangles = faces_[i].triangles;
      faces[i].mesh_area = faces_[i].area.total();
      faces[i].longest_side = std::sqrt(0 - faces_[i].minus_longest2);  // of no elements not -0
      if (faces[i].quads + faces[i].triangles > 0) faces[i].worst_sj = faces_[i].least_sj;
      report.mesh_area += faces[i].mesh_area;
      report.cad_area += faces[i].cad_area;
    }
    report_edges_and_nodes(report);
    return report;
  }

  void report_edges_and_nodes(QualityReport& report) const {
    const EdgeTotals& e = edge_totals_;
    report.nodes = nodes_.used;
    report.border_edges = e.border;
    report.nonmanifold_edges = e.nonmanifold;
    report.watertight = report.quads + report.triangles > 0 && e.border == 0 && e.nonmanifold == 0;
    report.face_interior_nodes = nodes_.face_interior;
    report.irregular_nodes = nodes_.irregular;
    if (nodes_.face_interior > 0)
      report.irregular_share = static_cast<double>(nodes_.irregular) / static_cast<double>(nodes_.face_interior);
    report.edges = e.count;
    if (e.count == 0) return;
    report.shortest_edge = e.shortest;
    report.longest_edge = -e.minus_longest;
    double n = static_cast<double>(e.count), mean = e.length.total() / n;
    report.length_mean = mean / h_;
    report.length_cv = mean > 0 ? std::sqrt(e.squares.total() / n) / mean : 0;
    report.length_in_band = static_cast<double>(e.in_band) / n;
  }

  const SurfaceMesh& mesh_;
  const ShareNumbers& numbers_;
  const double h_;
  const Progress& progress_;
  std::mutex mutex_;
  std::vector<char> is_used_;  // per node
  Totals quads_, triangles_;
  std::vector<FaceTotals> faces_;
  EdgeTotals edge_totals_;
  NodeTotals nodes_;
};

}  // namespace

ElementQuality element_quality(const SurfaceMesh& mesh) {
  std::size_t quads = mesh.quad_count(), count = quads + mesh.triangle_count();
  ElementQuality quality;
  quality.sj.resize(count);
  quality.jacobian_ratio.resize(count);
  quality.area.resize(count);
  quality.validity.resize(count);
  auto measure = [&](bool is_quad, std::size_t offset, std::size_t elements) {
    run_stretches(elements, task_elements, [&](std::size_t begin, std::size_t end) {
      std::array<ElementFigures, task_elements> figures;
      measure_elements(mesh, is_quad, begin, end, figures.data());
      for (std::size_t i = begin; i < end; ++i) {
        const ElementFigures& f = figures[i - begin];
        quality.sj[offset + i] = f.sj;
        quality.jacobian_ratio[offset + i] = f.ratio;
        quality.area[offset + i] = f.area;
        quality.validity[offset + i] = static_cast<std::int8_t>(f.validity);
      }
    });
  };
  measure(true, 0, quads);
  measure(false, quads, mesh.triangle_count());
  return quality;
}

QualityReport measure_quality(const MeshShare& share, double target_length, const std::vector<bool>& edge_is_periodic,
                              std::vector<FaceReport>& faces, const Progress& progress, Ranks& ranks) {
  return Measurement(share.result.mesh, share, target_length, progress).measure(edge_is_periodic, faces, ranks);
}

}  // namespace paver
