// Orientation: faces of a part that share an edge must run along it in opposite directions, and a closed body's normals
// must look outwards. Files without topology say nothing about either, so neighbours are walked over edges of exactly
// two of the part's faces.
#include <algorithm>
#include <map>
#include <queue>
#include <set>

#include "topology/build_parts_impl.h"

namespace paver {
namespace {

/// A face as one of the parts that have it sees it.
struct Use {
  int face = -1, part = -1;
  bool is_opposed = false;  ///< the part's own side is not the face's
};

struct Side {
  int use = -1;
  bool is_reversed = false;  ///< runs against the edge, the face's own reversal and the use's side included
};

class Orienter {
 public:
  Orienter(const Workpiece& work, Model& model, SharedTasks& tasks)
      : work_(work), model_(model), tasks_(tasks), sides_(model.edges.size()) {
    for (std::size_t f = 0; f < model.faces.size(); ++f) {
      first_use_.push_back(static_cast<int>(uses_.size()));
      for (const FaceUse& use : work.faces[f].uses) add_use({static_cast<int>(f), use.part, use.is_opposed});
    }
    group_.assign(uses_.size(), -1);
    is_turned_.assign(uses_.size(), false);
  }

  std::vector<std::string> run() {
    for (std::size_t u = 0; u < uses_.size(); ++u) {
      if (group_[u] < 0 && !loops_of(static_cast<int>(u)).empty()) walk(static_cast<int>(u));
    }
    align_sheets();
    look_outwards();
    return apply();
  }

 private:
  /// Two groups of sheets agree as they are, or one of them must be turned.
  struct Link {
    int group = -1;
    bool is_turned = false;
  };

  void add_use(const Use& use) {
    const Face& face = model_.faces[use.face];
    for (const Coedge& c : coedges_of(face.loops)) {
      bool is_reversed = c.is_reversed != (face.is_reversed != use.is_opposed);
      sides_[c.edge].push_back({static_cast<int>(uses_.size()), is_reversed});
    }
    uses_.push_back(use);
  }

  const Use& use(int u) const { return uses_[u]; }
  const std::vector<Loop>& loops_of(int u) const { return model_.faces[use(u).face].loops; }

  /// Those of one part.
  std::vector<Side> sides_of(int edge, int part) const {
    std::vector<Side> own;
    for (const Side& side : sides_[edge])
      if (use(side.use).part == part) own.push_back(side);
    return own;
  }

  /// Faces of a part that hang together, made to agree with each other; the majority stays as it is.
  void walk(int seed) {
    int group = static_cast<int>(groups_.size());
    std::vector<int> members;
    std::queue<int> open;
    auto enter = [&](int u, bool is_turned) {
      group_[u] = group;
      is_turned_[u] = is_turned;
      open.push(u);
      members.push_back(u);
    };
    enter(seed, false);
    for (; !open.empty(); open.pop()) {
      int u = open.front();
      for (const Coedge& c : coedges_of(loops_of(u))) cross_edge(c.edge, u, enter);
    }
    std::size_t turned = 0;
    for (int u : members) turned += is_turned_[u];
    if (2 * turned > members.size()) turn(members);
    groups_.push_back(std::move(members));
  }

  template <class Enter>
  void cross_edge(int edge, int u, Enter&& enter) {
    const std::vector<Side> sides = sides_of(edge, use(u).part);
    if (sides.size() != 2 || sides[0].use == sides[1].use) return;
    const Side& here = sides[0].use == u ? sides[0] : sides[1];
    const Side& there = sides[0].use == u ? sides[1] : sides[0];
    auto other = static_cast<std::size_t>(there.use);
    bool is_turned = is_turned_[u] != (here.is_reversed == there.is_reversed);
    if (group_[other] < 0) {
      enter(there.use, is_turned);
    } else if (is_turned_[other] != is_turned) {
      one_sided_.insert(use(u).part);
    }
  }

  /// Sheets that share faces, or edges that nothing else has, are made to agree with the first of them.
  void align_sheets() {
    const std::vector<std::vector<Link>> links = sheet_links();
    std::vector<bool> is_done(groups_.size(), false);
    std::set<std::size_t> turned;
    for (std::size_t first = 0; first < groups_.size(); ++first) {
      std::queue<std::size_t> open;
      if (!is_done[first]) open.push(first);
      is_done[first] = true;
      for (; !open.empty(); open.pop())
        for (const Link& link : links[open.front()]) {
          const auto other = static_cast<std::size_t>(link.group);
          if (is_done[other]) continue;
          is_done[other] = true;
          // What was turned since the links were taken counts as well.
          if (link.is_turned != turned.contains(open.front())) turn(groups_[other]), turned.insert(other);
          open.push(other);
        }
    }
  }

  /// Per group, in the order of faces and edges.
  std::vector<std::vector<Link>> sheet_links() const {
    std::vector<std::vector<Link>> links(groups_.size());
    auto link = [&](int a, int b, bool is_turned) {
      const int one = group_[a], two = group_[b];
      if (one < 0 || two < 0 || one == two) return;
      links[one].push_back({two, is_turned});
      links[two].push_back({one, is_turned});
    };
    auto is_turned = [&](int u) { return is_turned_[u]; };
    for (std::size_t u = 1; u < uses_.size(); ++u) {
      const int here = static_cast<int>(u), first = first_use_[uses_[u].face];
      if (here == first || !is_of_sheets(uses_[u].face)) continue;
      link(first, here, (is_turned(here) != use(here).is_opposed) != (is_turned(first) != use(first).is_opposed));
    }
    for (const std::vector<Side>& sides : sides_) {
      if (sides.size() != 2 || !is_of_sheets(use(sides[0].use).face) || !is_of_sheets(use(sides[1].use).face)) continue;
      link(sides[0].use, sides[1].use,
           (sides[0].is_reversed != is_turned(sides[0].use)) == (sides[1].is_reversed != is_turned(sides[1].use)));
    }
    return links;
  }

