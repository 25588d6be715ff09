#include "sizing/merging/merge_small.h"

#include <fmt/format.h>

#include <algorithm>

#include "sizing/merging/edge_chains.h"
#include "sizing/merging/short_edges.h"
#include "sizing/merging/thin_faces.h"

namespace paver {
namespace {

std::string count_of(long count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

}  // namespace

std::vector<Merge> merge_small(Model& model, const Options& options) {
  std::vector<Merge> merges;
  if (!(options.merge > 0)) return merges;
  ModelEdits edits(model);
  const MergeLimits limits(edits, options);
  join_chains(edits, limits, merges);
  collapse_tiny_faces(edits, limits, merges);
  merge_thin_faces(edits, limits, merges);
  collapse_short_edges(edits, limits, merges);
  return merges;
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
