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
  const std::vector<std::pair<Key, Entry>> mine(entries_.begin(), entries_.end());
  entries_.clear();
  for (const auto& [key, entry] : gather_all(mine, ranks)) add(key, entry);
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
  struct Words {
    const char *before, *one, *several, *after, *remedy = "use a smaller size or max-turn";
  };
  static constexpr Words words[] = {
      {"", "an element folds", "elements fold", " or cannot be proven not to"},
      {"", "an element runs", "elements run", " against the normal of the face"},
      {"", "an element has", "elements have", " the same corners as another"},
      {"", "an element lies", "elements lie", " on those of another face",
       "use a smaller size, or remove one of the faces if they are one"},
      {"", "a mesh edge", "mesh edges", " inside it would not lie in two elements side by side"},
      {"its elements do not fit ", "a mesh edge", "mesh edges", " of its boundary"},
      {"", "a mesh edge", "mesh edges", " of it would have elements of faces that do not meet there"},
      {"", "a node lies", "nodes lie", " off the B-rep edge", "repair the edge in the CAD model"},
      {"", "a node lies", "nodes lie", " off its surface"},
      {"", "an element cuts", "elements cut", " far across a bend of it"},
      {"its elements do not cover its area", "", "", ""},
  };
  static_assert(std::size(words) == static_cast<std::size_t>(FaultKind::area) + 1);
  const auto& [key, entry] = gravest(face);
  const auto& [before, one, several, after, remedy] = words[static_cast<std::size_t>(key.second)];
  const std::string counted = entry.count == 1 || !*several ? one : fmt::format("{} {}", entry.count, several);
  return fmt::format("{}{}{}; {}", before, counted, after, remedy);
}

}  // namespace paver
