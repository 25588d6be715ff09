// Journal of mesh edits. Edits are tried on connectivity alone first, which is
// cheap; only what lowers the energy is smoothed and measured.
#include "paving/cleanup/mesh_edit.h"

#include <algorithm>

#include "paving/smoothing/fit.h"

namespace paver {
namespace {

constexpr double widest = 155 * M_PI / 180;  // corner angle above which an element is as good as degenerate
constexpr int local_sweeps = 4;
constexpr double early_share = 0.3;  // of the fall in spread that a dear change must show after one sweep
constexpr double early_excess = 4;   // energy and spread together that a change may still lack after one sweep
constexpr double early_lack = 0.4;   // of the scaled Jacobian that mending is to leave, after one sweep
constexpr double early_loss = 0.2;   // of the worst, which is to rise

double corner_angle(const RegionMesh& mesh, const Element& e, int node) {
  const MetricVec out = mesh.between(node, e.after(node)), in = mesh.between(node, e.before(node));
  const MetricFrame frame(out, in);
  const Vec2 other = frame.of(in);
  return std::atan2(other.y, other.x);
}

// The number of elements whose corners at a node of this angle have the best
// sines; half way where two do equally.
double ideal_elements(double angle) {
  constexpr double tie = 0.05;
  double quarter = angle / (0.5 * M_PI);
  for (int n = 1;; ++n) {
    double border = 2.0 * n * (n + 1) / (2 * n + 1);  // corners of n and of n + 1 elements equally far from square
    if (quarter < border - tie) return n;
    if (quarter < border + tie) return n + 0.5;
  }
}

double area_in_targets(const RegionMesh& mesh, const Element& e) {
  const auto& v = e.v;
  double h = mesh.h[v[0]];
  const bool is_quad = e.corners() == 4;
  const MetricVec one = mesh.between(v[0], v[is_quad ? 2 : 1]);
  const MetricVec other = is_quad ? mesh.between(v[1], v[3]) : mesh.between(v[0], v[2]);
  const double mixed = dot(one, other);
  return 0.5 * std::sqrt(std::max(0.0, dot(one, one) * dot(other, other) - mixed * mixed)) / (h * h);
}

/// Per node, of the region there; 0 where it is not known or loops touch.
std::vector<double> boundary_angles(const Front& front) {
  std::vector<double> angles(front.mesh.node_count(), 0);
  std::vector<char> is_known(front.mesh.node_count(), false);
  for (const BoundaryFacet& facet : front.boundary) {
    angles[facet.a] = is_known[facet.a] ? 0 : std::max(0.0, facet.angle);
    is_known[facet.a] = true;
  }
  return angles;
}

/// Whether every edge at the node lies in two elements.
bool is_surrounded(const RegionMesh& mesh, int node) {
  const auto& star = mesh.star[node];
  return std::all_of(star.begin(), star.end(), [&](int e) {
    return std::any_of(star.begin(), star.end(),
                       [&](int other) { return mesh.elements[other].before(node) == mesh.elements[e].after(node); });
  });
}

}  // namespace

MeshEdit::MeshEdit(Front& front)
    : spread_price(fine_spread_price * front.region.evenness),
      front_(front),
      mesh_(front.mesh),
      aims_(front.mesh.node_count()) {
  delta_.assign(mesh_.node_count(), 0);
  commit();
  find_border();
  const std::vector<double> true_angle = boundary_angles(front);
  for (int i = 0; i < mesh_.node_count(); ++i) {
    if (!mesh_.is_fixed[i]) continue;
    if (mesh_.global[i] < 0 && is_surrounded(mesh_, i)) {
      aims_[i] = {static_cast<float>(mesh_.star[i].size()), 1, true};
      continue;
    }
    double angle = 0;
    for (int e : mesh_.star[i]) angle += corner_angle(mesh_, mesh_.elements[e], i);
    angle = std::max(angle, true_angle[i]);  // two chords of a smooth arc are no corner once sides are curved
    aims_[i].ideal = static_cast<float>(ideal_elements(angle));
    aims_[i].least = std::max(1, static_cast<int>(std::ceil(angle / widest - 1e-9)));
  }
}

void MeshEdit::find_border() {
  for (const Element& e : mesh_.elements)
    for (int i = 0, n = e.corners(); e.is_alive() && i < n; ++i) {
      const int a = e.v[i], b = e.v[(i + 1) % n];
      if (mesh_.is_fixed[a] && mesh_.is_fixed[b] && mesh_.across(a, b) < 0) border_.insert(side_key(a, b));
    }
}

double MeshEdit::energy_gain(const Change& change) {
  list_.clear();
  double gain = 0;
  const int old_count = mesh_.node_count();
  if (delta_.size() < mesh_.p.size() + change.fresh.size()) delta_.resize(mesh_.p.size() + change.fresh.size() + 64, 0);
  auto count = [&](const Corners& v, int by) {
    if (v[3] < 0) gain += by * triangle_energy;
    for (int node : v) {
      if (node < 0) continue;
      list_.push_back(node);
      delta_[node] += by;
    }
  };
  for (int e : change.gone) count(mesh_.elements[e].v, -1);
  for (const auto& v : change.made) count(v, 1);
  for (int node : list_) {
    if (delta_[node] != 0) gain += node < old_count ? step(node, delta_[node]) : energy_of_new(delta_[node]);
    delta_[node] = 0;
  }
  return gain;
}

// Whether an edge at the node is in two elements in the same direction.
bool MeshEdit::has_shared_edges(int node) const {
  after_.clear(), before_.clear();
  for (int e : mesh_.star[node]) {
    const int after = mesh_.elements[e].after(node), before = mesh_.elements[e].before(node);
    for (std::size_t i = 0; i < after_.size(); ++i)
      if (after_[i] == after || before_[i] == before) return true;
    after_.push_back(after), before_.push_back(before);
  }
  return false;
}

void MeshEdit::touch(int node) {
  if (slot_.size() < mesh_.p.size()) slot_.resize(mesh_.p.size() + 64, -1);
  if (slot_[node] >= 0) return;
  slot_[node] = static_cast<int>(touched_.size());
  touched_.push_back(node);
}

void MeshEdit::move(int node, Vec2 p, bool is_first) {
  if (is_first) journal_.push_back({Kind::move, node, {}, mesh_.place(node)});
  front_.slide(node, p);
}

// Target length at a new node by those of the first `count` touched nodes, the
// nearer the more.
double MeshEdit::target_between(int node, std::size_t count) const {
  double sum = 0, weights = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const MetricVec d = mesh_.between(touched_[i], node);
    double weight = 1 / (dot(d, d) + 1e-300);
    sum += weight * mesh_.h[touched_[i]];
    weights += weight;
  }
  return sum / weights;
}

