#include "check/doubts.h"

#include <algorithm>
#include <utility>

#include "check/distance/cracks.h"
#include "check/distance/crossings.h"
#include "check/distance/gaps.h"

namespace paver {

void find_doubts(const MeshPieces& pieces, const Model& model, Ranks& ranks, RunReport& report) {
  PartPairs told = report.model.unconnected;
  report.gaps = find_gaps(pieces, model, ranks);
  std::erase_if(report.gaps,
                [&](const Gap& gap) { return std::find(told.begin(), told.end(), gap.parts) != told.end(); });
  for (const Gap& gap : report.gaps) told.push_back(gap.parts);
  report.crossings = find_crossings(pieces, model, told, ranks);
  for (Gap& crack : find_cracks(model, report.target_length)) report.gaps.push_back(std::move(crack));
}

}  // namespace paver
