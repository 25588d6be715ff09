// The report of a run as JSON. The keys are a contract: core/docs/quality.md lists them.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "paver/output.h"
#include "paver/solver.h"

namespace paver {
namespace {

using Json = nlohmann::ordered_json;

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

Json contacts_json(const std::vector<Contact>& contacts) {
  Json json = Json::array();
  for (const Contact& contact : contacts)
    json.push_back({{"parts", contact.parts},
                    {"kind", contact_name(contact.kind)},
                    {"faces", contact.faces},
                    {"size", contact.size},
                    {"gap", contact.gap}});
  return json;
}

Json repairs_json(const std::vector<Repair>& repairs) {
  Json json = Json::array();
  for (const Repair& repair : repairs)
    json.push_back({{"kind", repair_name(repair.kind)},
                    {"count", repair.count},
                    {"distance", repair.distance},
                    {"faces", repair.faces}});
  return json;
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
          {"contacts", contacts_json(m.contacts)},
          {"unconnected", m.unconnected},
          {"one_sided", m.one_sided},
          {"curve_distance", m.curve_distance},
          {"stray_edges", m.stray_edges},
          {"unread", m.unread},
          {"open_solids", m.open_solids},
          {"holes", m.holes},
          {"repairs", repairs_json(m.repairs)}};
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

Json named_json(const RunReport& run) {
  Json json = {{"media", Json::array()}, {"ports", Json::array()}, {"wires", Json::array()}};
  for (const auto& [name, parts, eps_r, mu_r, loss_tangent, is_conductor] : run.media)
    json["media"].push_back({{"name", name},
                             {"parts", parts},
                             {"eps_r", eps_r},
                             {"mu_r", mu_r},
                             {"tan_d", loss_tangent},
                             {"conductor", is_conductor}});
  for (const auto& [name, parts] : run.ports) json["ports"].push_back({{"name", name}, {"parts", parts}});
  for (const auto& [name, parts, radius] : run.wires)
    json["wires"].push_back({{"name", name}, {"parts", parts}, {"radius", radius}});
  return json;
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
  if (face.where) json["where"] = {face.where->x, face.where->y, face.where->z};
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
               {"gaps", Json::array()},
               {"crossings", Json::array()},
               {"verdict", verdict(run)},
               {"faults", faults(run)},
               {"doubts", doubts(run)},
               {"quality", quality_json(run.quality)},
               {"solver", solver_json(run)},
               {"faces", Json::array()},
               {"merges", Json::array()},
               {"element_repairs", Json::array()},
               {"notes", run.notes},
               {"stage_seconds", Json::object()},
               {"stage_runs", Json::object()},
               {"tasks", Json::object()},
               {"peak_memory_mib", run.peak_memory_mib},
               {"checksum", fmt::format("{:016x}", mesh_checksum)}};
  for (const Gap& gap : run.gaps)
    json["gaps"].push_back(
        {{"parts", gap.parts}, {"distance", gap.distance}, {"where", {gap.where.x, gap.where.y, gap.where.z}}});
  for (const auto& [faces, where] : run.crossings)
    json["crossings"].push_back({{"faces", faces}, {"where", {where.x, where.y, where.z}}});
  for (std::size_t i = 0; i < run.faces.size(); ++i) {
    const std::string& label = i < result.face_names.size() ? result.face_names[i] : run.faces[i].name;
    json["faces"].push_back(face_json(run.faces[i], label));
  }
  json.update(named_json(run));
  json["lost_parts"] = run.lost_parts;
  for (const auto& [kind, name, into, size, where] : run.merges)
    json["merges"].push_back({{"kind", merge_name(kind)},
                              {"name", name},
                              {"into", into},
                              {"size", size},
                              {"where", {where.x, where.y, where.z}}});
  for (const auto& [kind, entity, where] : run.element_repairs)
    json["element_repairs"].push_back(
        {{"kind", element_repair_name(kind)}, {"entity", entity}, {"where", {where.x, where.y, where.z}}});
  for (const auto& [stage, runs] : run.stage_runs) json["stage_runs"][stage] = runs;
  for (const auto& [stage, seconds] : run.stage_seconds) json["stage_seconds"][stage] = seconds;
  for (const auto& [stage, seconds, elements] : run.tasks)
    json["tasks"][stage_name(stage)].push_back({seconds, elements});
  // Names from CAD files may not be UTF-8: replace what is not, rather than fail.
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace paver