bool MeshEdit::apply(const Change& change) {
  for (int e : change.gone)
    for (int v : mesh_.elements[e].nodes())
      if (aims_[v].is_kept) return false;
  std::size_t start = mark();
  for (int e : change.gone) {
    journal_.push_back({Kind::gone, e, mesh_.elements[e], {}});
    for (int v : mesh_.elements[e].nodes()) touch(v);
    mesh_.remove_element(e);
  }
  std::size_t old_count = touched_.size();
  for (Vec2 p : change.fresh) {
    int node = front_.add_node(p);
    if (aims_.size() < mesh_.p.size()) aims_.resize(mesh_.p.size() + 1024);
    journal_.push_back({Kind::node, node, {}, {}});
    mesh_.h[node] = std::min(mesh_.h[node], target_between(node, old_count));
    touch(node);
  }
  bool is_ok = true;
  for (const auto& v : change.made) {
    if (!(is_ok = !has_node_twice(mesh_, {v}))) break;
    journal_.push_back({Kind::made, mesh_.add_element(v), {}, {}});
  }
  for (int node : touched_) {
    if (!is_ok) break;
    int size = mesh_.star[node].size();
    bool is_border = mesh_.is_fixed[node];
    if ((is_border ? size < 1 : size == 1 || size == 2) || has_shared_edges(node)) is_ok = false;
  }
  NodePlace aim;
  aim.p = change.place;
  if (is_ok && change.moved >= 0) journal_.push_back({Kind::place, change.moved, {}, aim});
  if (!is_ok) roll_back(start);
  return is_ok;
}

