// Orientation: faces that share an edge must run along it in opposite directions, and a closed body's normals must look
// outwards. Files without topology say nothing about either, so neighbours are walked over edges of exactly two faces.
#include <algorithm>
#include <queue>

#include "topology/build_parts_impl.h"

namespace paver {
namespace {

struct Side {
  int face = -1;
  bool is_reversed = false;  ///< runs against the edge, the face's own reversal included
};

class Orienter {
 public:
  Orienter(const Workpiece& work, Model& model, SharedTasks& tasks)
      : work_(work), model_(model), tasks_(tasks), sides_(model.edges.size()) {
    for (std::size_t f = 0; f < model.faces.size(); ++f) {
      for (const Loop& loop : model.faces[f].loops)
        for (const Coedge& c : loop.coedges)
          sides_[static_cast<std::size_t>(c.edge)].push_back(
              {static_cast<int>(f), c.is_reversed != model.faces[f].is_reversed});
    }
    part_.assign(model.faces.size(), -1);
    is_turned_.assign(model.faces.size(), false);
  }

  void run() {
    for (std::size_t f = 0; f < model_.faces.size(); ++f) {
      if (part_[f] < 0 && !model_.faces[f].loops.empty()) walk(static_cast<int>(f));
    }
    look_outwards();
    apply();
  }

 private:
  /// Faces that hang together, made to agree with each other; the majority stays as it is.
  void walk(int seed) {
    int part = static_cast<int>(parts_.size());
    std::vector<int> members;
    std::queue<int> open;
    auto enter = [&](int face, bool is_turned) {
      part_[static_cast<std::size_t>(face)] = part;
      is_turned_[static_cast<std::size_t>(face)] = is_turned;
      open.push(face);
      members.push_back(face);
    };
    enter(seed, false);
    for (; !open.empty(); open.pop()) {
      int face = open.front();
      for (const Loop& loop : model_.faces[static_cast<std::size_t>(face)].loops)
        for (const Coedge& c : loop.coedges) cross_edge(c.edge, face, enter);
    }
    std::size_t turned = 0;
    for (int f : members) turned += is_turned_[static_cast<std::size_t>(f)];
    if (2 * turned > members.size()) turn(members);
    parts_.push_back(std::move(members));
  }

  template <class Enter>
  void cross_edge(int edge, int face, Enter&& enter) {
    const auto& sides = sides_[static_cast<std::size_t>(edge)];
    if (sides.size() != 2 || sides[0].face == sides[1].face) return;
    const Side& here = sides[0].face == face ? sides[0] : sides[1];
    const Side& there = sides[0].face == face ? sides[1] : sides[0];
    auto other = static_cast<std::size_t>(there.face);
    bool is_turned = is_turned_[static_cast<std::size_t>(face)] != (here.is_reversed == there.is_reversed);
    if (part_[other] < 0) {
      enter(there.face, is_turned);
    } else if (is_turned_[other] != is_turned) {
      is_one_sided_ = true;
    }
  }

  void turn(const std::vector<int>& members) {
    for (int f : members) is_turned_[static_cast<std::size_t>(f)] = !is_turned_[static_cast<std::size_t>(f)];
  }

  bool is_closed(const std::vector<int>& members) const {
    for (int f : members)
      for (const Loop& loop : model_.faces[static_cast<std::size_t>(f)].loops)
        for (const Coedge& c : loop.coedges) {
          if (sides_[static_cast<std::size_t>(c.edge)].size() != 2 &&
              !model_.edges[static_cast<std::size_t>(c.edge)].is_degenerate)
            return false;
        }
    return true;
  }

  /// Near all of them: what the sum over the faces is off grows with the distance.
  Vec3 middle_of(const std::vector<int>& members) const {
    Vec3 sum{0, 0, 0};
    double count = 0;
    for (int f : members)
      for (const Loop& loop : model_.faces[static_cast<std::size_t>(f)].loops)
        for (const Coedge& c : loop.coedges) {
          const Edge& edge = model_.edges[static_cast<std::size_t>(c.edge)];
          sum += model_.vertices[static_cast<std::size_t>(edge.start)];
          ++count;
        }
    return (1 / std::max(count, 1.0)) * sum;
  }

  /// Volumes inside closed bodies, of all their faces at once; NaN where the kernel cannot compute one.
  std::vector<double> volumes(const std::vector<std::vector<int>>& bodies) {
    struct Part {
      TopoDS_Face face;
      std::size_t body;
      Vec3 apex;
    };
    std::vector<Part> parts;
    std::vector<double> costs;
    for (std::size_t body = 0; body < bodies.size(); ++body) {
      const Vec3 apex = middle_of(bodies[body]);
      for (int f : bodies[body]) {
        auto i = static_cast<std::size_t>(f);
        parts.push_back({work_.faces[i].face, body, apex});
        if (is_turned_[i]) parts.back().face.Reverse();
        costs.push_back(measuring_cost(parts.back().face));
      }
    }
    const std::vector<double> shares = tasks_.run<double>(Stage::topology, costs, [&](int i) {
      const Part& part = parts[static_cast<std::size_t>(i)];
      return volume_to(part.face, part.apex);
    });
    std::vector<double> sums(bodies.size(), 0.0);
    for (std::size_t i = 0; i < parts.size(); ++i) sums[parts[i].body] += shares[i];
    return sums;
  }

  /// A solid's shells are judged together (those of cavities look inwards), other closed parts one by one.
  void look_outwards() {
    std::vector<std::vector<int>> bodies;
    std::vector<int> body_of_solid;
    for (const auto& part : parts_) {
      if (!is_closed(part)) continue;
      int solid = work_.faces[static_cast<std::size_t>(part[0])].solid;
      if (solid >= static_cast<int>(body_of_solid.size()))
        body_of_solid.resize(static_cast<std::size_t>(solid) + 1, -1);
      if (solid >= 0 && body_of_solid[static_cast<std::size_t>(solid)] >= 0) {
        auto& body = bodies[static_cast<std::size_t>(body_of_solid[static_cast<std::size_t>(solid)])];
        body.insert(body.end(), part.begin(), part.end());
        continue;
      }
      if (solid >= 0) body_of_solid[static_cast<std::size_t>(solid)] = static_cast<int>(bodies.size());
      bodies.push_back(part);
    }
    const std::vector<double> inside = volumes(bodies);
    for (std::size_t i = 0; i < bodies.size(); ++i)
      if (inside[i] < 0) turn(bodies[i]);
  }

  void apply() {
    std::vector<std::string> turned;
    for (std::size_t f = 0; f < model_.faces.size(); ++f) {
      if (!is_turned_[f]) continue;
      model_.faces[f].is_reversed = !model_.faces[f].is_reversed;
      turned.push_back(model_.faces[f].name);
    }
    if (!turned.empty())
      model_.notes.push_back("Turned over so that normals agree and look outwards: " + list_names(turned) + ".");
    if (is_one_sided_)
      model_.notes.push_back(
          "The faces form a one-sided surface (like a Moebius strip): their normals cannot all agree.");
  }

  const Workpiece& work_;
  Model& model_;
  SharedTasks& tasks_;
  std::vector<std::vector<Side>> sides_;  ///< per edge
  std::vector<int> part_;                 ///< per face: index of its part, -1 before
  std::vector<bool> is_turned_;
  std::vector<std::vector<int>> parts_;
  bool is_one_sided_ = false;
};

}  // namespace

void orient_faces(const Workpiece& work, Model& model, SharedTasks& tasks) { Orienter(work, model, tasks).run(); }

}  // namespace paver
