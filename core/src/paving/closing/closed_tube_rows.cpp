// In: loops of a region that goes round the origin of its chart. Out: rows of quads, loops of what is left.
// Elements of a slim tube are as narrow as it turns and as long as the target length. Rows of the front that meet a
// branch with them run into each other: few nodes go round. Steps: rims, and places along the tube where anything else
// is; stretches between these; rows of each, as long as the tube's columns are wide beside what is there, growing from
// there on.
#include "paving/closing/closed_tube_rows.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/cells.h"
#include "base/segment.h"
#include "paving/closing/tube_rows.h"

namespace paver {
namespace {

constexpr double slim = 4;         // target lengths round it
constexpr double off_line = 1e-6;  // of the way along it: nodes of a rim lie so far from a line across
constexpr double room = 1;         // columns' widths, between rows and what else is there
constexpr int samples = 128;       // of a stretch

/// Where along the tube (log of the radius in the chart) a rim lies, or a facet of anything else.
struct Stop {
  double low = 0, high = 0;
  int rim = -1;  ///< loop that lies there and goes round
};

class ClosedTubeRows {
 public:
  ClosedTubeRows(const Region& region, RegionMesh& mesh, std::vector<std::vector<int>> loops)
      : region_(region), mesh_(mesh), loops_(std::move(loops)) {}

  std::vector<std::vector<int>> run() {
    const std::vector<Stop> stops = find_stops();
    Stop last = stops.front();
    for (const Stop& next : stops) {
      if (next.low > last.high && (last.rim < 0 || next.rim < 0)) visit(last, next);
      if (next.high > last.high) last = next;
    }
    return std::move(loops_);
  }

 private:
  static double place(Vec2 p) { return 0.5 * std::log(dot(p, p)); }
  double place(int node) const { return place(mesh_.p[node]); }

  std::vector<Stop> find_stops() const {
    double low = INFINITY, high = -INFINITY;
    for (const std::vector<int>& loop : loops_)
      for (int node : loop) low = std::min(low, place(node)), high = std::max(high, place(node));
    std::vector<Stop> stops;
    for (std::size_t l = 0; l < loops_.size(); ++l) {
      const auto [first, last] = std::ranges::minmax(
          loops_[l], [](double a, double b) { return a < b; }, [this](int node) { return place(node); });
      const bool is_rim = goes_round(loops_[l]) && place(last) - place(first) <= off_line * (high - low) &&
                          (place(first) == low || place(last) == high);
      if (is_rim)
        stops.push_back({place(first), place(first), static_cast<int>(l)});
      else
        add_stops(loops_[l], stops);
    }
    for (const Fan& fan : region_.fans)
      for (const LoopNode& node : fan.ring) stops.push_back({place(fan.centre.p), place(node.p)});
    for (Stop& stop : stops)
      if (stop.low > stop.high) std::swap(stop.low, stop.high);
    std::ranges::stable_sort(stops, {}, &Stop::low);
    return stops;
  }

  /// Facets are straight in the chart: between its ends one lies further in than these.
  void add_stops(const std::vector<int>& loop, std::vector<Stop>& stops) const {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2 a = mesh_.p[loop[i]], b = mesh_.p[loop[(i + 1) % loop.size()]];
      stops.push_back({std::log(distance_to_segment(Vec2{}, a, b)), std::max(place(a), place(b))});
    }
  }

  bool goes_round(const std::vector<int>& loop) const {
    return goes_round_origin(loop.size(), [&](std::size_t i) { return mesh_.p[loop[i]]; });
  }

  /// Rows from a rim towards what else is there, else from the outer end inwards.
  void visit(const Stop& low, const Stop& high) {
    const int rim = std::max(low.rim, high.rim);
    const double from = low.rim >= 0 ? low.high : high.low, to = low.rim >= 0 ? high.low : low.high;
    std::vector<Vec2> columns;
    if (rim >= 0) {
      for (int node : loops_[rim]) columns.push_back(unit_of(mesh_.p[node]));
    } else {
      const std::size_t count = columns_by_turn(region_);
      for (std::size_t i = 0; i < count; ++i) {
        const double angle = 2 * M_PI * static_cast<double>(i) / static_cast<double>(count);
        columns.push_back({std::cos(angle), std::sin(angle)});
      }
    }
    // The chart keeps angles, so a stretch is as long, against the way round it, as its places tell.
    const double rooms = room * (rim >= 0 ? 1 : 2);
    if (std::fabs(to - from) * static_cast<double>(columns.size()) < 2 * M_PI * rooms) return;
    const double end = rim >= 0 ? end_of_slim(columns, from, to) : to;
    const double width = length_round(columns, 0.5 * (from + end)) / static_cast<double>(columns.size());
    if (!(width * static_cast<double>(columns.size()) < slim * region_.h)) return;
    const std::vector<Row> rows =
        divide(columns[0], from, end, {rim >= 0 ? 0 : room * width, end == to ? room * width : 0}, width);
    if (rows.size() > 1) lay(columns, rows, rim);
  }

