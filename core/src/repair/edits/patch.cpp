#include "repair/edits/patch.h"

#include <algorithm>

namespace paver {

ElementSet neighbours_of(const RegionMesh& mesh, int element) {
  ElementSet about;
  const Element& of = mesh.elements[element];
  for (int k = 0, n = of.corners(); k < n; ++k) {
    const int other = mesh.across(of.v[k], of.v[(k + 1) % n]);
    if (other >= 0 && std::find(about.begin(), about.end(), other) == about.end()) about.push_back(other);
  }
  return about;
}

ElementSet ring_about(const RegionMesh& mesh, int element) {
  ElementSet ring;
  for (int v : mesh.elements[element].nodes()) ring.insert(ring.end(), mesh.star[v].begin(), mesh.star[v].end());
  std::sort(ring.begin(), ring.end());
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  return ring;
}

std::vector<int> free_corners(const RegionMesh& mesh, int element) {
  std::vector<int> nodes;
  for (int v : mesh.elements[element].nodes())
    if (!mesh.is_fixed[v]) nodes.push_back(v);
  return nodes;
}

std::vector<int> free_nodes_near(const RegionMesh& mesh, const std::vector<int>& nodes) {
  std::vector<int> near;
  for (int of : nodes)
    for (int first : mesh.star[of])
      for (int e : ring_about(mesh, first))
        for (int v : free_corners(mesh, e)) near.push_back(v);
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  return near;
}

PatchOutline outline_of(const RegionMesh& mesh, const ElementSet& set, std::size_t most_nodes) {
  std::vector<std::pair<int, int>> sides;
  for (int e : set) {
    const Element& element = mesh.elements[e];
    for (int k = 0, n = element.corners(); k < n; ++k) {
      const int a = element.v[k], b = element.v[(k + 1) % n], other = mesh.across(a, b);
      if (other < 0 || std::find(set.begin(), set.end(), other) == set.end()) sides.push_back({a, b});
    }
  }
  if (sides.empty() || sides.size() > most_nodes) return {};
  PatchOutline outline;
  for (int at = sides.front().first; outline.loop.size() < sides.size();) {
    outline.loop.push_back(at);
    auto is_from = [&](const auto& side) { return side.first == at; };
    if (std::count_if(sides.begin(), sides.end(), is_from) != 1) return {};
    at = std::find_if(sides.begin(), sides.end(), is_from)->second;
    if (at == outline.loop.front()) break;
  }
  if (outline.loop.size() != sides.size()) return {};
  for (int e : set)
    for (int v : mesh.elements[e].nodes())
      if (std::find(outline.loop.begin(), outline.loop.end(), v) == outline.loop.end() &&
          std::find(outline.inside.begin(), outline.inside.end(), v) == outline.inside.end())
        outline.inside.push_back(v);
  return outline;
}

bool is_side_outside(const RegionMesh& mesh, const ElementSet& set, int a, int b) {
  return std::any_of(mesh.star[a].begin(), mesh.star[a].end(), [&](int e) {
    const Element& element = mesh.elements[e];
    return std::find(set.begin(), set.end(), e) == set.end() && (element.after(a) == b || element.before(a) == b);
  });
}

}  // namespace paver
