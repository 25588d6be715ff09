// The report of a run as JSON. The keys are a contract: core/docs/quality.md lists them.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "paver/output.h"
#include "paver/solver.h"

namespace paver {

using Json = nlohmann::ordered_json;

// The library finds these for what lists hold.
static void to_json(Json& json, const Vec3& x) { json = {x.x, x.y, x.z}; }
static void to_json(Json& json, const Contact& contact) {
  json = {{"parts", contact.parts},
          {"kind", contact_name(contact.kind)},
          {"faces", contact.faces},
          {"size", contact.size},
          {"gap", contact.gap}};
}
static void to_json(Json& json, const Repair& repair) {
  json = {{"kind", repair_name(repair.kind)},
          {"count", repair.count},
          {"distance", repair.distance},
          {"faces", repair.faces}};
}
static void to_json(Json& json, const Gap& gap) {
  json = {{"parts", gap.parts}, {"distance", gap.distance}, {"where", gap.where}};
}
static void to_json(Json& json, const Crossing& crossing) {
  json = {{"faces", crossing.faces}, {"where", crossing.where}};
}
static void to_json(Json& json, const Merge& merge) {
  json = {{"kind", merge_name(merge.kind)},
          {"name", merge.name},
          {"into", merge.into},
          {"size", merge.size},
          {"where", merge.where}};
}
static void to_json(Json& json, const ElementRepair& repair) {
  json = {{"kind", element_repair_name(repair.kind)}, {"entity", repair.entity}, {"where", repair.where}};
}
static void to_json(Json& json, const Medium& medium) {
  json = {{"name", medium.name}, {"parts", medium.parts},        {"eps_r", medium.eps_r},
          {"mu_r", medium.mu_r}, {"tan_d", medium.loss_tangent}, {"conductor", medium.is_conductor}};
}
static void to_json(Json& json, const Port& port) { json = {{"name", port.name}, {"parts", port.parts}}; }
static void to_json(Json& json, const Wire& wire) {
  json = {{"name", wire.name}, {"parts", wire.parts}, {"radius", wire.radius}};
}

namespace {

constexpr int report_version = 1;  // grows when a key changes its meaning or goes

template <class Value>
Json or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}

const char* status_name(FaceStatus status) {
  static constexpr const char* names[] = {"meshed", "no_area", "failed", "common", "dropped", "merged"};
  static_assert(std::size(names) == static_cast<std::size_t>(FaceStatus::merged) + 1);
  return names[static_cast<std::size_t>(status)];
}

Json model_json(const ModelReport& m) {
  return {{"file", m.file},
          {"format", m.format},
          {"unit", m.unit},
          {"solids", m.solids},
          {"shells", m.shells},
          {"faces", m.faces},
          {"edges", m.edges},
          {"vertices", m.vertices},
          {"diagonal", m.diagonal},
          {"area", m.area},
          {"sewn_edges", m.sewn_edges},
          {"sew_tolerance", m.sew_tolerance},
          {"free_edges", m.free_edges},
          {"free_edge_names", m.free_edge_names},
          {"nonmanifold_edges", m.nonmanifold_edges},
          {"nonmanifold_edge_names", m.nonmanifold_edge_names},
          {"contacts", m.contacts},
          {"unconnected", m.unconnected},
          {"one_sided", m.one_sided},
          {"curve_distance", m.curve_distance},
          {"stray_edges", m.stray_edges},
          {"unread", m.unread},
          {"open_solids", m.open_solids},
          {"holes", m.holes},
          {"repairs", m.repairs}};
}

Json sj_json(const ScaledJacobianStats& sj) { return {{"min", sj.min}, {"mean", sj.mean}, {"below_03", sj.below_03}}; }

Json distance_json(const SurfaceDistance& distance) {
  constexpr double degree = M_PI / 180;
  return {{"largest", distance.largest}, {"mean", distance.mean}, {"angle", distance.angle / degree}};
}

Json metric_json(const MetricFigures& m) {
  return {{"predicted", m.predicted},
          {"sj", {{"min", m.least_sj}, {"mean", m.mean_sj}}},
          {"length_mean", m.length_mean},
          {"length_in_band", m.length_in_band}};
}

Json quality_json(const QualityReport& q) {
  return {{"quads", q.quads},
          {"triangles", q.triangles},
          {"nodes", q.nodes},
          {"wire_lines", q.wire_lines},
          {"sj", {{"quads", sj_json(q.sj_quads)}, {"triangles", sj_json(q.sj_triangles)}, {"all", sj_json(q.sj_all)}}},
          {"irregular_share", q.irregular_share},
          {"irregular_nodes", q.irregular_nodes},
          {"face_interior_nodes", q.face_interior_nodes},
          {"edges", q.edges},
          {"shortest_edge", q.shortest_edge},
          {"longest_edge", q.longest_edge},
          {"length_mean", q.length_mean},
          {"length_cv", q.length_cv},
          {"length_in_band", q.length_in_band},
          {"mesh_area", q.mesh_area},
          {"cad_area", q.cad_area},
          {"chord_error", q.distance.largest},
          {"distance", distance_json(q.distance)},
          {"inverted", q.inverted},
          {"undecided", q.undecided},
          {"min_jacobian_ratio", q.min_jacobian_ratio},
          {"border_edges", q.border_edges},
          {"nonmanifold_edges", q.nonmanifold_edges},
          {"watertight", q.watertight},
          {"metric", metric_json(q.metric)}};
}

/// Elements per square wavelength; null without a frequency or elements.
Json density(long elements, double area, std::optional<double> wavelength) {
  if (!wavelength || elements == 0 || !(area > 0)) return nullptr;
  return static_cast<double>(elements) * *wavelength * *wavelength / area;
}

Json solver_json(const RunReport& run) {
  const SolverFigures figures = solver_figures(run);
  const std::optional<double> wave = figures.wavelength;
  auto in_waves = [&](double length) { return wave ? Json(length / *wave) : Json(nullptr); };
  return {{"unknowns", figures.unknowns},
          {"matrix_mib", figures.matrix_mib},
          {"wavelength", or_null(wave)},
          {"wavelength_around", or_null(run.wavelength)},
          {"shortest_edge_wavelengths", in_waves(figures.shortest_edge)},
          {"longest_edge_wavelengths", in_waves(figures.longest_edge)},
          {"elements_per_square_wavelength",
           density(run.quality.quads + run.quality.triangles, run.quality.mesh_area, run.wavelength)},
          {"segment", or_null(figures.least_segment)},
          {"hints", solver_hints(figures)}};
}

Json face_json(const FaceReport& face, const std::string& label) {
  bool has_elements = face.quads + face.triangles > 0;
  Json json = {
      {"name", face.name},
      {"label", label},
      {"front", face.front},
      {"back", face.back},
      {"front_medium", or_null(face.front_medium)},
      {"back_medium", or_null(face.back_medium)},
      {"status", status_name(face.status)},
      {"stage", face.stage},
      {"reason", face.reason},
      {"quads", face.quads},
      {"triangles", face.triangles},
      {"worst_sj", has_elements ? Json(face.worst_sj) : Json(nullptr)},
      {"longest_side", face.longest_side},
      {"cad_area", face.cad_area},
      {"distance", distance_json(face.distance)},
      {"mesh_area", face.mesh_area},
      {"elements_per_square_wavelength", density(face.quads + face.triangles, face.mesh_area, face.wavelength)},
      {"closed_by_triangulation", face.closed_by_triangulation}};
  if (face.where) json["where"] = *face.where;
  return json;
}

}  // namespace

