// Steps: pairs of elements that are near each other in cells of space where elements have no part in common; their
// distances.
#include "check/distance/gaps.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <tuple>

#include "check/near/found_places.h"

namespace paver {
namespace {

using Parts = std::vector<int>;
using Pair = std::array<int, 2>;

constexpr double no_gap = 1e-9;  // of the target length: nothing is nearer
/// Parts with points or edges in common touch elsewhere, too, where they come nearer than this, in target lengths, a
/// target length from all these: a ball on a plate lies farther from it there if the mesh is no finer than a 500th of
/// its radius. So do parts that run into each other.
constexpr double common_gap = 1e-3, from_common = 1;

struct Common {
  std::vector<Vec3> points;
  std::vector<const Edge*> edges;
};

bool have_common(const Parts& a, const Parts& b) { return std::ranges::find_first_of(a, b) != a.end(); }

/// Some of the sets of parts that have elements in a cell.
struct CellSets {
  static constexpr int most = 6;
  std::array<int, most> sets{};
  int count = 0;  ///< most + 1: of more

  void add(int set) {
    if (count > most || std::find(sets.begin(), sets.begin() + count, set) != sets.begin() + count) return;
    if (count < most) sets[count] = set;
    ++count;
  }
  void add(const CellSets& others) {
    if (others.count > most) count = others.count;
    for (int i = 0; i < std::min(others.count, most); ++i) add(others.sets[i]);
  }
};

/// Of a pair of parts: the nearest; of those where the parts meet, the first.
struct GapPlace {
  Pair pair{};
  PatchDistance found;
  bool is_met = false;
  PairOrder order;

  auto key() const {
    const Vec3 x = found.where;
    return std::tuple(!is_met, is_met ? order : PairOrder{}, found.distance, x.x, x.y, x.z);
  }
};
using FoundGaps = FoundPlaces<GapPlace>;

/// Parts that run through each other do so in many elements.
bool are_met(const FoundGaps& found, Pair parts) {
  const GapPlace* place = found.of(parts);
  return place && place->is_met;
}

class GapSearch {
 public:
  using Summary = CellSets;

  GapSearch(const MeshPieces& all, const Model& model) : model_(model), all_(all) {
    find_common();
    number_sets();
  }

  bool is_wanted(std::size_t element) const { return element < all_.element_count() || all_.is_of_wire(element); }
  /// With half of the largest gap that is told.
  Box box(const Piece& piece) const { return piece.patch.bounds().grown(0.5 * told_gap * piece.target); }
  CellSets summary(const Piece& piece) const {
    CellSets own;
    own.add(set_of(piece));
    return own;
  }
  bool is_mixed(const CellSets& some) const {
    for (int i = 0; i < std::min(some.count, CellSets::most); ++i)
      for (int k = 0; k < i; ++k)
        if (!have_common(sets_[some.sets[i]], sets_[some.sets[k]])) return true;
    return some.count > CellSets::most;
  }

  void compare(FoundGaps& some, const Piece& a, const Piece& b, const PairOrder& order) const {
    const Parts &of_a = sets_[set_of(a)], &of_b = sets_[set_of(b)];
    if (have_common(of_a, of_b)) return;
    std::vector<Pair> pairs;
    for (int p : of_a)
      for (int q : of_b)
        if (const Pair pair{std::min(p, q), std::max(p, q)}; !are_met(some, pair)) pairs.push_back(pair);
    const double target = std::min(a.target, b.target);
    if (pairs.empty() || are_apart(a.patch, b.patch, told_gap * target)) return;
    if (have_common(parts_about(a), parts_about(b))) return;
    const PatchDistance found = distance(a.patch, b.patch);
    if (found.distance > told_gap * target) return;
    const Parts &before_a = solids_along(a, found.way), &before_b = solids_along(b, -1 * found.way);
    for (Pair pair : pairs) {
      const bool is_gap = before_a.empty() && before_b.empty(),
                 is_overlap = found.distance <= common_gap * target && has(before_a, pair) && has(before_b, pair);
      if ((is_gap || is_overlap) && is_told(pair, found, target))
        some.add({pair, found, found.distance <= no_gap * target, order});
    }
  }

