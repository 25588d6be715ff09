// Steps: boxes of the parts; elements that lie where boxes of parts without a common vertex meet, from all ranks; a
// tree of boxes about them; distances of the pairs whose boxes meet.
#include "check/distance/gaps.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <span>
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
/// Parts with nothing but points in common touch elsewhere, too, where they come nearer than this, in target lengths,
/// so many target lengths from all these: a ball on a plate lies farther from it there, however fine the mesh.
constexpr double point_gap = 1e-3, from_points = 4;

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

class GapSearch {
 public:
  GapSearch(const SurfaceMesh& mesh, const Model& model, Ranks& ranks) : mesh_(mesh), model_(model), ranks_(ranks) {}

  std::vector<Gap> run() {
    find_neighbours();
    if (model_.parts.size() > 1) longest_ = longest_element();
    find_partners();
    if (std::all_of(partners_.begin(), partners_.end(), [](const Parts& of) { return of.empty(); })) return {};
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
  // Pairs of parts with an edge in common, and with vertices only.
  void find_neighbours() {
    vertex_parts_.resize(model_.vertices.size());
    std::vector<std::set<int>>& parts = vertex_parts_;
    std::vector<std::set<int>> edge_parts(model_.edges.size());
    auto note = [&](int edge, const Parts& of) {
      const Edge& e = model_.edges[edge];
      for (int vertex : {e.start, e.end}) parts[vertex].insert(of.begin(), of.end());
      if (!e.is_degenerate) edge_parts[edge].insert(of.begin(), of.end());
    };
    for (std::size_t f = 0; f < model_.faces.size(); ++f) {
      for (const Loop& loop : model_.faces[f].loops)
        for (const Coedge& coedge : loop.coedges) note(coedge.edge, model_.face_parts[f]);
      for (const InnerPoint& point : model_.faces[f].points)
        parts[point.vertex].insert(model_.face_parts[f].begin(), model_.face_parts[f].end());
    }
    for (std::size_t e = 0; e < model_.edges.size(); ++e)
      if (model_.edge_part[e] >= 0) note(static_cast<int>(e), {model_.edge_part[e]});
    auto for_pairs = [](const std::set<int>& of, auto visit) {
      for (auto a = of.begin(); a != of.end(); ++a)
        for (auto b = std::next(a); b != of.end(); ++b) visit(Pair{*a, *b});
    };
    for (const std::set<int>& of : edge_parts) for_pairs(of, [&](Pair pair) { neighbours_.insert(pair); });
    for (std::size_t v = 0; v < parts.size(); ++v)
      for_pairs(parts[v], [&](Pair pair) {
        if (!neighbours_.contains(pair)) common_points_[pair].push_back(model_.vertices[v]);
      });
  }

  bool are_apart(int a, int b) const { return a != b && !neighbours_.contains({std::min(a, b), std::max(a, b)}); }

  bool is_told(Pair pair, const PatchDistance& found, double target) const {
    const auto points = common_points_.find(pair);
    if (points == common_points_.end()) return true;
    auto is_near = [&](Vec3 point) { return norm(found.where - point) < from_points * target; };
    return found.distance <= point_gap * target && std::none_of(points->second.begin(), points->second.end(), is_near);
  }

  std::span<const int> parts_of(const Piece& piece) const {
    if (piece.face >= 0) return model_.face_parts[piece.face];
    return {&model_.edge_part[piece.edge], 1};
  }

  // Parts that have the piece or one of its nodes, rising.
  Parts parts_about(const Piece& piece) const {
    const std::span<const int> own = parts_of(piece);
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

  // Of all ranks. At the lowest frequencies the target length is beyond all elements, and all parts were near each
  // other.
  double longest_element() const {
    double longest = 0;
    for_pieces([&](const Piece& piece) {
      const Vec3* x = piece.patch.nodes.data();
      for (int k = 1; k < piece.patch.corners; ++k) longest = std::max(longest, norm(x[k] - x[0]));
    });
    return greatest(longest, ranks_);
  }

  // Parts apart whose boxes meet. The boxes of all ranks.
  void find_partners() {
    partners_.resize(model_.parts.size());
    if (model_.parts.size() < 2) return;
    part_boxes_.resize(model_.parts.size());
    for_pieces([&](const Piece& piece) {
      const Box box = piece.box();
      for (int part : parts_of(piece)) part_boxes_[part].add(box);
    });
    unite(part_boxes_, ranks_);
    std::vector<int> by_x(model_.parts.size());
    std::iota(by_x.begin(), by_x.end(), 0);
    std::stable_sort(by_x.begin(), by_x.end(),
                     [&](int a, int b) { return part_boxes_[a].low.x < part_boxes_[b].low.x; });
    for (std::size_t i = 0; i < by_x.size(); ++i)
      for (std::size_t j = i + 1; j < by_x.size() && part_boxes_[by_x[j]].low.x <= part_boxes_[by_x[i]].high.x; ++j)
        if (part_boxes_[by_x[i]].meets(part_boxes_[by_x[j]]) && are_apart(by_x[i], by_x[j])) {
          partners_[by_x[i]].push_back(by_x[j]);
          partners_[by_x[j]].push_back(by_x[i]);
        }
  }

  // Pieces that reach into the box of a part apart from theirs, in an order that does not depend on ranks.
  void gather() {
    std::vector<Piece> mine;
    for_pieces([&](const Piece& piece) {
      const Box box = piece.box();
      const std::span<const int> parts = parts_of(piece);
      const bool is_near = std::any_of(parts.begin(), parts.end(), [&](int part) {
        const Parts& of = partners_[part];
        return std::any_of(of.begin(), of.end(), [&](int other) { return part_boxes_[other].meets(box); });
      });
      if (is_near) mine.push_back(piece);
    });
    pieces_ = gather_all(mine, ranks_);
    std::ranges::sort(pieces_, {}, &Piece::key);
    auto is_same = [](const Piece& a, const Piece& b) { return a.key() == b.key(); };
    pieces_.erase(std::unique(pieces_.begin(), pieces_.end(), is_same), pieces_.end());
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
    const std::span<const int> of_a = parts_of(a), of_b = parts_of(b);
    std::vector<Pair> pairs;
    for (int p : of_a)
      for (int q : of_b)
        if (are_apart(p, q)) pairs.push_back({std::min(p, q), std::max(p, q)});
    const double target = std::min(a.target, b.target);
    std::erase_if(pairs, [&](Pair pair) { return meets_already(pair, target); });
    if (pairs.empty() || have_common(about_[i], about_[j])) return;
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
  double longest_ = std::numeric_limits<double>::infinity();  // mm, of the elements
  std::vector<std::set<int>> vertex_parts_;
  std::set<Pair> neighbours_;
  std::map<Pair, std::vector<Vec3>> common_points_;  // of parts that have nothing else in common
  std::vector<Parts> partners_;                      // per part: parts apart from it whose boxes meet its own
  std::vector<Box> part_boxes_, boxes_;
  std::vector<Piece> pieces_;
  std::vector<Parts> about_;  // per piece: parts_about()
  std::map<Pair, PatchDistance> nearest_;
};

}  // namespace

std::vector<Gap> find_gaps(const SurfaceMesh& mesh, const Model& model, Ranks& ranks) {
  return GapSearch(mesh, model, ranks).run();
}

}  // namespace paver