  static Vec2 unit_of(Vec2 p) { return (1 / norm(p)) * p; }
  static Vec2 at(Vec2 column, double place) { return std::exp(place) * column; }

  double length_round(const std::vector<Vec2>& columns, double place) const {
    double way = 0;
    Vec3 last = region_.point(at(columns.back(), place));
    for (Vec2 column : columns) {
      const Vec3 next = region_.point(at(column, place));
      way += norm(next - last);
      last = next;
    }
    return way;
  }

  /// Where a funnel from a rim on is no longer slim; chords of rows farther on might cross what else is there.
  double end_of_slim(const std::vector<Vec2>& columns, double from, double to) const {
    constexpr int steps = 32;
    double last = from;
    for (int i = 1; i <= steps; ++i) {
      const double place = from + i * (to - from) / steps;
      if (length_round(columns, place) > slim * region_.h) return i > 1 ? last : to;
      last = place;
    }
    return to;
  }

  struct Row {
    double place = 0, h = 0;
  };

  /// Of a rising table, the value where it reaches x.
  static double value_at(const std::vector<double>& table, const std::vector<double>& values, double x) {
    const std::size_t i = cell_of(table, x);
    const double rise = table[i + 1] - table[i];
    const double share = rise > 0 ? std::clamp((x - table[i]) / rise, 0.0, 1.0) : 0;
    return values[i] + share * (values[i + 1] - values[i]);
  }

  /// Places of rows, with so much room beside `from` and `to`; nothing where there is none for any.
  std::vector<Row> divide(Vec2 column, double from, double to, std::array<double, 2> rooms, double width) const {
    std::vector<double> places, along{0};
    std::vector<NodePlace> points;
    for (int i = 0; i <= samples; ++i) {
      places.push_back(from + i * (to - from) / samples);
      points.push_back(region_.place(at(column, places[i])));
      if (i > 0) along.push_back(along.back() + norm(points[i].x - points[i - 1].x));
    }
    const double start = rooms[0], end = along.back() - rooms[1];
    if (!(end > start)) return {};
    const auto target = [&](double s) {
      const double away = start > 0 ? std::min(s - start, end - s) : end - s;
      return std::min(region_.h, width + region_.gradation * away);
    };
    std::vector<double> within{start}, reached{0};  // reached: in target lengths
    for (int i = 1; i <= samples; ++i) {
      within.push_back(std::clamp(along[i], start, end));
      const double step = within[i] - within[i - 1], length = step / target(0.5 * (within[i] + within[i - 1])),
                   turn = step > 0 ? region_.size.turn_weight() * norm(points[i].n - points[i - 1].n) : 0;
      reached.push_back(reached.back() + std::sqrt(length * length + turn * turn));
    }
    std::vector<Row> rows;
    const long count = std::lround(reached.back());
    for (long k = 0; count > 0 && k <= count; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(count);
      const double s = value_at(reached, within, share * reached.back());
      rows.push_back({value_at(along, places, s), target(s)});
    }
    return rows;
  }

  /// With the region on the left: the columns of a new row run counter-clockwise, and all that is laid from it lies
  /// inwards.
  void lay(const std::vector<Vec2>& columns, const std::vector<Row>& rows, int rim) {
    std::vector<int> last = rim >= 0 ? loops_[rim] : add_row(columns, rows[0]);
    if (rim < 0) loops_.emplace_back(last.rbegin(), last.rend());
    for (std::size_t k = 1; k < rows.size(); ++k) {
      std::vector<int> next = add_row(columns, rows[k]);
      for (std::size_t i = 0, n = columns.size(); i < n; ++i)
        mesh_.add_element({last[i], last[(i + 1) % n], next[(i + 1) % n], next[i]});
      last = std::move(next);
    }
    if (rim >= 0)
      loops_[rim] = std::move(last);
    else
      loops_.push_back(std::move(last));
  }

  std::vector<int> add_row(const std::vector<Vec2>& columns, const Row& row) {
    std::vector<int> nodes;
    for (Vec2 column : columns) nodes.push_back(mesh_.add_node(region_.place(at(column, row.place)), row.h));
    return nodes;
  }

  const Region& region_;
  RegionMesh& mesh_;
  std::vector<std::vector<int>> loops_;
};

}  // namespace

std::vector<std::vector<int>> lay_closed_tube_rows(const Region& region, RegionMesh& mesh,
                                                   std::vector<std::vector<int>> loops) {
  if (!region.goes_round || !region.chart->bends()) return loops;
  return ClosedTubeRows(region, mesh, std::move(loops)).run();
}

}  // namespace paver
