// Steps of build_model: edges and vertices, loops, orientation of faces.
#pragma once

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Face.hxx>
#include <string>
#include <vector>

#include "brep/connecting/workpiece_impl.h"
#include "topology/model.h"

namespace paver {

/// Which model edge an OpenCASCADE edge is.
struct EdgeIndex {
  TopTools_IndexedMapOfShape map;         ///< all edges, in the order of the model
  std::vector<int> edge;                  ///< per position from 1: index in Model::edges, -1 where no face uses it
  TopTools_IndexedMapOfShape vertex_map;  ///< all vertices
  std::vector<int> vertex{-1};            ///< per position from 1: index in Model::vertices

  /// -1: not in the model.
  int find(const TopoDS_Shape& shape) const { return edge[map.FindIndex(shape)]; }
  int find_vertex(const TopoDS_Shape& shape) const { return vertex[vertex_map.FindIndex(shape)]; }
};

/// Fills model.edges and model.vertices with what the faces and wires use, and with the points. Edges shorter than 1e-7
/// diagonal become degenerate and their two vertices one.
EdgeIndex build_edges(const Workpiece& work, Model& model);

/// Coedges of a face whose edges are these, by shares of their way: 0 at the start, 1 at the end.
class CoedgeWalker {
 public:
  explicit CoedgeWalker(const std::vector<Edge>& edges) : edges_(edges) {}
  const Edge& edge(const Coedge& c) const { return edges_[c.edge]; }
  int start(const Coedge& c) const { return start_of(edge(c), c); }
  int end(const Coedge& c) const { return end_of(edge(c), c); }
  double parameter(const Coedge& c, double share) const {
    double s = c.is_reversed ? 1 - share : share;
    return edge(c).t0 + s * (edge(c).t1 - edge(c).t0);
  }
  Vec2 uv_at(const Coedge& c, double share) const { return c.pcurve->uv(parameter(c, share)); }

 protected:
  const std::vector<Edge>& edges_;
};

struct LoopResult {
  std::vector<Loop> loops;
  std::string fault;       ///< not empty: no loops, and why
  int skipped_edges = 0;   ///< edges inside the face that bound nothing
  int turned_loops = 0;    ///< loops that ran the wrong way around
  double largest_gap = 0;  ///< between images of consecutive edges, over the extent of the face in (u, v)
};

/// Loops of a face. `face` must be FORWARD.
LoopResult build_loops(const TopoDS_Face& face, const Surface& surface, const EdgeIndex& index,
                       const std::vector<Edge>& edges);

/// Links edges inside a face into its loops, each walked on both sides. Gives how many could not be linked: those that
/// end at a pole.
int add_slits(const Surface& surface, const std::vector<Edge>& edges, const std::vector<Coedge>& inner,
              std::vector<Loop>& loops);

/// The faces with an area as BREP text, part by part: closed ones as solids, others as shells, then the wires and
/// points. `faces`: those of the model, as orienting left them.
std::string repaired_brep(const Workpiece& work, const std::vector<Face>& faces);

/// Turns faces over until neighbours agree, and closed bodies until their normals look outwards. Adds notes.
/// Gives the names of those that were turned. Collective.
std::vector<std::string> orient_faces(const Workpiece& work, Model& model, SharedTasks& tasks);

}  // namespace paver
