// A model that went through all stages up to paving, each region paved by itself; for tests of what comes after.
#pragma once

#include <utility>
#include <vector>

#include "boundary/edge_nodes.h"
#include "paving/pave_region.h"
#include "regions/build_regions.h"
#include "support/alone.h"

namespace paver::test {

struct PavedModel {
  PavedModel(Model m, const Options& options) : model(std::move(m)) {
    Progress progress;
    Alone alone(progress);
    SizeField size = build_size_field(model, options, progress);
    std::vector<FaceLayout> layouts = plan_layouts(model, size, ClosedLayouts::made, progress);
    EdgeCounts counts = choose_counts(model, size, progress, alone);
    settle_counts(model, layouts, counts.count);
    edges = divide_edges(model, size, counts, alone);
    regions = build_regions(model, size, layouts, edges);
    for (const Region& region : regions) paved.push_back(pave_region(region, progress).mesh);
  }

  Model model;
  EdgeNodes edges;
  std::vector<Region> regions;
  std::vector<RegionMesh> paved;
};

}  // namespace paver::test