void MeshEdit::roll_back(std::size_t mark) {
  while (journal_.size() > mark) {
    const Entry& entry = journal_.back();
    switch (entry.kind) {
      case Kind::made:
        mesh_.remove_element(entry.id);
        mesh_.elements.pop_back();
        break;
      case Kind::gone:
        mesh_.restore_element(entry.id, entry.element.v);
        break;
      case Kind::node:
        touched_.erase(std::remove(touched_.begin(), touched_.end(), entry.id), touched_.end());
        slot_[entry.id] = -1;
        front_.drop_last_node();
        break;
      case Kind::place:
        break;
      case Kind::move:
        mesh_.put(entry.id, entry.place);
        break;
    }
    journal_.pop_back();
  }
  if (mark == 0) forget_touched();
}

void MeshEdit::forget_touched() {
  for (int node : touched_) slot_[node] = -1;
  touched_.clear();
}

void MeshEdit::commit() {
  for (int node : touched_)
    for (int e : mesh_.star[node])
      if (static_cast<std::size_t>(e) < measures_.size()) measures_[e] = {};  // to be measured anew
  journal_.clear();
  forget_touched();
  old_elements_ = static_cast<int>(mesh_.elements.size());
}

void MeshEdit::smooth_touched(bool is_first) {
  sum_.assign(touched_.size(), {});
  for (std::size_t k = 0; k < touched_.size(); ++k) slot_[touched_[k]] = static_cast<int>(k);  // some may have gone
  for (int e : near_) {
    const Element& element = mesh_.elements[e];
    MetricVec steps[4];
    if (!fit_evenly(mesh_, element, steps)) continue;
    for (int i = 0; i < element.corners(); ++i)
      if (const int slot = slot_[element.v[i]]; slot >= 0) sum_[slot] += steps[i];
  }
  for (std::size_t k = 0; k < touched_.size(); ++k) {
    const int node = touched_[k];
    int size = mesh_.star[node].size();
    if (mesh_.is_fixed[node] || size == 0) continue;
    MetricVec step = (1.0 / size) * sum_[k];
    constexpr double longest_step = 0.8;  // target lengths
    double most = longest_step * mesh_.h[node], length = norm(step);
    if (length > most) step = (most / length) * step;
    move(node, mesh_.p[node] + mesh_.pull_back(node, step), is_first);
  }
}

// Elements about the free touched nodes, and all those made.
void MeshEdit::collect_near() {
  near_.clear();
  for (int node : touched_) {
    if (mesh_.is_fixed[node]) continue;
    near_.insert(near_.end(), mesh_.star[node].begin(), mesh_.star[node].end());
  }
  for (const Entry& entry : journal_)
    if (entry.kind == Kind::made && mesh_.elements[entry.id].is_alive()) near_.push_back(entry.id);
  std::sort(near_.begin(), near_.end());
  near_.erase(std::unique(near_.begin(), near_.end()), near_.end());
}

// Of an element as it was at the last commit.
const MeshEdit::Measure& MeshEdit::measured(int id, const Element& e) {
  if (measures_.size() <= static_cast<std::size_t>(id)) measures_.resize(mesh_.elements.size() + 1024);
  Measure& m = measures_[id];
  constexpr float measured = 1.5F;  // less than what it starts with
  if (m.jacobian > measured) {
    measure(e, m);
    m.area = static_cast<float>(area_in_targets(mesh_, e));
  }
  return m;
}

