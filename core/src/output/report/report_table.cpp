// The report of a run as text for a terminal: totals, quality, lengths, faces that need a look, times, notes.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/listed.h"
#include "paver/output.h"
#include "paver/solver.h"

namespace paver {
namespace {

constexpr std::size_t most_faces = 10, most_notes = 20, most_contacts = 3;
constexpr double poor_face_sj = 0.3;

/// Lines "name   text", the names in one column.
class Text {
 public:
  template <class... Values>
  void line(const char* name, fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), "{:<14}", name);
    fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
    text_ += '\n';
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

const char* plural(long n) { return n == 1 ? "" : "s"; }

/// "3 closed loops (0.001 mm), 2 poles"; sewing has a line of its own.
std::string repairs(const ModelReport& model) {
  std::string list;
  for (const Repair& repair : model.repairs) {
    if (repair.kind == RepairKind::sewn_edge) continue;
    list += fmt::format("{}{} {}", list.empty() ? "" : ", ", repair.count, repair_name(repair.kind));
    if (repair.distance > 0) list += fmt::format(" ({:.3g} mm)", repair.distance);
  }
  return list;
}

void add_model(const RunReport& run, Text& text) {
  const ModelReport& m = run.model;
  text.line("model", "{} ({}{}), {} solid{}, {} face{}, {} edge{}, diagonal {:.6g} mm", m.file, m.format,
            m.unit.empty() ? "" : ", unit " + m.unit, m.solids, plural(m.solids), m.faces, plural(m.faces), m.edges,
            plural(m.edges), m.diagonal);
  if (m.sew_tolerance > 0) {
    text.line("sewing", "{} edge{} made common, tolerance {:.3g} mm", m.sewn_edges, plural(m.sewn_edges),
              m.sew_tolerance);
  }
  if (std::string list = repairs(m); !list.empty()) text.line("repairs", "{}", list);
  if (m.free_edges + m.nonmanifold_edges > 0) {
    text.line("edges", "{} on one face only, {} on more than two", m.free_edges, m.nonmanifold_edges);
  }
}

/// What touches what, and how many meshes come of it.
void add_contacts(const RunReport& run, Text& text) {
  std::vector<std::string> touching, separate;
  for (const Contact& contact : run.model.contacts)
    touching.push_back(fmt::format("{} and {} ({})", contact.parts[0], contact.parts[1], contact_name(contact.kind)));
  if (!touching.empty()) text.line("contacts", "{}", listed(touching, most_contacts));
  if (run.components.size() < 2) return;
  for (const std::vector<std::string>& parts : run.components)
    separate.push_back(parts.front() + (parts.size() > 1 ? fmt::format(" with {} more", parts.size() - 1) : ""));
  text.line("separate", "{} meshes that share no node: {}", run.components.size(),
            listed(separate, most_contacts, "more", "; "));
}

void add_quality(const RunReport& run, Text& text) {
  const QualityReport& q = run.quality;
  text.line("target", "{:.6g} mm, order {}, {} thread{}", run.target_length, run.order, run.threads,
            plural(run.threads));
  text.line("mesh", "{} quad{}, {} triangle{}, {} nodes, {}", q.quads, plural(q.quads), q.triangles,
            plural(q.triangles), q.nodes,
            q.watertight ? "watertight" : fmt::format("{} border edge{}", q.border_edges, plural(q.border_edges)));
  for (const Medium& medium : run.media)
    text.line("medium", "{}: {}, {}", medium.name,
              medium.is_conductor ? "conductor" : fmt::format("eps_r {:.6g}, mu_r {:.6g}", medium.eps_r, medium.mu_r),
              fmt::join(medium.parts, ", "));
  for (const Port& port : run.ports) text.line("port", "{}: {}", port.name, fmt::join(port.parts, ", "));
  for (const Wire& wire : run.wires)
    text.line("wire", "{}: {}, radius {:.6g} mm", wire.name, fmt::join(wire.parts, ", "), wire.radius);
  if (q.wire_lines > 0) text.line("wires", "{} line element{}", q.wire_lines, plural(q.wire_lines));
  text.line("SJ", "min {:.3f}, mean {:.3f}, below 0.3: {:.2f} %", q.sj_all.min, q.sj_all.mean, 100 * q.sj_all.below_03);
  text.line("curved", "{} inverted, {} undecided, Jacobian at least {:.3f} of its mean", q.inverted, q.undecided,
            q.min_jacobian_ratio);
  text.line("irregular", "{:.2f} % of {} nodes inside faces", 100 * q.irregular_share, q.face_interior_nodes);
  const SolverFigures solver = solver_figures(run);
  text.line("unknowns", "{} of first order, full matrix {:.4g} MiB{}", solver.unknowns, solver.matrix_mib,
            solver.wavelength
                ? fmt::format("; edges from {:.2g} to {:.2g} wavelengths", solver.shortest_edge / *solver.wavelength,
                              solver.longest_edge / *solver.wavelength)
                : "");
  text.line("edge length", "mean {:.3f} h, CV {:.3f}, within 0.7 to 1.4 h: {:.2f} %", q.length_mean, q.length_cv,
            100 * q.length_in_band);
  if (q.cad_area > 0) {
    text.line("area", "{:.6g} mm2, {:+.3g} % against the CAD", q.mesh_area, 100 * (q.mesh_area / q.cad_area - 1));
    text.line("distance", "at most {:.3g} mm ({:.2g} h) from the CAD, mean {:.3g} mm; normals within {:.2g} degrees",
              q.distance.largest, q.distance.largest / run.target_length, q.distance.mean,
              q.distance.angle * 180 / M_PI);
  }
}

void add_verdict(const RunReport& run, Text& text) {
  std::vector<std::string> found = faults(run);
  const std::vector<std::string> doubtful = doubts(run);
  found.insert(found.end(), doubtful.begin(), doubtful.end());
  if (found.empty()) {
    text.line("verdict", "the mesh is sound");
  } else {
    text.line("verdict", "the mesh is {}: {}{}", verdict(run), found.front(),
              found.size() > 1 ? fmt::format(" And {} more.", found.size() - 1) : "");
  }
}

std::vector<const FaceReport*> faces_to_list(const std::vector<FaceReport>& faces) {
  std::vector<const FaceReport*> listed;
  for (const FaceReport& face : faces) {
    bool is_poor = face.quads + face.triangles > 0 && face.worst_sj < poor_face_sj;
    if (face.status == FaceStatus::failed || is_poor) listed.push_back(&face);
  }
  auto rank = [](const FaceReport* face) { return face->status == FaceStatus::failed ? -2.0 : face->worst_sj; };
  std::stable_sort(listed.begin(), listed.end(), [&](auto* a, auto* b) { return rank(a) < rank(b); });
  return listed;
}

void add_faces(const std::vector<FaceReport>& faces, Text& text) {
  std::vector<const FaceReport*> listed = faces_to_list(faces);
  for (std::size_t i = 0; i < std::min(listed.size(), most_faces); ++i) {
    const FaceReport& face = *listed[i];
    if (face.status == FaceStatus::failed) {
      text.line(i ? "" : "faces", "{} failed ({}): {}", face.name, face.stage, face.reason);
    } else {
      text.line(i ? "" : "faces", "{}: worst SJ {:.3f} of {} elements", face.name, face.worst_sj,
                face.quads + face.triangles);
    }
  }
  if (listed.size() > most_faces) text.line("", "and {} more", listed.size() - most_faces);
}

void add_costs(const RunReport& run, Text& text) {
  std::string stages;
  double sum = 0;
  for (const auto& [stage, seconds] : run.stage_seconds) {
    stages += fmt::format("{}{} {:.2f}", stages.empty() ? "" : ", ", stage, seconds);
    sum += seconds;
  }
  text.line("seconds", "{:.2f}: {}", sum, stages);
  text.line("memory", "{:.0f} MiB at most", run.peak_memory_mib);
}

}  // namespace

std::string report_table(const RunReport& report) {
  Text text;
  add_model(report, text);
  add_contacts(report, text);
  add_quality(report, text);
  add_verdict(report, text);
  add_faces(report.faces, text);
  add_costs(report, text);
  for (std::size_t i = 0; i < std::min(report.notes.size(), most_notes); ++i) {
    text.line("note", "{}", report.notes[i]);
  }
  if (report.notes.size() > most_notes) text.line("note", "and {} more", report.notes.size() - most_notes);
  return text.take();
}

}  // namespace paver