  bool is_of_sheets(int face) const {
    const auto& uses = work_.faces[face].uses;
    return std::none_of(uses.begin(), uses.end(), [&](const FaceUse& use) { return work_.parts[use.part].solid >= 0; });
  }

  void turn(const std::vector<int>& members) {
    for (int u : members) is_turned_[u] = !is_turned_[u];
  }

  bool is_closed(const std::vector<int>& members) const {
    for (int u : members)
      for (const Coedge& c : coedges_of(loops_of(u))) {
        if (sides_of(c.edge, use(u).part).size() != 2 && !edge_of(model_, c).is_degenerate) return false;
      }
    return true;
  }

  /// Near all of them: what the sum over the faces is off grows with the distance.
  Vec3 middle_of(const std::vector<int>& members) const {
    Vec3 sum;
    double count = 0;
    for (int u : members)
      for (const Coedge& c : coedges_of(loops_of(u))) {
        sum += model_.vertices[edge_of(model_, c).start];
        ++count;
      }
    return (1 / std::max(count, 1.0)) * sum;
  }

  /// Volumes inside closed bodies, of all their faces at once; NaN where the kernel cannot compute one.
  std::vector<double> volumes(const std::vector<std::vector<int>>& bodies) {
    struct Wall {
      TopoDS_Face face;
      std::size_t body;
      Vec3 apex;
    };
    std::vector<Wall> walls;
    std::vector<double> costs;
    for (std::size_t body = 0; body < bodies.size(); ++body) {
      const Vec3 apex = middle_of(bodies[body]);
      for (int u : bodies[body]) {
        walls.push_back({work_.faces[use(u).face].face, body, apex});
        if (is_turned_[u] != use(u).is_opposed) walls.back().face.Reverse();
        costs.push_back(measuring_cost(walls.back().face));
      }
    }
    const std::vector<double> shares = tasks_.run<double>(Stage::topology, costs, [&](int i) {
      const Wall& wall = walls[i];
      return volume_to(wall.face, wall.apex);
    });
    std::vector<double> sums(bodies.size(), 0.0);
    for (std::size_t i = 0; i < walls.size(); ++i) sums[walls[i].body] += shares[i];
    return sums;
  }

  /// A solid's shells are judged together (those of cavities look inwards), other closed parts one by one.
  void look_outwards() {
    std::vector<std::vector<int>> bodies;
    std::map<int, std::size_t> body_of_solid;
    for (const auto& group : groups_) {
      if (!is_closed(group)) continue;
      const int solid = work_.parts[use(group[0]).part].solid;
      const std::size_t body =
          solid < 0 ? bodies.size() : body_of_solid.try_emplace(solid, bodies.size()).first->second;
      if (body == bodies.size()) bodies.emplace_back();
      bodies[body].insert(bodies[body].end(), group.begin(), group.end());
    }
    const std::vector<double> inside = volumes(bodies);
    for (std::size_t i = 0; i < bodies.size(); ++i)
      if (inside[i] < 0) turn(bodies[i]);
  }

  /// A face turns with the first part that has it; to the others it shows its other side then.
  std::vector<std::string> apply() {
    std::vector<std::string> turned;
    for (std::size_t f = 0; f < model_.faces.size(); ++f) {
      Face& face = model_.faces[f];
      const auto& uses = work_.faces[f].uses;
      const auto first = static_cast<std::size_t>(first_use_[f]);
      for (std::size_t k = 0; k < uses.size(); ++k) {
        bool is_opposed = uses[k].is_opposed != (is_turned_[first + k] != is_turned_[first]);
        if (work_.parts[uses[k].part].solid >= 0) (is_opposed ? face.front : face.back).push_back(uses[k].part);
      }
      for (std::vector<int>* side : {&face.front, &face.back})
        side->insert(side->end(), work_.faces[f].inside_of.begin(), work_.faces[f].inside_of.end());
      if (uses.empty() || !is_turned_[first]) continue;
      face.is_reversed = !face.is_reversed;
      turned.push_back(face.name);
    }
    if (!turned.empty())
      model_.notes.push_back("Turned over so that normals agree and look outwards: " + list_names(turned) + ".");
    for (int part : one_sided_) {
      const WorkPart& known = work_.parts[part];
      if (known.solid >= 0)
        model_.report.one_sided.push_back(known.name);
      else
        model_.notes.push_back("The faces of " + known.name +
                               " form a one-sided surface (like a Moebius strip): their normals cannot all agree.");
    }
    return turned;
  }

  const Workpiece& work_;
  Model& model_;
  SharedTasks& tasks_;
  std::vector<Use> uses_;
  std::vector<int> first_use_;            ///< per face
  std::vector<std::vector<Side>> sides_;  ///< per edge
  std::vector<int> group_;                ///< per use: index of its group, -1 before
  std::vector<bool> is_turned_;           ///< per use
  std::vector<std::vector<int>> groups_;  ///< uses that hang together
  std::set<int> one_sided_;               ///< parts
};

}  // namespace

std::vector<std::string> orient_faces(const Workpiece& work, Model& model, SharedTasks& tasks) {
  return Orienter(work, model, tasks).run();
}

}  // namespace paver
