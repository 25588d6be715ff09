// Finds the rows of a loop and lays them facet by facet.
#include "paving/rows/row.h"

#include <algorithm>

#include "paving/rows/row_plan.h"

namespace paver {

namespace {

constexpr double deg = M_PI / 180;
constexpr double sharpest_of_side = 100 * deg;  // a row ends at sharper corners
constexpr double widest_of_side = 140 * deg;
constexpr double widest_wish = M_PI / 2 + 0.2;  // radians from the facet to the side that starts a row
constexpr double fair_misfit = 0.35;            // logarithm of a side's length by the row's height
constexpr double cost_step = 0.35;  // radians (20 degrees): of rows whose costs lie in one step the shorter goes first

/// How badly the row would fit the sides at its ends: they are as long as its end quads are high.
double misfit(const Front& front, int first, int last) {
  int before = front.facets[first].prev, after = front.facets[last].next;
  auto off = [&](int side, int node) {
    double ratio = front.length(side) / front.mesh.h[node];
    return ratio > 0 ? std::max(0.0, std::fabs(std::log(ratio)) - fair_misfit) : 1;
  };
  return 0.5 * (off(before, front.facets[first].b) + off(after, front.facets[last].a));
}

/// Lays the extra quads of a corner or reversal at the end node of the quad just laid: on the facet that leads to it.
int lay_around(Front& front, int node, const NodePlan& plan, int level, std::vector<int>& new_nodes) {
  int laid = 0;
  for (int i = 1; i + 1 < plan.count; i += 2) {
    int f = front.facet_from(node);
    if (f < 0 || front.sectors(node) != 1) return laid;
    f = front.facets[f].prev;  // leads to the node from the side node laid last
    Wish diagonal = plan.wish[i];
    // The diagonal is wished from the corner node but belongs to the new facet's start: aim at the same place.
    int from = front.facets[f].a;
    const MetricVec aim = front.mesh.between(from, node) + diagonal.length * diagonal.direction;
    double length = norm(aim);
    if (!(length > 0)) return laid;
    Wish left{from, (1 / length) * aim, length, diagonal.width};
    if (!lay_quad(front, f, &left, &plan.wish[i + 1], level, new_nodes)) return laid;
    ++laid;
  }
  return laid;
}

}  // namespace

bool lay_quad(Front& front, int f, const Wish* left, const Wish* right, int level, std::vector<int>& new_nodes) {
  constexpr double least_of_new = 0.05, least_of_old = 1e-3;  // scaled Jacobian
  const Facet facet = front.facets[f];
  const int a = facet.a, b = facet.b, before = front.facets[facet.prev].a, after = front.facets[facet.next].b;
  auto start = [&] { return front.empty.facet_side(f).triangle; };
  Granted d{before, false}, c{after, false};
  if (left) d = grant(front, *left, start(), b, right ? after : -1);
  if (d.node < 0) return false;
  if (right) c = grant(front, *right, start(), a, left ? d.node : -1);
  auto put = [&](const Granted& g, int base) {
    return !g.is_new || front.empty.insert(g.node, front.empty.walk(start(), base, front.mesh.p[g.node]));
  };
  const double least = d.is_new || c.is_new ? least_of_new : least_of_old;
  const bool is_fit = c.node >= 0 && c.node != d.node && positive_jacobian(front.mesh, {a, b, c.node, d.node}) > least;
  bool is_laid = false;
  if (is_fit && put(d, a)) {
    if (put(c, b)) {
      is_laid = front.form_element(f, c.node, d.node, level);
      if (!is_laid && c.is_new) front.empty.erase(c.node, start(), b);
    }
    if (!is_laid && d.is_new) front.empty.erase(d.node, start(), a);
  }
  for (const Granted& g : {d, c}) {
    if (!g.is_new) continue;
    if (is_laid) {
      new_nodes.push_back(g.node);
    } else {
      front.drop_last_node();
    }
  }
  return is_laid;
}

std::vector<Row> find_rows(const Front& front, const std::vector<int>& loop, const std::vector<double>& angles) {
  int n = static_cast<int>(loop.size());
  std::vector<int> ends;
  std::vector<double> cost(n, 0);
  for (int i = 0; i < n; ++i) {
    double angle = angles[i];
    int node = front.facets[loop[i]].b;
    if (classify(front, node, angle) != NodeState::end) continue;
    ends.push_back(i);
    cost[i] = ambiguity(front, node, angle, NodeState::end);
  }
  std::vector<Row> rows;
  auto add = [&](int from, int count, bool has_ends, double row_cost) {
    Row row;
    row.has_ends = has_ends;
    row.cost = row_cost;
    row.level = front.facets[loop[from % n]].level;
    for (int i = 0; i < count; ++i) {
      row.facets.push_back(loop[(from + i) % n]);
      row.level = std::min(row.level, front.facets[row.facets.back()].level);
    }
    rows.push_back(std::move(row));
  };
  if (ends.empty()) {
    add(0, n, false, 0);
    return rows;
  }
  for (std::size_t k = 0; k < ends.size(); ++k) {
    int i = ends[k], j = ends[(k + 1) % ends.size()];
    int count = (j - i + n) % n;
    int size = count == 0 ? n : count;
    add(i + 1, size, true,
        cost[i] + cost[j] + front.misfit_weight * misfit(front, loop[(i + 1) % n], loop[(i + size) % n]));
  }
  for (std::size_t k = 0, m = rows.size(); k < m; ++k)
    rows[k].is_low = rows[k].level <= std::min(rows[(k + 1) % m].level, rows[(k + m - 1) % m].level);
  std::stable_sort(rows.begin(), rows.end(), [](const Row& p, const Row& q) {
    if (p.level != q.level) return p.level < q.level;
    double pc = std::floor(p.cost / cost_step), qc = std::floor(q.cost / cost_step);
    return pc != qc ? pc < qc : p.facets.size() < q.facets.size();
  });
  return rows;
}

int lay_row(Front& front, const Row& row, std::vector<int>& new_nodes) {
  std::vector<NodePlan> plans = plan_row(front, row);
  int n = static_cast<int>(row.facets.size()), laid = 0, level = row.level + 1;
  for (int i = 0; i < n; ++i) {
    int f = row.facets[i];
    if (!front.facets[f].is_alive) continue;  // used up by an end, a tuck or a closed gap
    const NodePlan& here = plans[i];
    double before = front.chord_angle_after(front.facets[f].prev), after = front.chord_angle_after(f);
    const Wish* left = nullptr;
    Wish started;
    bool is_first = i == 0 && !row.has_ends;
    if (is_first) {
      const NodePlan& last = plans[n - 1];
      if (last.count == 0) continue;
      left = &last.wish[last.count - 1];
    } else if (before > widest_of_side) {
      // The left side was not laid (a quad before failed): start the row anew at this facet.
      started = make_wish(front, front.facets[f].prev, std::min(0.5 * before, widest_wish),
                          0.5 * (front.mesh.h[front.facets[f].a] + front.length(f)));
      left = &started;
    }
    bool ends_here = here.state == NodeState::end || after < sharpest_of_side;
    const Wish* right = ends_here || here.count == 0 ? nullptr : &here.wish[0];
    if (!right && !ends_here) continue;
    if (!lay_quad(front, f, left, right, level, new_nodes)) {
      if (laid > 0) break;
      continue;
    }
    ++laid;
    if (right && here.count > 1) laid += lay_around(front, right->base, here, level, new_nodes);
  }
  return laid;
}

}  // namespace paver
