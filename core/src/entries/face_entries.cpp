#include "entries/face_entries.h"

#include <algorithm>
#include <utility>

#include "check/distance/surface_distance.h"
#include "topology/named_parts.h"

namespace paver {
namespace {

void keep_common(std::vector<std::string>& names, const std::vector<std::string>& others) {
  std::erase_if(names, [&](const std::string& name) { return std::ranges::find(others, name) == others.end(); });
}

// A face has failed when one of its pieces has, and has no area when none of them has.
void add_piece(FaceReport& face, const FaceReport& piece) {
  face.distance =
      join_distances(face.distance, face.quads + face.triangles, piece.distance, piece.quads + piece.triangles);
  if (piece.quads + piece.triangles > 0) face.worst_sj = std::min(face.worst_sj, piece.worst_sj);
  face.longest_side = std::max(face.longest_side, piece.longest_side);
  face.quads += piece.quads;
  face.triangles += piece.triangles;
  face.mesh_area += piece.mesh_area;
  bool is_worse = piece.status == FaceStatus::failed && face.status != FaceStatus::failed;
  bool is_first_area =
      piece.status == FaceStatus::meshed && face.status != FaceStatus::failed && face.status != FaceStatus::meshed;
  if (is_worse || is_first_area) {
    face.status = piece.status;
    face.stage = piece.stage;
    face.reason = piece.reason;
    face.where = piece.where;
  }
  keep_common(face.front, piece.front);
  keep_common(face.back, piece.back);
  if (face.front_medium != piece.front_medium) face.front_medium.reset();
  if (face.back_medium != piece.back_medium) face.back_medium.reset();
  if (piece.wavelength) face.wavelength = std::min(*piece.wavelength, face.wavelength.value_or(INFINITY));
  face.cad_area += piece.cad_area;
  face.closed_by_triangulation += piece.closed_by_triangulation;
}

}  // namespace

void list_faces(const Model& model, const Options& options, MeshResult& result) {
  for (const Face& face : model.faces) {
    FaceReport report;
    report.name = face.name;
    report.cad_area = face.area;
    if (!face.has_area) report.status = FaceStatus::no_area;
    if (face.is_common) report.status = FaceStatus::common;
    if (face.is_dropped) report.status = FaceStatus::dropped;
    if (face.is_merged) report.status = FaceStatus::merged;
    for (int part : face.front) report.front.push_back(model.parts[part]);
    for (int part : face.back) report.back.push_back(model.parts[part]);
    report.front_medium = medium_of(model, face.front);
    report.back_medium = medium_of(model, face.back);
    report.wavelength = shortest_wavelength(options, {*report.front_medium, *report.back_medium});
    if (face.has_area && !face.fault.empty()) report.fail(stage_name(Stage::topology), face.fault);
    result.report.faces.push_back(report);
    result.face_names.push_back(face.label.empty() ? face.name : face.label);
  }
}

void merge_pieces(const Model& model, MeshResult& result) {
  for (int& face : result.mesh.quad_face) face = model.faces[face].origin;
  for (int& face : result.mesh.triangle_face) face = model.faces[face].origin;
  std::vector<FaceReport> pieces = std::move(result.report.faces);
  std::vector<std::string> names = std::move(result.face_names);
  result.report.faces.clear();
  result.face_names.clear();
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (i > 0 && model.faces[i].origin == model.faces[i - 1].origin) {
      add_piece(result.report.faces.back(), pieces[i]);
    } else {
      result.report.faces.push_back(pieces[i]);
      result.face_names.push_back(names[i]);
    }
  }
}

}  // namespace paver
