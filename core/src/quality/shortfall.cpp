// Whether a result is all that was asked for, in one sentence.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/listed.h"
#include "paver/result.h"
#include "quality/metrics.h"

namespace paver {
namespace {

constexpr std::size_t most_named_faces = 10;

std::string without_stop(std::string sentence) {
  while (sentence.ends_with('.')) sentence.pop_back();
  return sentence;
}

std::string unconnected_parts(const std::vector<std::array<std::string, 2>>& pairs) {
  std::vector<std::string> names;
  for (const auto& [one, other] : pairs) names.push_back(one + " and " + other);
  return fmt::format(
      "Parts that touch, or come near it, could not be connected and are meshed as drawn: {}; fuse them in the CAD "
      "program, give a sew-tolerance where their edges are to meet, or say connect none where they are to stay apart.",
      listed(names, most_named_faces, "more pairs"));
}

std::string one_sided_solids(const std::vector<std::string>& solids) {
  return fmt::format(
      "The normals of the faces of {} cannot all look outwards: their loops contradict each other; repair the solid in "
      "the CAD program.",
      fmt::join(solids, ", "));
}

/// A sentence about these; empty without any.
std::string about(const std::vector<std::string>& items, fmt::format_string<std::string> sentence) {
  return items.empty() ? "" : fmt::format(sentence, listed(items, most_named_faces));
}

// Nodes lie on curves and on surfaces: where these are farther apart the mesh leaves one of them.
constexpr double farthest_curve = 0.25;  // of the target length
constexpr double largest_share = 0.05;   // of the diagonal: no target length forgives more than for this one

bool has_stray_curves(const RunReport& report) {
  const double h = std::min(report.target_length, largest_share * report.model.diagonal);
  return report.model.curve_distance > farthest_curve * h;
}

std::string stray_curves(const RunReport& report) {
  return fmt::format(
      "Curves lie up to {:.3g} mm off faces that use them ({}), so that no mesh follows both; repair the model in the "
      "CAD program.",
      report.model.curve_distance, listed(report.model.stray_edges, most_named_faces));
}

std::string lost(const std::vector<std::string>& parts) {
  return fmt::format("Not in the mesh: {}; name faces, edges and vertices that stay, or mend those that fail.",
                     fmt::join(parts, ", "));
}

std::string long_sides(const RunReport& report) {
  std::vector<std::string> faces;
  for (const FaceReport& face : report.faces)
    if (face.longest_side > far_too_long * report.target_length)
      faces.push_back(fmt::format("{} ({:.1f})", face.name, face.longest_side / report.target_length));
  return about(faces,
               "Elements are many times as long as the target length: {}; a slightly different size may mesh it.");
}

constexpr double turned = 90 * std::numbers::pi / 180;  // between normals of mesh and surface

// Along a lip of next to no radius normals turn within a hundredth of an element; what folds over has more area, too.
bool folds_over(const FaceReport& face) {
  constexpr double largest = 1.01;  // area of the elements, by the face's
  return face.distance.angle > turned && face.mesh_area > largest * face.cad_area;
}

std::string folded(const RunReport& report) {
  std::vector<std::string> faces;
  for (const FaceReport& face : report.faces)
    if (folds_over(face))
      faces.push_back(fmt::format("{} ({:+.1f} %)", face.name, 100 * (face.mesh_area / face.cad_area - 1)));
  return about(faces, "Elements fold over one another, by what they have more of area: {}; use a smaller size there.");
}

// Chords cut off less: eight around a ball take 15 % of its area. Normals that turn by more than 90 degrees are no sign
// by themselves: along a lip they do.
bool is_too_coarse(const FaceReport& face) {
  constexpr double least = 0.65, least_turned = 0.8;  // area of the elements, by the face's
  constexpr double farthest = 0.15;                   // distance of mesh and surface, by the longest side
  if (face.mesh_area < least * face.cad_area) return true;
  return face.distance.angle > turned &&
         (face.mesh_area < least_turned * face.cad_area || face.distance.largest > farthest * face.longest_side);
}

// Curved elements follow a shape that they are fine enough for: about a nose that they bridge a body loses its edge.
bool has_other_area(const RunReport& report, const FaceReport& face, double least, double merged) {
  constexpr double most_curved = 0.05;  // of the face's area
  const double off = std::fabs(face.mesh_area - face.cad_area) - merged;
  return report.order > 1 && !folds_over(face) && off > most_curved * std::max(face.cad_area, least);
}

std::string too_coarse(const RunReport& report) {
  constexpr double small = 0.02;  // of the area of all faces: such faces are merged at their borders
  double whole = 0, merged = 0;
  for (const FaceReport& face : report.faces) {
    whole += face.cad_area;
    if (face.status == FaceStatus::merged) merged += face.cad_area;
  }
  std::vector<std::string> faces;
  for (const FaceReport& face : report.faces) {
    if (face.status != FaceStatus::meshed) continue;
    const bool is_large = face.cad_area > small * whole;
    if ((is_large && is_too_coarse(face)) || has_other_area(report, face, small * whole, merged))
      faces.push_back(fmt::format("{} ({:.0f} % of its area)", face.name, 100 * face.mesh_area / face.cad_area));
  }
  return about(faces, "Elements are too coarse for the shape of {}; use a smaller size or max-turn there.");
}

// Farther apart than elements may be off their surface, faces may have been drawn so.
std::string merged(const RunReport& report) {
  constexpr double widest = 0.05;  // of the target length
  const ModelReport& model = report.model;
  if (!(model.merged_gap > widest * report.target_length)) return {};
  return fmt::format(
      "Faces of {} lie up to {:.2g} mm apart and were taken for one; where they are to stay apart, "
      "say connect none.",
      listed(model.merged_parts, most_named_faces), model.merged_gap);
}

// On a narrow strip a side need not be far off its edge to take some of its area along.
std::string off_edge(const RunReport& report) {
  constexpr double farthest = 0.05, least = 0.01;  // of the target length
  constexpr double largest = 1.05;                 // area of the elements, by the face's
  const double h = std::min(report.target_length, report.model.diagonal);
  auto is_larger = [](const FaceReport& face) { return face.mesh_area > largest * face.cad_area; };
  const bool is_off =
      report.off_edge > farthest * h || (report.off_edge > least * h && std::ranges::any_of(report.faces, is_larger));
  if (!is_off) return {};
  return fmt::format(
      "Sides of elements lie up to {:.3g} mm off their edges, to keep elements valid; use a smaller size.",
      report.off_edge);
}

std::string place(Vec3 where) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", where.x, where.y, where.z); }

std::string crossings(const std::vector<Crossing>& places) {
  std::vector<std::string> found;
  for (const auto& [faces, where] : places) {
    const std::string with = faces[0] == faces[1] ? "itself" : faces[1];
    found.push_back(fmt::format("{} with {} at {}", faces[0], with, place(where)));
  }
  return about(found,
               "Elements run through each other: {}; where the shape crosses itself repair it, elsewhere use a smaller "
               "size.");
}

constexpr const char* no_mesh = "None of the faces has an area, so there is no mesh.";

}  // namespace

bool is_empty(const MeshResult& result) {
  const QualityReport& quality = result.report.quality;  // of a result without its mesh, too
  return result.mesh.quad_count() + result.mesh.triangle_count() == 0 &&
         quality.quads + quality.triangles + quality.wire_lines == 0;
}

std::vector<std::string> faults(const RunReport& report) {
  std::vector<std::string> sentences;
  for (const FaceReport& face : report.faces)
    if (face.status == FaceStatus::failed)
      sentences.push_back(fmt::format("{} failed ({}): {}.", face.name, face.stage, without_stop(face.reason)));
  const QualityReport& quality = report.quality;
  if (sentences.empty() && quality.quads + quality.triangles + quality.wire_lines == 0) sentences.push_back(no_mesh);
  if (!report.model.unconnected.empty()) sentences.push_back(unconnected_parts(report.model.unconnected));
  if (!report.model.one_sided.empty()) sentences.push_back(one_sided_solids(report.model.one_sided));
  if (has_stray_curves(report)) sentences.push_back(stray_curves(report));
  if (!report.lost_parts.empty()) sentences.push_back(lost(report.lost_parts));
  if (const long folded = quality.inverted + quality.undecided; folded > 0)
    sentences.push_back(fmt::format("Elements that fold or may fold: {}; use a smaller size.", folded));
  return sentences;
}

std::vector<std::string> doubts(const RunReport& report) {
  std::vector<std::string> sentences;
  for (const Gap& gap : report.gaps)
    if (gap.parts[0] == gap.parts[1])
      sentences.push_back(
          fmt::format("{} is open at {}, where its edges run along each other up to {:.3g} mm apart and share no node; "
                      "where they are to be one, give a sew-tolerance above that.",
                      gap.parts[0], place(gap.where), gap.distance));
    else
      sentences.push_back(
          fmt::format("{} and {} come within {:.3g} mm of each other at {} and share no node there; where they are to "
                      "touch, close the gap in the CAD program or with a sew-tolerance.",
                      gap.parts[0], gap.parts[1], gap.distance, place(gap.where)));
  const ModelReport& model = report.model;
  for (std::string sentence :
       {crossings(report.crossings),
        about(model.unread,
              "Not read, or not as the file has it, so that something is missing, elsewhere or of another size: {}; "
              "export the model again, or in another format."),
        about(model.open_solids,
              "Solids that are open, as faces of theirs are missing or do not meet: {}; repair them in the CAD "
              "program, or give a sew-tolerance above their gaps."),
        about(model.holes,
              "Too small to have an area and left out, which leaves holes in their bodies: {}; remove them in the CAD "
              "program."),
        long_sides(report), folded(report), too_coarse(report), merged(report), off_edge(report)})
    if (!sentence.empty()) sentences.push_back(std::move(sentence));
  return sentences;
}

const char* verdict(const RunReport& report) {
  if (!faults(report).empty()) return "faulty";
  return doubts(report).empty() ? "sound" : "doubtful";
}

std::optional<Error> shortfall(const MeshResult& result) {
  const std::vector<FaceReport>& faces = result.report.faces;
  const bool has_mesh = !is_empty(result);
  std::vector<std::string> failed;
  int first = -1;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const FaceReport& face = faces[i];
    if (face.status != FaceStatus::failed) continue;
    if (failed.empty()) first = static_cast<int>(i);
    failed.push_back(fmt::format("{} ({}: {})", face.name, face.stage, without_stop(face.reason)));
  }
  if (!failed.empty()) {
    const FaceReport& face = faces[first];
    return Error(ErrorCode::face_failed,
                 fmt::format("{} of {} faces could not be meshed, {}: {}.", failed.size(), faces.size(),
                             has_mesh ? "the mesh of the others is delivered" : "there is no mesh",
                             listed(failed, most_named_faces)),
                 {face.stage, first, -1, face.where});
  }
  const ModelReport& model = result.report.model;
  auto of_model = [](const std::string& sentence) {
    return Error(ErrorCode::face_failed, sentence, {"topology", -1, -1, {}});
  };
  if (!model.unconnected.empty()) return of_model(unconnected_parts(model.unconnected));
  if (!model.one_sided.empty()) return of_model(one_sided_solids(model.one_sided));
  if (has_stray_curves(result.report)) return of_model(stray_curves(result.report));
  if (!has_mesh) return Error(ErrorCode::no_faces, no_mesh);
  if (!result.report.lost_parts.empty())
    return Error(ErrorCode::face_failed, lost(result.report.lost_parts), {"join", -1, -1, {}});
  return std::nullopt;
}

}  // namespace paver
