// Positions: coarse edges become cubics that run smoothly through regular nodes, grids blend the four edges about them
// (Coons), both in space; each node finds its chart point from its neighbours', one step off, and the surface from
// there.
#include "multilevel/fine_mesh.h"

#include <algorithm>

namespace paver {
namespace {

constexpr double least_jacobian = 0.1;  // of a grid's elements as laid
constexpr double close = 0.02;          // of the target length: near enough to where a node should be
constexpr int corrections = 2;

}  // namespace

FineMesh::FineMesh(const Region& whole, const LevelPlan& level_plan, Front& fine_front)
    : plan(level_plan),
      mesh(level_plan.mesh),
      net(level_plan.net),
      front(fine_front),
      whole_(whole),
      counts_(level_plan.counts),
      fine_(fine_front.mesh) {
  front.start_whole();
}

// Loops that touch in a vertex share one node; the two sides of a cut do not.
int FineMesh::node_on_loop(std::size_t l, int at) {
  const std::vector<LoopNode>& loop = whole_.loops[l];
  const std::size_t n = loop.size(), i = static_cast<std::size_t>(at) % n;
  Row& made = made_[loop[i].global];
  for (int node : made)
    if (norm(fine_.p[node] - loop[i].p) <= 1e-9 * norm(loop[(i + 1) % n].p - loop[i].p)) return node;
  made.push_back(front.add_boundary_node(loop, i));
  return made.back();
}

const LoopNode& FineMesh::loop_node(const CoarseEdge& edge, int i) const {
  const std::vector<LoopNode>& loop = whole_.loops[edge.loop];
  int at = plan.at[edge.loop][edge.facet] + i;
  return loop[static_cast<std::size_t>(at) % loop.size()];
}

int FineMesh::corner_node(int v) {
  if (auto known = node_.find(v); known != node_.end()) return known->second;
  int node = -1;
  if (auto [loop, i] = plan.place_on_loop[v]; loop >= 0) {
    node = node_on_loop(static_cast<std::size_t>(loop), plan.at[loop][i]);
  } else {
    node = front.add_placed_node(mesh.place(v));
    if (plan.outline_of_node[v] >= 0) share(node, plan.outline_of_node[v]);
    if (is_pole(v)) {
      fine_.is_fixed[node] = 1;
      fine_.global[node] = mesh.global[v];
    }
  }
  node_[v] = node;
  return node;
}

void FineMesh::share(int node, int outline) {
  fine_.is_fixed[node] = 1;
  fine_.global[node] = plan.boundary_nodes + outline;
}

int FineMesh::pole_of(int e) const {
  for (int v : mesh.elements[e].nodes())
    if (is_pole(v)) return v;
  return -1;
}

bool FineMesh::lay(int e) {
  const Element& element = mesh.elements[e];
  const int n = element.corners();
  for (int v : element.nodes()) corner_node(v);
  std::vector<Row> rows;
  for (int k = 0; k < n; ++k) rows.push_back(row_of(net.of_element[e][k], element.v[k]));
  // A pole comes last of all corners: nothing can be placed from there.
  const int pole = pole_of(e);
  if (n == 4 && pole >= 0) std::rotate(rows.begin(), rows.begin() + (element.corner_of(pole) + 2) % 4, rows.end());
  const int nodes = fine_.node_count();
  const std::size_t made = fine_.elements.size();
  if (n == 4 ? lay_grid(rows[0], rows[1], rows[2], rows[3]) : lay_triangle(rows)) return true;
  for (std::size_t i = fine_.elements.size(); i-- > made;) fine_.remove_element(static_cast<int>(i));
  fine_.elements.resize(made);
  while (fine_.node_count() > nodes) front.drop_last_node();
  return false;
}

// The edge's nodes, ends included, from coarse node `from`.
Row FineMesh::row_of(int e, int from) {
  const CoarseEdge& edge = net.edges[e];
  Row row;
  if (edge.loop >= 0) {
    const std::size_t l = static_cast<std::size_t>(edge.loop), f = static_cast<std::size_t>(edge.facet);
    for (int i = plan.at[l][f]; i <= plan.at[l][f + 1]; ++i) row.push_back(node_on_loop(l, i));
  } else {
    const int a = corner_node(edge.a), b = corner_node(edge.b);
    auto first = first_.find(e);
    if (first == first_.end()) first = first_.emplace(e, add_edge_nodes(e)).first;
    row.push_back(a);
    for (int i = 0; i + 1 < counts_[e]; ++i) row.push_back(first->second + i);
    row.push_back(b);
  }
  if (from != edge.a) std::reverse(row.begin(), row.end());
  return row;
}

int FineMesh::add_edge_nodes(int e) {
  const CoarseEdge& edge = net.edges[e];
  // From a pole nothing can be placed.
  bool is_turned = is_pole(edge.a);
  const int a = is_turned ? edge.b : edge.a, b = is_turned ? edge.a : edge.b, n = counts_[e];
  const Vec3 xa = mesh.x[a], xb = mesh.x[b], ta = tangent(e, a), tb = -1 * tangent(e, b);
  Row row{corner_node(a)};
  const int first = fine_.node_count();
  for (int i = 1; i < n; ++i) {
    double t = static_cast<double>(i) / n, s = 1 - t;
    Vec3 y = (s * s * (1 + 2 * t)) * xa + (t * t * (1 + 2 * s)) * xb + (s * s * t) * ta - (t * t * s) * tb;
    Vec2 guess = i > 1 ? 2 * fine_.p[row[i - 1]] - fine_.p[row[i - 2]] : stepped(row[0], y);
    row.push_back(place(y, guess));
  }
  if (is_turned && n > 2) reverse_nodes(first, n - 1);
  if (plan.outline_of_edge[e] >= 0)
    for (int i = 0; i + 1 < n; ++i) share(first + i, plan.outline_of_edge[e] + i);
  return first;
}

void FineMesh::reverse_nodes(int first, int count) {
  for (int i = 0, j = count - 1; i < j; ++i, --j) {
    NodePlace low = fine_.place(first + i), high = fine_.place(first + j);
    fine_.put(first + i, high), fine_.put(first + j, low);
    std::swap(fine_.h[first + i], fine_.h[first + j]);
  }
}

// Of the edge's curve at its end v, pointing along the edge, per whole edge.
Vec3 FineMesh::tangent(int e, int v) const {
  const CoarseEdge& edge = net.edges[e];
  const int w = edge.a == v ? edge.b : edge.a;
  const Vec3 chord = mesh.x[w] - mesh.x[v];
  const int across = edge_across(e, v);
  if (across < 0) return chord;
  const CoarseEdge& other = net.edges[across];
  const int z = other.a == v ? other.b : other.a;
  return (static_cast<double>(counts_[e]) / (counts_[e] + counts_[across])) * (mesh.x[w] - mesh.x[z]);
}

// The edge that goes on at a regular node where `e` ends, or -1.
int FineMesh::edge_across(int e, int v) const {
  const Star& star = mesh.star[v];
  if (star.size() != 4 || mesh.is_fixed[v]) return -1;
  const CoarseEdge& edge = net.edges[e];
  int found[2] = {-1, -1}, others = 0;
  for (int i : star) {
    if (mesh.elements[i].corners() != 4) return -1;
    if (i == edge.element[0] || i == edge.element[1]) continue;
    if (others == 2) return -1;
    int k = mesh.elements[i].corner_of(v);
    int out = net.of_element[i][k], in = net.of_element[i][(k + 3) % 4];
    if (others == 0) {
      found[0] = out, found[1] = in;
    } else {
      if (found[0] == out || found[0] == in) return found[0];
      if (found[1] == out || found[1] == in) return found[1];
    }
    ++others;
  }
  return -1;
}

Vec2 FineMesh::stepped(int from, Vec3 to) const {
  return front.region.chart->walk(fine_.p[from], fine_.pull_back(from, {to - fine_.x[from], {}}));
}

int FineMesh::place(Vec3 y, Vec2 guess) {
  int node = front.add_node(guess);
  for (int i = 0; i < corrections; ++i) {
    Vec2 step = fine_.pull_back(node, {y - fine_.x[node], {}});
    Vec3 way = step.x * fine_.xp[node] + step.y * fine_.xq[node];
    if (norm(way) <= close * fine_.h[node]) break;
    front.slide(node, fine_.p[node] + step);
  }
  return node;
}

//      top (reversed)
//     +----<----+
// left v        ^ right      rows run counter-clockwise; grid nodes from bottom left
//     +---->----+
//       bottom
bool FineMesh::lay_grid(const Row& bottom, const Row& right, const Row& top, const Row& left) {
  const int m = static_cast<int>(bottom.size()) - 1, n = static_cast<int>(right.size()) - 1;
  if (static_cast<int>(top.size()) - 1 != m || static_cast<int>(left.size()) - 1 != n) return false;
  grid_.assign(static_cast<std::size_t>(m + 1) * static_cast<std::size_t>(n + 1), -1);
  auto at = [&](int i, int j) -> int& { return grid_[j * (m + 1) + i]; };
  for (int i = 0; i <= m; ++i) at(i, 0) = bottom[i], at(i, n) = top[m - i];
  for (int j = 0; j <= n; ++j) at(0, j) = left[n - j], at(m, j) = right[j];
  const Vec3 x00 = fine_.x[at(0, 0)], xm0 = fine_.x[at(m, 0)], x0n = fine_.x[at(0, n)], xmn = fine_.x[at(m, n)];
  for (int j = 1; j < n; ++j)
    for (int i = 1; i < m; ++i) {
      double s = static_cast<double>(i) / m, t = static_cast<double>(j) / n;
      Vec3 y = (1 - t) * fine_.x[at(i, 0)] + t * fine_.x[at(i, n)] + (1 - s) * fine_.x[at(0, j)] +
               s * fine_.x[at(m, j)] - ((1 - s) * (1 - t)) * x00 - (s * (1 - t)) * xm0 - ((1 - s) * t) * x0n -
               (s * t) * xmn;
      Vec2 guess = fine_.p[at(i - 1, j)] + fine_.p[at(i, j - 1)] - fine_.p[at(i - 1, j - 1)];
      at(i, j) = place(y, guess);
    }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < m; ++i)
      if (!add_quad({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)})) return false;
  return true;
}

