// A mesh dealt to several ranks at random, to test what works on shares without a mesher that makes them.
#pragma once

#include <vector>

#include "paver/mesher.h"

namespace paver::test {

/// Deals quads and triangles in runs of 1 to `longest_run` to `ranks` shares; the same seed deals the same. Nodes that
/// nothing uses go to any one of them. Lines and their nodes are in all.
std::vector<MeshShare> deal_shares(const MeshResult& whole, int ranks, unsigned seed, int longest_run = 7);

}  // namespace paver::test
