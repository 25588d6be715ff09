// Steps: elements that share a cell of a grid with others that have no part in common with them, from all ranks; a tree
// of boxes about them; distances of the pairs whose boxes meet.
#include "check/distance/gaps.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "base/tasks/gather.h"
#include "check/distance/element_patch.h"

namespace paver {
namespace {

using Parts = std::vector<int>;
using Pair = std::array<int, 2>;

/// Of how far a quadratic element reaches beyond its nodes, of their extent.
constexpr double overshoot = 0.3;
constexpr double no_gap = 1e-9;  // of the target length: nothing is nearer
/// Parts with points or edges in common touch elsewhere, too, where they come nearer than this, in target lengths, so
/// many target lengths from all these: a ball on a plate lies farther from it there, however fine the mesh.
constexpr double common_gap = 1e-3, from_common = 4;

/// An element or a line of a wire, as ranks give it to each other.
struct Piece {
  ElementPatch patch;
  int face = -1, edge = -1;
  std::array<int, 9> node_edge{};  // B-rep edge per node, or -1
  double target = 0;

  Box box() const {
    Box box;
    for (int k = 0; k < patch.node_count(); ++k) box.add(patch.nodes[k]);
    const Vec3 more = overshoot * (patch.order - 1) * (box.high - box.low);
    const double gap = 0.5 * told_gap * target;
    const Vec3 grown = more + Vec3{gap, gap, gap};
    return {box.low - grown, box.high + grown};
  }
  auto key() const {
    const Vec3 a = patch.nodes[0], b = patch.nodes[1], c = patch.nodes[2];
    return std::tuple(face, edge, a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z);
  }
};

struct Common {
  std::vector<Vec3> points;
  std::vector<const Edge*> edges;
};

/// Cubes about the model, those at its border without end: at most `most` along a side, none smaller than the longest
/// element.
class CellGrid {
 public:
  CellGrid(const Box& whole, double longest) : low_(whole.low) {
    const Vec3 size = whole.high - whole.low;
    side_ = std::max(longest, std::max({size.x, size.y, size.z}) / most);
  }

  template <class Visit>
  void visit(const Box& box, Visit visit) const {
    const std::array<int, 3> a = cell(box.low), b = cell(box.high);
    for (int x = a[0]; x <= b[0]; ++x)
      for (int y = a[1]; y <= b[1]; ++y)
        for (int z = a[2]; z <= b[2]; ++z) visit((x * most + y) * most + z);
  }

 private:
  static constexpr int most = 64;

  std::array<int, 3> cell(Vec3 x) const {
    auto along = [&](double from) { return std::clamp(static_cast<int>(from / side_), 0, most - 1); };
    const Vec3 from = x - low_;
    return {along(from.x), along(from.y), along(from.z)};
  }

  Vec3 low_;
  double side_ = 1;
};

/// A cell of a grid about the model, and one of the sets of parts that have elements in it.
struct Occupied {
  int cell = 0, set = 0;
  auto operator<=>(const Occupied&) const = default;
};

class GapSearch {
 public:
  GapSearch(const SurfaceMesh& mesh, const Model& model, Ranks& ranks) : mesh_(mesh), model_(model), ranks_(ranks) {}

