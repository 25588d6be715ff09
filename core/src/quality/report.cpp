// Measures a whole mesh: elements one by one on all threads, then sums in the elements' own order, so that the figures
// are the same for any number of threads; then the edges and the nodes inside faces.
#include "quality/report.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

#include "paver/quality.h"
#include "quality/jacobian.h"
#include "quality/mesh_edges_impl.h"
#include "quality/metrics.h"

namespace paver {
namespace {

constexpr double poor_sj = 0.3;
constexpr double band_low = 0.7, band_high = 1.4;  // edge length over target length

struct ElementFigures {
  double sj, area, ratio;
  Validity validity;
};

ElementFigures measure_element(const JacobianForm& form, const std::vector<Vec3>& nodes, const int* element,
                               bool is_quad) {
  std::array<Vec3, JacobianForm::max_nodes> x;
  for (int k = 0; k < form.node_count(); ++k) x[k] = nodes[element[k]];
  JacobianBound bound = form.bound(x.data());
  double sj = is_quad ? scaled_jacobian(x[0], x[1], x[2], x[3]) : scaled_jacobian(x[0], x[1], x[2]);
  return {sj, form.area(x.data()), bound.ratio, bound.validity};
}

std::vector<ElementFigures> measure_elements(const SurfaceMesh& mesh, bool is_quad, const Progress& progress) {
  const JacobianForm& form = jacobian_form(is_quad ? ElementShape::quad : ElementShape::triangle, mesh.order);
  const std::vector<int>& elements = is_quad ? mesh.quads : mesh.triangles;
  std::vector<ElementFigures> figures(is_quad ? mesh.quad_count() : mesh.triangle_count());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, figures.size(), 1024), [&](const auto& range) {
    progress.check();
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      figures[i] = measure_element(form, mesh.nodes, elements.data() + i * form.node_count(), is_quad);
    }
  });
  return figures;
}

/// Sums of one kind of element; `poor` counts those below poor_sj.
struct Totals {
  double least = 0, sum = 0, area = 0, ratio = 0;
  long count = 0, poor = 0, inverted = 0, undecided = 0;
};

Totals total_of(const std::vector<ElementFigures>& figures) {
  Totals t;
  for (const ElementFigures& f : figures) {
    t.least = t.count ? std::min(t.least, f.sj) : f.sj;
    t.ratio = t.count ? std::min(t.ratio, f.ratio) : f.ratio;
    t.sum += f.sj;
    t.area += f.area;
    t.poor += f.sj < poor_sj;
    t.inverted += f.validity == Validity::invalid;
    t.undecided += f.validity == Validity::undecided;
    ++t.count;
  }
  return t;
}

Totals join(const Totals& a, const Totals& b) {
  if (!a.count) return b;
  if (!b.count) return a;
  return {std::min(a.least, b.least), a.sum + b.sum,   a.area + b.area,         std::min(a.ratio, b.ratio),
          a.count + b.count,          a.poor + b.poor, a.inverted + b.inverted, a.undecided + b.undecided};
}

ScaledJacobianStats stats_of(const Totals& t) {
  double n = static_cast<double>(std::max(t.count, 1L));
  return {t.least, t.sum / n, static_cast<double>(t.poor) / n};
}

void credit_faces(std::vector<FaceReport>& faces, const std::vector<int>& face_of,
                  const std::vector<ElementFigures>& figures, long FaceReport::*count) {
  for (std::size_t i = 0; i < figures.size(); ++i) {
    FaceReport& face = faces.at(static_cast<std::size_t>(face_of[i]));
    bool is_first = face.quads + face.triangles == 0;
    face.worst_sj = is_first ? figures[i].sj : std::min(face.worst_sj, figures[i].sj);
    face.mesh_area += figures[i].area;
    ++(face.*count);
  }
}

