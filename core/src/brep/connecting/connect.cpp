// Connecting, in order: which parts may touch, clusters of them fused, faces replaced by their images, what lies inside
// others found, contacts listed.
#include <BOPTools_AlgoTools.hxx>
#include <TopTools_MapOfShape.hxx>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

#include "base/union_find.h"
#include "brep/connecting/connect_impl.h"
#include "brep/occt_impl.h"
#include "brep/occt_shapes_impl.h"

namespace paver {
namespace {

/// Of the diagonal: parts that are farther from the origin are fused there. The kernel's intersections are as exact as
/// coordinates are, and it takes 1e-7 mm for granted.
constexpr double far_away = 10;
/// Smaller and larger models (mm) are fused at a power of two of their size, below the last one: the kernel follows
/// intersections to within 1e-7 mm, which on large surfaces comes to no end, and takes for one what is as near.
constexpr double small = 1, large = 1e5, fused_size = 2e3;

double fused_scale(double diagonal) {
  return diagonal > large || diagonal < small ? std::exp2(std::floor(std::log2(fused_size / diagonal))) : 1;
}

/// Clusters of parts that pairs hang together; those of one part are left out but for loose ones.
std::vector<std::vector<int>> clusters_of(const std::vector<PartPair>& pairs, const std::vector<WorkPart>& parts) {
  UnionFind together(parts.size());
  for (auto [a, b] : pairs) together.merge(a, b);
  std::vector<std::vector<int>> clusters = together.sets();
  std::erase_if(clusters, [&](const std::vector<int>& list) { return list.size() == 1 && !parts[list[0]].is_loose; });
  return clusters;
}

Error not_moved_back() {
  return {ErrorCode::internal, "The connected parts cannot be moved back; report it with the model."};
}

class Connector {
 public:
  Connector(Workpiece& work, double tolerance, Progress& progress)
      : work_(work), tolerance_(tolerance), progress_(progress) {
    NearParts near = find_near_parts(work, tolerance);
    pairs_ = std::move(near.pairs);
    failed = std::move(near.free_form);
  }

  /// Whether anything was fused.
  bool run() {
    const std::vector<std::vector<int>> clusters = clusters_of(pairs_, work_.parts);
    if (clusters.empty()) return false;
    const bool is_far = norm(work_.centre) > far_away * work_.diagonal;
    double scale = fused_scale(work_.diagonal);
    if ((!is_far && scale == 1) || !move_work(work_, -1 * work_.centre, scale)) copy_shape(work_), scale = 1;
    tolerance_ *= scale;
    const std::vector<Twin> twins = find_twins(work_, pairs_);
    auto is_twin = [&](int part) { return std::ranges::find(twins, part, &Twin::part) != twins.end(); };
    for (std::vector<int> cluster : clusters)
      if (std::erase_if(cluster, is_twin) == 0 || cluster.size() > 1) connect_cluster(cluster);
    for (const Twin& twin : twins) connect_twin(twin);
    if (!fusions_.empty()) replace_faces();
    merged.gap /= scale;
    if (scale != 1 && !move_work(work_, {}, 1 / scale)) throw not_moved_back();
    return !fusions_.empty();
  }

  std::vector<PartPair> failed;
  MergedParts merged;

 private:
  /// Where all together cannot be fused, the parts that cannot be in pairs are left out, the one with most such pairs
  /// first; where that does not help, any one; failing that all stay as they are. Before that what solids share is
  /// copied, and the points are left out.
  void connect_cluster(std::vector<int> parts) {
    const std::vector<PartPair> all = pairs_among(parts);
    if (auto matching = match_parts(work_, parts, all, tolerance_, progress_)) {
      fusions_.push_back(std::move(*matching));
      return;
    }
    if (have_inner_shapes(work_, parts)) unshare_parts(work_, parts);
    turn_balls(work_, parts, all, false);
    order_tori(work_, parts);
    if (try_to_fuse(parts)) return;
    if (try_to_fuse_changed(parts, [&] { return unshare_parts(work_, parts); }) ||
        try_to_fuse_changed(parts, [&] { return turn_balls(work_, parts, all, true); }))
      return;
    if (leave_points(parts) && (parts.size() < 2 || try_to_fuse(parts))) return;
    if (leave_solids_as_drawn(parts) && (parts.size() < 2 || try_to_fuse(parts))) return;
    for (int part : parts)
      if (work_.parts[part].is_loose) failed.push_back({part, part});
    std::vector<PartPair> pairs = pairs_among(parts), bad;
    for (const PartPair& pair : pairs)
      if (pairs.size() > 1 && !fuse(work_, {pair[0], pair[1]}, tolerance_, progress_)) bad.push_back(pair);
    while (!bad.empty()) {
      const int worst = most_frequent(bad);
      std::erase(parts, worst);
      std::erase_if(bad, [&](PartPair pair) { return pair[0] == worst || pair[1] == worst; });
    }
    if (pairs_among(parts).size() == pairs.size() || !try_to_fuse(parts)) parts = fuse_all_but_one(parts);
    const std::vector<PartPair> connected = pairs_among(parts);
    for (PartPair pair : pairs)
      if (std::find(connected.begin(), connected.end(), pair) == connected.end()) failed.push_back(pair);
  }

