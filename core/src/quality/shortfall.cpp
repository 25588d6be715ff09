// Whether a result is all that was asked for, in one sentence.
#include <fmt/format.h>

#include "paver/result.h"

namespace paver {
namespace {

constexpr std::size_t most_named_faces = 10;

/// "Face3 (paving: no room), Face9 (...)"; counts the failed faces and notes the first one.
std::string failed_faces(const std::vector<FaceReport>& faces, std::size_t& count, int& first) {
  std::string text;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const FaceReport& face = faces[i];
    if (face.status != FaceStatus::failed) continue;
    if (++count == 1) first = static_cast<int>(i);
    if (count > most_named_faces) continue;
    std::string reason = face.reason;
    while (reason.ends_with('.')) reason.pop_back();
    text += fmt::format("{}{} ({}: {})", text.empty() ? "" : ", ", face.name, face.stage, reason);
  }
  if (count > most_named_faces) text += fmt::format(" and {} more", count - most_named_faces);
  return text;
}

}  // namespace

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
  if (is_empty) return Error(ErrorCode::no_faces, "None of the faces has an area, so there is no mesh.");
  return std::nullopt;
}

}  // namespace paver