double MeshEdit::spread_about(std::span<const int> elements) {
  double sum = 0;
  if (stamp_.size() < mesh_.elements.size()) stamp_.resize(mesh_.elements.size() + 1024, 0);
  ++run_;
  for (int e : elements)
    for (int v : mesh_.elements[e].nodes()) {
      if (mesh_.is_fixed[v]) continue;
      for (int g : mesh_.star[v]) {
        if (stamp_[g] == run_) continue;
        stamp_[g] = run_;
        sum += measured(g, mesh_.elements[g]).spread;
      }
    }
  return sum;
}

void MeshEdit::measure(const Element& e, Measure& worst) const {
  const auto jacobian = static_cast<float>(scaled_jacobian(mesh_, e));
  worst.jacobian = std::min(worst.jacobian, jacobian);
  worst.skew += 1 - jacobian;
  measure_lengths(e, worst);
}

void MeshEdit::measure_lengths(const Element& e, Measure& worst) const {
  for (int i = 0, n = e.corners(); i < n; ++i) {
    int a = e.v[i], b = e.v[(i + 1) % n];
    if (is_border(a, b)) continue;
    const auto ratio = static_cast<float>(mesh_.relative_length(a, b));
    worst.shortest = std::min(worst.shortest, ratio);
    worst.longest = std::max(worst.longest, ratio);
    worst.spread += static_cast<float>(spread(ratio));
  }
}

// Over the elements the journal removed and the old ones about the touched
// nodes; nothing has moved yet.
MeshEdit::Measure MeshEdit::measure_before() {
  Measure worst;
  for (const Entry& entry : journal_)
    if (entry.kind == Kind::gone && entry.id < old_elements_) worst.add(measured(entry.id, entry.element));
  collect_near();
  for (int e : near_)
    if (e < old_elements_) worst.add(measured(e, mesh_.elements[e]));
  return worst;
}

// Most changes come to nothing, which one sweep tells. Measured on a wavy patch: of the dear changes that pay all but 2
// % have a fifth of the fall in spread by then, which four in five of the others have not; of the cavities filled anew
// that pay all but 2 % are within `early_excess` by then, which two thirds of the others are not. On real models: of
// those that mend all but 2 % have no worse shapes by then, which two thirds of the others have. Triangles joined are
// too rare to lose any.
bool MeshEdit::is_promising(const Demand& demand, const Measure& before) const {
  if (demand.rise > 0) {
    const double least = std::max(demand.jacobian - early_lack, before.jacobian - early_loss);
    return std::all_of(near_.begin(), near_.end(),
                       [&](int e) { return scaled_jacobian(mesh_, mesh_.elements[e]) >= least; });
  }
  const double wanted = demand.gain + demand.fall;
  Measure now;
  for (int e : near_) measure_lengths(mesh_.elements[e], now);
  const double fall = spread_price * (before.spread - now.spread);
  return fall >= (wanted > 0 ? early_share * wanted : wanted - early_excess);
}

bool MeshEdit::settle(const Demand& demand) {
  const Measure before = measure_before();
  for (std::size_t i = 0, n = journal_.size(); i < n; ++i)
    if (journal_[i].kind == Kind::place && mesh_.star[journal_[i].id].size() > 0)
      move(journal_[i].id, journal_[i].place.p, true);
  for (int sweep = 0; sweep < local_sweeps; ++sweep) {
    smooth_touched(sweep == 0);
    if (sweep == 0 && !is_promising(demand, before)) return false;
  }
  Measure after;
  for (int e : near_) {
    if (!is_positive(mesh_, mesh_.elements[e])) return false;
    measure(mesh_.elements[e], after);
  }
  const double uneven = spread_price * (after.spread - before.spread), skew = skew_price * (after.skew - before.skew);
  if (demand.gain + uneven + skew > -demand.fall) return false;
  if (demand.rise > 0 && after.jacobian < before.jacobian + demand.rise) return false;
  return after.jacobian >= std::min<double>(demand.jacobian, before.jacobian) &&
         after.shortest >= std::min<double>(demand.shortest, before.shortest) &&
         after.longest <= std::max<double>(demand.longest, before.longest);
}

}  // namespace paver
