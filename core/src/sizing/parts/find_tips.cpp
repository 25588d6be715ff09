// In: loops of faces. Out: vertices. Every face gives what it spans at its vertices; edges say where the surface is
// closed.
#include <algorithm>
#include <cmath>

#include "sizing/parts/find_places.h"
#include "topology/corner_angle.h"

namespace paver {
namespace {

constexpr double most_of_tip = M_PI * 0.999;  // a corner of three right angled or equilateral faces is none

class TipFinder {
 public:
  explicit TipFinder(const Model& model)
      : model_(model), angle_(model.vertices.size(), 0), is_open_(model.vertices.size(), 0) {}

  std::vector<Tip> run() {
    for (std::size_t f = 0; f < model_.faces.size(); ++f)
      for (const Loop& loop : model_.faces[f].loops) add(static_cast<int>(f), loop);
    for (const Edge& edge : model_.edges)
      if (edge.curve && edge.faces.size() != 2) open(edge.start), open(edge.end);
    std::vector<Tip> tips;
    std::vector<int> tip_of(angle_.size(), -1);
    for (std::size_t v = 0; v < angle_.size(); ++v) {
      if (!(angle_[v] > 0 && angle_[v] < most_of_tip) || is_open_[v]) continue;
      tip_of[v] = static_cast<int>(tips.size());
      tips.push_back({static_cast<int>(v), 0, {}});
    }
    for (const Edge& edge : model_.edges) {
      if (edge.is_degenerate) continue;
      if (edge.start >= 0) measure(edge, tip_of[edge.start], tips);
      if (edge.end >= 0 && edge.end != edge.start) measure(edge, tip_of[edge.end], tips);
    }
    return tips;
  }

 private:
  void open(int vertex) {
    if (vertex >= 0) is_open_[vertex] = 1;
  }

  void add(int f, const Loop& loop) {
    const Face& face = model_.faces[f];
    const std::size_t n = loop.coedges.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Coedge &before = loop.coedges[(i + n - 1) % n], &after = loop.coedges[i];
      const Edge& edge = edge_of(model_, after);
      const int vertex = start_of(edge, after);
      if (vertex < 0) continue;
      double& sum = angle_[vertex];
      if (!face.fault.empty() || (edge.is_degenerate && !after.pcurve))
        open(vertex);
      else if (edge.is_degenerate)
        sum += pole_angle(model_, face, after);
      else if (!edge_of(model_, before).is_degenerate)
        sum += corner_angle(model_, face, before, after);
    }
  }

  static void measure(const Edge& edge, int index, std::vector<Tip>& tips) {
    if (index < 0) return;
    Tip& tip = tips[index];
    tip.room = std::max(tip.room, edge.length);
    tip.faces.insert(tip.faces.end(), edge.faces.begin(), edge.faces.end());
  }

  const Model& model_;
  std::vector<double> angle_;  // per vertex
  std::vector<char> is_open_;
};

}  // namespace

std::vector<Tip> find_tips(const Model& model) { return TipFinder(model).run(); }

}  // namespace paver