  std::vector<Gap> run() {
    if (model_.parts.size() < 2) return {};
    find_common();
    number_sets();
    measure();
    gather();
    for (const Piece& piece : pieces_) {
      boxes_.push_back(piece.box());
      about_.push_back(parts_about(piece));
    }
    std::vector<int> all(pieces_.size());
    std::iota(all.begin(), all.end(), 0);
    search(all);
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

  template <class Visit>
  void for_pieces(Visit visit) const {
    auto all = [&](const std::vector<int>& rows, const std::vector<int>& owners, int corners, int stride) {
      for (std::size_t i = 0; i < owners.size(); ++i) {
        Piece piece;
        piece.patch.corners = corners;
        piece.patch.order = mesh_.order;
        (corners > 2 ? piece.face : piece.edge) = owners[i];
        if (corners == 2 && model_.edge_part[owners[i]] < 0) continue;
        for (int k = 0; k < stride; ++k) {
          piece.patch.nodes[k] = mesh_.nodes[rows[i * stride + k]];
          piece.node_edge[k] = mesh_.node_edge[rows[i * stride + k]];
        }
        for (int k = 0; k < corners; ++k) piece.target += mesh_.node_target[rows[i * stride + k]] / corners;
        piece.target = std::min(piece.target, longest_);
        visit(piece);
      }
    };
    all(mesh_.quads, mesh_.quad_face, 4, mesh_.nodes_per_quad());
    all(mesh_.triangles, mesh_.triangle_face, 3, mesh_.nodes_per_triangle());
    all(mesh_.lines, mesh_.line_edge, 2, mesh_.order + 1);
  }

  // Of all ranks: the box about all nodes, and the longest element: at the lowest frequencies the target length is
  // beyond that, and all parts were near each other.
  void measure() {
    std::vector<Box> whole(1);
    double longest = 0;
    for_pieces([&](const Piece& piece) {
      const Vec3* x = piece.patch.nodes.data();
      for (int k = 0; k < piece.patch.corners; ++k) {
        whole[0].add(x[k]);
        longest = std::max(longest, norm(x[k] - x[0]));
      }
    });
    unite(whole, ranks_);
    whole_ = whole[0];
    longest_ = greatest(longest, ranks_);
  }

  // Pieces that share a cell with one of other parts, in an order that does not depend on ranks.
  void gather() {
    const CellGrid grid(whole_, longest_);
    std::vector<Occupied> occupied;
    for_pieces([&](const Piece& piece) {
      grid.visit(piece.box(), [&](int cell) {
        const Occupied next{cell, set_of(piece)};
        if (occupied.empty() || next != occupied.back()) occupied.push_back(next);
      });
    });
    keep_shared(occupied);
    std::vector<Piece> mine;
    for_pieces([&](const Piece& piece) {
      bool is_near = false;
      grid.visit(piece.box(), [&](int cell) {
        is_near = is_near || std::ranges::binary_search(occupied, Occupied{cell, set_of(piece)});
      });
      if (is_near) mine.push_back(piece);
    });
    pieces_ = gather_all(mine, ranks_);
    std::ranges::sort(pieces_, {}, &Piece::key);
    auto is_same = [](const Piece& a, const Piece& b) { return a.key() == b.key(); };
    pieces_.erase(std::unique(pieces_.begin(), pieces_.end(), is_same), pieces_.end());
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

  // Halves the pieces along the longest side of their box and compares the halves where they meet.
  void search(const std::vector<int>& all) {
    if (all.size() < 2) return;
    auto [low, high] = halves(all);
    search(low);
    search(high);
    meet(std::move(low), std::move(high));
  }

  // Pairs between two sets of pieces: those of either that the other's box does not meet are left out on the way.
  void meet(std::vector<int> a, std::vector<int> b) {
    keep_meeting(a, b);
    keep_meeting(b, a);
    constexpr std::size_t few = 64;
    if (a.empty() || b.empty()) return;
    if (a.size() * b.size() <= few || std::min(a.size(), b.size()) == 1) {
      for (int i : a)
        for (int j : b) compare(i, j);
      return;
    }
    std::vector<int>& larger = a.size() >= b.size() ? a : b;
    const std::vector<int> other = a.size() >= b.size() ? b : a;
    auto [low, high] = halves(larger);
    meet(std::move(low), other);
    meet(std::move(high), other);
  }

  Box box_of(const std::vector<int>& some) const {
    Box box;
    for (int i : some) box.add(boxes_[i]);
    return box;
  }

  void keep_meeting(std::vector<int>& a, const std::vector<int>& b) const {
    const Box box = box_of(b);
    std::erase_if(a, [&](int i) { return !boxes_[i].meets(box); });
  }

  std::pair<std::vector<int>, std::vector<int>> halves(std::vector<int> all) const {
    const Box box = box_of(all);
    const Vec3 size = box.high - box.low;
    const bool is_x = size.x >= size.y && size.x >= size.z, is_y = !is_x && size.y >= size.z;
    auto along = [&](Vec3 x) { return is_x ? x.x : is_y ? x.y : x.z; };
    auto place = [&](int i) { return std::pair(along(boxes_[i].low + boxes_[i].high), i); };
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
    std::nth_element(all.begin(), middle, all.end(), [&](int i, int j) { return place(i) < place(j); });
    return {{all.begin(), middle}, {middle, all.end()}};
  }

  void compare(int i, int j) {
    if (!boxes_[i].meets(boxes_[j])) return;
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

  const SurfaceMesh& mesh_;
  const Model& model_;
  Ranks& ranks_;
  Box whole_;
  double longest_ = std::numeric_limits<double>::infinity();  // mm, of the elements
  std::vector<std::set<int>> vertex_parts_;
  std::map<Pair, Common> common_;
  std::vector<Parts> sets_;  // each rising
  std::vector<int> face_set_, edge_set_;
  std::vector<Box> boxes_;
  std::vector<Piece> pieces_;
  std::vector<Parts> about_;  // per piece: parts_about()
  std::map<Pair, PatchDistance> nearest_;
};

}  // namespace

std::vector<Gap> find_gaps(const SurfaceMesh& mesh, const Model& model, Ranks& ranks) {
  return GapSearch(mesh, model, ranks).run();
}

}  // namespace paver
