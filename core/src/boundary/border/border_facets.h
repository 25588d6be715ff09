// The border of a face in facets, before there are nodes.
#pragma once

#include <set>
#include <vector>

#include "boundary/parity.h"
#include "topology/model.h"

namespace paver {

/// Per edge of a model: shares of its length with a node opposite a vertex.
using OppositeShares = std::vector<std::vector<double>>;

/// The chord of an interval, the face to its left.
struct BorderFacet {
  Vec3 a, b;
  Vec3 inward;  ///< unit
  int edge = -1;
  int before = -1, after = -1;  ///< neighbours in the loop, by their places in the list
  double length() const { return norm(b - a); }
};

/// Of the coedge's edge, between nodes at these `shares` of it, without neighbours.
std::vector<BorderFacet> facets_of(const Model& model, int face, const Coedge& coedge, std::vector<double> shares);

/// All facets of a face, loop by loop; none where one of its edges is not divided or has no image on its surface.
/// `loops`: linked_loops of the face without periodic edges; `opposite`: as shares_of takes it, per edge of the model.
std::vector<BorderFacet> border_of(const Model& model, int face, const std::vector<Loop>& loops,
                                   const std::vector<EdgeCount>& counts, const OppositeShares& opposite);

/// Of the two facets at the start of facet i.
double shortest_at(const std::vector<BorderFacet>& border, int i);

/// Where an edge of `count` intervals has its nodes, as shares of its length: at `opposite`, the first of them where
/// these are too many, and evenly between.
std::vector<double> shares_of(const std::vector<double>& opposite, int count);

/// divide(f) for each of so many `faces`: gives edges that it divided, whose faces come once more, for the `most`
/// rounds.
template <class Divide>
void divide_in_rounds(const Model& model, std::size_t faces, int most, Divide divide) {
  std::set<int> open;
  for (std::size_t f = 0; f < faces; ++f) open.insert(static_cast<int>(f));
  for (int round = 0; round < most; ++round) {
    std::set<int> next;
    for (int f : open)
      for (int edge : divide(f)) next.insert(model.edges[edge].faces.begin(), model.edges[edge].faces.end());
    open = std::move(next);
  }
}

}  // namespace paver