bool FineMesh::add_quad(const Corners& v) {
  const Element quad{v};
  if (!is_positive(fine_, quad) || !has_jacobian(fine_, quad, least_jacobian)) return false;
  fine_.add_element(v);
  return true;
}

// Three grids about a centre. On edge k (from corner k) part[k] fine edges belong to corner k; what lies opposite in
// each grid agrees when part[k] + part[k + 1] == count[k + 1] all round.
bool FineMesh::lay_triangle(const std::vector<Row>& rows) {
  int count[3], part[3];
  for (int k = 0; k < 3; ++k) count[k] = static_cast<int>(rows[k].size()) - 1;
  for (int k = 0; k < 3; ++k) {
    int sum = count[k] + count[(k + 1) % 3] - count[(k + 2) % 3];
    if (sum % 2 != 0 || sum <= 0) return false;
    part[k] = sum / 2;
  }
  Vec3 middle{0, 0, 0};
  for (int k = 0; k < 3; ++k) middle += (1.0 / 3) * fine_.x[rows[k][part[k]]];
  int centre = place(middle, stepped(rows[0][part[0]], middle));
  Row spoke[3];  // from the edge to the centre
  for (int k = 0; k < 3; ++k) spoke[k] = straight_row(rows[k][part[k]], centre, part[(k + 1) % 3]);
  for (int k = 0; k < 3; ++k) {
    int last = (k + 2) % 3;
    Row out(rows[k].begin(), rows[k].begin() + part[k] + 1), in(rows[last].begin() + part[last], rows[last].end());
    Row back(spoke[last].rbegin(), spoke[last].rend());
    if (!lay_grid(out, spoke[k], back, in)) return false;
  }
  return true;
}

Row FineMesh::straight_row(int a, int b, int n) {
  Row row{a};
  const Vec3 xa = fine_.x[a], xb = fine_.x[b];
  for (int i = 1; i < n; ++i) {
    double t = static_cast<double>(i) / n;
    Vec3 y = (1 - t) * xa + t * xb;
    row.push_back(place(y, stepped(row.back(), y)));
  }
  row.push_back(b);
  return row;
}

}  // namespace paver
