// In: faces with their edges, target lengths. Out: pieces of gaps.
// Steps, face by face: samples along its edges, in cells as wide as a gap may be; from each the nearest one that faces
// it; neighbours along an edge whose gaps hang together become one piece.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "sizing/parts/find_places.h"

namespace paver {
namespace {

constexpr double narrow = 0.7;                           // target lengths
constexpr double step = 0.25;                            // target lengths between samples
constexpr int fewest_samples = 16, most_samples = 4000;  // of an edge
const double ahead = std::cos(M_PI / 4);                 // of the direction into the face: what lies across
const double along = std::cos(M_PI / 6);                 // between the directions of two edges

struct Sample {
  Vec3 x, tangent, inward;
  bool is_last = false;  // of its coedge
};

class GapsOfFace {
 public:
  GapsOfFace(const Model& model, const Face& face, double h) : reach_(narrow * h) {
    for (const Coedge& coedge : coedges_of(face.loops)) add_samples(face, coedge, edge_of(model, coedge), h);
    for (std::size_t i = 0; i < samples_.size(); ++i) cells_[cell_of(samples_[i].x)].push_back(i);
  }

  void find(std::vector<GapPiece>& pieces) const {
    std::optional<GapPiece> last;
    for (const Sample& sample : samples_) {
      std::optional<GapPiece> here = gap_at(sample);
      if (last) {
        const bool hangs_on = here && norm(here->to - last->to) < reach_;
        if (hangs_on)
          last->next_from = here->from, last->next_to = here->to, last->width = std::min(last->width, here->width);
        pieces.push_back(*last);
      }
      if (sample.is_last && here) pieces.push_back(*here);
      last = sample.is_last ? std::nullopt : here;
    }
  }

 private:
  using Cell = std::array<long, 3>;

  void add_samples(const Face& face, const Coedge& coedge, const Edge& edge, double h) {
    if (!edge.curve || edge.is_degenerate || edge.is_periodic || !coedge.pcurve) return;
    const double wanted = std::min(edge.length / (step * h), 1.0 * most_samples);
    const int count = std::max(fewest_samples, static_cast<int>(std::ceil(wanted)));
    for (int i = 0; i <= count; ++i) {
      const double share = (i + 0.5 * (i == 0) - 0.5 * (i == count)) / count, t = edge.parameter(share);
      const auto [at, way] = edge.curve->slope(t);
      const Vec3 tangent = unit(coedge.is_reversed ? -1 * way : way);
      samples_.push_back({at, tangent, cross(face.surface->normal(coedge.pcurve->uv(t)), tangent), i == count});
    }
  }

  Cell cell_of(Vec3 x) const {
    return {std::lround(std::floor(x.x / reach_)), std::lround(std::floor(x.y / reach_)),
            std::lround(std::floor(x.z / reach_))};
  }

  /// From a sample to the nearest other one that lies across.
  std::optional<GapPiece> gap_at(const Sample& sample) const {
    std::optional<GapPiece> found;
    const Cell cell = cell_of(sample.x);
    for (long i = -1; i <= 1; ++i)
      for (long j = -1; j <= 1; ++j)
        for (long k = -1; k <= 1; ++k) {
          const auto there = cells_.find({cell[0] + i, cell[1] + j, cell[2] + k});
          if (there == cells_.end()) continue;
          for (std::size_t other : there->second) look_across(sample, samples_[other], found);
        }
    return found;
  }

  void look_across(const Sample& one, const Sample& two, std::optional<GapPiece>& found) const {
    const Vec3 off = two.x - one.x, across = off - dot(off, two.tangent) * two.tangent;
    const double width = norm(across), far = norm(off);
    if (!(width > 0) || far >= reach_ || (found && width >= found->width)) return;
    if (-dot(one.tangent, two.tangent) < along) return;
    if (dot(off, one.inward) < ahead * far || dot(off, two.inward) > -ahead * far) return;
    const Vec3 to = one.x + across;
    found = GapPiece{one.x, to, one.x, to, width};
  }

  const double reach_;
  std::vector<Sample> samples_;
  std::map<Cell, std::vector<std::size_t>> cells_;
};

}  // namespace

std::vector<GapPiece> find_gaps(const Model& model, const std::function<double(int face)>& length) {
  std::vector<GapPiece> pieces;
  for (std::size_t f = 0; f < model.faces.size(); ++f) {
    const Face& face = model.faces[f];
    if (face.has_area && face.surface && !face.is_merged)
      GapsOfFace(model, face, length(static_cast<int>(f))).find(pieces);
  }
  return pieces;
}

}  // namespace paver
