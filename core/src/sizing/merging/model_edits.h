// Changes to the model that take small parts out of it.
#pragma once

#include <set>
#include <vector>

#include "topology/corner_angle.h"
#include "topology/model.h"

namespace paver {

/// A parameter of one edge for each of another: linear between rows.
struct ParameterMatch {
  std::vector<double> from, to;  ///< `from` rises

  double operator()(double t) const;
};

/// An edge as part of a side of a face, or of a chain.
struct SideEdge {
  int edge = -1;
  bool is_reversed = false;  ///< against the side
};
using Side = std::vector<SideEdge>;

/// The side as it runs the other way.
Side reversed(Side side);

/// Edges of a model by their vertices, kept up to date while edges go and vertices become one. Neither edges nor
/// vertices change their numbers; edges that are gone have no curve and no faces. Keeps a reference to the model.
class ModelEdits {
 public:
  explicit ModelEdits(Model& model);

  Model& model() { return model_; }
  const Model& model() const { return model_; }
  Face& face(int f) { return model_.faces[f]; }
  const Face& face(int f) const { return model_.faces[f]; }
  Edge& edge(int e) { return model_.edges[e]; }
  const Edge& edge(int e) const { return model_.edges[e]; }
  int start_of(SideEdge e) const { return e.is_reversed ? edge(e.edge).end : edge(e.edge).start; }
  int end_of(SideEdge e) const { return start_of({e.edge, !e.is_reversed}); }
  Vec3 point(int vertex) const { return model_.vertices[vertex]; }
  /// Edges with a curve that end at the vertex, rising; one that closes on itself twice.
  const std::vector<int>& edges_at(int vertex) const { return edges_at_[vertex]; }
  /// Whether nothing may move the vertex or take it away.
  bool is_fixed(int vertex) const { return is_fixed_[vertex] != 0; }
  /// Whether the surface had no corner at the edge before anything was merged there.
  bool was_smooth(int edge) const { return was_smooth_.contains(edge); }
  void note_smooth(int edge) { was_smooth_.insert(edge); }
  void fix(int vertex) { is_fixed_[vertex] = 1; }

  /// Whether the edge goes along an end of the face's image, and the face is far wider elsewhere.
  bool narrows_to(int face, const Coedge& end) const;

  /// No face uses the edges any more.
  void take_out(const std::vector<int>& edges);
  /// The same of edges that become points: faces that narrow to one have a pole there.
  void collapse(const std::vector<int>& edges);
  /// The edge with another curve and other ends.
  void set(int index, const Edge& edge);
  /// All edges that end at `from` end at `to`; their faces change by what lies between sides no longer than `reach`.
  void move_vertex(int from, int to, double reach);
  /// Divides the edge at `t`; gives the edge behind it. All faces have both.
  int split(int edge, double t);
  /// Faces that use `gone` use `kept` in its place. `match`: what kept's parameter is on `gone`.
  void replace(int gone, int kept, bool same_direction, const ParameterMatch& match);
  /// A face that its neighbours take over; its loops go.
  void leave_out(int face);

 private:
  void make_pole(int face, Coedge& coedge);
  void unlink(int edge);
  void link(int edge);

  Model& model_;
  std::vector<std::vector<int>> edges_at_;
  std::vector<char> is_fixed_;
  std::vector<int> poles_;
  std::set<int> was_smooth_;
};

/// Direction of an edge where it leaves one of its ends, of length one.
Vec3 direction_out(const Edge& edge, bool at_end);

/// Angle by which one edge that ends at a vertex bends off from the other.
double bend_between(const Edge& one, const Edge& other, int vertex);

}  // namespace paver
