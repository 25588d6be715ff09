// Steps: elements that share a cell of a grid with others that have no part in common with them, from all ranks; a tree
// of boxes about them; distances of the pairs whose boxes meet.
#include "check/distance/gaps.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <tuple>

#include "base/tasks/gather.h"
#include "check/distance/box_pairs.h"
#include "check/distance/mesh_pieces.h"

namespace paver {
namespace {

using Parts = std::vector<int>;
using Pair = std::array<int, 2>;

constexpr double no_gap = 1e-9;  // of the target length: nothing is nearer
/// Parts with points or edges in common touch elsewhere, too, where they come nearer than this, in target lengths, so
/// many target lengths from all these: a ball on a plate lies farther from it there, however fine the mesh.
constexpr double common_gap = 1e-3, from_common = 4;

/// With half of the largest gap that is told.
Box box_about(const Piece& piece) {
  const Box box = piece.patch.bounds();
  const double half = 0.5 * told_gap * piece.target;
  const Vec3 more{half, half, half};
  return {box.low - more, box.high + more};
}

struct Common {
  std::vector<Vec3> points;
  std::vector<const Edge*> edges;
};

/// A cell of a grid about the model, and one of the sets of parts that have elements in it.
struct Occupied {
  int cell = 0, set = 0;
  auto operator<=>(const Occupied&) const = default;
};

class GapSearch {
 public:
  GapSearch(const SurfaceMesh& mesh, const Model& model, Ranks& ranks)
      : model_(model), ranks_(ranks), all_(mesh, model, ranks) {}

  std::vector<Gap> run() {
    find_common();
    number_sets();
    gather();
    std::vector<Box> boxes;
    for (const Piece& piece : pieces_) {
      boxes.push_back(box_about(piece));
      about_.push_back(parts_about(piece));
    }
    for_meeting(boxes, [&](int i, int j) { compare(i, j); });
    std::vector<Gap> gaps;
    for (const auto& [pair, found] : nearest_)
      gaps.push_back({{model_.parts[pair[0]], model_.parts[pair[1]]}, found.distance, found.where});
    return gaps;
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

  static bool have_common(const Parts& a, const Parts& b) {
    Parts common;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
    return !common.empty();
  }

  // Pieces that share a cell with one of other parts, in an order that does not depend on ranks.
  void gather() {
    const CellGrid grid = all_.cells();
    std::vector<Occupied> occupied;
    all_.visit([&](const Piece& piece) {
      grid.visit(box_about(piece), [&](int cell) {
        const Occupied next{cell, set_of(piece)};
        if (occupied.empty() || next != occupied.back()) occupied.push_back(next);
      });
    });
    keep_shared(occupied);
    std::vector<Piece> mine;
    all_.visit([&](const Piece& piece) {
      bool is_near = false;
      grid.visit(box_about(piece), [&](int cell) {
        is_near = is_near || std::ranges::binary_search(occupied, Occupied{cell, set_of(piece)});
      });
      if (is_near) mine.push_back(piece);
    });
    pieces_ = gather_pieces(mine, ranks_);
  }

  // Of all ranks: those whose cell has a set without a part of theirs.
  void keep_shared(std::vector<Occupied>& occupied) const {
    auto sort = [&] {
      std::ranges::sort(occupied);
      occupied.erase(std::unique(occupied.begin(), occupied.end()), occupied.end());
    };
    sort();
    occupied = gather_all(occupied, ranks_);
    sort();
    std::vector<Occupied> shared;
    for (auto first = occupied.begin(); first != occupied.end();) {
      const auto last = std::find_if(first, occupied.end(), [&](const Occupied& o) { return o.cell != first->cell; });
      std::copy_if(first, last, std::back_inserter(shared), [&](const Occupied& o) {
        return std::any_of(first, last,
                           [&](const Occupied& other) { return !have_common(sets_[o.set], sets_[other.set]); });
      });
      first = last;
    }
    occupied = std::move(shared);
  }

  void compare(int i, int j) {
    const Piece &a = pieces_[i], &b = pieces_[j];
    if (have_common(about_[i], about_[j])) return;
    std::vector<Pair> pairs;
    for (int p : sets_[set_of(a)])
      for (int q : sets_[set_of(b)]) pairs.push_back({std::min(p, q), std::max(p, q)});
    const double target = std::min(a.target, b.target);
    std::erase_if(pairs, [&](Pair pair) { return meets_already(pair, target); });
    if (pairs.empty()) return;
    const PatchDistance found = distance(a.patch, b.patch);
    if (found.distance > told_gap * target) return;
    for (Pair pair : pairs) {
      if (!is_told(pair, found, target)) continue;
      auto [known, is_new] = nearest_.try_emplace(pair, found);
      auto key = [](const PatchDistance& d) { return std::tuple(d.distance, d.where.x, d.where.y, d.where.z); };
      if (!is_new && key(found) < key(known->second)) known->second = found;
    }
  }

  // Parts that run through each other do so in many elements, and one place is told.
  bool meets_already(Pair pair, double target) const {
    const auto known = nearest_.find(pair);
    return known != nearest_.end() && known->second.distance <= no_gap * target;
  }

  const Model& model_;
  Ranks& ranks_;
  const MeshPieces all_;
  std::vector<std::set<int>> vertex_parts_;
  std::map<Pair, Common> common_;
  std::vector<Parts> sets_;  // each rising
  std::vector<int> face_set_, edge_set_;
  std::vector<Piece> pieces_;
  std::vector<Parts> about_;  // per piece: parts_about()
  std::map<Pair, PatchDistance> nearest_;
};

}  // namespace

std::vector<Gap> find_gaps(const SurfaceMesh& mesh, const Model& model, Ranks& ranks) {
  if (model.parts.size() < 2) return {};
  return GapSearch(mesh, model, ranks).run();
}

}  // namespace paver
