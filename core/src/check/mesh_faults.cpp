#include "check/mesh_faults.h"

#include <fmt/format.h>

#include <tuple>

#include "base/tasks/gather.h"

namespace paver {
namespace {

bool is_before(Vec3 a, Vec3 b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); }

}  // namespace

void MeshFaults::add(Key key, const Entry& entry) {
  Entry& known = entries_[key];
  if (known.count == 0 || is_before(entry.where, known.where)) known.where = entry.where;
  known.count += entry.count;
}

void MeshFaults::add(const MeshFaults& other) {
  for (const auto& [key, entry] : other.entries_) add(key, entry);
}

void MeshFaults::unite(Ranks& ranks) {
  struct Row {
    int face;
    FaultKind kind;
    Entry entry;
  };
  std::vector<Row> mine;
  for (const auto& [key, entry] : entries_) mine.push_back({key.first, key.second, entry});
  entries_.clear();
  for (const Row& row : gather_all(mine, ranks)) add({row.face, row.kind}, row.entry);
}

std::vector<int> MeshFaults::faces() const {
  std::vector<int> faces;
  for (const auto& [key, entry] : entries_)
    if (faces.empty() || faces.back() != key.first) faces.push_back(key.first);
  return faces;
}

long MeshFaults::count(int face) const {
  long count = 0;
  for (auto at = entries_.lower_bound({face, FaultKind::folded}); at != entries_.end() && at->first.first == face; ++at)
    count += at->second.count;
  return count;
}

long MeshFaults::count(int face, FaultKind kind) const {
  auto at = entries_.find({face, kind});
  return at == entries_.end() ? 0 : at->second.count;
}

std::string MeshFaults::reason(int face) const {
  const auto& [key, entry] = gravest(face);
  const long n = entry.count;
  auto counted = [n](const char* one, const char* several) {
    return n == 1 ? std::string(one) : fmt::format("{} {}", n, several);
  };
  constexpr const char* remedy = "; use a smaller size or max-turn";
  switch (key.second) {
    case FaultKind::folded:
      return counted("an element folds", "elements fold") + " or cannot be proven not to" + remedy;
    case FaultKind::turned:
      return counted("an element runs", "elements run") + " against the normal of the face" + remedy;
    case FaultKind::same_element:
      return counted("an element has", "elements have") + " the same corners as another" + remedy;
    case FaultKind::overlap:
      return counted("an element lies", "elements lie") +
             " on those of another face; remove one of the faces in the CAD model";
    case FaultKind::side:
      return counted("a mesh edge", "mesh edges") + " inside it would not lie in two elements side by side" + remedy;
    case FaultKind::boundary:
      return "its elements do not fit " + counted("a mesh edge", "mesh edges") + " of its boundary" + remedy;
    case FaultKind::shared:
      return counted("a mesh edge", "mesh edges") + " of it would have elements of faces that do not meet there" +
             remedy;
    case FaultKind::off_edge:
      return counted("a node lies", "nodes lie") + " off the B-rep edge; repair the edge in the CAD model";
    case FaultKind::off_surface:
      return counted("a node lies", "nodes lie") + " off its surface" + remedy;
    case FaultKind::chord:
      return counted("an element cuts", "elements cut") + " far across a bend of it" + remedy;
    case FaultKind::area:
      return std::string("its elements do not cover its area") + remedy;
  }
  return "";
}

}  // namespace paver