  /// As its twin is connected; where that is with nothing else, or has failed, these two alone.
  void connect_twin(const Twin& twin) {
    for (const PartPair& pair : std::vector<PartPair>(failed))
      for (int k : {0, 1})
        if (pair[k] == twin.of) failed.push_back({std::min(twin.part, pair[1 - k]), std::max(twin.part, pair[1 - k])});
    auto is_of_twin = [&](int face) { return work_.faces[face].has_part(twin.of); };
    auto has_twin = [&](const Fusion& fusion) {
      return std::ranges::any_of(fusion.images,
                                 [&](const auto& image) { return std::ranges::any_of(image.of, is_of_twin); });
    };
    auto fusion = std::ranges::find_if(fusions_, has_twin);
    if (fusion == fusions_.end()) {
      fusions_.emplace_back();
      for (const auto& [face, other] : twin.faces) fusions_.back().images.push_back({work_.faces[other].face, {other}});
      std::ranges::sort(fusions_.back().images, {}, [](const auto& image) { return image.of[0]; });
      fusion = fusions_.end() - 1;
    }
    add_twin(work_, twin, *fusion);
  }

  /// Those that can be fused where one is left out, that with the fewest pairs; none where more would have to be.
  std::vector<int> fuse_all_but_one(const std::vector<int>& parts) {
    constexpr std::size_t most_tries = 24;
    const std::vector<PartPair> pairs = pairs_among(parts);
    auto count = [&](int part) {
      return std::ranges::count_if(pairs, [&](PartPair pair) { return pair[0] == part || pair[1] == part; });
    };
    std::vector<int> order = parts;
    std::ranges::stable_sort(order, {}, count);
    order.resize(std::min(order.size(), most_tries));
    for (const int part : order) {
      std::vector<int> others = parts;
      std::erase(others, part);
      if (others.size() > 1 && try_to_fuse(others)) return others;
    }
    return {};
  }

  /// `change`: of the parts; whether there was anything to change.
  template <class Change>
  bool try_to_fuse_changed(const std::vector<int>& parts, Change change) {
    Workpiece before = work_;
    if (change() && try_to_fuse(parts)) return true;
    work_ = std::move(before);
    return false;
  }

  /// That solids touch themselves shall not cost the others their connection. Whether there were any.
  bool leave_solids_as_drawn(const std::vector<int>& parts) {
    bool is_changed = false;
    for (const int part : parts)
      if (WorkPart& solid = work_.parts[part]; solid.solid >= 0) is_changed |= std::exchange(solid.is_loose, false);
    return is_changed;
  }

  /// Points shall not cost the others their connection, nor a try each. Whether there were any.
  bool leave_points(std::vector<int>& parts) {
    auto is_point = [&](int part) {
      return std::any_of(work_.points.begin(), work_.points.end(),
                         [&](const auto& point) { return point.part == part; });
    };
    for (const PartPair& pair : pairs_among(parts))
      if (is_point(pair[0]) || is_point(pair[1])) failed.push_back(pair);
    return std::erase_if(parts, is_point) > 0;
  }

  bool try_to_fuse(const std::vector<int>& parts) {
    auto fusion = fuse(work_, parts, tolerance_, progress_);
    if (!fusion) return false;
    if (const std::vector<TopoDS_Vertex> points = points_apart(parts, *fusion); !points.empty())
      if (auto with_points = fuse(work_, parts, tolerance_, progress_, points)) fusion = std::move(with_points);
    merged.add(fusion->merged);
    for (const PartPair& pair : pairs_among(parts))
      if (fusion->doubled.contains(pair[0]) && fusion->doubled.contains(pair[1])) failed.push_back(pair);
    fusions_.push_back(std::move(*fusion));
    return true;
  }

