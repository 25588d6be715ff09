// A face's loops without periodic edges and poles.
// In: model and face. Out: loops, chained by vertices.
// A coedge whose successor stays keeps it; else its successor is a coedge that lost its predecessor and starts at the
// same vertex, the next one in the face's own order where several do.
#include "boundary/region_loops.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace paver {
namespace {

constexpr std::array<double, 3> shares{0, 0.5, 1};
constexpr double apart = 0.25;  // of the period: two uses this far apart in (u, v) are the sides of a periodic edge

bool lie_apart(const Edge& edge, const Coedge& a, const Coedge& b, Vec2 period) {
  if (!a.pcurve || !b.pcurve) return edge.is_periodic;
  // All along: where a body is pressed flat, border runs back from a turning point that both uses have.
  return std::all_of(shares.begin(), shares.end(), [&](double share) {
    const double t = edge.t0 + share * (edge.t1 - edge.t0);
    const Vec2 gap = a.pcurve->uv(t) - b.pcurve->uv(t);
    return (period.x > 0 && std::abs(gap.x) > apart * period.x) || (period.y > 0 && std::abs(gap.y) > apart * period.y);
  });
}

// One coedge that stays, with its links.
struct Link {
  const Coedge* coedge = nullptr;
  int next = -1;
  bool has_previous = false;
  int from = -1, to = -1;  // vertices
};

// In the order of the face. Each is linked to those beside it in its loop that stay, too; a pole between two is one
// point of both, whatever else starts there.
std::vector<Link> kept_links(const Model& model, int face, const std::vector<std::vector<bool>>& dropped) {
  std::vector<Link> links;
  for (std::size_t l = 0; l < dropped.size(); ++l) {
    const std::vector<Coedge>& coedges = model.faces[face].loops[l].coedges;
    const std::size_t n = coedges.size();
    const int first = static_cast<int>(links.size());
    auto is_pole = [&](std::size_t c) { return edge_of(model, coedges[c % n]).is_degenerate; };
    auto stays = [&](std::size_t c) { return !is_pole(c) && !dropped[l][c % n]; };
    for (std::size_t c = 0; c < n; ++c) {
      if (!stays(c)) continue;
      const Edge& edge = edge_of(model, coedges[c]);
      const int here = static_cast<int>(links.size());
      std::size_t after = c + 1, before = c + n - 1;
      while (is_pole(after)) ++after;
      while (is_pole(before)) --before;
      const int next = !stays(after) ? -1 : after < n ? here + 1 : first;
      links.push_back({&coedges[c], next, stays(before), start_of(edge, coedges[c]), end_of(edge, coedges[c])});
    }
  }
  return links;
}

// Per last link of an open chain: the first one.
std::vector<int> chain_heads(const std::vector<Link>& links) {
  std::vector<int> head(links.size(), -1);
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (links[i].has_previous) continue;
    std::size_t last = i;
    while (links[last].next >= 0) last = static_cast<std::size_t>(links[last].next);
    head[last] = static_cast<int>(i);
  }
  return head;
}

// Where the chain that starts at `head` and ends in link i goes on: at its own start where that is the same vertex, as
// a circle's is, whoever else starts there; else at the next start there.
int find_next(const std::vector<Link>& links, int i, int head) {
  const int n = static_cast<int>(links.size());
  const int end = links[i].to;
  if (links[head].from == end) return head;
  int any = -1;
  for (int step = 1; step <= n; ++step) {
    const int j = (i + step) % n;
    const Link& candidate = links[j];
    if (candidate.has_previous) continue;
    if (candidate.from == end) return j;
    if (any < 0) any = j;
  }
  // There are as many open starts as open ends, so `any` exists; a face whose chain is broken stays a closed list.
  return any;
}

// Joins the ends left open by what was dropped.
void join_open_ends(std::vector<Link>& links) {
  std::vector<int> heads = chain_heads(links);
  for (int i = 0; i < static_cast<int>(links.size()); ++i) {
    if (links[i].next >= 0) continue;
    const int head = std::exchange(heads[i], -1), next = find_next(links, i, head);
    links[i].next = next;
    links[next].has_previous = true;
    auto it = std::find(heads.begin(), heads.end(), next);
    if (next != head && it != heads.end()) *it = head;
  }
}

}  // namespace

std::vector<std::vector<bool>> periodic_coedges(const Model& model, int face) {
  const Face& whole = model.faces[face];
  const Vec2 period = whole.surface ? whole.surface->period() : Vec2{};
  std::vector<std::vector<bool>> result;
  std::map<int, std::pair<std::size_t, std::size_t>> last;  // per edge: loop and coedge of its last use
  for (std::size_t l = 0; l < whole.loops.size(); ++l) {
    const std::vector<Coedge>& coedges = whole.loops[l].coedges;
    result.emplace_back(coedges.size(), false);
    for (std::size_t c = 0; c < coedges.size(); ++c) {
      const int edge = coedges[c].edge;
      if (const auto use = last.find(edge); use != last.end()) {
        const auto [loop, before] = use->second;
        if (lie_apart(model.edges[edge], whole.loops[loop].coedges[before], coedges[c], period))
          result[loop][before] = result[l][c] = true;
      }
      last[edge] = {l, c};
    }
  }
  return result;
}

std::vector<std::vector<bool>> own_periodic_coedges(const Model& model, int face) {
  std::vector<std::vector<bool>> result = periodic_coedges(model, face);
  const Face& whole = model.faces[face];
  for (std::size_t l = 0; l < result.size(); ++l)
    for (std::size_t c = 0; c < result[l].size(); ++c)
      if (result[l][c] && has_other_user(model, whole.loops[l].coedges[c].edge, face)) result[l][c] = false;
  return result;
}

std::vector<Loop> linked_loops(const Model& model, int face) {
  return linked_loops(model, face, own_periodic_coedges(model, face));
}

std::vector<Loop> linked_loops(const Model& model, int face, const std::vector<std::vector<bool>>& dropped) {
  std::vector<Loop> loops;
  std::vector<Link> links = kept_links(model, face, dropped);
  join_open_ends(links);
  std::vector<bool> is_done(links.size(), false);
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (is_done[i]) continue;
    Loop loop;
    for (std::size_t j = i; !is_done[j]; j = static_cast<std::size_t>(links[j].next)) {
      is_done[j] = true;
      loop.coedges.push_back(*links[j].coedge);
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace paver
