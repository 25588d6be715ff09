#include "support/deal_shares.h"

#include <random>

namespace paver::test {
namespace {

class Dealer {
 public:
  Dealer(const MeshResult& whole, int ranks, unsigned seed, int longest_run)
      : whole_(whole), ranks_(ranks), longest_run_(longest_run), random_(seed) {}

  std::vector<MeshShare> deal() {
    const SurfaceMesh& mesh = whole_.mesh;
    quad_rank_ = deal_runs(mesh.quad_count());
    triangle_rank_ = deal_runs(mesh.triangle_count());
    holds_.assign(static_cast<std::size_t>(ranks_), std::vector<char>(mesh.nodes.size(), 0));
    hold(mesh.quads, quad_rank_, mesh.nodes_per_quad());
    hold(mesh.triangles, triangle_rank_, mesh.nodes_per_triangle());
    for (auto& held : holds_)
      for (const std::vector<int>* nodes : {&mesh.lines, &mesh.points})
        for (int node : *nodes) held[static_cast<std::size_t>(node)] = 1;
    choose_owners();
    std::vector<MeshShare> shares;
    for (int rank = 0; rank < ranks_; ++rank) shares.push_back(share_of(rank));
    return shares;
  }

 private:
  int below(std::size_t n) { return static_cast<int>(random_() % n); }

  std::vector<int> deal_runs(std::size_t elements) {
    std::vector<int> rank_of;
    while (rank_of.size() < elements) {
      int length = 1 + below(static_cast<std::size_t>(longest_run_));
      rank_of.insert(rank_of.end(), static_cast<std::size_t>(length), below(static_cast<std::size_t>(ranks_)));
    }
    rank_of.resize(elements);
    return rank_of;
  }

  void hold(const std::vector<int>& elements, const std::vector<int>& rank_of, int stride) {
    for (std::size_t i = 0; i < elements.size(); ++i)
      holds_[rank_of[i / stride]][static_cast<std::size_t>(elements[i])] = 1;
  }

  void choose_owners() {
    for (std::size_t node = 0; node < whole_.mesh.nodes.size(); ++node) {
      std::vector<int> holders;
      for (int rank = 0; rank < ranks_; ++rank)
        if (holds_[rank][node]) holders.push_back(rank);
      if (holders.empty()) {
        holders = {below(static_cast<std::size_t>(ranks_))};
        holds_[holders[0]][node] = 1;
      }
      owner_.push_back(holders[static_cast<std::size_t>(below(holders.size()))]);
      is_shared_.push_back(holders.size() > 1);
    }
  }

  MeshShare share_of(int rank) const {
    const SurfaceMesh& from = whole_.mesh;
    MeshShare share;
    share.result.report = whole_.report;
    share.result.face_names = whole_.face_names;
    share.result.edge_names = whole_.edge_names;
    share.result.edge_groups = whole_.edge_groups;
    share.result.point_names = whole_.point_names;
    share.nodes = static_cast<long>(from.nodes.size());
    share.quads = static_cast<long>(from.quad_count());
    share.triangles = static_cast<long>(from.triangle_count());
    SurfaceMesh& mesh = share.result.mesh;
    mesh.order = from.order;
    std::vector<int> local = add_nodes(rank, share);
    add_elements(from.quads, from.quad_face, quad_rank_, rank, local, mesh.quads, mesh.quad_face, share.quad_number);
    add_elements(from.triangles, from.triangle_face, triangle_rank_, rank, local, mesh.triangles, mesh.triangle_face,
                 share.triangle_number);
    for (int node : from.lines) mesh.lines.push_back(local[static_cast<std::size_t>(node)]);
    for (int node : from.points) mesh.points.push_back(local[static_cast<std::size_t>(node)]);
    mesh.line_edge = from.line_edge;
    mesh.further_edges = from.further_edges;
    return share;
  }

  std::vector<int> add_nodes(int rank, MeshShare& share) const {
    const SurfaceMesh& from = whole_.mesh;
    SurfaceMesh& mesh = share.result.mesh;
    std::vector<int> local(from.nodes.size(), -1);
    for (std::size_t node = 0; node < from.nodes.size(); ++node) {
      if (!holds_[static_cast<std::size_t>(rank)][node]) continue;
      local[node] = static_cast<int>(mesh.nodes.size());
      mesh.nodes.push_back(from.nodes[node]);
      if (!from.node_edge.empty()) mesh.node_edge.push_back(from.node_edge[node]);
      if (!from.node_target.empty()) mesh.node_target.push_back(from.node_target[node]);
      share.node_number.list.push_back(static_cast<long>(node));
      share.is_own_node.push_back(owner_[node] == rank);
      share.is_shared_node.push_back(is_shared_[node]);
    }
    return local;
  }

  static void add_elements(const std::vector<int>& from, const std::vector<int>& face_of,
                           const std::vector<int>& rank_of, int rank, const std::vector<int>& local,
                           std::vector<int>& to, std::vector<int>& to_face, RowNumbers& numbers) {
    std::size_t stride = face_of.empty() ? 1 : from.size() / face_of.size();
    for (std::size_t i = 0; i < face_of.size(); ++i) {
      if (rank_of[i] != rank) continue;
      for (std::size_t k = 0; k < stride; ++k) to.push_back(local[static_cast<std::size_t>(from[i * stride + k])]);
      to_face.push_back(face_of[i]);
      numbers.list.push_back(static_cast<long>(i));
    }
  }

  const MeshResult& whole_;
  const int ranks_, longest_run_;
  std::mt19937 random_;  // its numbers are the same everywhere
  std::vector<int> quad_rank_, triangle_rank_, owner_;
  std::vector<char> is_shared_;
  std::vector<std::vector<char>> holds_;
};

}  // namespace

std::vector<MeshShare> deal_shares(const MeshResult& whole, int ranks, unsigned seed, int longest_run) {
  return Dealer(whole, ranks, seed, longest_run).deal();
}

}  // namespace paver::test