  /// Where parts touch in points that a fusion has not found.
  std::vector<TopoDS_Vertex> points_apart(const std::vector<int>& parts, const Fusion& fusion) const {
    const std::vector<PartPair> pairs = pairs_among(parts);
    const std::set<PartPair> touching = touching_parts(work_, fusion);
    std::vector<PartPair> apart;
    std::ranges::set_difference(pairs, touching, std::back_inserter(apart));
    return find_touching_points(work_, apart, tolerance_, progress_);
  }

  std::vector<PartPair> pairs_among(const std::vector<int>& parts) const {
    const std::vector<char> is_member = marked_parts(work_, parts);
    std::vector<PartPair> pairs;
    for (PartPair pair : pairs_)
      if (is_member[pair[0]] && is_member[pair[1]]) pairs.push_back(pair);
    return pairs;
  }

  static int most_frequent(const std::vector<PartPair>& pairs) {
    std::map<int, int> count;
    for (PartPair pair : pairs) ++count[pair[0]], ++count[pair[1]];
    auto less = [](const auto& a, const auto& b) { return a.second < b.second; };
    return std::max_element(count.begin(), count.end(), less)->first;
  }

  void replace_faces() {
    std::vector<std::vector<WorkFace>> pieces(work_.faces.size());
    std::vector<char> is_fused(work_.faces.size(), 0);
    std::map<std::vector<int>, std::vector<WorkFace>> common;  // by the faces as read that have them
    for (const Fusion& fusion : fusions_)
      for (const Fusion::Image& image : fusion.images) {
        std::set<int> origins;
        for (int f : image.of) {
          is_fused[f] = 1;
          origins.insert(work_.faces[f].origin);
        }
        WorkFace piece = piece_of(image);
        if (origins.size() == 1) {
          pieces[image.of[0]].push_back(std::move(piece));
        } else {
          piece.gap = closed_gap(image, work_, fusion.tolerance);
          common[{origins.begin(), origins.end()}].push_back(std::move(piece));
        }
      }
    std::set<int> kept;
    for (std::size_t f = 0; f < work_.faces.size(); ++f) {
      if (!is_fused[f]) pieces[f].push_back(work_.faces[f]);
      if (!pieces[f].empty()) kept.insert(work_.faces[f].origin);
    }
    std::vector<WorkFace> faces;
    for (std::size_t f = 0; f < work_.faces.size(); ++f) {
      // A face that is common as a whole keeps its place in the report.
      if (kept.insert(work_.faces[f].origin).second) pieces[f].push_back(placeholder(work_.faces[f]));
      std::move(pieces[f].begin(), pieces[f].end(), std::back_inserter(faces));
    }
    for (auto& [origins, list] : common) {
      work_.common.push_back(origins);
      for (WorkFace& piece : list) {
        piece.origin = work_.read_faces + static_cast<int>(work_.common.size()) - 1;
        faces.push_back(std::move(piece));
      }
    }
    note_edges();
    move_points();
    work_.faces = std::move(faces);
    work_.is_rebuilt = true;
    Progress silent;
    std::vector<Repair> repairs = work_.repairs;
    // The kernel leaves some new edges without an image on a face, which is no fault of the file.
    repair(work_, silent);
    work_.repairs = std::move(repairs);
  }

  static WorkFace placeholder(const WorkFace& face) {
    WorkFace gone = face;
    gone.lose_area();
    gone.is_common = true;
    return gone;
  }

  /// As the first of its faces that bounds a solid, else the first, on whose side it is; what the others' uses say is
  /// turned where they look elsewhere.
  WorkFace piece_of(const Fusion::Image& image) {
    std::vector<int> of = image.of;
    std::stable_partition(of.begin(), of.end(), [&](int f) { return is_of_solid(f); });
    WorkFace piece = work_.faces[of[0]];
    piece.face = oriented_as(image.face, piece.face);
    piece.area = face_area(piece.face);
    piece.has_area = work_.has_area(piece);
    for (std::size_t i = 1; i < of.size(); ++i) {
      const WorkFace& other = work_.faces[of[i]];
      bool is_opposed = oriented_as(image.face, other.face).Orientation() != piece.face.Orientation();
      for (const FaceUse& use : other.uses)
        if (!piece.has_part(use.part)) {
          piece.uses.push_back({use.part, use.is_opposed != is_opposed});
        } else if (is_opposed && work_.parts[use.part].solid >= 0) {
          piece.is_dropped = true;  // where a solid touches itself, which is on both sides
        }
    }
    if (piece.is_dropped) piece.lose_area();
    return piece;
  }

