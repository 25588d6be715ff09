// In: model, target length. Out: the model with edges divided.
// Steps, face by face: places opposite vertices, and where edges come nearest to each other; of places that are near
// each other the one of the narrowest gap. Faces of divided edges once more: the next line beside may be as near.
#include "sizing/gaps/divide_at_gaps.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <vector>

#include "sizing/gaps/gap_places.h"
#include "sizing/merging/merge_limits.h"

namespace paver {
namespace {

constexpr int most_rounds = 3;

bool may_have_gaps(const Face& face) { return face.is_meshed() && face.surface && !face.loops.empty(); }

class GapDivider {
 public:
  GapDivider(Model& model, const Options& options) : edits_(model), limits_(edits_, options, lasting_) {}

  void run() {
    std::set<int> open;
    for (std::size_t f = 0; f < edits_.model().faces.size(); ++f) open.insert(static_cast<int>(f));
    for (int round = 0; round < most_rounds && !open.empty(); ++round) {
      std::vector<GapPlace> places;
      for (const int f : open) {
        if (!may_have_gaps(edits_.face(f))) continue;
        const FaceBanks banks(edits_, f);
        find_gap_ends(banks, limits_, places);
        find_necks(banks, limits_, places);
      }
      open = divide(std::move(places));
    }
  }

 private:
  /// Narrowest gaps first; gives the faces of what was divided.
  std::set<int> divide(std::vector<GapPlace> places) {
    std::ranges::stable_sort(places, {}, &GapPlace::distance);
    std::map<int, std::vector<GapPlace>> of_edges;
    for (const GapPlace& place : places) {
      std::vector<GapPlace>& taken = of_edges[place.edge];
      auto is_near = [&](const GapPlace& other) { return std::fabs(other.before - place.before) < place.apart; };
      if (!limits_.has_own_length(place.edge) && std::ranges::none_of(taken, is_near)) taken.push_back(place);
    }
    std::set<int> faces;
    for (auto& [edge, taken] : of_edges) {
      if (taken.empty()) continue;
      faces.insert(edits_.edge(edge).faces.begin(), edits_.edge(edge).faces.end());
      // From its end on, as the edge keeps what lies before a place.
      std::ranges::sort(taken, std::ranges::greater(), &GapPlace::t);
      for (const GapPlace& place : taken) {
        const double length = edits_.edge(edge).length;
        const int behind = edits_.split(edge, place.t);
        edits_.edge(edge).length = place.before;
        edits_.edge(behind).length = length - place.before;
      }
    }
    return faces;
  }

  ModelEdits edits_;
  std::vector<int> lasting_;
  MergeLimits limits_;
};

}  // namespace

void divide_at_gaps(Model& model, const Options& options) { GapDivider(model, options).run(); }

}  // namespace paver
