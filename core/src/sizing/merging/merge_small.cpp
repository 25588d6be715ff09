// Thin faces that were to be merged, as a tiny one at their end was, and could not be: once more, with what ends them.
#include "sizing/merging/merge_small.h"

#include <fmt/format.h>

#include <algorithm>

#include "sizing/merging/merge_steps.h"

namespace paver {
namespace {

constexpr int most_rounds = 3;

std::string count_of(long count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

}  // namespace

std::vector<Merge> merge_small(Model& model, const Options& options) {
  if (!(options.merge > 0)) return {};
  std::vector<int> lasting;
  for (int round = 0;;) {
    Model merged = model;
    std::vector<Merge> merges;
    ModelEdits edits(merged);
    const MergeLimits limits(edits, options, lasting);
    join_chains(edits, limits, merges);
    close_tiny_rims(edits, limits, merges);
    std::vector<int> going = collapse_tiny_faces(edits, limits, merges);
    const std::vector<int> stayed = merge_thin_faces(edits, limits, merges);
    std::erase_if(going, [&](int f) { return !merged.faces[f].has_area; });
    if (++round <= most_rounds) going.insert(going.end(), stayed.begin(), stayed.end());
    if (going.empty()) {
      collapse_short_edges(edits, limits, merges);
      model = std::move(merged);
      return merges;
    }
    lasting.insert(lasting.end(), going.begin(), going.end());
  }
}

const char* merge_name(MergeKind kind) { return kind == MergeKind::edge ? "edge" : "face"; }

std::string note_merges(const std::vector<Merge>& merges) {
  if (merges.empty()) return {};
  long edges = 0, faces = 0;
  double largest = 0;
  for (const Merge& merge : merges) {
    (merge.kind == MergeKind::edge ? edges : faces) += 1;
    largest = std::max(largest, merge.size);
  }
  return fmt::format("Merged, as they are small against the target length: {}, up to {:.3g} mm (merge off keeps them).",
                     edges == 0   ? count_of(faces, "face")
                     : faces == 0 ? count_of(edges, "edge")
                                  : count_of(edges, "edge") + " and " + count_of(faces, "face"),
                     largest);
}

}  // namespace paver
