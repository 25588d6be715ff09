#include "boundary/border/border_facets.h"

#include <algorithm>
#include <iterator>

namespace paver {

std::vector<BorderFacet> facets_of(const Model& model, int face, const Coedge& coedge, std::vector<double> shares) {
  const Edge& edge = edge_of(model, coedge);
  if (coedge.is_reversed) std::ranges::reverse(shares);
  std::vector<BorderFacet> facets;
  for (std::size_t i = 1; i < shares.size(); ++i) {
    const double from = edge.parameter(shares[i - 1]), to = edge.parameter(shares[i]);
    const Vec3 a = edge.curve->point(from), b = edge.curve->point(to);
    const auto [x, xu, xv] = model.faces[face].surface->slope(coedge.pcurve->uv(0.5 * (from + to)));
    facets.push_back({a, b, unit(cross(cross(xu, xv), b - a)), coedge.edge});
  }
  return facets;
}

std::vector<BorderFacet> border_of(const Model& model, int face, const std::vector<Loop>& loops,
                                   const std::vector<EdgeCount>& counts, const OppositeShares& opposite) {
  std::vector<BorderFacet> border;
  if (!model.faces[face].surface) return border;
  for (const Loop& loop : loops) {
    const int first = static_cast<int>(border.size());
    for (const Coedge& coedge : loop.coedges) {
      const int count = counts[coedge.edge].count;
      if (!coedge.pcurve || !edge_of(model, coedge).curve || count == 0) return {};
      std::ranges::move(facets_of(model, face, coedge, shares_of(opposite[coedge.edge], count)),
                        std::back_inserter(border));
    }
    const int last = static_cast<int>(border.size()) - 1;
    for (int i = first; i <= last; ++i) {
      border[i].before = i > first ? i - 1 : last;
      border[i].after = i < last ? i + 1 : first;
    }
  }
  return border;
}

double shortest_at(const std::vector<BorderFacet>& border, int i) {
  return std::min(border[i].length(), border[border[i].before].length());
}

std::vector<double> shares_of(const std::vector<double>& opposite, int count) {
  constexpr double longer = 1 + 1e-6;  // equal ones take intervals in their order
  const auto taken = std::min<std::size_t>(opposite.size(), count - 1);
  std::vector<double> ends{0, 1};
  ends.insert(ends.end(), opposite.begin(), opposite.begin() + static_cast<long>(taken));
  std::ranges::sort(ends);
  std::vector<int> parts(ends.size() - 1, 1);
  auto interval = [&](std::size_t i) { return (ends[i + 1] - ends[i]) / parts[i]; };
  for (auto n = static_cast<int>(parts.size()); n < count; ++n) {
    std::size_t longest = 0;
    for (std::size_t i = 1; i < parts.size(); ++i)
      if (interval(i) > longer * interval(longest)) longest = i;
    ++parts[longest];
  }
  std::vector<double> shares{0};
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (int k = 1; k <= parts[i]; ++k)
      shares.push_back(ends[i] + (ends[i + 1] - ends[i]) * static_cast<double>(k) / parts[i]);
  return shares;
}

}  // namespace paver
