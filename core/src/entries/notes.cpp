#include "entries/notes.h"

#include <fmt/format.h>

#include <array>

#include "base/listed.h"

namespace paver {

void note_repairs(RunReport& report) {
  constexpr std::array ways{"by moving nodes", "by other elements", "with nodes inside faces",
                            "by other meshes of whole faces", "with nodes on B-rep edges"};
  std::array<long, ways.size()> counts{};
  for (const ElementRepair& repair : report.element_repairs) ++counts[static_cast<std::size_t>(repair.kind)];
  std::vector<std::string> list;
  for (std::size_t i = 0; i < ways.size(); ++i)
    if (counts[i] > 0) list.push_back(fmt::format("{} {}", counts[i], ways[i]));
  if (!list.empty()) report.notes.push_back(fmt::format("Elements repaired, places: {}.", listed(list, list.size())));
}

void note_remaining(RunReport& report) {
  if (report.elements == Elements::quad_dominant) return;
  const bool all_quad = report.elements == Elements::all_quad;
  std::vector<std::string> faces;
  for (const FaceReport& face : report.faces)
    if (const long count = all_quad ? face.triangles : face.quads; count > 0)
      faces.push_back(fmt::format("{} ({})", face.name, count));
  if (!faces.empty())
    report.notes.push_back(
        fmt::format("{} remain in {}.", all_quad ? "Triangles" : "Quads", listed(faces, faces.size())));
}

void note_far_faces(RunReport& report) {
  constexpr double far = 0.05;  // of the target length
  constexpr std::size_t most_listed = 6;
  if (report.order == 1) return;
  std::vector<std::string> faces;
  for (const FaceReport& face : report.faces)
    if (const double off = face.distance.largest / report.target_length; off > far)
      faces.push_back(fmt::format("{} ({:.2f})", face.name, off));
  if (!faces.empty())
    report.notes.push_back(
        fmt::format("Farther off the surface than {} of the target length: {}; a smaller size there follows it.", far,
                    listed(faces, most_listed)));
}

}  // namespace paver
