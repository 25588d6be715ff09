// Whether a result is all that was asked for, in one sentence.
#include <fmt/format.h>

#include "paver/result.h"

namespace paver {
namespace {

constexpr std::size_t most_named_faces = 10;

std::string without_stop(std::string sentence) {
  while (sentence.ends_with('.')) sentence.pop_back();
  return sentence;
}

/// "Face3 (paving: no room), Face9 (...)"; counts the failed faces and notes the first one.
std::string failed_faces(const std::vector<FaceReport>& faces, std::size_t& count, int& first) {
  std::string text;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const FaceReport& face = faces[i];
    if (face.status != FaceStatus::failed) continue;
    if (++count == 1) first = static_cast<int>(i);
    if (count > most_named_faces) continue;
    text += fmt::format("{}{} ({}: {})", text.empty() ? "" : ", ", face.name, face.stage, without_stop(face.reason));
  }
  if (count > most_named_faces) text += fmt::format(" and {} more", count - most_named_faces);
  return text;
}

constexpr const char* no_mesh = "None of the faces has an area, so there is no mesh.";

}  // namespace

std::vector<std::string> faults(const RunReport& report) {
  std::vector<std::string> sentences;
  for (const FaceReport& face : report.faces)
    if (face.status == FaceStatus::failed)
      sentences.push_back(fmt::format("{} failed ({}): {}.", face.name, face.stage, without_stop(face.reason)));
  const QualityReport& quality = report.quality;
  if (sentences.empty() && quality.quads + quality.triangles == 0) sentences.push_back(no_mesh);
  if (const long folded = quality.inverted + quality.undecided; folded > 0)
    sentences.push_back(fmt::format("Elements that fold or may fold: {}; use a smaller size.", folded));
  return sentences;
}

std::optional<Error> shortfall(const MeshResult& result) {
  const std::vector<FaceReport>& faces = result.report.faces;
  const QualityReport& quality = result.report.quality;  // of a result without its mesh, too
  bool is_empty =
      result.mesh.quad_count() + result.mesh.triangle_count() == 0 && quality.quads + quality.triangles == 0;
  std::size_t failed = 0;
  int first = -1;
  std::string names = failed_faces(faces, failed, first);
  if (failed > 0) {
    const FaceReport& face = faces[static_cast<std::size_t>(first)];
    return Error(ErrorCode::face_failed,
                 fmt::format("{} of {} faces could not be meshed, {}: {}.", failed, faces.size(),
                             is_empty ? "there is no mesh" : "the mesh of the others is delivered", names),
                 {face.stage, first, -1, face.where});
  }
  if (is_empty) return Error(ErrorCode::no_faces, no_mesh);
  return std::nullopt;
}

}  // namespace paver