  bool is_of_solid(int face) const {
    const FaceUse& first = work_.faces[face].uses.front();
    return work_.parts[first.part].solid >= 0;
  }

  TopoDS_Face oriented_as(const TopoDS_Face& image, const TopoDS_Face& face) {
    bool is_turned = BOPTools_AlgoTools::IsSplitToReverse(image, face, context_);
    return is_turned ? TopoDS::Face(image.Reversed()) : image;
  }

  void note_edges() {
    TopTools_MapOfShape replaced;
    std::vector<WorkWire> pieces;
    for (const Fusion& fusion : fusions_)
      for (const auto& [edge, image] : fusion.edges) {
        replaced.Add(edge);
        add_edge_origins(work_, image, edge);
        for (const WorkWire& wire : work_.wires)
          if (wire.edge.IsSame(edge)) pieces.push_back({forward(TopoDS::Edge(image)), wire.part, wire.origin});
      }
    std::erase_if(work_.wires, [&](const WorkWire& wire) { return replaced.Contains(wire.edge); });
    std::move(pieces.begin(), pieces.end(), std::back_inserter(work_.wires));
  }

  void move_points() {
    for (const Fusion& fusion : fusions_)
      for (const auto& [vertex, image] : fusion.points)
        for (WorkPoint& point : work_.points)
          if (point.vertex.IsSame(vertex)) point.vertex = TopoDS::Vertex(image.Oriented(TopAbs_FORWARD));
  }

  Workpiece& work_;
  double tolerance_;
  Progress& progress_;
  std::vector<PartPair> pairs_;
  std::vector<Fusion> fusions_;
  Handle(IntTools_Context) context_ = new IntTools_Context;
};

/// Faces fail that lost a neighbour: closed skins stay closed unless a solid cannot tell inside from outside.
void fault_open_skins(Workpiece& work, const EdgeUses& before) {
  const EdgeUses after = count_uses(work.faces);
  auto is_opened = [&](const TopoDS_Shape& edge) {
    return before.count.Contains(edge) && !before.is_free(edge) && after.is_free(edge);
  };
  for (WorkFace& face : work.faces) {
    if (!face.is_usable()) continue;
    if (std::ranges::any_of(edges_of(face.face), is_opened))
      face.fault =
          "the union leaves it open along an edge: a solid there runs into itself; repair the solid in the CAD program "
          "or use connect imprint";
  }
}

void drop_inside(Workpiece& work) {
  const EdgeUses before = count_uses(work.faces);
  for (WorkFace& face : work.faces) {
    bool has_front = !face.inside_of.empty(), has_back = has_front;
    for (const FaceUse& use : face.uses) {
      if (work.parts[use.part].solid < 0) continue;
      (use.is_opposed ? has_front : has_back) = true;
    }
    if (!has_front || !has_back || !face.has_area) continue;
    face.is_dropped = true;
    face.lose_area();
  }
  fault_open_skins(work, before);
}

}  // namespace

ConnectResult connect(Workpiece& work, Connect how, double tolerance, Progress& progress) {
  ConnectResult result;
  find_loose_parts(work, tolerance);
  if (work.parts.size() < 2 && (work.parts.empty() || !work.parts[0].is_loose)) return result;
  Workpiece fused = work;
  Connector connector(fused, tolerance, progress);
  bool is_fused = connector.run();
  const bool has_ends =
      std::any_of(work.points.begin(), work.points.end(), [](const WorkPoint& point) { return point.is_end; });
  if (is_fused || has_ends) result.contacts = find_contacts(fused);
  if (how == Connect::none) {
    find_insides(work);
    return result;
  }
  result.failed = std::move(connector.failed);
  result.merged = std::move(connector.merged);
  find_insides(fused);
  if (how == Connect::united) drop_inside(fused);
  if (const Vec3 back = work.centre - fused.centre; norm(back) > 0 && !move_work(fused, back)) throw not_moved_back();
  work = std::move(fused);
  return result;
}

}  // namespace paver
