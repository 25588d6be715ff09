// Contacts between connected parts, from what faces, edges and vertices have in common; and gaps that were closed
// there.
#include <BRep_Tool.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <algorithm>
#include <map>
#include <set>

#include "brep/connecting/connect_impl.h"
#include "brep/occt_shapes_impl.h"

namespace paver {
namespace {

/// What meets at an edge or a vertex.
struct Meeting {
  std::set<int> parts;
  std::vector<int> faces;  ///< of the work
};

using Meetings = NCollection_IndexedDataMap<TopoDS_Shape, Meeting, TopTools_ShapeMapHasher>;

class ContactFinder {
 public:
  explicit ContactFinder(const Workpiece& work) : work_(work) {}

  std::vector<Contact> run() {
    meet();
    for (std::size_t f = 0; f < work_.faces.size(); ++f) add_face(static_cast<int>(f));
    for (int i = 1; i <= edges_.Extent(); ++i) add_edge(i);
    for (int i = 1; i <= vertices_.Extent(); ++i) add_vertex(i);
    std::vector<Contact> contacts;
    for (const auto& [key, contact] : found_) {
      Contact& made = contacts.emplace_back();
      for (int k : {0, 1}) made.parts[k] = work_.parts[key.first[k]].name;
      made.kind = key.second;
      made.size = contact.size;
      made.gap = contact.gap;
      for (int face : contact.faces) made.faces.push_back(face_name(face));
    }
    return contacts;
  }

 private:
  struct Found {
    std::set<int> faces;  ///< as read
    double size = 0, gap = 0;
  };

  void meet_at(const TopoDS_Shape& shape, const std::vector<int>& parts, int face) {
    auto note = [&](Meetings& meetings, const TopoDS_Shape& place) {
      Meeting& meeting = meetings.ChangeFromIndex(meetings.Add(place, {}));
      meeting.parts.insert(parts.begin(), parts.end());
      if (face >= 0) meeting.faces.push_back(face);
    };
    for (const TopoDS_Edge& edge : edges_of(shape)) note(edges_, edge);
    for (TopExp_Explorer inner(shape, TopAbs_VERTEX); inner.More(); inner.Next()) note(vertices_, inner.Current());
  }

  void meet() {
    for (std::size_t f = 0; f < work_.faces.size(); ++f) {
      if (!work_.faces[f].has_area) continue;
      std::vector<int> parts;
      for (const FaceUse& use : work_.faces[f].uses) parts.push_back(use.part);
      meet_at(work_.faces[f].face, parts, static_cast<int>(f));
    }
    for (const WorkWire& wire : work_.wires) meet_at(wire.edge, {wire.part}, -1);
    for (const WorkPoint& point : work_.points) meet_at(point.vertex, {point.part}, -1);
  }

  template <class F>
  static void for_pairs(const std::set<int>& parts, F&& f) {
    for (auto a = parts.begin(); a != parts.end(); ++a)
      for (auto b = std::next(a); b != parts.end(); ++b) f(PartPair{*a, *b});
  }

  Found& note(PartPair pair, ContactKind kind, const std::vector<int>& faces, double size) {
    Found& contact = found_[{pair, kind}];
    contact.size += size;
    for (int f : faces) {
      const std::vector<int> names = work_.faces_as_read(work_.faces[f].origin);
      contact.faces.insert(names.begin(), names.end());
    }
    return contact;
  }

  void add_face(int f) {
    const WorkFace& face = work_.faces[f];
    std::set<int> parts;
    for (const FaceUse& use : face.uses) parts.insert(use.part);
    if (!face.has_area || parts.size() < 2) return;
    for_pairs(parts, [&](PartPair pair) {
      Found& contact = note(pair, ContactKind::face, {f}, face.area);
      contact.gap = std::max(contact.gap, face.gap);
    });
    for (const TopoDS_Edge& edge : edges_of(face.face))
      for_pairs(parts, [&](PartPair pair) { bordered_.insert({edges_.FindIndex(edge), pair}); });
    for (TopExp_Explorer inner(face.face, TopAbs_VERTEX); inner.More(); inner.Next())
      for_pairs(parts, [&](PartPair pair) { touched_.insert({vertices_.FindIndex(inner.Current()), pair}); });
  }