 private:
  // What pairs of parts have in common.
  void find_common() {
    vertex_parts_.resize(model_.vertices.size());
    std::vector<std::set<int>> edge_parts(model_.edges.size());
    auto note = [&](int edge, const Parts& of) {
      const Edge& e = model_.edges[edge];
      for (int vertex : {e.start, e.end}) vertex_parts_[vertex].insert(of.begin(), of.end());
      if (!e.is_degenerate) edge_parts[edge].insert(of.begin(), of.end());
    };
    for (std::size_t f = 0; f < model_.faces.size(); ++f) {
      for (const Loop& loop : model_.faces[f].loops)
        for (const Coedge& coedge : loop.coedges) note(coedge.edge, model_.face_parts[f]);
      for (const InnerPoint& point : model_.faces[f].points)
        vertex_parts_[point.vertex].insert(model_.face_parts[f].begin(), model_.face_parts[f].end());
    }
    for (std::size_t e = 0; e < model_.edges.size(); ++e)
      if (model_.edge_part[e] >= 0) note(static_cast<int>(e), {model_.edge_part[e]});
    auto for_pairs = [](const std::set<int>& of, auto visit) {
      for (auto a = of.begin(); a != of.end(); ++a)
        for (auto b = std::next(a); b != of.end(); ++b) visit(Pair{*a, *b});
    };
    for (std::size_t v = 0; v < vertex_parts_.size(); ++v)
      for_pairs(vertex_parts_[v], [&](Pair pair) { common_[pair].points.push_back(model_.vertices[v]); });
    for (std::size_t e = 0; e < edge_parts.size(); ++e)
      for_pairs(edge_parts[e], [&](Pair pair) { common_[pair].edges.push_back(&model_.edges[e]); });
  }

  // The sets of parts that have a face or a wire, the same on all ranks.
  void number_sets() {
    std::map<Parts, int> numbers;
    auto number = [&](Parts of) {
      std::ranges::sort(of);
      const auto [known, is_new] = numbers.try_emplace(of, static_cast<int>(sets_.size()));
      if (is_new) sets_.push_back(std::move(of));
      return known->second;
    };
    for (const Parts& of : model_.face_parts) face_set_.push_back(number(of));
    for (int part : model_.edge_part) edge_set_.push_back(part >= 0 ? number({part}) : -1);
  }

  bool is_told(Pair pair, const PatchDistance& found, double target) const {
    const auto common = common_.find(pair);
    if (common == common_.end()) return true;
    const double far = from_common * target;
    auto is_near = [&](Vec3 point) { return norm(found.where - point) < far; };
    return found.distance <= common_gap * target &&
           std::none_of(common->second.points.begin(), common->second.points.end(), is_near) &&
           std::none_of(common->second.edges.begin(), common->second.edges.end(),
                        [&](const Edge* edge) { return is_nearer(found.where, *edge, far); });
  }

  // By places along the edge, a quarter of `far` apart where it is not ten thousand times as long.
  static bool is_nearer(Vec3 x, const Edge& edge, double far) {
    constexpr double most = 1e4;
    const int steps = static_cast<int>(std::clamp(4 * edge.length / far, 4.0, most));
    for (int i = 0; i <= steps; ++i)
      if (norm(edge.curve->point(edge.parameter(static_cast<double>(i) / steps)) - x) < far) return true;
    return false;
  }

  /// What is between parts there is meshed, too: a trace and a ground plane are as far apart as the board between them
  /// is thick, and the far side of a part is no nearer to others than what bounds it before. But where both parts are
  /// there, they run into each other.
  const Parts& solids_along(const Piece& piece, Vec3 way) const {
    constexpr double least_steep = 0.5;  // sine
    static const Parts none;
    if (piece.face < 0) return none;
    const Vec3 normal = piece.patch.mean_normal();
    const double steep = dot(way, normal), least = least_steep * norm(way) * norm(normal);
    const Face& face = model_.faces[piece.face];
    return steep > least ? face.front : steep < -least ? face.back : none;
  }

  static bool has(const Parts& parts, Pair pair) {
    return std::ranges::all_of(pair, [&](int part) { return std::ranges::find(parts, part) != parts.end(); });
  }

  int set_of(const Piece& piece) const { return piece.face >= 0 ? face_set_[piece.face] : edge_set_[piece.edge]; }

  // Parts that have the piece or one of its nodes, rising.
  Parts parts_about(const Piece& piece) const {
    const Parts& own = sets_[set_of(piece)];
    std::set<int> about(own.begin(), own.end());
    for (int k = 0; k < piece.patch.node_count(); ++k) {
      if (piece.node_edge[k] < 0) continue;
      const Edge& edge = model_.edges[piece.node_edge[k]];
      for (int face : edge.faces) about.insert(model_.face_parts[face].begin(), model_.face_parts[face].end());
      for (int vertex : {edge.start, edge.end})
        if (piece.patch.nodes[k] == model_.vertices[vertex])
          about.insert(vertex_parts_[vertex].begin(), vertex_parts_[vertex].end());
    }
    return {about.begin(), about.end()};
  }

  const Model& model_;
  const MeshPieces& all_;
  std::vector<std::set<int>> vertex_parts_;
  std::map<Pair, Common> common_;
  std::vector<Parts> sets_;  // each rising
  std::vector<int> face_set_, edge_set_;
};

}  // namespace

std::vector<Gap> find_gaps(const MeshPieces& pieces, const Model& model, Ranks& ranks) {
  if (model.parts.size() < 2) return {};
  std::vector<Gap> gaps;
  for (const auto& [pair, found, is_met, order] : find_places<GapPlace>(GapSearch(pieces, model), pieces, ranks))
    gaps.push_back({{model.parts[pair[0]], model.parts[pair[1]]}, found.distance, found.where});
  return gaps;
}

}  // namespace paver