void report_elements(const SurfaceMesh& mesh, std::vector<FaceReport>& faces, const Progress& progress,
                     QualityReport& report) {
  std::vector<ElementFigures> quads = measure_elements(mesh, true, progress);
  std::vector<ElementFigures> triangles = measure_elements(mesh, false, progress);
  for (FaceReport& face : faces) face.quads = face.triangles = 0, face.mesh_area = 0;
  credit_faces(faces, mesh.quad_face, quads, &FaceReport::quads);
  credit_faces(faces, mesh.triangle_face, triangles, &FaceReport::triangles);
  for (const FaceReport& face : faces) report.cad_area += face.cad_area;
  Totals of_quads = total_of(quads), of_triangles = total_of(triangles), all = join(of_quads, of_triangles);
  report.quads = of_quads.count;
  report.triangles = of_triangles.count;
  report.sj_quads = stats_of(of_quads);
  report.sj_triangles = stats_of(of_triangles);
  report.sj_all = stats_of(all);
  report.mesh_area = all.area;
  report.inverted = all.inverted;
  report.undecided = all.undecided;
  report.min_jacobian_ratio = all.ratio;
}

void report_lengths(const EdgeFigures& edges, double h, QualityReport& report) {
  if (edges.chords.empty()) return;
  double n = static_cast<double>(edges.chords.size()), sum = 0, squares = 0;
  long in_band = 0;
  for (double chord : edges.chords) {
    sum += chord;
    in_band += chord >= band_low * h && chord <= band_high * h;
  }
  double mean = sum / n;
  for (double chord : edges.chords) squares += (chord - mean) * (chord - mean);
  report.length_mean = mean / h;
  report.length_cv = mean > 0 ? std::sqrt(squares / n) / mean : 0;
  report.length_in_band = static_cast<double>(in_band) / n;
}

/// Per node: whether it lies on a B-rep edge that is not periodic. Poles have no lines and count as inside.
std::vector<bool> nodes_on_edges(const SurfaceMesh& mesh, const std::vector<bool>& edge_is_periodic) {
  std::vector<bool> on_edge(mesh.nodes.size(), false);
  std::size_t stride = static_cast<std::size_t>(mesh.order) + 1;
  for (std::size_t i = 0; i < mesh.line_edge.size(); ++i) {
    if (edge_is_periodic.at(static_cast<std::size_t>(mesh.line_edge[i]))) continue;
    for (std::size_t k = 0; k < stride; ++k) on_edge[mesh.lines[i * stride + k]] = true;
  }
  return on_edge;
}

void report_valence(const SurfaceMesh& mesh, const EdgeFigures& edges, const std::vector<bool>& edge_is_periodic,
                    QualityReport& report) {
  std::vector<bool> on_edge = nodes_on_edges(mesh, edge_is_periodic);
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
    if (!edges.is_corner[node] || edges.is_border[node] || on_edge[node]) continue;
    ++report.face_interior_nodes;
    report.irregular_nodes += edges.valence[node] != 4;
  }
  report.irregular_share = report.face_interior_nodes ? static_cast<double>(report.irregular_nodes) /
                                                            static_cast<double>(report.face_interior_nodes)
                                                      : 0;
}

long count_used_nodes(const SurfaceMesh& mesh) {
  std::vector<bool> is_used(mesh.nodes.size(), false);
  for (int node : mesh.quads) is_used[node] = true;
  for (int node : mesh.triangles) is_used[node] = true;
  return std::count(is_used.begin(), is_used.end(), true);
}

}  // namespace

ElementQuality element_quality(const SurfaceMesh& mesh) {
  Progress progress;
  ElementQuality quality;
  for (bool is_quad : {true, false}) {
    for (const ElementFigures& f : measure_elements(mesh, is_quad, progress)) {
      quality.sj.push_back(f.sj);
      quality.jacobian_ratio.push_back(f.ratio);
      quality.area.push_back(f.area);
      quality.validity.push_back(static_cast<std::int8_t>(f.validity));
    }
  }
  return quality;
}

QualityReport measure_quality(const SurfaceMesh& mesh, double target_length, const std::vector<bool>& edge_is_periodic,
                              std::vector<FaceReport>& faces, const Progress& progress) {
  QualityReport report;
  report_elements(mesh, faces, progress, report);
  report.nodes = count_used_nodes(mesh);
  EdgeFigures edges = measure_edges(mesh);
  progress.check();
  report.border_edges = edges.border;
  report.nonmanifold_edges = edges.nonmanifold;
  report.watertight = report.quads + report.triangles > 0 && edges.border == 0 && edges.nonmanifold == 0;
  report_lengths(edges, target_length, report);
  report_valence(mesh, edges, edge_is_periodic, report);
  return report;
}

}  // namespace paver