  /// Edges that no face as read has been given are where parts cross.
  void add_edge(int index) {
    const Meeting& meeting = edges_(index);
    const TopoDS_Edge edge = TopoDS::Edge(edges_.FindKey(index));
    if (meeting.parts.size() < 2 || BRep_Tool::Degenerated(edge)) return;
    ContactKind kind = edge_origins(work_, edge).empty() ? ContactKind::crossing : ContactKind::edge;
    for_pairs(meeting.parts, [&](PartPair pair) {
      for (TopExp_Explorer ends(edge, TopAbs_VERTEX); ends.More(); ends.Next())
        touched_.insert({vertices_.FindIndex(ends.Current()), pair});
      if (bordered_.count({index, pair})) return;
      Found& contact = note(pair, kind, meeting.faces, edge_length(edge));
      if (kind != ContactKind::crossing) contact.gap = std::max(contact.gap, closed_gap(BRep_Tool::Tolerance(edge)));
    });
  }

  void add_vertex(int index) {
    const Meeting& meeting = vertices_(index);
    for_pairs(meeting.parts, [&](PartPair pair) {
      if (touched_.count({index, pair})) return;
      Found& contact = note(pair, ContactKind::point, meeting.faces, 1);
      contact.gap = std::max(contact.gap, closed_gap(BRep_Tool::Tolerance(TopoDS::Vertex(vertices_.FindKey(index)))));
    });
  }

  const Workpiece& work_;
  Meetings edges_, vertices_;
  std::map<std::pair<PartPair, ContactKind>, Found> found_;
  std::set<std::pair<int, PartPair>> bordered_, touched_;  // edges of common faces; vertices of common edges and faces
};

/// From places of the image's border, on its surface, to the faces' surfaces.
double measured_gap(const Fusion::Image& image, const Workpiece& work) {
  const Handle(IntTools_Context) context = new IntTools_Context;
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(image.face);
  double gap = 0;
  for (const TopoDS_Edge& edge : edges_of(image.face)) {
    const EdgeImage border = image_of(edge, image.face);
    if (border.curve.IsNull()) continue;
    for (double share : {0.0, 0.5, 1.0}) {
      const gp_Pnt2d uv = border.uv(share);
      for (int f : image.of) {
        GeomAPI_ProjectPointOnSurf& foot = context->ProjPS(work.faces[f].face);
        foot.Perform(surface->Value(uv.X(), uv.Y()));
        if (foot.IsDone() && foot.NbPoints() > 0) gap = std::max(gap, foot.LowerDistance());
      }
    }
  }
  return gap;
}

}  // namespace

double closed_gap(double tolerance) { return tolerance > 2 * Precision::Confusion() ? tolerance : 0; }

double closed_gap(const Fusion::Image& image, const Workpiece& work, double fusion_tolerance) {
  double gap = 0;
  for (const TopoDS_Edge& edge : edges_of(image.face)) gap = std::max(gap, closed_gap(BRep_Tool::Tolerance(edge)));
  return gap > fusion_tolerance ? std::min(gap, std::max(fusion_tolerance, measured_gap(image, work))) : gap;
}

std::vector<Contact> find_contacts(const Workpiece& work) { return ContactFinder(work).run(); }

const char* contact_name(ContactKind kind) {
  static constexpr const char* names[] = {"face", "edge", "point", "crossing"};
  static_assert(std::size(names) == static_cast<std::size_t>(ContactKind::crossing) + 1);
  return names[static_cast<std::size_t>(kind)];
}

}  // namespace paver
