// In: model, face. Out: its edges as points, the boxes of the lines between these.
#include "sizing/gaps/banks.h"

#include <algorithm>

#include "base/segment.h"

namespace paver {
namespace {

constexpr int samples = 16;  // of an edge that is not straight
constexpr double straight = 1 - 1e-9;

}  // namespace

FaceBanks::FaceBanks(const ModelEdits& edits, int face) : edits_(edits), face_(edits.face(face)) {
  for (const Loop& loop : face_.loops) add(loop);
  std::vector<Box> boxes;
  for (std::size_t b = 0; b < banks_.size(); ++b)
    for (std::size_t i = 0; i + 1 < banks_[b].points.size(); ++i) {
      bank_of_.push_back(static_cast<int>(b));
      boxes.push_back(box_of(banks_[b], i));
    }
  tree_ = BoxTree(std::move(boxes));
}

void FaceBanks::add(const Loop& loop) {
  const auto first = static_cast<int>(banks_.size()), count = static_cast<int>(loop.coedges.size());
  for (int i = 0; i < count; ++i) {
    const Coedge& coedge = loop.coedges[i];
    const Edge& edge = edits_.edge(coedge.edge);
    Bank bank{coedge.edge,
              coedge.is_reversed,
              coedge.pcurve.get(),
              first + (i + count - 1) % count,
              first + (i + 1) % count,
              {},
              {}};
    if (edge.curve && coedge.pcurve && !edge.is_periodic) {
      const bool is_straight = norm(edits_.point(edge.end) - edits_.point(edge.start)) > straight * edge.length;
      for (int k = 0, n = is_straight ? 1 : samples; k <= n; ++k) {
        bank.t.push_back(edge.parameter(static_cast<double>(k) / n));
        bank.points.push_back(edge.curve->point(bank.t.back()));
      }
      for (std::size_t k = 0; !is_straight && k + 1 < bank.t.size(); ++k)
        bank.bulge = std::max(bank.bulge, norm(edge.curve->point(0.5 * (bank.t[k] + bank.t[k + 1])) -
                                               0.5 * (bank.points[k] + bank.points[k + 1])));
    }
    banks_.push_back(std::move(bank));
  }
}

std::vector<int> FaceBanks::meeting(const Box& box) const {
  std::vector<int> found;
  tree_.each_meeting(box, [&](int line) { found.push_back(bank_of_[line]); });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

Box FaceBanks::box_of(const Bank& bank, std::size_t line) {
  Box box;
  box.add(bank.points[line]);
  box.add(bank.points[line + 1]);
  return box.grown(bank.bulge);
}

bool FaceBanks::meet(const Bank& one, const Bank& two) const {
  const Edge &a = edits_.edge(one.edge), &b = edits_.edge(two.edge);
  return a.start == b.start || a.start == b.end || a.end == b.start || a.end == b.end;
}

BankFoot FaceBanks::foot_on(const Bank& bank, Vec3 x) const {
  BankFoot foot;
  double upto = 0, total = 0;
  for (std::size_t i = 0; i + 1 < bank.points.size(); ++i) {
    const Vec3 a = bank.points[i], b = bank.points[i + 1];
    const double share = nearest_share(x, a, b), here = norm(x - a - share * (b - a));
    if (here < foot.distance)
      foot.distance = here, foot.t = (1 - share) * bank.t[i] + share * bank.t[i + 1],
      upto = total + share * norm(b - a);
    total += norm(b - a);
  }
  if (!(total > 0)) return {};
  const Curve& curve = *edits_.edge(bank.edge).curve;
  for (int step = 0; step < 4 && bank.points.size() > 2; ++step) {
    const auto [at, slope] = curve.slope(foot.t);
    foot.t = std::clamp(foot.t + dot(x - at, slope) / dot(slope, slope), bank.t.front(), bank.t.back());
  }
  const double scale = edits_.edge(bank.edge).length / total;
  foot.distance = norm(x - curve.point(foot.t));
  foot.before = scale * upto, foot.behind = scale * (total - upto);
  return foot;
}

Vec3 FaceBanks::inward(const Bank& bank, double t) const {
  const auto [at, xu, xv] = face_.surface->slope(bank.image->uv(t));
  return (bank.is_reversed ? -1 : 1) * cross(cross(xu, xv), edits_.edge(bank.edge).curve->slope(t).t);
}

}  // namespace paver