std::string report_json(const MeshResult& result) { return report_json(result, checksum(result.mesh)); }

std::string report_json(const MeshResult& result, std::uint64_t mesh_checksum) {
  const RunReport& run = result.report;
  Json json = {{"report_version", report_version},
               {"length_unit", "mm"},
               {"target_length", run.target_length},
               {"order", run.order},
               {"elements", elements_name(run.elements)},
               {"threads", run.threads},
               {"model", model_json(run.model)},
               {"components", run.components},
               {"gaps", run.gaps},
               {"crossings", run.crossings},
               {"verdict", verdict(run)},
               {"faults", faults(run)},
               {"doubts", doubts(run)},
               {"quality", quality_json(run.quality)},
               {"solver", solver_json(run)},
               {"faces", Json::array()},
               {"merges", run.merges},
               {"element_repairs", run.element_repairs},
               {"notes", run.notes},
               {"stage_seconds", Json::object()},
               {"stage_runs", Json::object()},
               {"tasks", Json::object()},
               {"peak_memory_mib", run.peak_memory_mib},
               {"checksum", fmt::format("{:016x}", mesh_checksum)},
               {"media", run.media},
               {"ports", run.ports},
               {"wires", run.wires},
               {"lost_parts", run.lost_parts}};
  for (std::size_t i = 0; i < run.faces.size(); ++i) {
    const std::string& label = i < result.face_names.size() ? result.face_names[i] : run.faces[i].name;
    json["faces"].push_back(face_json(run.faces[i], label));
  }
  for (const auto& [stage, runs] : run.stage_runs) json["stage_runs"][stage] = runs;
  for (const auto& [stage, seconds] : run.stage_seconds) json["stage_seconds"][stage] = seconds;
  for (const auto& [stage, seconds, elements] : run.tasks)
    json["tasks"][stage_name(stage)].push_back({seconds, elements});
  // Names from CAD files may not be UTF-8: replace what is not, rather than fail.
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace paver
